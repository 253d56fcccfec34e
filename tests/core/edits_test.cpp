#include <QtTest>

#include "core/project/edits.h"

using namespace graftsman;

namespace {

std::shared_ptr<const MeshAsset> asset(const std::string& name) {
  std::vector<Point> points;
  std::vector<Face> faces;
  for (Index i = 0; i < 8; ++i) {
    points.emplace_back(i, i % 2, 0);
  }
  for (Index i = 0; i + 2 < 8; ++i) {
    faces.push_back(i % 2 == 0 ? Face{i, i + 1, i + 2} : Face{i + 1, i, i + 2});
  }
  return std::make_shared<const MeshAsset>(
      MeshAsset{name, name + ".obj", {}, std::make_shared<const TriangleMesh>(points, faces)});
}

CVP pair(Index part, Index base) {
  return {SurfacePoint::atVertex(part), SurfacePoint::atVertex(base)};
}

Fusion withPairs(int count) {
  Fusion fusion = edits::loadMesh({}, Side::Part, asset("part"));
  fusion = edits::loadMesh(std::move(fusion), Side::Base, asset("base"));
  for (int i = 0; i < count; ++i) {
    fusion = *edits::insertPair(fusion, static_cast<std::size_t>(i), pair(i, i + 1));
  }
  return fusion;
}

std::vector<std::pair<Index, Index>> numbers(const Fusion& fusion) {
  std::vector<std::pair<Index, Index>> all;
  for (const CVP& p : fusion.inputs.loop) {
    all.emplace_back(p.part.vertex, p.base.vertex);
  }
  return all;
}

using Pairs = std::vector<std::pair<Index, Index>>;

}  // namespace

class EditsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aMeshThatReplacesAnotherEmptiesTheLoop() {
    Fusion fusion = *edits::closeLoop(withPairs(4));
    const auto other = asset("other");
    fusion = edits::loadMesh(std::move(fusion), Side::Base, other);
    QVERIFY(fusion.inputs.loop.empty());
    QVERIFY(!fusion.closed);
    QCOMPARE(fusion.inputs.base, other->mesh);
  }

  void theFirstMeshOfASideKeepsWhatIsThere() {
    Fusion fusion = edits::loadMesh({}, Side::Part, asset("part"));
    fusion.inputs.fcf = FCF::preset(FCF::Preset::Half);
    fusion = edits::loadMesh(std::move(fusion), Side::Base, asset("base"));
    QVERIFY(fusion.inputs.fcf == FCF::preset(FCF::Preset::Half));
    QVERIFY(fusion.part && fusion.base);
  }

  void aPairIsInsertedWhereItIsAskedFor() {
    const Result<Fusion> after = edits::insertPair(withPairs(3), 1, pair(7, 7));
    QVERIFY(after);
    QCOMPARE(numbers(*after), (Pairs{{0, 1}, {7, 7}, {1, 2}, {2, 3}}));
  }

  void aPairOnATakenPointIsRefusedAndNamed() {
    const Result<Fusion> after = edits::insertPair(withPairs(3), 3, pair(7, 2));
    QVERIFY(!after);
    QCOMPARE(after.error().code, ErrorCode::LoopRepeatsPoint);
    QCOMPARE(after.error().side, Side::Base);
    QCOMPARE(after.error().cvs, (std::vector<int>{1, 3}));
  }

  void aPairOffTheMeshIsRefused() {
    QCOMPARE(edits::insertPair(withPairs(3), 3, pair(8, 7)).error().code, ErrorCode::LoopIndexOutOfRange);
    QCOMPARE(edits::insertPair({}, 0, pair(0, 0)).error().code, ErrorCode::LoopIndexOutOfRange);
  }

  void aCVMovesOnItsOwnSideAlone() {
    QCOMPARE(numbers(*edits::moveCV(withPairs(3), 1, Side::Base, SurfacePoint::atVertex(7))),
             (Pairs{{0, 1}, {1, 7}, {2, 3}}));
    QVERIFY(!edits::moveCV(withPairs(3), 1, Side::Base, SurfacePoint::atVertex(1)));
    QVERIFY(edits::moveCV(withPairs(3), 1, Side::Base, SurfacePoint::atVertex(2)));  // where it is
  }

  void aClosedLoopOfTwoIsOpen() {
    Fusion fusion = *edits::closeLoop(withPairs(4));
    fusion = edits::removePairs(std::move(fusion), {1});
    QVERIFY(fusion.closed);
    fusion = edits::removePairs(std::move(fusion), {0, 2});
    QVERIFY(!fusion.closed);
    QCOMPARE(numbers(fusion), (Pairs{{2, 3}}));
  }

  void twoPairsMakeNoLoop() {
    QCOMPARE(edits::closeLoop(withPairs(2)).error().code, ErrorCode::LoopTooShort);
  }

  void reversingTwiceGivesTheLoopBack() {
    const Fusion fusion = withPairs(5);
    const Fusion reversed = edits::reverseLoop(fusion);
    QCOMPARE(numbers(reversed), (Pairs{{0, 1}, {4, 5}, {3, 4}, {2, 3}, {1, 2}}));
    QVERIFY(edits::reverseLoop(reversed) == fusion);
  }

  void shiftingAsOftenAsThereArePairsGivesTheLoopBack() {
    const Fusion fusion = withPairs(3);
    Fusion shifted = edits::shiftCorrespondence(fusion);
    QCOMPARE(numbers(shifted), (Pairs{{2, 1}, {0, 2}, {1, 3}}));
    shifted = edits::shiftCorrespondence(edits::shiftCorrespondence(shifted));
    QVERIFY(shifted == fusion);
  }

  void mirroringTurnsThePartsOrderAlone() {
    QCOMPARE(numbers(edits::mirrorCorrespondence(withPairs(4))), (Pairs{{0, 1}, {3, 2}, {2, 3}, {1, 4}}));
  }
};

QTEST_APPLESS_MAIN(EditsTest)
#include "edits_test.moc"
