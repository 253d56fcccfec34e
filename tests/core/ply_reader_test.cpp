#include <QtTest>

#include "tests/support/mesh_text.h"

using namespace graftsman;
using mesh_text::ply;
using mesh_text::raw;
using mesh_text::refusal;

namespace {

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kList = "property list uchar int vertex_indices\n";

std::string header(const std::string& format, const std::string& elements) {
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}

std::string ascii(const std::string& elements, const std::string& body) {
  return header("ascii", elements) + body;
}

const std::string kTriangle = "element vertex 3\n" + kXyz + "element face 1\n" + kList;
const std::vector<Point> kTrianglePoints = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

// One coordinate as the type that PLY calls `type`.
std::string scalar(const std::string& type, double value, bool swapped) {
  if (type == "char" || type == "int8") {
    return raw(static_cast<std::int8_t>(value), swapped);
  }
  if (type == "uchar" || type == "uint8") {
    return raw(static_cast<std::uint8_t>(value), swapped);
  }
  if (type == "short" || type == "int16") {
    return raw(static_cast<std::int16_t>(value), swapped);
  }
  if (type == "ushort" || type == "uint16") {
    return raw(static_cast<std::uint16_t>(value), swapped);
  }
  if (type == "int" || type == "int32") {
    return raw(static_cast<std::int32_t>(value), swapped);
  }
  if (type == "uint" || type == "uint32") {
    return raw(static_cast<std::uint32_t>(value), swapped);
  }
  if (type == "float" || type == "float32") {
    return raw(static_cast<float>(value), swapped);
  }
  return raw(value, swapped);
}

}  // namespace

class PlyReaderTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void readsText() {
    const auto file = ply(ascii(kTriangle, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")).value();
    QCOMPARE(file.mesh->points(), kTrianglePoints);
    QCOMPARE(file.mesh->faces(), (std::vector<Face>{{0, 1, 2}}));
    QVERIFY(!file.report.binary);
  }

  void readsTextWithAnyLineEnd() {
    const std::string text = ascii(kTriangle, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2");
    for (const char* const end : {"\r\n", "\r"}) {
      QString other = QString::fromStdString(text);
      other.replace("\n", end);
      QCOMPARE(ply(other.toStdString()).value().mesh->points(), kTrianglePoints);
    }
  }

  void readsBothBinaryOrdersAndEveryTypeOfCoordinate() {
    for (const char* const type :
         {"char", "int8", "uchar", "uint8", "short", "int16", "ushort", "uint16", "int", "int32", "uint",
          "uint32", "float", "float32", "double", "float64"}) {
      for (const bool big : {false, true}) {
        std::string text = header(big ? "binary_big_endian" : "binary_little_endian",
                                  "element vertex 3\nproperty " + std::string(type) + " x\nproperty " + type +
                                      " y\nproperty " + type + " z\nelement face 1\n" + kList);
        for (const double c : {0, 0, 0, 1, 0, 0, 0, 1, 100}) {
          text += scalar(type, c, big);
        }
        text += "\3" + raw(0, big) + raw(1, big) + raw(2, big);
        const auto file = ply(text);
        QVERIFY2(file.has_value(), type);
        QCOMPARE(file->mesh->points(), (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 100}}));
        QCOMPARE(file->mesh->faces(), (std::vector<Face>{{0, 1, 2}}));
        QVERIFY(file->report.binary);
      }
    }
  }

  void readsEveryTypeOfCountAndCorner() {
    for (const char* const count : {"char", "uchar", "short", "ushort", "int", "uint"}) {
      for (const char* const corner :
           {"char", "uchar", "short", "ushort", "int", "uint", "float", "double"}) {
        for (const bool big : {false, true}) {
          std::string text = header(big ? "binary_big_endian" : "binary_little_endian",
                                    "element face 2\nproperty list " + std::string(count) + " " + corner +
                                        " vertex_index\nelement vertex 4\n" + kXyz);
          for (const int k : {3, 4}) {
            text += scalar(count, k, big);
            for (int i = 0; i < k; ++i) {
              text += scalar(corner, i, big);
            }
          }
          for (const float c : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) {
            text += raw(c, big);
          }
          const auto file = ply(text);
          QVERIFY2(file.has_value(), file ? "" : file.error().message.c_str());
          QCOMPARE(file->mesh->faces(), (std::vector<Face>{{0, 1, 2}, {0, 2, 3}}));
          QCOMPARE(file->report.fileFaces, 2U);
          QCOMPARE(file->report.droppedDuplicate, 1U);
        }
      }
    }
  }

