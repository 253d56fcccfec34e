#include <QtTest>
#include <limits>

#include "core/base/parallel.h"
#include "core/base/predicates.h"
#include "core/fusion/embedding.h"
#include "tests/support/embedding_checks.h"
#include "tests/support/embedding_tiles.h"
#include "tests/support/shapes.h"
#include "tests/support/tiles.h"

using namespace graftsman;

namespace {

/// Pleats far higher than the triangles are wide: slivers, angles near π.
DiscTile pleatedDisc() {
  std::mt19937 random(11);
  return shapes::rings(shapes::discSizes(14), 5, [&](double depth, double angle) {
    const double z = static_cast<double>(random() % 1001) / 1000;
    return Point((1 - depth) * std::cos(angle), (1 - depth) * std::sin(angle), 0.6 * z * z * z);
  });
}

/// Mean distance of the vertices first, first + 1, … of a ring from their middle.
double ringRadius(const Embedding& e, Index first, Index around) {
  Point2 middle = Point2::Zero();
  for (Index i = 0; i < around; ++i) {
    middle += e.uv[static_cast<std::size_t>(first + i)] / around;
  }
  double sum = 0;
  for (Index i = 0; i < around; ++i) {
    sum += (e.uv[static_cast<std::size_t>(first + i)] - middle).norm() / around;
  }
  return sum;
}

}  // namespace

class EmbeddingMethodsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void bumpyTilesEmbedByEveryMethod() {
    for (const unsigned seed : {1U, 2U, 3U, 4U}) {
      const DiscTile tile = shapes::bumpyDisc(25, 5, 0.1 * seed, seed);
      for (const Method method : {Method::Automatic, Method::MeanValue, Method::LowStretch}) {
        const auto e = embedTile(tile, method);
        VERIFY_EMBEDS(tile, e);
      }
    }
  }

  void trianglesFlippedByCotangentWeightsAreOvercome() {
    const DiscTile tile = pleatedDisc();
    const auto e = embedTile(tile);
    VERIFY_EMBEDS(tile, e);
    QVERIFY(e->flippedCotangent > 0);
    QCOMPARE(e->weights, EmbeddingWeights::MeanValue);
  }

  void cotangentWeightsThatFoldTheTileAreAnErrorWhereNoOtherIsAllowed() {
    const auto e = embedTile(pleatedDisc(), Method::Cotangent);
    QVERIFY(!e);
    QCOMPARE(e.error().code, ErrorCode::EmbeddingFailed);
    QVERIFY(QString::fromStdString(e.error().message).contains("would fold over"));
    QVERIFY(QString::fromStdString(e.error().message).contains("automatically"));
  }

  void coordinatesThatAreNoNumbersAreAnError() {
    DiscTile tile = shapes::hemisphere(5, 3);
    tile.points[40].y() = std::numeric_limits<double>::quiet_NaN();
    const auto e = embedTile(tile);
    QVERIFY(!e);
    QCOMPARE(e.error().code, ErrorCode::EmbeddingFailed);
    QVERIFY(QString::fromStdString(e.error().message).contains("Vertex 40"));
  }

  void hornsOfAnyLengthEmbed_data() {
    QTest::addColumn<double>("height");
    QTest::addColumn<bool>("isOpened");
    for (const auto& [height, isOpened] :
         {std::pair(1.0, false), {3.0, false}, {5.0, false}, {10.0, true}, {30.0, true}, {100.0, true}}) {
      QTest::addRow("%g", height) << height << isOpened;
    }
  }

  void hornsOfAnyLengthEmbed() {
    QFETCH(double, height);
    QFETCH(bool, isOpened);
    const DiscTile tile = shapes::horn(height, 20, 5);
    const auto e = embedTile(tile);
    VERIFY_EMBEDS(tile, e);
    QCOMPARE(e->weights, isOpened ? EmbeddingWeights::LowStretch : EmbeddingWeights::Cotangent);
    if (isOpened) {
      const auto rows = static_cast<Index>(std::ceil(height / (2 * std::numbers::pi / 20 * 0.87)));
      const auto radiusAt = [&](int tenths) { return ringRadius(*e, rows * tenths / 10 * 20, 20); };
      QVERIFY2(radiusAt(5) > 0.05, QByteArray::number(radiusAt(5)).constData());
      QVERIFY2(radiusAt(9) > 1.0 / 300, QByteArray::number(radiusAt(9)).constData());
      QVERIFY2(e->smallestAreaRatio > 1e-5, QByteArray::number(e->smallestAreaRatio).constData());
    }
  }

  void aSqueezedHornIsValidWhereHarmonicIsAskedFor() {
    const DiscTile tile = shapes::horn(20, 20, 5);
    const auto e = embedTile(tile, Method::Cotangent);
    VERIFY_EMBEDS(tile, e);
    QVERIFY(e->smallestAreaRatio < 1e-14);
    QVERIFY(e->smallestAreaRatio > 0);
  }

  void conesStayHarmonic() {
    for (const double height : {1.0, 3.0}) {
      const DiscTile tile = shapes::rings(shapes::discSizes(20), 6, [=](double depth, double angle) {
        return Point((1 - depth) * std::cos(angle), (1 - depth) * std::sin(angle), height * depth);
      });
      const auto e = embedTile(tile);
      VERIFY_EMBEDS(tile, e);
      QCOMPARE(e->weights, EmbeddingWeights::Cotangent);
    }
  }

  void severalHornsOfDifferentLengthAreAllOpened() {
    const DiscTile tile = shapes::twoHorns(4, 12);
    const auto e = embedTile(tile);
    VERIFY_EMBEDS(tile, e);
    QCOMPARE(e->weights, EmbeddingWeights::LowStretch);
    QVERIFY2(e->smallestAreaRatio > 1e-4, QByteArray::number(e->smallestAreaRatio).constData());
  }

  void lowStretchIsUsedWhenAskedFor() {
    const DiscTile tile = shapes::horn(4, 20, 5);
    const auto low = embedTile(tile, Method::LowStretch);
    const auto harmonic = embedTile(tile, Method::Cotangent);
    VERIFY_EMBEDS(tile, low);
    VERIFY_EMBEDS(tile, harmonic);
    QCOMPARE(low->weights, EmbeddingWeights::LowStretch);
    QVERIFY(low->smallestAreaRatio > 3 * harmonic->smallestAreaRatio);
  }
};

QTEST_APPLESS_MAIN(EmbeddingMethodsTest)
#include "embedding_methods_test.moc"
