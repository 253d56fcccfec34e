#include <QTemporaryDir>
#include <QtTest>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/project/project_file.h"
#include "tests/support/cli_runs.h"
#include "tests/support/projects.h"
#include "tests/support/samples.h"

using namespace graftsman;

namespace {

// The sample scenario as a project.
Project projectOf(const std::string& name) {
  const LoadedScenario loaded = readScenario(samples::scenarioPath(name), {}).value();
  Project project;
  Fusion& fusion = projects::fusionOf(project);
  const auto asset = [](const std::filesystem::path& source, const ReadReport& report, auto mesh) {
    return std::make_shared<const MeshAsset>(MeshAsset{source.filename(), source, report, std::move(mesh)});
  };
  fusion.inputs = loaded.scenario.inputs;
  fusion.part = asset(loaded.scenario.part, loaded.partReport, fusion.inputs.part);
  fusion.base = asset(loaded.scenario.base, loaded.baseReport, fusion.inputs.base);
  fusion.closed = true;
  return project;
}

void save(const QString& path, const Project& project) {
  QVERIFY(writeProject(path.toStdString(), project, {}));
}

}  // namespace

class CliProjectsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aProjectGivesTheBytesAndTheReportOfItsScenario() {
    const QTemporaryDir dir;
    save(dir.filePath("Nose.GRAFT"), projectOf("fig8b_cone_nose"));
    QCOMPARE(runCli({"fuse", scenario("fig8b_cone_nose"), "-o", dir.filePath("a.obj")}).exitCode, 0);
    const Outcome outcome = runCli({"fuse", dir.filePath("Nose.GRAFT"), "-o", dir.filePath("b.obj"),
                                    "--report", dir.filePath("b.json")});
    QCOMPARE(outcome.err, QByteArray());
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY(!contentOf(dir.filePath("a.obj")).isEmpty());
    QCOMPARE(contentOf(dir.filePath("b.obj")), contentOf(dir.filePath("a.obj")));
    const auto json = nlohmann::json::parse(contentOf(dir.filePath("b.json")).toStdString());
    QVERIFY(json["checks"]["all_hold"].get<bool>());
    QCOMPARE(json["name"].get<std::string>(), std::string("Nose"));
    QCOMPARE(json["reading"]["part"]["format"].get<std::string>(), std::string("STL"));
    // Its curve can be replaced, too.
    const auto fuseWith = [&](const QString& input, const QString& output) {
      return runCli({"fuse", input, "-o", dir.filePath(output), "--fcf", "half"}).exitCode;
    };
    QCOMPARE(fuseWith(dir.filePath("Nose.GRAFT"), "c.obj"), 0);
    QCOMPARE(fuseWith(scenario("fig8b_cone_nose"), "d.obj"), 0);
    QVERIFY(contentOf(dir.filePath("c.obj")) != contentOf(dir.filePath("a.obj")));
    QCOMPARE(contentOf(dir.filePath("c.obj")), contentOf(dir.filePath("d.obj")));
  }

  void aProjectThatCannotBeFusedIsOneLine_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("open") << "open" << QByteArray("loop is not closed yet");
    QTest::newRow("no base") << "no base" << QByteArray("has no base yet");
    QTest::newRow("empty") << "empty" << QByteArray("has no part yet");
    QTest::newRow("damaged") << "damaged" << QByteArray("is damaged and was left out");
    QTest::newRow("no project") << "no project" << QByteArray("is no Graftsman project");
  }

  void aProjectThatCannotBeFusedIsOneLine() {
    QFETCH(QString, what);
    QFETCH(QByteArray, says);
    const QTemporaryDir dir;
    const QString file = dir.filePath("p.graft");
    Project project = projectOf("fig4a_cone_sphere");
    if (what == "open") {
      projects::fusionOf(project).closed = false;
    } else if (what == "no base") {
      projects::fusionOf(project).base = nullptr;
    } else if (what == "empty") {
      project = {};
    }
    save(file, project);
    if (what == "damaged") {
      QByteArray bytes = contentOf(file);
      const qsizetype inside = bytes.indexOf("grafmesh") + 500;
      bytes[inside] = static_cast<char>(bytes[inside] ^ 1);
      write(file, bytes);
    } else if (what == "no project") {
      write(file, "{}");
    }
    const Outcome outcome = runCli({"fuse", file, "-o", dir.filePath("a.obj")});
    verifyOneLineError(outcome);
    QVERIFY2(outcome.err.contains(says) && outcome.err.contains("p.graft"), outcome.err);
    QVERIFY(!QFile::exists(dir.filePath("a.obj")));
  }

  void aDamagedPictureIsNoHindrance() {
    const QTemporaryDir dir;
    Project project = projectOf("fig4a_cone_sphere");
    project.thumbnail = "picture";
    save(dir.filePath("p.graft"), project);
    QByteArray bytes = contentOf(dir.filePath("p.graft"));
    write(dir.filePath("p.graft"), bytes.replace("picture", "pictura"));
    const Outcome outcome = runCli({"fuse", dir.filePath("p.graft"), "-o", dir.filePath("a.obj")});
    QCOMPARE(outcome.exitCode, 0);
    QCOMPARE(outcome.err, QByteArray());
  }

  void aHistoryIsNoHindrance() {
    const QTemporaryDir dir;
    Project project = projectOf("fig4a_cone_sphere");
    save(dir.filePath("plain.graft"), project);
    Fusion before = *project.document.fusions.front();
    before.inputs.fcf = FCF::preset(FCF::Preset::Half);
    project.history.steps.push_back({"Curve: Linear", 1, 1, {}, {}});
    project.history.states = {{{std::make_shared<const Fusion>(before)}, {}}, project.document};
    project.history.index = 1;
    save(dir.filePath("p.graft"), project);
    QVERIFY(QFileInfo(dir.filePath("p.graft")).size() > QFileInfo(dir.filePath("plain.graft")).size());
    for (const char* name : {"plain", "p"}) {
      const QString stem = dir.filePath(name);
      const Outcome outcome = runCli({"fuse", stem + ".graft", "-o", stem + ".obj"});
      QCOMPARE(outcome.exitCode, 0);
      QCOMPARE(outcome.err, QByteArray());
    }
    QCOMPARE(contentOf(dir.filePath("p.obj")), contentOf(dir.filePath("plain.obj")));
  }

  void neitherAProjectNorItsModelsAreOverwritten() {
    const QTemporaryDir dir;
    const QString file = dir.filePath("p.graft");
    const QString source = dir.filePath("sphere.off");
    QVERIFY(QFile::copy(model("sphere.off"), source));
    Project project = projectOf("fig4a_cone_sphere");
    MeshAsset base = *projects::fusionOf(project).base;
    base.source = source.toStdString();
    projects::fusionOf(project).base = std::make_shared<const MeshAsset>(base);
    save(file, project);
    const QByteArray before = contentOf(file);
    verifyOneLineError(runCli({"fuse", file, "-o", source}));
    verifyOneLineError(runCli({"fuse", file, "-o", dir.filePath("a.obj"), "--report", file}));
    QCOMPARE(contentOf(file), before);
    QCOMPARE(contentOf(source), contentOf(model("sphere.off")));
  }
};

QTEST_GUILESS_MAIN(CliProjectsTest)
#include "cli_projects_test.moc"
