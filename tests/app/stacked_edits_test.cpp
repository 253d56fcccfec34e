#include <QCryptographicHash>
#include <QTemporaryDir>
#include <QtTest>

#include "core/project/project_file.h"
#include "tests/support/stacked.h"
#include "tests/support/stacked_edits.h"

using namespace graftsman;

namespace {

// What every fusion of a document comes to: of a result its bits, of none why.
using Digest = std::map<FusionId, QByteArray>;

Digest digestOf(const Document& document, Evaluated& known) {
  Digest digest;
  for (const auto& fusion : document.fusions) {
    const FusionResults results = evaluate(document.fusions, fusion->id, known, {}).results;
    QCryptographicHash hash(QCryptographicHash::Sha1);
    const auto add = [&hash](const auto& values) {
      hash.addData(QByteArray::fromRawData(reinterpret_cast<const char*>(values.data()),
                                           static_cast<qsizetype>(values.size() * sizeof(values[0]))));
    };
    if (results.error) {
      add(results.error->message);
    } else if (results.fused) {
      add(results.fused->points);
      add(results.fused->faces());
    }
    digest[fusion->id] = hash.result();
  }
  return digest;
}

std::size_t resultsIn(const Document& document, Evaluated& known) {
  return static_cast<std::size_t>(std::ranges::count_if(document.fusions, [&](const auto& fusion) {
    return evaluate(document.fusions, fusion->id, known, {}).results.fused != nullptr;
  }));
}

}  // namespace

class StackedEditsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theFiveFusionsHaveResults() {
    Evaluated known;
    QCOMPARE(resultsIn(samples::fiveStackedFusions(), known), std::size_t{5});
  }

  void everyStateOfRandomEditsReproducesBitForBit() {
    std::mt19937 random(20'261'126);
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("stacked.graft").toStdString();
    DocumentModel model;
    model.reset(samples::fiveStackedFusions(), 5);
    Evaluated known;
    std::vector<std::pair<Document, Digest>> states = {{model.document(), digestOf(model.document(), known)}};
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
          states.emplace_back(model.document(), digestOf(model.document(), known));
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
        model.reset(std::move(loaded->project.document), loaded->project.shown);
        states = {{model.document(), saved}};
        ++reopened;
      }
      QVERIFY2(model.document() == at().first, qPrintable(QString("step %1").arg(step)));
      QVERIFY2(digestOf(model.document(), known) == at().second, qPrintable(QString("step %1").arg(step)));
      if (step % 25 == 0) {
        Evaluated nothing;
        QVERIFY2(digestOf(model.document(), nothing) == at().second,
                 qPrintable(QString("step %1, computed afresh").arg(step)));
      }
      results += resultsIn(model.document(), known);
    }
    QVERIFY2(edits > 80 && reopened > 5 && results > 600,
             qPrintable(QString("%1 edits, %2 files, %3 results").arg(edits).arg(reopened).arg(results)));
  }
};

QTEST_GUILESS_MAIN(StackedEditsTest)
#include "stacked_edits_test.moc"
