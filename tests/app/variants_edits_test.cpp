#include <QTemporaryDir>
#include <QtTest>

#include "core/project/project_file.h"
#include "tests/support/document_digest.h"
#include "tests/support/variant_edits.h"

using namespace graftsman;

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kSteps = 60;
#else
constexpr int kSteps = 300;
#endif

// What a document's variants are but for their fusions.
QStringList wordsOf(const Document& document) {
  QStringList words;
  for (const auto& variant : document.variants) {
    words.append(QString("%1 %2 %3 %4 %5 of %6")
                     .arg(variant->id)
                     .arg(QString::fromStdString(variant->name), QString::fromStdString(variant->note))
                     .arg(variant->starred)
                     .arg(variant->shown)
                     .arg(variant->fusions.size()));
  }
  return words;
}

// A state with what it came to when it arose.
struct State {
  Document document;
  Digest fusions;
  std::map<VariantId, QByteArray> variants;  // the result that each shows
  QStringList words;
};

// What variants come to, each computed from what it was before.
class VariantDigests {
 public:
  QByteArray operator()(const Variant& variant) {
    return digestOf(evaluate(variant.fusions, variant.shown, known_[variant.id], {}).results);
  }

 private:
  std::map<VariantId, Evaluated> known_;
};

QByteArray afresh(const Variant& variant) {
  Evaluated nothing;
  return digestOf(evaluate(variant.fusions, variant.shown, nothing, {}).results);
}

}  // namespace

class VariantsEditsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theTenVariantsHaveResultsThatDiffer() {
    std::set<QByteArray> results;
    for (const auto& variant : samples::tenVariantsOfStackedFusions().variants) {
      Evaluated nothing;
      QVERIFY(evaluate(variant->fusions, variant->shown, nothing, {}).results.fused);
      results.insert(afresh(*variant));
    }
    QCOMPARE(results.size(), std::size_t{10});
  }

  // Undo, redo, jumps in the history, saving and reopening with the history lie between the edits.
  void everyStateOfRandomEditsReproducesBitForBit() {
    std::mt19937 random(20'261'127);
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("variants.graft").toStdString();
    DocumentModel model;
    model.reset(samples::tenVariantsOfStackedFusions(), 5);
    Evaluated known;
    VariantDigests digests;
    const auto stateNow = [&](const State* before) {
      State state{model.document(), digestOf(model.document().fusions, known), {}, wordsOf(model.document())};
      for (const auto& variant : state.document.variants) {
        const bool kept = before && std::ranges::find(before->document.variants, variant) !=
                                        before->document.variants.end();
        state.variants[variant->id] = kept ? before->variants.at(variant->id) : digests(*variant);
      }
      return state;
    };
    std::vector<State> states = {stateNow(nullptr)};
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    std::set<QString> kinds;
    int edits = 0;
    int jumps = 0;
    int reopened = 0;
    std::size_t results = 0;
    for (int step = 0; step < kSteps; ++step) {
      const QByteArray where = "step " + QByteArray::number(step);
      const int what = below(20);
      const int before = model.history()->index();
      if (what < 13) {
        bool broke = false;
        if (what < 7) {
          randomVariantEdit(model, random);
        } else {
          broke = randomStackedEdit(model, random, known);
        }
        if (model.history()->index() > before) {
          states.resize(static_cast<std::size_t>(before) + 1);
          states.push_back(stateNow(&states.back()));
          kinds.insert(model.history()->undoText().section(' ', 0, 0));
          ++edits;
          // Mostly back, so that there is a result to compare.
          model.history()->setIndex(broke && below(5) > 0 ? before : before + 1);
        }
      } else if (what < 18) {
        model.history()->setIndex(what < 15   ? std::max(before - 1, 0)
                                  : what < 17 ? std::min(before + 1, model.history()->count())
                                              : below(model.history()->count() + 1));
        jumps += model.history()->index() != before ? 1 : 0;
      } else {
        const History history = model.historyValue();
        QVERIFY(writeProject(path, {model.document(), model.shown(), {}, {}, {}, {}, history}, {}));
        Result<LoadedProject> loaded = readProject(path, {});
        QVERIFY2(loaded && loaded->damage.empty(), where.constData());
        model.reset(loaded->project.document, loaded->project.shown, loaded->project.history);
        QCOMPARE(static_cast<std::size_t>(model.history()->count()) + 1, states.size());
        QCOMPARE(model.history()->index(), before);
        // Meshes are others from now on; what all comes to is what is remembered.
        const History read = model.historyValue();
        for (std::size_t i = 0; i < read.states.size(); ++i) {
          states[i].document = read.states[i];
        }
        if (read.states.empty()) {
          states.front().document = model.document();
        }
        ++reopened;
      }

      const State& now = states[static_cast<std::size_t>(model.history()->index())];
      QVERIFY2(model.document() == now.document, where.constData());
      QVERIFY2(wordsOf(model.document()) == now.words, where.constData());
      QVERIFY2(digestOf(model.document().fusions, known) == now.fusions, where.constData());
      const auto& variants = model.document().variants;
      const Variant& one = *variants[static_cast<std::size_t>(below(static_cast<int>(variants.size())))];
      QVERIFY2(digests(one) == now.variants.at(one.id), where.constData());
      if (step % 25 == 0) {
        Evaluated nothing;
        QVERIFY2(digestOf(model.document().fusions, nothing) == now.fusions, where.constData());
        for (const auto& variant : variants) {
          QVERIFY2(afresh(*variant) == now.variants.at(variant->id), where.constData());
        }
      }
      results += resultsIn(model.document().fusions, known);
    }
    QVERIFY2(edits > kSteps / 4 && jumps > kSteps / 12 && reopened > kSteps / 20 &&
                 results > static_cast<std::size_t>(2 * kSteps) && kinds.size() > 8,
             qPrintable(QString("%1 edits of %2 kinds, %3 jumps, %4 files, %5 results")
                            .arg(edits)
                            .arg(kinds.size())
                            .arg(jumps)
                            .arg(reopened)
                            .arg(results)));
  }
};

QTEST_GUILESS_MAIN(VariantsEditsTest)
#include "variants_edits_test.moc"
