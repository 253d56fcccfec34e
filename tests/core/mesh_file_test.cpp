#include <QtTest>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "core/io/mesh_writer.h"
#include "core/io/read_file.h"
#include "tests/support/mesh_file_texts.h"
#include "tests/support/mesh_text.h"
#include "tests/support/shapes.h"

using namespace graftsman;
using namespace std::chrono_literals;

namespace {

// Every kind of double, at random bits.
std::vector<Point> awkwardPoints() {
  std::vector<double> numbers = {0.0,
                                 -0.0,
                                 std::numeric_limits<double>::denorm_min(),
                                 -std::numeric_limits<double>::min(),
                                 std::numeric_limits<double>::max(),
                                 std::numeric_limits<double>::lowest(),
                                 0.1,
                                 1.0 / 3,
                                 9007199254740993.0,
                                 9007199254740992.0,
                                 123456789012345678.0,
                                 1e22,
                                 1e23,
                                 8.41e21,
                                 5e-324,
                                 2.2250738585072011e-308};
  std::mt19937_64 random(7);  // NOLINT: the same on every run
  while (numbers.size() < 3000) {
    const double number = std::bit_cast<double>(random());
    if (std::isfinite(number)) {
      numbers.push_back(number);
    }
    numbers.push_back(std::ldexp(static_cast<double>(random() % 2000000) - 1e6, -10));
    numbers.push_back((static_cast<double>(random() % 2000000) - 1e6) / 1e4);
  }
  std::vector<Point> points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  return points;
}

}  // namespace

class MeshFileTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theNamesEndingSaysTheFormat() {
    QCOMPARE(formatOf("a.obj").value(), MeshFormat::Obj);
    QCOMPARE(formatOf("a.b/c.PLY").value(), MeshFormat::Ply);
    QCOMPARE(formatOf("a.Stl").value(), MeshFormat::Stl);
    QCOMPARE(formatOf("a.off").value(), MeshFormat::Off);
    for (const char* const name : {"a", "a.glb", "obj", ".obj", "a.obj.gz", ""}) {
      QCOMPARE(formatOf(name).error().code, ErrorCode::FormatUnknown);
      QVERIFY(formatOf(name).error().message.ends_with("the name must end in .obj, .ply, .stl or .off"));
    }
    QVERIFY(formatOf("").error().message.starts_with("The mesh file's name is empty"));
    QCOMPARE(readMesh("a.glb", {}).error().code, ErrorCode::FormatUnknown);
    QCOMPARE(writeMesh("a.glb", {}, {}, {}, {}).error().code, ErrorCode::FormatUnknown);
  }

  void polygonsAreDividedInTheOrderOfTheFile() {
    const auto file = mesh_text::obj(
                          "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 3 0\nv 1 1 4\n"
                          "f 1 2 6\nf 1 2 3 4\nf 2 3 6\nf 1 2 3 5 4\nf 3 4 6\n")
                          .value();
    QCOMPARE(file.mesh->faceCount(), 3 + 2 + 3);
    QCOMPARE(file.mesh->face(0), (Face{0, 1, 5}));
    QCOMPARE(file.mesh->face(1), (Face{0, 1, 2}));
    QCOMPARE(file.mesh->face(2), (Face{0, 2, 3}));
    QCOMPARE(file.mesh->face(3), (Face{1, 2, 5}));
    QCOMPARE(file.mesh->face(7), (Face{2, 3, 5}));
    QCOMPARE(file.report.fileFaces, 5U);
    QCOMPARE(file.report.triangulated, 2U);
  }

  void polygonsWithRepeatedOrTooFewCornersAreCounted() {
    const std::string corners = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n";
    const auto report = [&](const char* face) {
      return mesh_text::obj(corners + "f 2 3 4\n" + face + "\n").value().report;
    };
    QCOMPARE(report("f 1 2 2 3").droppedDegenerate, 1U);
    QCOMPARE(report("f 1 2 2 3").triangulated, 0U);
    QCOMPARE(report("f 1 2 3 1").droppedDegenerate, 1U);
    QCOMPARE(mesh_text::off("OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2 0 1\n1 0\n")
                 .value()
                 .report.droppedDegenerate,
             2U);
    QCOMPARE(report("f 1 1 2").droppedDegenerate, 1U);
    QCOMPARE(report("f 1 1 1 1 1").droppedDegenerate, 3U);
    QCOMPARE(report("f 1 2 1 3").droppedDegenerate, 2U);
    QCOMPARE(report("f 1 2 3 3 4").triangulated, 1U);
    QCOMPARE(mesh_text::obj(corners + "f 2 3 4\nf 1 2 2 3\n").value().mesh->faces(),
             (std::vector<Face>{{1, 2, 3}, {0, 1, 2}}));
  }

  void duplicateTrianglesAreDroppedButNotThoseTurnedOver() {
    const auto file = mesh_text::obj(
                          "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 2 1 4\nf 1 2 3\nf 2 3 1\nf 3 2 1\nf 3 1 2\n"
                          "f 4 1 3\n")
                          .value();
    QCOMPARE(file.report.droppedDuplicate, 2U);
    QCOMPARE(file.mesh->faces(), (std::vector<Face>{{1, 0, 3}, {0, 1, 2}, {2, 1, 0}, {3, 0, 2}}));
  }

  void aSoupIsWelded() {
    const auto file = mesh_text::obj(
                          "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\nv 1 0 -0\nv 1 1 0\nv 0 1 0\n"
                          "f 5 6 7\nv 0 0 0\n")
                          .value();
    // Vertices 0 and 7 have no face: they stay, though the last one lies on the first triangle's corner.
    QCOMPARE(file.vertexOfFileVertex, (std::vector<Index>{0, 1, 2, 3, 2, 4, 3, 5}));
    QCOMPARE(file.mesh->faces(), (std::vector<Face>{{1, 2, 3}, {2, 4, 3}}));
    QCOMPARE(file.report.welded, 2U);
    QCOMPARE(file.report.fileVertices, 8U);
    QCOMPARE(file.report.isolated, 2U);
    QCOMPARE(file.mesh->vertexCount(), 6);
    QCOMPARE(file.mesh->twin(1), 5);
  }

  void aSoupOfQuadrilateralsIsWelded() {
    const auto file = mesh_text::off(
                          "OFF\n8 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 0 0\n2 0 0\n2 1 0\n1 1 0\n4 0 1 2 3\n"
                          "4 4 5 6 7\n")
                          .value();
    QCOMPARE(file.mesh->vertexCount(), 6);
    QCOMPARE(file.report.welded, 2U);
  }

  void equalVerticesOfAConnectedMeshStayApart() {
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    const auto shared = mesh_text::obj(points + "f 1 2 3\nf 4 5 6\nf 1 3 5\n").value();
    QCOMPARE(shared.mesh->vertexCount(), 6);
    QCOMPARE(shared.report.welded, 0U);
    QVERIFY(shared.vertexOfFileVertex.empty());
    const auto single = mesh_text::obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0\nf 1 2 3 4\n").value();
    QCOMPARE(single.mesh->vertexCount(), 4);
  }

  void trianglesThatTouchNowhereStayAsTheyAre() {
    const auto file = mesh_text::obj(kTriangle + "v 5 0 0\nv 6 0 0\nv 5 1 0\nf 4 5 6\n").value();
    QCOMPARE(file.mesh->vertexCount(), 6);
    QVERIFY(file.vertexOfFileVertex.empty());
  }

  void doublesSurviveATextBitForBit() {
    const std::vector<Point> points = awkwardPoints();
    const std::vector<Face> faces = {{0, 1, 2}, {2, 1, 3}};
    for (const MeshFormat format : {MeshFormat::Obj, MeshFormat::Ply, MeshFormat::Off}) {
      for (const bool binary : {false, true}) {
        const auto text = formatMesh(format, "x", points, faces, {binary}, {});
        const auto file = parseMesh(text.value(), format, "x", {}).value();
        QVERIFY(sameBits(file.mesh->points(), points));
        QCOMPARE(file.mesh->faces(), faces);
        QCOMPARE(file.report.isolated, points.size() - 4);
        QCOMPARE(file.report.binary, binary && format == MeshFormat::Ply);
      }
    }
    const std::vector<Point> corners(points.begin(), points.begin() + 3);
    const auto stl = formatMesh(MeshFormat::Stl, "x", corners, std::vector<Face>{{0, 1, 2}}, {false}, {});
    QVERIFY(sameBits(parseMesh(stl.value(), MeshFormat::Stl, "x", {}).value().mesh->points(), corners));
  }

  void numbersInTextAreReadAsStrtodReadsThem() {
    std::mt19937_64 random(11);  // NOLINT: the same on every run
    std::vector<std::string> numbers = {"9007199254740993",
                                        "0.9007199254740993",
                                        "00000000000000000000000.5",
                                        "1.",
                                        ".5",
                                        "12345678",
                                        "123456789012345678",
                                        "0.00000001",
                                        "1e-400",
                                        "-0",
                                        "-0.0",
                                        "3.14159265358979323846264338327950288",
                                        "72057594037927937e-20"};
    for (int i = 0; i < 3000; ++i) {
      std::string number = std::to_string(random() >> (random() % 60));
      number.insert(random() % (number.size() + 1), 1, '.');
      if (random() % 2 == 0) {
        number.insert(0, 1, '-');
      }
      numbers.push_back(number);
    }
    for (const std::string& number : numbers) {
      for (const char* const rest : {" 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", " 0 0\nf 1 1 1"}) {
        const auto file = mesh_text::obj("v " + number + rest);
        if (file) {
          const double wanted = std::strtod(number.c_str(), nullptr);
          QVERIFY2(mesh_text::raw(file->mesh->point(0).x()) == mesh_text::raw(wanted), number.c_str());
        } else {
          QCOMPARE(file.error().code, ErrorCode::MeshEmpty);
        }
      }
    }
  }

  void stlHoldsTheFacetsAndTheirNormals() {
    const auto sphere = shapes::icosphere(2);
    for (const bool binary : {true, false}) {
      const auto text =
          formatMesh(MeshFormat::Stl, "x", sphere->points(), sphere->faces(), {binary}, {}).value();
      QCOMPARE(text.starts_with("solid"), !binary);
      const auto file = parseMesh(text, MeshFormat::Stl, "x", {}).value();
      QCOMPARE(file.mesh->vertexCount(), sphere->vertexCount());
      QCOMPARE(file.mesh->faceCount(), sphere->faceCount());
      QCOMPARE(file.report.binary, binary);
    }
    const std::vector<Point> points = {{0, 0, 0}, {0, 1e200, 0}, {0, 0, 1e-200}};
    const auto text =
        formatMesh(MeshFormat::Stl, "x", points, std::vector<Face>{{0, 1, 2}, {0, 1, 1}}, {false}, {});
    QVERIFY(text.value().find("facet normal 1 0 0\n") != std::string::npos);
    QVERIFY(text.value().find("facet normal 0 0 0\n") != std::string::npos);
  }
};

QTEST_APPLESS_MAIN(MeshFileTest)
#include "mesh_file_test.moc"
