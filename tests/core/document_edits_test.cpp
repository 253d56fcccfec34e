#include <QtTest>

#include "tests/support/stacked.h"

using namespace graftsman;

namespace {

std::vector<std::string> names(const Document& document) {
  std::vector<std::string> found;
  for (const auto& variant : document.variants) {
    found.push_back(variant->name);
  }
  return found;
}

const Fusion& shownOf(const Variant& variant) {
  return *find(variant.fusions, variant.shown);
}

}  // namespace

class DocumentEditsTest : public QObject {
  Q_OBJECT

  const Document start_ = samples::documentOf(samples::fusion("fig4c_cone_sphere"));

 private Q_SLOTS:
  void fusionsGetNumbersThatNeverComeAgain() {
    Document document = edits::addFusion(start_, nullptr, nullptr);
    QCOMPARE(document.fusions.back()->id, 2);
    document = edits::addVariant(document, 2);
    document = edits::removeFusion(document, 2);
    // The variant still has fusion 2.
    document = edits::addFusion(document, nullptr, nullptr);
    QCOMPARE(document.fusions.back()->id, 3);
  }

  void theLastFusionThatGoesLeavesAnEmptyOne() {
    const Document document = edits::removeFusion(start_, 1);
    QCOMPARE(document.fusions.size(), std::size_t{1});
    QVERIFY(!document.fusions.front()->part && !document.fusions.front()->base);
  }

  void aFusionIsCalledByWhatItIsMadeOfUntilItHasAName() {
    QCOMPARE(label(*start_.fusions.front()), std::string("part on base"));
    const Document named = edits::renameFusion(start_, 1, "Nose");
    QCOMPARE(label(*named.fusions.front()), std::string("Nose"));
    QCOMPARE(label(*edits::removeFusion(start_, 1).fusions.front()), std::string("Fusion 1"));
  }

  void aVariantKeepsTheStateAndSharesItsMeshes() {
    Document document = edits::addVariant(start_, 1, "Sharp");
    Fusion changed = *document.fusions.front();
    changed.inputs.fcf = FCF::preset(FCF::Preset::Half);
    document = edits::withFusion(document, changed);
    document = edits::addVariant(document, 1);
    QCOMPARE(names(document), (std::vector<std::string>{"Sharp", "Variant 2"}));
    QVERIFY(document.variants[0]->fusions == start_.fusions);
    QCOMPARE(shownOf(*document.variants[1]).inputs.base, start_.fusions.front()->inputs.base);
    QVERIFY(edits::applyVariant(document, 1).fusions == start_.fusions);
  }

  void aChangeToSeveralVariantsLeavesTheOthersAndTheFusions() {
    Document document = start_;
    for (int i = 0; i < 3; ++i) {
      document = edits::addVariant(document, 1);
    }
    const Document changed = edits::changeVariants(
        document, {1, 3}, [](Fusion& fusion) { fusion.inputs.fcf = FCF::preset(FCF::Preset::Paste); });
    QVERIFY(shownOf(*changed.variants[0]).inputs.fcf == FCF::preset(FCF::Preset::Paste));
    QCOMPARE(changed.variants[1], document.variants[1]);
    QVERIFY(shownOf(*changed.variants[2]).inputs.fcf == FCF::preset(FCF::Preset::Paste));
    QVERIFY(changed.fusions == document.fusions);
  }

  void aCrossHasTheLoopOfOneAndTheCurveOfTheOther() {
    Document document = edits::addVariant(start_, 1, "A");
    Fusion other = *document.fusions.front();
    other = edits::removePairs(std::move(other), {2});
    other.inputs.fcf = FCF::preset(FCF::Preset::Half);
    document = edits::addVariant(edits::withFusion(document, other), 1, "B");
    document = edits::crossVariants(document, 1, 2);
    QCOMPARE(names(document).back(), std::string("A × B"));
    const Fusion& cross = shownOf(*document.variants.back());
    QVERIFY(cross.inputs.loop == start_.fusions.front()->inputs.loop);
    QVERIFY(cross.inputs.fcf == other.inputs.fcf);
  }

  void removedVariantsAreGone() {
    Document document = edits::addVariant(edits::addVariant(start_, 1), 1);
    document = edits::removeVariants(document, {1});
    QCOMPARE(names(document), std::vector<std::string>{"Variant 2"});
  }

  void aCVOnAResultRemembersItsPlace() {
    const Document document = samples::twoConesOnASphere();
    const Fusion& second = *find(document.fusions, 2);
    for (const CVP& pair : second.inputs.loop) {
      QVERIFY(pair.base.place && !pair.part.place);
    }
    const Fusion moved = *edits::moveCV(second, 0, Side::Base, SurfacePoint::atVertex(5));
    QCOMPARE(*moved.inputs.loop[0].base.place, second.inputs.base->point(5));
  }
};

QTEST_GUILESS_MAIN(DocumentEditsTest)
#include "document_edits_test.moc"
