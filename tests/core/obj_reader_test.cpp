#include <QtTest>

#include "tests/support/mesh_text.h"

using namespace graftsman;
using mesh_text::obj;
using mesh_text::refusal;

namespace {
const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
}

class ObjReaderTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void readsVerticesAndFacesInOrder() {
    const auto file = obj(kCorners + "f 1 2 3\nf 2 4 3\n").value();
    QCOMPARE(file.mesh->points(), (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
    QCOMPARE(file.mesh->faces(), (std::vector<Face>{{0, 1, 2}, {1, 3, 2}}));
    QCOMPARE(file.report.fileVertices, 4U);
    QCOMPARE(file.report.fileFaces, 2U);
    QVERIFY(file.vertexOfFileVertex.empty());
    QVERIFY(!file.report.binary);
  }

  void readsEveryFormOfACorner() {
    for (const char* const face :
         {"f 1/1 2/2 3/3", "f 1//7 2//8 3//9", "f 1/1/1 2/2/2 3/3/3", "f 1/ 2/ 3/", "f -4 -3 -2",
          "f -4/1/-1 2 -2//5", "f\t1\t2\t3\t", "f +1 2 3", "fo 1 2 3", "f 1 2 3 # the last", "f 1 2 3#",
          "f 1 \\\n 2 3", "f 1 2\\\r\n3", "f\\\n1 2 3", "f 000000000000001 2 3"}) {
      const auto file = obj(kCorners + face + "\n");
      QVERIFY2(file.has_value(), face);
      QCOMPARE(file->mesh->faces(), (std::vector<Face>{{0, 1, 2}}));
    }
  }

  void countsNegativeNumbersFromTheVerticesSoFar() {
    const auto file = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -4 -3 -1\n").value();
    QCOMPARE(file.mesh->faces(), (std::vector<Face>{{0, 1, 2}, {0, 1, 3}}));
  }

  void readsFacesThatComeBeforeTheirVertices() {
    QCOMPARE(obj("f 1 2 3\n" + kCorners).value().mesh->faces(), (std::vector<Face>{{0, 1, 2}}));
  }

  void readsEveryFormOfAVertex() {
    for (const char* const vertex :
         {"v 0.5 -0.25 1e3", "v 0.5 -.25 1000.", "v  5e-1\t-2.5E-1 +1e+3 1.0", "v 0.5 -0.25 1000 1 0 0",
          "v 0.5 -0.25 1000 0.1 0.2 0.3 1", "v 0.5 \\\n-0.25 1000", "v\\\n.5 -0.25 1000",
          "v 0.5 -0.25 1000 # a comment \\", "v 0.5 -0.25 1000#"}) {
      const auto file = obj(std::string(vertex) + "\nv 1 0 0\nv 0 1 0\nf 1 2 3");
      QVERIFY2(file.has_value(), vertex);
      QCOMPARE(file->mesh->point(0), Point(0.5, -0.25, 1000));
    }
  }

  void readsEveryKindOfLineEnd() {
    for (const char* const end : {"\n", "\r\n", "\r", "\n\n", " \n", "\t\r\n"}) {
      std::string text;
      for (const char* const line : {"v 0 0 0", "v 1 0 0", "v 0 1 0", "f 1 2 3"}) {
        text += std::string(line) + end;
      }
      QCOMPARE(obj(text).value().mesh->faces(), (std::vector<Face>{{0, 1, 2}}));
      text.erase(text.find_last_not_of(" \t\r\n") + 1);
      QCOMPARE(obj(text).value().mesh->faces(), (std::vector<Face>{{0, 1, 2}}));
    }
  }

  void passesOverEverythingElse() {
    const auto file = obj("# comment\nmtllib a b.mtl\no thing\n" + kCorners +
                          "vt 0 0\nvn 0 0 1\nvp 1 2\ng a b\ns off\nusemtl x\\y\nl 1 2\np 1 2 3\n"
                          "curv 0 1 \\\n 2 3\n  f 1 2 3\n\xff\xfe\n\nfoo\nvv 1\n# the end\\")
                          .value();
    QCOMPARE(file.mesh->vertexCount(), 4);
    QCOMPARE(file.mesh->faces(), (std::vector<Face>{{0, 1, 2}}));
    QCOMPARE(file.report.isolated, 1U);
  }

  void aBackslashAtTheEndOfACommentContinuesNothing() {
    QCOMPARE(obj("# C:\\models\\\nv 7 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3").value().mesh->point(0),
             Point(7, 0, 0));
  }

  void namesTheLineOfABrokenVertex() {
    QCOMPARE(refusal(obj("v 0 0 0\nv 1 nose 0\n")),
             "nose.obj:2: expected the y coordinate of vertex 2, found 'nose'");
    QCOMPARE(refusal(obj("\r\n\r\nv 0 0\r\nf 1 1 1")),
             "nose.obj:3: expected the z coordinate of vertex 1, found the end of the line");
    QCOMPARE(refusal(obj("v 0 0")),
             "nose.obj:1: expected the z coordinate of vertex 1, found the end of the file");
    QCOMPARE(refusal(obj("v 1,5 0 0")), "nose.obj:1: expected the x coordinate of vertex 1, found '1,5'");
    QCOMPARE(refusal(obj("v 0x10 0 0")), "nose.obj:1: expected the x coordinate of vertex 1, found '0x10'");
    QCOMPARE(refusal(obj("v 1 \x1b[31m2 3")),
             "nose.obj:1: expected the y coordinate of vertex 1, found '\\x1b[31m2'");
  }

  void refusesCoordinatesThatAreNotFinite() {
    for (const char* const number : {"nan", "NaN", "inf", "-inf", "infinity", "1e999", "-1e400"}) {
      QCOMPARE(refusal(obj(kCorners + "v 0 " + number + " 0\n")),
               "nose.obj:5: the y coordinate of vertex 5 is '" + std::string(number) +
                   "', which is not a finite number");
    }
  }

  void namesTheLineOfABrokenFace() {
    QCOMPARE(refusal(obj(kCorners + "f 1 2 3\nf 1 2 9123\n" + "v 9 9 9\n")),
             "nose.obj:6: a face refers to vertex 9123, but the file has 5 vertices");
    QCOMPARE(refusal(obj("f 1 2 99999999999999999999999999\n" + kCorners)),
             "nose.obj:1: a face refers to vertex 99999999999999999999..., but the file has 4 vertices");
    QCOMPARE(refusal(obj("f 1 2 4294967297\n" + kCorners)),
             "nose.obj:1: a face refers to vertex 4294967297, but the file has 4 vertices");
    QCOMPARE(refusal(obj(kCorners + "\\\n\nf 0 1 2\n")),
             "nose.obj:7: a face refers to vertex 0, but OBJ counts vertices from 1");
    QCOMPARE(refusal(obj(kCorners + "f -5 1 2\n")),
             "nose.obj:5: a face refers to vertex -5, but the file has 4 vertices so far");
    QCOMPARE(refusal(obj(kCorners + "f 1 \\\n 2 x3\n")), "nose.obj:6: expected a vertex number, found 'x3'");
    QCOMPARE(refusal(obj(kCorners + "f 1 2 3.5\n")), "nose.obj:5: expected a vertex number, found '3.5'");
    QCOMPARE(refusal(obj(kCorners + "f \n")), "nose.obj:5: the face has no corner");
    QCOMPARE(refusal(obj(kCorners + "f 1 2 3\nf 1 2")),
             "nose.obj:6: the face has 2 corners, but a face needs 3 or more; is the file cut off?");
    QCOMPARE(refusal(obj(kCorners + "f 1 \\\n# 2 3\n")),
             "nose.obj:5: the face has 1 corner, but a face needs 3 or more; is the file cut off?");
  }

  void aFileWithoutFacesIsEmpty() {
    const auto file = obj(kCorners);
    QCOMPARE(file.error().code, ErrorCode::MeshEmpty);
    QCOMPARE(file.error().message, "nose.obj: the file has 4 vertices, but no face");
    QCOMPARE(obj(kCorners + "f 1 1 2\nf 2 1 2\n").error().message,
             "nose.obj: the file has 4 vertices, but no face with three different corners");
  }

  void aFileWithoutVerticesAndFacesIsNoObjFile() {
    for (const char* const text : {"\x7f\x45\x4c\x46\x02\n\xff", "hello world\n", "# a comment\n", " \n"}) {
      const auto file = obj(text);
      QCOMPARE(file.error().code, ErrorCode::FileMalformed);
      QCOMPARE(file.error().message,
               "nose.obj: does not look like an OBJ file: it has no line with a vertex (v) or a face (f)");
    }
  }
};

QTEST_APPLESS_MAIN(ObjReaderTest)
#include "obj_reader_test.moc"
