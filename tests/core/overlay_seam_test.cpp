#include <QtTest>

#include "core/base/parallel.h"
#include "core/fusion/combined_tile.h"
#include "core/fusion/overlay_cells.h"
#include "core/fusion/overlay_predicates.h"
#include "core/fusion/overlay_vertices.h"
#include "core/fusion/seam_merge.h"
#include "core/fusion/vertex_snap.h"
#include "tests/support/embeddings.h"
#include "tests/support/overlay_checks.h"

using namespace graftsman;

class OverlaySeamTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void addedVerticesLieOnTheTile() {
    TestTile part = shapes::randomTile(3, 4, 4, 50);
    // The last vertex becomes one that the embedding put into a face of the tile.
    part.points.pop_back();
    part.embedding.added.push_back({{3, 20, 30}, {0.5, 0.25, 0.25}});
    const TestTile base = shapes::randomTile(4, 4, 4, 50);
    const auto combined = overlay(part.view(), base.view(), {});
    QVERIFY(combined.has_value());
    const auto last = static_cast<Index>(part.points.size());
    bool found = false;
    for (std::size_t v = 0; v < combined->part.size(); ++v) {
      const TileLocation& location = combined->onPart[v];
      if (location.kind == TileLocation::Kind::OnVertex && location.corners[0] == last) {
        found = true;
        const Point expected = (2 * part.points[3] + part.points[20] + part.points[30]) / 4;
        QVERIFY((combined->part[v] - expected).norm() < 1e-15);
      }
    }
    QVERIFY(found);
  }

  void smallModelsFarFromTheOriginKeepWhatDoublesAllow() {
    TestTile part = shapes::randomTile(3, 5, 4, 100);
    TestTile base = shapes::randomTile(4, 5, 4, 100);
    const Point offset(100, 200, 300);
    std::vector<Point> exactBase = base.points;
    for (TestTile* tile : {&part, &base}) {
      for (Point& p : tile->points) {
        p = offset + 1e-4 * p;
      }
    }
    const auto combined = overlay(part.view(), base.view(), {});
    QVERIFY(combined.has_value());
    for (std::size_t v = 0; v < combined->base.size(); ++v) {
      const TileLocation& location = combined->onBase[v];
      Point p = Point::Zero();
      for (std::size_t k = 0; k < 3 && location.corners[k] >= 0; ++k) {
        p += location.weights[static_cast<Eigen::Index>(k)] *
             (base.points[static_cast<std::size_t>(location.corners[k])] - offset);
      }
      QVERIFY((combined->base[v] - offset - p).cwiseAbs().maxCoeff() < 6e-14);  // one ulp of 300
    }
  }

  void seamHoldsTheVerticesOfBothBoundaries() {
    const TestTile part = shapes::randomTile(3, 5, 14, 100);
    const TestTile base = shapes::randomTile(4, 5, 9, 100);
    const auto combined = overlay(part.view(), base.view(), {});
    QVERIFY(combined.has_value());
    QCOMPARE(combined->seamSize, 5 + 5 * 14 + 5 * 9);
    for (const bool isPart : {true, false}) {
      const TestTile& tile = isPart ? part : base;
      const auto& seam = isPart ? combined->seamOnPart : combined->seamOnBase;
      const auto& positions = isPart ? combined->part : combined->base;
      QCOMPARE(static_cast<Index>(seam.size()), combined->seamSize);
      Index vertex = 0;
      for (std::size_t k = 0; k < seam.size(); ++k) {
        if (seam[k].t == 0) {
          QCOMPARE(seam[k].edge, vertex++);
          QCOMPARE(positions[k], tile.points[static_cast<std::size_t>(seam[k].edge)]);
        } else {
          QCOMPARE(seam[k].edge, vertex - 1);
          QVERIFY(seam[k].t < 1);
          QVERIFY(seam[k - 1].edge < seam[k].edge || seam[k - 1].t < seam[k].t);
        }
      }
      QCOMPARE(vertex, static_cast<Index>(tile.embedding.boundary.size()));
    }
  }

  void nearBoundaryVerticesAreJoined() {
    const TestTile base = shapes::randomTile(4, 5, 9, 100);
    TestTile part = base;
    std::vector<BoundaryPosition>& boundary = part.embedding.boundary;
    for (std::size_t i = 0; i < boundary.size(); ++i) {
      if (boundary[i].t > 0) {
        boundary[i].t += (i % 2 == 0 ? 1e-16 : -1e-6) * boundary[i].t;
        part.embedding.uv[i] = boundaryPoint(5, boundary[i]);
      }
    }
    const auto combined = overlay(part.view(), base.view(), {});
    QVERIFY(combined.has_value());
    QCOMPARE(combined->seamSize, static_cast<Index>(boundary.size()));
    verify(part, base);
  }

  void distinctBoundaryVerticesStayApart() {
    const TestTile base = shapes::randomTile(4, 5, 9, 100);
    TestTile part = base;
    std::vector<BoundaryPosition>& boundary = part.embedding.boundary;
    boundary[4].t += 0.01 * (boundary[5].t - boundary[4].t);
    part.embedding.uv[4] = boundaryPoint(5, boundary[4]);
    const auto combined = overlay(part.view(), base.view(), {});
    QVERIFY(combined.has_value());
    QCOMPARE(combined->seamSize, static_cast<Index>(boundary.size()) + 1);
  }

  void apexesWithinRoundingOfTheBoundaryAreMoved() {
    // The apex of base triangle (0, 1, 3·…) nearly touches side 0, where the part has many vertices.
    TestTile base = shapes::randomTile(4, 4, 0, 1);
    base.embedding.uv[4] = boundaryPoint(4, {0, 0.3}) - Point2(1e-16, 1e-16);
    QVERIFY(shapes::isValid(base.embedding));
    const TestTile part = shapes::randomTile(3, 4, 40, 50);
    const Overlaid o = overlaid(part, base);
    verifyExactly(o);
    verifyDisk(o.combined);
  }

  void boundariesTooFineForDoublesAreAnError() {
    TestTile part = shapes::randomTile(3, 6, 9, 50);
    TestTile base = shapes::randomTile(4, 6, 9, 50);
    // On side 1, whose x runs from 0.5 down: parameters that differ, positions that are rounded to one.
    const double t = 0.01;
    base.embedding.boundary[11].t = t;
    part.embedding.boundary[11].t = std::nextafter(t, 0.0);
    part.embedding.boundary[12].t = std::nextafter(t, 1.0);
    for (TestTile* tile : {&part, &base}) {
      for (const std::size_t i : {11, 12}) {
        tile->embedding.uv[i] = boundaryPoint(6, tile->embedding.boundary[i]);
      }
    }
    const auto combined = overlay(part.view(), base.view(), {});
    QVERIFY(!combined.has_value());
    QCOMPARE(combined.error().code, ErrorCode::CombinedTileTooFine);
    QCOMPARE(combined.error().cvs, (std::vector<int>{1, 2}));
    QVERIFY(combined.error().message.find("CV 1") != std::string::npos);
  }
};

QTEST_APPLESS_MAIN(OverlaySeamTest)
#include "overlay_seam_test.moc"
