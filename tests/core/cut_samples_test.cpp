#include <QtTest>
#include <filesystem>

#include "core/io/mesh_file.h"
#include "tests/support/cut_checks.h"
#include "tests/support/loops.h"

using namespace graftsman;

namespace {

/// What gatherTile() must find, from the divided mesh as a whole, without its view of mesh and cut.
std::optional<ErrorCode> expectedError(const TriangleMesh& mesh, const Cut& cut) {
  const TriangleMesh divided = checks::dividedMesh(mesh, cut);
  std::vector<bool> wall(static_cast<std::size_t>(divided.halfedgeCount()), false);
  std::vector<Index> open;
  std::vector<Index> right;
  for (std::size_t i = 0; i < cut.boundary.size(); ++i) {
    const Index h = divided.halfedgeBetween(cut.boundary[i], cut.boundary[(i + 1) % cut.boundary.size()]);
    if (h < 0) {
      return ErrorCode::TileEmpty;
    }
    open.push_back(h / 3);
    wall[checks::at(h)] = true;
    if (const Index t = divided.twin(h); t >= 0) {
      right.push_back(t / 3);
      wall[checks::at(t)] = true;
    }
  }
  std::vector<bool> inside(static_cast<std::size_t>(divided.faceCount()), false);
  std::vector<Face> faces;
  while (!open.empty()) {
    const Index f = open.back();
    open.pop_back();
    if (inside[checks::at(f)]) {
      continue;
    }
    inside[checks::at(f)] = true;
    faces.push_back(divided.face(f));
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      if (!wall[checks::at(h)] && divided.twin(h) >= 0) {
        open.push_back(divided.twin(h) / 3);
      }
    }
  }
  if (std::any_of(right.begin(), right.end(), [&](Index f) { return inside[checks::at(f)]; })) {
    return ErrorCode::TileNotSeparated;
  }
  for (const Face& face : faces) {
    if (std::any_of(face.begin(), face.end(), [&](Index v) { return divided.singular(v); })) {
      return ErrorCode::TileNotManifold;
    }
  }
  const TriangleMesh region(divided.points(), std::move(faces));
  if (checks::borderEdges(region) != std::ssize(cut.boundary)) {
    return ErrorCode::TileHasHole;
  }
  if (checks::eulerCharacteristic(region) != 1) {
    return ErrorCode::TileHasHandle;
  }
  return {};
}

QByteArray fault(const TriangleMesh& mesh, const LoopPaths& paths) {
  const Cut cut = cutMesh(mesh, paths);
  if (const std::string wrong = checks::cutFault(mesh, paths, cut); !wrong.empty()) {
    return QByteArray::fromStdString(wrong);
  }
  const auto tile = gatherTile(mesh, cut, Side::Part, {}, {});
  const auto expected = expectedError(mesh, cut);
  if (tile.has_value() == expected.has_value() || (expected && tile.error().code != *expected)) {
    return QByteArray::fromStdString(tile ? "a tile where none is"
                                          : "not the expected error: " + tile.error().message);
  }
  return tile ? QByteArray::fromStdString(checks::tileFault(mesh, cut, *tile)) : QByteArray();
}

}  // namespace

class CutSamplesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void randomLoopsOnEverySampleAreCutAndTheirTilesAreDisksOrExplained_data() {
    QTest::addColumn<QString>("path");
    for (const auto& entry : std::filesystem::directory_iterator(GRAFTSMAN_SAMPLES "/models")) {
      if (formatOf(entry.path())) {
        QTest::newRow(entry.path().filename().c_str()) << QString::fromStdString(entry.path().string());
      }
    }
  }

  void randomLoopsOnEverySampleAreCutAndTheirTilesAreDisksOrExplained() {
    QFETCH(QString, path);
    const auto file = readMesh(path.toStdString(), {});
    QVERIFY2(file.has_value(), file ? "" : file.error().message.c_str());
    for (unsigned seed = 0; seed < 12; ++seed) {
      const loops::AnchoredLoopPaths loop = loops::randomLoop(file->mesh, seed);
      QVERIFY(!loop.paths.paths.empty());
      QCOMPARE(fault(*loop.mesh, loop.paths), QByteArray());
      QCOMPARE(fault(*loop.mesh, loops::reversed(loop.paths)), QByteArray());
    }
  }
};

QTEST_APPLESS_MAIN(CutSamplesTest)
#include "cut_samples_test.moc"
