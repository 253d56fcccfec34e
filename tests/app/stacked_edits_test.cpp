#include <QTemporaryDir>
#include <QtTest>

#include "core/project/project_file.h"
#include "tests/support/document_digest.h"
#include "tests/support/stacked.h"
#include "tests/support/stacked_edits.h"

using namespace graftsman;

class StackedEditsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theFiveFusionsHaveResults() {
    Evaluated known;
    QCOMPARE(resultsIn(samples::fiveStackedFusions().fusions, known), std::size_t{5});
  }

  void everyStateOfRandomEditsReproducesBitForBit() {
    std::mt19937 random(20'261'126);
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("stacked.graft").toStdString();
    DocumentModel model;
    model.reset(samples::fiveStackedFusions(), 5);
    Evaluated known;
    std::vector<std::pair<Document, Digest>> states = {
        {model.document(), digestOf(model.document().fusions, known)}};
    const auto at = [&]() -> auto& {
      return states[static_cast<std::size_t>(model.history()->index())];
    };
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    std::size_t results = 0;
    int edits = 0;
    int reopened = 0;
    for (int step = 0; step < 300; ++step) {
      const int what = below(20);
      const int before = model.history()->index();
      if (what < 12) {
        const bool broke = randomStackedEdit(model, random, known);
        if (model.history()->index() > before) {
          states.resize(static_cast<std::size_t>(before) + 1);
          states.emplace_back(model.document(), digestOf(model.document().fusions, known));
          ++edits;
          // Mostly back, so that there is a result to compare.
          model.history()->setIndex(broke && below(5) > 0 ? before : before + 1);
        }
      } else if (what < 19) {
        model.history()->setIndex(what < 15   ? std::max(before - 1, 0)
                                  : what < 17 ? std::min(before + 1, model.history()->count())
                                              : below(model.history()->count() + 1));
      } else {
        QVERIFY(writeProject(path, {model.document(), model.shown(), {}, {}, {}, {}, {}}, {}));
        Result<LoadedProject> loaded = readProject(path, {});
        QVERIFY(loaded && loaded->damage.empty());
        const Digest saved = at().second;
        model.reset(loaded->project.document, loaded->project.shown);
        states = {{model.document(), saved}};
        ++reopened;
      }
      QVERIFY2(model.document() == at().first, qPrintable(QString("step %1").arg(step)));
      QVERIFY2(digestOf(model.document().fusions, known) == at().second,
               qPrintable(QString("step %1").arg(step)));
      if (step % 25 == 0) {
        Evaluated nothing;
        QVERIFY2(digestOf(model.document().fusions, nothing) == at().second,
                 qPrintable(QString("step %1, computed afresh").arg(step)));
      }
      results += resultsIn(model.document().fusions, known);
    }
    QVERIFY2(edits > 80 && reopened > 5 && results > 600,
             qPrintable(QString("%1 edits, %2 files, %3 results").arg(edits).arg(reopened).arg(results)));
  }
};

QTEST_GUILESS_MAIN(StackedEditsTest)
#include "stacked_edits_test.moc"