  void passesOverOtherElementsAndProperties() {
    const std::string elements =
        "comment c\nobj_info i\nelement material 1\nproperty list uchar float l\nproperty int n\nelement "
        "empty 7\n"
        "element vertex 3\nproperty uchar red\nproperty float x\nproperty list int short a\nproperty float "
        "y\n"
        "property float z\nproperty float nx\nelement face 1\nproperty int flags\n" +
        kList +
        "property list uchar float texcoord\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n";
    const auto text = ply(ascii(elements,
                                "2 0.5 0.5 9\n255 0 0 0 0 1\n255 1 2 8 9 0 0 1\n255 0 1 5 1 0 1\n"
                                "77 3 0 1 2 6 0 0 0 0 0 0\n0 1\n"));
    QCOMPARE(text.value().mesh->points(), kTrianglePoints);
    QCOMPARE(text.value().mesh->faces(), (std::vector<Face>{{0, 1, 2}}));

    std::string body = "\2" + raw(0.5F) + raw(0.5F) + raw(9);
    for (const Point& p : kTrianglePoints) {
      body += "\7" + raw(static_cast<float>(p.x())) + raw(2) + raw(std::int16_t{1}) + raw(std::int16_t{2}) +
              raw(static_cast<float>(p.y())) + raw(static_cast<float>(p.z())) + raw(1.0F);
    }
    body += raw(77) + "\3" + raw(0) + raw(1) + raw(2) + "\1" + raw(0.5F) + raw(0) + raw(1);
    const auto binary = ply(header("binary_little_endian", elements) + body);
    QCOMPARE(binary.value().mesh->points(), kTrianglePoints);
    QCOMPARE(binary.value().mesh->faces(), (std::vector<Face>{{0, 1, 2}}));
  }

  void widensFloatsExactly() {
    const float third = 1.0F / 3;
    std::string body = raw(third) + raw(-0.0F) + raw(1e-40F);
    body += raw(1.0F) + raw(0.0F) + raw(0.0F) + raw(0.0F) + raw(1.0F) + raw(0.0F);
    const auto file = ply(header("binary_little_endian", kTriangle) + body + "\3" + raw(0) + raw(1) + raw(2));
    const Point& p = file.value().mesh->point(0);
    QCOMPARE(raw(p.x()), raw(static_cast<double>(third)));
    QCOMPARE(raw(p.y()), raw(-0.0));
    QCOMPARE(raw(p.z()), raw(static_cast<double>(1e-40F)));
  }

  void aBodyMayBeginWithAnyByte() {
    for (const char* const end : {"\n", "\r\n", "\r"}) {
      QString head =
          QString::fromStdString(header("binary_little_endian",
                                        "element vertex 3\nproperty uchar x\nproperty uchar y\nproperty "
                                        "uchar z\nelement face 1\nproperty list uchar uchar vertex_index\n"));
      head.replace("\n", end);
      const auto file = ply(head.toStdString() + "\n\r\n" + "\r\n\r" + "\1\1\1" + std::string("\3\0\1\2", 4));
      QCOMPARE(file.value().mesh->points(), (std::vector<Point>{{10, 13, 10}, {13, 10, 13}, {1, 1, 1}}));
    }
  }

  void refusesABrokenHeader() {
    QCOMPARE(refusal(ply("plx\n")), "nose.ply:1: a PLY file begins with 'ply', this one with 'plx'");
    QCOMPARE(refusal(ply("ply\nformat ascii 1.0\n")), "nose.ply:3: the header has no 'end_header'");
    QCOMPARE(refusal(ply("ply\nformat xml 1.0\n")), "nose.ply:2: unknown PLY format 'xml'");
    QCOMPARE(refusal(ply("ply\nelement vertex 3\n" + kXyz + "end_header\n")),
             "nose.ply:6: the header has no 'format'");
    QCOMPARE(refusal(ply(header("ascii", "foo\n"))), "nose.ply:3: unknown keyword 'foo' in the header");
    QCOMPARE(refusal(ply(header("ascii", "property int x\n"))),
             "nose.ply:3: a property comes before the first element");
    QCOMPARE(refusal(ply(header("ascii", "element vertex x\n"))),
             "nose.ply:3: expected 'element NAME COUNT', found a count 'x'");
    QVERIFY(!refusal(ply(header("ascii", "element vertex -3\n"))).empty());
    QCOMPARE(refusal(ply(header("ascii", "element vertex 0\nproperty quad x\n"))),
             "nose.ply:4: unknown type 'quad' of a property");
    QCOMPARE(refusal(ply(header("ascii", "element face 0\nproperty list float int vertex_index\n"))),
             "nose.ply:4: 'float' is no integer type for a list's length");
    QCOMPARE(refusal(ply(header("ascii", "element a 0\nelement a 0\n"))),
             "nose.ply:4: the element 'a' is declared twice");
    QCOMPARE(refusal(ply(header("ascii", "element face 0\n" + kList))),
             "nose.ply:6: the header declares no element 'vertex'");
    QCOMPARE(refusal(ply(header("ascii", "element vertex 0\nproperty float x\nproperty float y\n"))),
             "nose.ply:3: the element 'vertex' must have one property 'z', it has 0");
    QVERIFY(!refusal(ply(header("ascii", "element vertex 0\n" + kXyz + "property int x\n"))).empty());
    QCOMPARE(refusal(ply(header("ascii", "element vertex 0\n" + kXyz + "element face 0\n" + kList + kList))),
             "nose.ply:7: the element 'face' has two lists of vertices");
    QCOMPARE(refusal(ply(header("ascii", "element vertex 0\n" + kXyz +
                                             "element tristrips 0\nproperty list int int vertex_indices\n"))),
             "nose.ply:7: the file holds triangle strips, which are not read; save it with faces");
    std::string many = "element vertex 0\n";
    for (int i = 0; i <= 1000; ++i) {
      many += "property int a\n";
    }
    QCOMPARE(refusal(ply(header("ascii", many))), "nose.ply:1004: more than 1000 properties");
  }

