#include <QTemporaryDir>
#include <QtTest>

#include "tests/support/many_variants.h"
#include "tests/support/projects.h"

using namespace graftsman;

// What variants cost in a project's file.
class VariantsFileTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void twoHundredVariantsOfALargeFusionCostNoCopiesOfItsMeshes() {
    constexpr int kVariants = 200;
    constexpr std::uintmax_t kEach = 20'000;
    const QTemporaryDir folder;
    const auto size = [&](const Project& project, const char* name) {
      const std::filesystem::path path = folder.filePath(name).toStdString();
      projects::mustSucceed(writeProject(path, project, {}));
      return std::filesystem::file_size(path);
    };
    const Project project = samples::manyVariants(kVariants);
    QVERIFY(project.document.fusions.front()->inputs.base->faceCount() > 100'000);
    Project without = project;
    without.document.variants.clear();
    const std::uintmax_t meshes = size(without, "meshes.graft");
    const std::uintmax_t all = size(project, "variants.graft");
    QVERIFY2(all <= meshes + kVariants * kEach,
             qPrintable(QString("%1 bytes a variant").arg((all - meshes) / kVariants)));

    const Result<LoadedProject> loaded = readProject(folder.filePath("variants.graft").toStdString(), {});
    QVERIFY(loaded);
    QCOMPARE(loaded->project.document.variants.size(), std::size_t{kVariants});
    const auto& base = loaded->project.document.fusions.front()->base;
    for (std::size_t i = 0; i < kVariants; ++i) {
      const Fusion& read = *loaded->project.document.variants[i]->fusions.front();
      const Fusion& written = *project.document.variants[i]->fusions.front();
      QCOMPARE(read.base, base);
      QVERIFY(read.inputs.fcf == written.inputs.fcf && read.inputs.loop == written.inputs.loop);
    }
  }
};

QTEST_MAIN(VariantsFileTest)
#include "variants_file_test.moc"
