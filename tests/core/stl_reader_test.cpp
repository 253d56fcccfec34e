#include <QtTest>
#include <limits>

#include "core/io/weld.h"
#include "tests/support/mesh_text.h"

using namespace graftsman;
using mesh_text::binaryStl;
using mesh_text::raw;
using mesh_text::refusal;
using mesh_text::stl;

namespace {

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return "  facet normal 0 0 1\n    outer loop\n      vertex " + a + "\n      vertex " + b +
         "\n      vertex " + c + "\n    endloop\n  endfacet\n";
}

std::string solid(const std::string& facets) {
  return "solid nose with spaces\n" + facets + "endsolid nose\n";
}

const std::vector<std::array<float, 9>> kTwoFacets = {{5, 0, 0, 1, 0, 0, 0, 1, -0.0F},
                                                      {0, 1, 0, 1, 0, -0.0F, 1, 1, 0}};
const std::vector<Point> kPoints = {{5, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
const std::vector<Face> kFaces = {{0, 1, 2}, {2, 1, 3}};

}  // namespace

class StlReaderTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void weldsEqualCornersAndNumbersThemByFirstAppearance() {
    const auto text =
        stl(solid(facet("5 0 0", "1 0 0", "0 1 -0") + facet("0 1 0", "1.0 0 -0", "1 1 0"))).value();
    const auto binary = stl(binaryStl(kTwoFacets)).value();
    for (const MeshFile& file : {text, binary}) {
      QCOMPARE(file.mesh->points(), kPoints);
      QCOMPARE(file.mesh->faces(), kFaces);
      QCOMPARE(raw(file.mesh->point(2).z()), raw(-0.0));  // the first one's bits
      QCOMPARE(file.report.fileVertices, 6U);
      QCOMPARE(file.report.fileFaces, 2U);
      QCOMPARE(file.report.welded, 2U);
      QVERIFY(file.vertexOfFileVertex.empty());
    }
    QVERIFY(!text.report.binary);
    QVERIFY(binary.report.binary);
  }

  void weldsOnlyEqualBits() {
    const double next = std::nextafter(1.0, 2.0);
    const auto file =
        stl(solid(facet("5 0 0", "1 0 0", "0 1 0") +
                  facet("0 1 0", QString::number(next, 'g', 17).toStdString() + " 0 0", "1 1 0")));
    QCOMPARE(file.value().mesh->vertexCount(), 5);
  }

  void readsAnyLayoutOfText() {
    const std::string plain = solid(facet("5 0 0", "1 0 0", "0 1 0") + facet("0 1 0", "1 0 0", "1 1 0"));
    const QString upper = QString::fromStdString(plain).toUpper();
    QString windows = QString::fromStdString(plain);
    windows.replace("\n", "\r\n");
    QString oneLine = QString::fromStdString(plain);
    oneLine.replace("\n    ", "\t")
        .replace("normal 0 0 1\touter", "normal 0 0 1\router")
        .replace("endloop\n", "endloop ");
    QString nan = QString::fromStdString(plain);
    nan.replace("normal 0 0 1", "normal nan nan nan");
    QString twoSolids = QString::fromStdString(plain);
    twoSolids.insert(twoSolids.lastIndexOf("  facet"), "endsolid a\nsolid facet\n");
    const QString unnamed = QString::fromStdString(plain).replace("solid nose with spaces", "solid");
    for (const QString& text : {upper, windows, oneLine, nan, twoSolids, unnamed, " \n" + upper}) {
      const auto file = stl(text.toStdString());
      QVERIFY2(file.has_value(), file ? "" : file.error().message.c_str());
      QCOMPARE(file->mesh->points(), kPoints);
      QCOMPARE(file->mesh->faces(), kFaces);
    }
  }

  void recognisesBinaryBySizeWhateverTheHeaderSays() {
    for (const char* const header : {"solid", "solid name\nfacet normal", "", "binary"}) {
      const auto file = stl(binaryStl(kTwoFacets, header));
      QCOMPARE(file.value().mesh->faces(), kFaces);
      QVERIFY(file.value().report.binary);
    }
    std::string spaces = binaryStl(kTwoFacets);
    spaces.replace(0, 80, "solid" + std::string(75, ' '));
    QCOMPARE(stl(spaces).value().mesh->faces(), kFaces);
  }

  void refusesABrokenBinary() {
    const std::string whole = binaryStl(kTwoFacets);
    QCOMPARE(
        refusal(stl(whole.substr(0, 150))),
        "nose.stl: byte 80: the header declares 2 facets, but the file of 150 bytes holds 1; is it cut off?");
    QCOMPARE(refusal(stl(whole + std::string(50, '\0'))),
             "nose.stl: byte 80: the header declares 2 facets, but the file of 234 bytes holds 3");
    std::string huge = whole;
    huge.replace(80, 4, raw(4000000000U));
    QCOMPARE(refusal(stl(huge)),
             "nose.stl: byte 80: the header declares 4000000000 facets, but the file of 184 bytes "
             "holds 2; is it cut off?");
    std::string infinite = whole;
    infinite.replace(84 + 50 + 24, 4, raw(-std::numeric_limits<float>::infinity()));
    QCOMPARE(refusal(stl(infinite)), "nose.stl: byte 158: a coordinate of facet 1 is not a finite number");
    QVERIFY(refusal(stl("hello")).starts_with("nose.stl: byte 5: the file is too short for an STL file"));
    // A few bytes more than the facets need are no harm.
    QCOMPARE(stl(whole + "end").value().mesh->faces(), kFaces);
  }

  void namesTheLineOfABrokenText() {
    const std::string good = facet("5 0 0", "1 0 0", "0 1 0");
    QCOMPARE(refusal(stl(solid(good + facet("0 1 0", "1 b 0", "1 1 0")))),
             "nose.stl:12: expected the y coordinate of vertex 4, found 'b'");
    QCOMPARE(refusal(stl(solid(good + facet("0 1 0", "1 0 nan", "1 1 0")))),
             "nose.stl:12: the z coordinate of vertex 4 is 'nan', which is not a finite number");
    QCOMPARE(refusal(stl(solid(
                 good + "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nendloop\nendfacet\n"))),
             "nose.stl:14: the facet has 2 vertices instead of three");
    QCOMPARE(
        refusal(stl(solid("facet normal 0 0 1\nouter loop\n" + std::string("vertex 0 0 0\nvertex 0 0 1\n") +
                          "vertex 0 0 0\nvertex 0 0 1\nendloop\nendfacet\n"))),
        "nose.stl:7: the facet has more than three vertices");
    QCOMPARE(refusal(stl(solid("vertex 0 0 0\n"))), "nose.stl:2: a vertex outside of a facet");
    QCOMPARE(refusal(stl(solid("endfacet\n"))), "nose.stl:2: 'endfacet' without a facet");
    QCOMPARE(refusal(stl(solid("facet\nfacet\n"))),
             "nose.stl:3: a facet begins before the one above has ended");
    QCOMPARE(refusal(stl("solid\nfacet\nendsolid")), "nose.stl:3: a facet has not ended");
    QCOMPARE(refusal(stl("solid\nfacet\nouter loop\n")),
             "nose.stl:4: the file ends within a facet; is it cut off?");
    QCOMPARE(refusal(stl(solid("face normal\n"))),
             "nose.stl:2: expected a keyword of STL such as 'facet' or 'vertex', found 'face'");
  }

  void aSolidWithoutFacetsIsEmpty() {
    QCOMPARE(stl("solid\nendsolid\n").error().code, ErrorCode::MeshEmpty);
    QCOMPARE(stl(binaryStl({})).error().code, ErrorCode::MeshEmpty);
  }

  void dropsFacetsThatWeldingCollapsed() {
    const auto file = stl(binaryStl({{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 0, 1, 0, 0, -0.0F, 0, 0}})).value();
    QCOMPARE(file.mesh->faceCount(), 1);
    QCOMPARE(file.report.droppedDegenerate, 1U);
  }

  void weldingBySortingGivesTheSame() {
    std::vector<Point> points;
    for (int i = 0; i < 5000; ++i) {
      points.emplace_back(i * 7919 % 31, i * 104729 % 37, i % 2 == 0 ? 0.0 : -0.0);
    }
    PointWelder hashed(4);
    PointWelder ordered(4, 0);  // the first collision after a thousand points makes the map take over
    std::vector<Index> numbers(points.size());
    hashed.add(points, numbers);
    for (std::size_t i = 0; i < points.size(); ++i) {
      QCOMPARE(ordered.add(points[i]), numbers[i]);
    }
    QCOMPARE(hashed.size(), 31U * 37U);
    QCOMPARE(ordered.takePoints(), hashed.takePoints());
  }
};

QTEST_APPLESS_MAIN(StlReaderTest)
#include "stl_reader_test.moc"