  void refusesCountsThatTheFileHasNoRoomFor() {
    QCOMPARE(refusal(ply(header("binary_little_endian", "element vertex 4000000000\n" + kXyz))),
             "nose.ply:3: the header declares 4000000000 elements 'vertex', too many for a file of 124 "
             "bytes; is it cut "
             "off?");
    QVERIFY(
        refusal(ply(header("ascii", "element vertex 99999999999999999999\n" + kXyz)))
            .starts_with("nose.ply:3: the header declares 99999999999999999999 elements 'vertex', too many"));
    QVERIFY(!refusal(ply(ascii("element vertex 3\n" + kXyz + "element face 99999999999999\n" + kList,
                               "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")))
                 .empty());
    QVERIFY(refusal(ply(ascii(kTriangle, "0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n")))
                .starts_with("nose.ply:13: 'vertex_indices' of 'face' 0 declares 2000000000 items"));
    QVERIFY(!refusal(ply(ascii(kTriangle, "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n"))).empty());
    // Rows without a byte do not take time, either.
    QVERIFY(ply(ascii("element nothing 9000000000000000000\n" + kTriangle, "0 0 0 1 0 0 0 1 0 3 0 1 2"))
                .has_value());
  }

  void namesTheLineOfABrokenText() {
    QCOMPARE(refusal(ply(ascii(kTriangle, "0 0 0\n1 a 0\n0 1 0\n3 0 1 2\n"))),
             "nose.ply:11: expected a value of 'y' of 'vertex' 1, found 'a'");
    QCOMPARE(refusal(ply(ascii(kTriangle, "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"))),
             "nose.ply:11: the coordinate y of vertex 1 is not a finite number");
    QCOMPARE(refusal(ply(ascii(kTriangle, "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"))),
             "nose.ply:13: face 0 refers to vertex 3, but the file has 3 vertices, counted from 0");
    QCOMPARE(refusal(ply(ascii(kTriangle, "0 0 0\n1 0 0\n0 1 0\n3 0 -1 2\n"))),
             "nose.ply:13: face 0 refers to vertex -1, but the file has 3 vertices, counted from 0");
    QCOMPARE(refusal(ply(ascii(kTriangle, "0 0 0\n1 0 0\n0 1 0\n3 0 1.5 2\n"))),
             "nose.ply:13: face 0 refers to a vertex number that is no integer, but the file has 3 vertices, "
             "counted "
             "from 0");
    QCOMPARE(refusal(ply(ascii(kTriangle, "0 0 0\n1 0 0\n0 1 0\n3 0 1\n"))),
             "nose.ply:14: expected a value of 'vertex_indices' of 'face' 0, the file ends there");
  }

  void namesTheByteOfABrokenBinary() {
    const std::string head = header("binary_little_endian", kTriangle);
    std::string points;
    for (const Point& p : kTrianglePoints) {
      points +=
          raw(static_cast<float>(p.x())) + raw(static_cast<float>(p.y())) + raw(static_cast<float>(p.z()));
    }
    const std::size_t face = head.size() + points.size();
    QCOMPARE(refusal(ply(head + points + "\3" + raw(0) + raw(7) + raw(2))),
             "nose.ply: byte " + std::to_string(face + 5) +
                 ": face 0 refers to vertex 7, but the file has 3 vertices, counted from 0");
    QCOMPARE(
        refusal(ply(head + points + "\3" + raw(0) + raw(1))),
        "nose.ply: byte " + std::to_string(face) +
            ": 'vertex_indices' of 'face' 0 declares 3 items; the rest of the file has no room for them");
    std::string infinite = points;
    infinite.replace(16, 4, raw(std::numeric_limits<float>::infinity()));
    QCOMPARE(refusal(ply(head + infinite + "\3" + raw(0) + raw(1) + raw(2))),
             "nose.ply: byte " + std::to_string(head.size() + 16) +
                 ": the coordinate y of vertex 1 is not a finite number");
  }

  void aFileWithoutFacesIsEmpty() {
    QCOMPARE(ply(ascii("element vertex 1\n" + kXyz, "0 0 0\n")).error().code, ErrorCode::MeshEmpty);
  }
};

QTEST_APPLESS_MAIN(PlyReaderTest)
#include "ply_reader_test.moc"
