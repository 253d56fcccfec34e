#include "app/workbench/fusion_rows.h"

#include <QtTest>

#include "core/project/document_edits.h"

using namespace graftsman;

namespace {

std::shared_ptr<const MeshAsset> mesh(const std::string& name) {
  MeshAsset asset;
  asset.name = name;
  return std::make_shared<const MeshAsset>(std::move(asset));
}

Document nose() {
  Document document;
  Fusion fusion = *document.fusions.front();
  setAsset(fusion, Side::Part, mesh("cone.stl"));
  setAsset(fusion, Side::Base, mesh("head.obj"));
  fusion.closed = true;
  return edits::withFusion(std::move(document), std::move(fusion));
}

// Fusions 2 and 3 on the result of fusion 1.
Document twoOnANose() {
  Document document = nose();
  for (const char* part : {"horn.stl", "hat.stl"}) {
    document =
        edits::addFusion(std::move(document), mesh(part), edits::resultAsset(*document.fusions.front()));
  }
  return document;
}

}  // namespace

class FusionRowsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void anEmptyDocumentIsOneEmptyFusion() {
    const std::vector<FusionRow> rows = fusionRows(Document().fusions, 1, {});
    QCOMPARE(rows.size(), std::size_t{1});
    QCOMPARE(rows[0].name, QString("Fusion 1"));
    QCOMPARE(rows[0].what, QString("empty"));
    QVERIFY(rows[0].shown);
    QCOMPARE(rows[0].rows[0].name, QString("no part yet"));
    QCOMPARE(rows[0].rows[1].name, QString("no base yet"));
  }

  void aFusionThatIsUsedTwiceIsThereTwiceAndNotAtTheTop() {
    const std::vector<FusionRow> rows = fusionRows(twoOnANose().fusions, 3, {});
    QCOMPARE(rows.size(), std::size_t{2});
    QCOMPARE(rows[0].fusion, 2);
    QCOMPARE(rows[1].fusion, 3);
    QVERIFY(!rows[0].shown && rows[1].shown);
    for (const FusionRow& row : rows) {
      const FusionRow& base = row.rows[1];
      QCOMPARE(base.fusion, 1);
      QCOMPARE(base.owner, row.fusion);
      QVERIFY(base.side == Side::Base);
      QCOMPARE(base.rows[1].name, QString("head.obj"));
    }
  }

  void aNameFollowsTheNamesThatItIsMadeOf() {
    Document document = twoOnANose();
    QCOMPARE(fusionName(document.fusions, 2), QString("horn on cone on head"));
    document = edits::renameFusion(std::move(document), 1, "Nose v1.2");
    QCOMPARE(fusionName(document.fusions, 2), QString("horn on Nose v1.2"));
    document = edits::renameFusion(std::move(document), 2, "Horn");
    QCOMPARE(fusionName(document.fusions, 2), QString("Horn"));
    QCOMPARE(fusionName(document.fusions, 9), QString());
  }

  void whatIsMissingIsSaid() {
    Document document = twoOnANose();
    const KnownResults known = {{1, {1234, {}}}, {3, {0, "Path 1 crosses path 2."}}};
    Fusion third = *find(document.fusions, 3);
    third.closed = true;
    document = edits::withFusion(std::move(document), third);
    const std::vector<FusionRow> rows = fusionRows(document.fusions, 1, known);
    QCOMPARE(rows[0].what, QString("open loop"));
    QCOMPARE(rows[0].rows[1].what, QString("1,234 faces"));
    QCOMPARE(rows[1].what, QString("no result"));
    QCOMPARE(rows[1].problem, QString("Path 1 crosses path 2."));
    document = edits::addFusion(std::move(document), mesh("a.obj"), nullptr);
    QCOMPARE(fusionRows(document.fusions, 1, known)[2].what, QString("no base"));
  }

  void theFirstBaseIsTheMeshThatAllIsMadeOn() {
    const Document document = twoOnANose();
    QCOMPARE(firstBase(document.fusions, 3), find(document.fusions, 1)->base);
    QCOMPARE(firstBase(document.fusions, 1), find(document.fusions, 1)->base);
    QVERIFY(!firstBase(Document().fusions, 1));
  }
};

QTEST_GUILESS_MAIN(FusionRowsTest)
#include "fusion_rows_test.moc"
