#include "core/fusion/blend.h"

#include <QtTest>
#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <new>
#include <numeric>
#include <random>

#include "core/base/parallel.h"

using namespace graftsman;

namespace {
std::atomic<std::size_t> allocations = 0;
}

// Counts what the program takes from the heap. Not inlined: GCC 14 takes an inlined free() for a mismatch
// with new.
void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size > 0 ? size : 1)) {
    return memory;
  }
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace {

CombinedTile randomTile(std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  std::uniform_real_distribution<double> position(-10, 10);
  CombinedTile tile;
  for (std::size_t i = 0; i < count; ++i) {
    tile.part.emplace_back(position(random), position(random), position(random));
    tile.base.emplace_back(position(random), position(random), position(random));
    tile.s.push_back(i % 100 == 0 ? 0 : unit(random));
  }
  return tile;
}

std::vector<Index> identity(std::size_t count) {
  std::vector<Index> target(count);
  std::iota(target.begin(), target.end(), 0);
  return target;
}

bool sameBits(const Point& a, const Point& b) {
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) {
      return false;
    }
  }
  return true;
}

FCF constant(double f) {
  return FCF::through({{0, f}, {0.3, f}, {0.6, f}, {1, f}}).value();
}

}  // namespace

class BlendTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { setThreadCount(0); }

  void everyVertexIsTheWeightedMeanOfItsTwoPositions() {
    const CombinedTile tile = randomTile(1000);
    const FCF f = FCF::preset(FCF::Preset::KeepBaseSlope);
    std::vector<Point> out(1000);
    blend(tile, f, identity(1000), out);
    for (std::size_t i = 0; i < 1000; ++i) {
      const double w = f(tile.s[i]);
      QVERIFY((out[i] - (w * tile.part[i] + (1 - w) * tile.base[i])).norm() <= 1e-14);
    }
  }

  void whereTheCurveIsZeroTheBaseComesBackBitForBit() {
    CombinedTile tile = randomTile(1000);
    tile.base[3] = Point(-0.0, 1e-320, 0.1);
    std::vector<Point> out(1000);
    blend(tile, constant(0), identity(1000), out);
    for (std::size_t i = 0; i < 1000; ++i) {
      QVERIFY(sameBits(out[i], tile.base[i]));
    }
  }

  void whereTheCurveIsOneThePartComesBackBitForBit() {
    CombinedTile tile = randomTile(1000);
    tile.part[3] = Point(-0.0, 1e-320, 0.1);
    std::vector<Point> out(1000);
    blend(tile, constant(1), identity(1000), out);
    for (std::size_t i = 0; i < 1000; ++i) {
      QVERIFY(sameBits(out[i], tile.part[i]));
    }
    blend(tile, FCF::preset(FCF::Preset::Paste), identity(1000), out);
    for (std::size_t i = 0; i < 1000; ++i) {
      QVERIFY(tile.s[i] < 0.08 || sameBits(out[i], tile.part[i]));
      QVERIFY(tile.s[i] != 0 || sameBits(out[i], tile.base[i]));
    }
  }

  void onlyTheTargetsAreWritten() {
    const CombinedTile tile = randomTile(3);
    const Point untouched(-0.0, 2, 3);
    std::vector<Point> out(6, untouched);
    blend(tile, constant(0), std::vector<Index>{4, 0, 2}, out);
    QVERIFY(sameBits(out[4], tile.base[0]));
    QVERIFY(sameBits(out[0], tile.base[1]));
    QVERIFY(sameBits(out[2], tile.base[2]));
    for (const std::size_t i : {1U, 3U, 5U}) {
      QVERIFY(sameBits(out[i], untouched));
    }
  }

  void whereTheVerticesGoDoesNotChangeTheirBits() {
    const std::size_t count = 3000;
    const CombinedTile tile = randomTile(count);
    const FCF f = FCF::preset(FCF::Preset::Paste);
    std::vector<Point> inOrder(count);
    blend(tile, f, identity(count), inOrder);
    std::vector<Index> target = identity(count);
    std::shuffle(target.begin() + 600, target.end(), std::mt19937(9));
    std::vector<Point> out(count);
    blend(tile, f, target, out);
    for (std::size_t i = 0; i < count; ++i) {
      QVERIFY(sameBits(out[static_cast<std::size_t>(target[i])], inOrder[i]));
    }
  }

  void anEmptyTileIsNothingToDo() {
    std::vector<Point> out(1, Point(1, 2, 3));
    blend(CombinedTile(), FCF(), {}, out);
    QVERIFY(sameBits(out[0], Point(1, 2, 3)));
  }

  void aCurveDragAllocatesNothingForItsVertices() {
    const std::size_t count = 200000;
    const CombinedTile tile = randomTile(count);
    const std::vector<Index> target = identity(count);
    const FCF f = FCF::preset(FCF::Preset::KeepBaseSlope);
    std::vector<Point> out(count);
    const std::size_t before = allocations;
    blend(tile, f, target, out);
    QCOMPARE(allocations - before, std::size_t{0});
  }

  void theThreadsDoNotChangeTheBits() {
    const std::size_t count = 600001;
    const CombinedTile tile = randomTile(count);
    const std::vector<Index> target = identity(count);
    const FCF f = FCF::preset(FCF::Preset::Linear);
    std::vector<Point> one(count);
    std::vector<Point> many(count);
    setThreadCount(1);
    blend(tile, f, target, one);
    setThreadCount(4);
    blend(tile, f, target, many);
    for (std::size_t i = 0; i < count; ++i) {
      QVERIFY(sameBits(one[i], many[i]));
    }
  }
};

QTEST_APPLESS_MAIN(BlendTest)
#include "blend_test.moc"
