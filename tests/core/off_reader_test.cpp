#include <QtTest>

#include "tests/support/mesh_text.h"

using namespace graftsman;
using mesh_text::off;
using mesh_text::refusal;

class OffReaderTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void readsEveryKindOfHeader() {
    for (const char* const header :
         {"OFF\n3 1 0\n", "OFF 3 1 0\n", "OFF 3 1\n", "OFF\n3 1\n", "OFF\n3 1\n0\n", "3 1 0\n",
          "off\n3 1 0\n", "# c\n\nOFF # d\n# e\n3 1 0 # f\n", "OFF\r\n3 1 0\r\n", "COFF\n3 1 0\n",
          "NOFF 3 1 0\n", "CNOFF 3 1 0\n", "NCOFF 3 1 0\n", "STOFF\n3 1 0\n", "STCNOFF\n3 1 3\n",
          "OFF# c\n3\n1\n0\n"}) {
      const auto file = off(std::string(header) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
      QVERIFY2(file.has_value(), header);
      QCOMPARE(file->mesh->points(), (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
      QCOMPARE(file->mesh->faces(), (std::vector<Face>{{0, 1, 2}}));
    }
  }

  void passesOverWhatFollowsAVertexOrAFace() {
    const auto file = off("STCNOFF\n3 1 0\n0 0 0  0 0 1  255 0 0 255  0.5 0.5\n1 0 0 0 0 1 # c\n\n"
                          "0 1e0 0 1 1 1 1\n# d\n3  0 1 2  0.1 0.2 0.3\n")
                          .value();
    QCOMPARE(file.mesh->points(), (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    QCOMPARE(file.mesh->faces(), (std::vector<Face>{{0, 1, 2}}));
  }

  void readsRowsThatGoOverSeveralLines() {
    const auto file = off("OFF\n3 1 0\n0\n0 0\n1 0\n0\n0 1 0\n3\n0 # c\n1\n2").value();
    QCOMPARE(file.mesh->faces(), (std::vector<Face>{{0, 1, 2}}));
  }

  void refusesOtherKinds() {
    QCOMPARE(
        refusal(off("4OFF\n1 1 1\n")),
        "nose.off:1: files of the kind '4OFF' are not read: their vertices do not have three coordinates");
    QVERIFY(refusal(off("# c\nnOFF 3\n1 1 1\n"))
                .starts_with("nose.off:2: files of the kind 'nOFF' are not read"));
    QVERIFY(refusal(off("STCN4nOFF 3\n1 1 1\n")).starts_with("nose.off:1: files of the kind 'STCN4nOFF'"));
    QCOMPARE(refusal(off("OFF BINARY\n\1\2\3")),
             "nose.off:1: binary OFF files are not read; save the mesh as text");
    QCOMPARE(refusal(off("solid OFF")), "nose.off:1: expected the keyword OFF, found 'solid'");
    QCOMPARE(refusal(off("XOFF 3 1 0")), "nose.off:1: expected the keyword OFF, found 'XOFF'");
    QCOMPARE(refusal(off("-3 1 0")), "nose.off:1: expected the keyword OFF, found '-3'");
  }

  void refusesCountsThatTheFileHasNoRoomFor() {
    QCOMPARE(refusal(off("OFF\n4000000000 1 0\n0 0 0\n")),
             "nose.off:2: the header declares 4000000000 vertices and 1 faces, too many for a file of 25 "
             "bytes; is "
             "it cut off?");
    QVERIFY(
        refusal(off("OFF\n1 99999999999999999999 0\n0 0 0\n"))
            .starts_with("nose.off:2: the header declares 1 vertices and 99999999999999999999 faces, too"));
    QVERIFY(refusal(off("OFF\n300000000000000000000000 99999999999999999999 0\n0 0 0\n"))
                .starts_with("nose.off:2: the header declares 30000000000000000000... vertices and"));
    QCOMPARE(refusal(off("OFF\n-1 1 0\n0 0 0\n")), "nose.off:2: expected the number of vertices, found '-1'");
    QCOMPARE(refusal(off("OFF\n3")), "nose.off:2: expected the number of faces, found the end of the file");
  }

  void namesTheLineOfABrokenRow() {
    const std::string start = "OFF\n3 1 0\n0 0 0\n1 0 0\n";
    QCOMPARE(refusal(off(start + "0 x 0\n3 0 1 2\n")),
             "nose.off:5: expected the y coordinate of vertex 2, found 'x'");
    QCOMPARE(refusal(off(start + "0 inf 0\n3 0 1 2\n")),
             "nose.off:5: the y coordinate of vertex 2 is 'inf', which is not a finite number");
    QCOMPARE(refusal(off(start + "0 1 0\n3 0 1 3\n")),
             "nose.off:6: face 0 refers to vertex 3, but the file has 3 vertices, counted from 0");
    QCOMPARE(refusal(off(start + "0 1 0\n3 0 1 -1\n")),
             "nose.off:6: face 0 refers to vertex -1, but the file has 3 vertices, counted from 0");
    QCOMPARE(refusal(off(start + "0 1 0\n3 0 1\n")),
             "nose.off:7: expected a vertex number of face 0, found the end of the file");
    QCOMPARE(refusal(off(start + "0 1 0\nx 0 1\n")),
             "nose.off:6: expected the number of corners of face 0, found 'x'");
    QCOMPARE(refusal(off(start + "0 1 0\n3 0 1 99999999999999999999\n")),
             "nose.off:6: face 0 refers to vertex 99999999999999999999, but the file has 3 vertices, counted "
             "from 0");
    QVERIFY(refusal(off(start + "0 1 0\n99999999999999999999 0 1 2\n"))
                .starts_with("nose.off:6: face 0 declares 99999999999999999999 corners"));
    QVERIFY(refusal(off(start + "0 1 0\n999999999 0 1 2\n"))
                .starts_with("nose.off:6: face 0 declares 999999999 corners"));
  }
};

QTEST_APPLESS_MAIN(OffReaderTest)
#include "off_reader_test.moc"
