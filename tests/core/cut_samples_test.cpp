#include <QtTest>
#include <filesystem>

#include "core/io/mesh_file.h"
#include "core/io/scenario.h"
#include "tests/support/cut_checks.h"
#include "tests/support/loops.h"
#include "tests/support/places.h"

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

void addRows(const std::filesystem::path& folder) {
  QTest::addColumn<QString>("path");
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (formatOf(entry.path()) || entry.path().extension() == ".json") {
      QTest::newRow(entry.path().filename().c_str()) << QString::fromStdString(entry.path().string());
    }
  }
}

}  // namespace

class CutSamplesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyScenariosLoopsHaveTiles_data() { addRows(places::samples() / "scenarios"); }

  void everyScenariosLoopsHaveTiles() {
    QFETCH(QString, path);
    const auto loaded = readScenario(path.toStdString(), {});
    QVERIFY2(loaded.has_value(), loaded ? "" : loaded.error().message.c_str());
    const FusionInputs& inputs = loaded->scenario.inputs;
    for (const PathMode mode : {PathMode::Straightened, PathMode::Paper}) {
      for (const Side side : {Side::Part, Side::Base}) {
        const auto anchored = anchorLoop(side == Side::Part ? inputs.part : inputs.base, inputs.loop, side);
        QVERIFY(anchored.has_value());
        const TriangleMesh& mesh = *anchored->mesh;
        const auto paths = findPaths(mesh, anchored->cvs, mode, side, nullptr, {}, {});
        QVERIFY2(paths.has_value(), paths ? "" : paths.error().message.c_str());
        QCOMPARE(fault(mesh, **paths), QByteArray());
        const auto tile = gatherTile(mesh, cutMesh(mesh, **paths), side, inputs.tile, {});
        QVERIFY2(tile.has_value(), tile ? "" : tile.error().message.c_str());
      }
    }
  }

  void foundPathsBetweenRandomVerticesAreCut_data() { addRows(places::samples() / "models"); }

  void foundPathsBetweenRandomVerticesAreCut() {
    QFETCH(QString, path);
    const auto file = readMesh(path.toStdString(), {});
    const TriangleMesh& mesh = *file->mesh;
    std::mt19937 random(1);
    int found = 0;
    for (int round = 0; round < 30 && found < 8; ++round) {
      std::vector<Index> cvs;
      while (cvs.size() < 3 + static_cast<std::size_t>(round) % 4) {
        const auto v = static_cast<Index>(random() % static_cast<unsigned>(mesh.vertexCount()));
        if (!mesh.singular(v) && std::find(cvs.begin(), cvs.end(), v) == cvs.end()) {
          cvs.push_back(v);
        }
      }
      const PathMode mode = round % 4 == 3 ? PathMode::Paper : PathMode::Straightened;
      const auto paths = findPaths(mesh, cvs, mode, Side::Base, nullptr, {}, {});
      if (paths) {  // else on different components, or the paths cross
        ++found;
        QCOMPARE(fault(mesh, **paths), QByteArray());
        QCOMPARE(fault(mesh, loops::reversed(**paths)), QByteArray());
      }
    }
    QVERIFY(found > 0);
  }

  void randomLoopsOnEverySampleAreCutAndTheirTilesAreDisksOrExplained_data() {
    addRows(places::samples() / "models");
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
