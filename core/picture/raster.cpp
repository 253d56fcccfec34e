#include "core/picture/raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace graftsman::picture_detail {
namespace {

using Vector = Eigen::Vector3f;

constexpr float kNearest = 1e-3F;  // of the pivot's distance
constexpr int kFraction = 8;       // bits after the point of a corner's place
constexpr std::int64_t kOne = 1 << kFraction;
// Places beyond this many samples are moved there: products of their differences fit into 64 bits.
constexpr float kFarthest = 1 << 21;
// Of faces smaller than this many samples, products fit into 32 bits.
constexpr std::int32_t kSmall = 64 << kFraction;

// A corner in the raster.
struct PixelPlace {
  std::int32_t x = 0;  // in 1/256 of a sample
  std::int32_t y = 0;
  float nearness = 0;  // 0: nearer than kNearest or behind the camera
};

class Rasteriser {
 public:
  Rasteriser(Raster& raster) : raster_(raster) {}

  void draw(std::span<const Face> faces) {
    places_.reserve(raster_.points.size());
    for (const Vector& p : raster_.points) {
      places_.push_back(placeOf(p));
    }
    for (std::size_t f = 0; f < faces.size(); ++f) {
      face_ = static_cast<Index>(f);
      const auto& [a, b, c] = faces[f];
      const PixelPlace& pa = places_[static_cast<std::size_t>(a)];
      const PixelPlace& pb = places_[static_cast<std::size_t>(b)];
      const PixelPlace& pc = places_[static_cast<std::size_t>(c)];
      if (pa.nearness > 0 && pb.nearness > 0 && pc.nearness > 0) {
        drawTriangle(pa, pb, pc);
      } else if (pa.nearness > 0 || pb.nearness > 0 || pc.nearness > 0) {
        drawCutOff(faces[f]);
      }
    }
  }

 private:
  [[nodiscard]] PixelPlace placeOf(const Vector& p) const {
    if (!(p.z() >= kNearest)) {
      return {};
    }
    const Lens& lens = raster_.lens;
    const float nearness = 1 / p.z();
    const float toSamples = nearness / lens.step;
    const auto fixed = [](float samples) {
      return static_cast<std::int32_t>(
          std::lrint(std::clamp(samples, -kFarthest, kFarthest) * static_cast<float>(kOne)));
    };
    return {fixed(lens.centreX + p.x() * toSamples), fixed(lens.centreY - p.y() * toSamples), nearness};
  }

  // What remains of a face that reaches behind the plane z = kNearest: three or four corners.
  void drawCutOff(const Face& face) {
    std::array<PixelPlace, 4> kept;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto from = static_cast<std::size_t>(face[k]);
      const auto to = static_cast<std::size_t>(face[(k + 1) % 3]);
      if (places_[from].nearness > 0) {
        kept[count++] = places_[from];
      }
      if ((places_[from].nearness > 0) != (places_[to].nearness > 0)) {
        const Vector& a = raster_.points[from];
        const Vector& b = raster_.points[to];
        Vector p = a + (kNearest - a.z()) / (b.z() - a.z()) * (b - a);
        p.z() = kNearest;
        kept[count++] = placeOf(p);
      }
    }
    for (std::size_t k = 2; k < count; ++k) {
      drawTriangle(kept[0], kept[k - 1], kept[k]);
    }
  }

  void drawTriangle(const PixelPlace& a, PixelPlace b, PixelPlace c) {
    const auto [lowX, highX] = std::minmax({a.x, b.x, c.x});
    const auto [lowY, highY] = std::minmax({a.y, b.y, c.y});
    // Samples lie at whole places.
    constexpr auto kMask = static_cast<std::int32_t>(kOne - 1);
    const int firstX = std::max((lowX + kMask) >> kFraction, 0);
    const int firstY = std::max((lowY + kMask) >> kFraction, 0);
    const int lastX = std::min(highX >> kFraction, raster_.width - 1);
    const int lastY = std::min(highY >> kFraction, raster_.height - 1);
    if (firstX > lastX || firstY > lastY) {
      return;
    }
    const std::int64_t area = doubledArea(a, b, c);
    if (area == 0) {
      return;
    }
    if (area < 0) {
      std::swap(b, c);
    }
    if (highX - lowX < kSmall && highY - lowY < kSmall) {
      fill<std::int32_t>(a, b, c, firstX, firstY, lastX, lastY);
    } else {
      fill<std::int64_t>(a, b, c, firstX, firstY, lastX, lastY);
    }
  }

  [[nodiscard]] static std::int64_t doubledArea(const PixelPlace& a, const PixelPlace& b,
                                                const PixelPlace& c) {
    return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{c.x - a.x} * (b.y - a.y);
  }

  /// Twice the signed area that a sample spans with an edge: a linear function, ≥ 0 on the face's side.
  template <class Integer>
  struct Edge {
    Integer value;  // at the first sample of the row
    Integer perX;   // from one sample to the next
    Integer perY;

    Edge(const PixelPlace& from, const PixelPlace& to, int x, int y) {
      const Integer dx = to.x - from.x;
      const Integer dy = to.y - from.y;
      value = dx * (static_cast<Integer>(y) * static_cast<Integer>(kOne) - from.y) -
              dy * (static_cast<Integer>(x) * static_cast<Integer>(kOne) - from.x);
      perX = -dy * static_cast<Integer>(kOne);
      perY = dx * static_cast<Integer>(kOne);
    }
  };

  template <class Integer>
  void fill(const PixelPlace& a, const PixelPlace& b, const PixelPlace& c, int firstX, int firstY, int lastX,
            int lastY) {
    Edge<Integer> ofA(b, c, firstX, firstY);
    Edge<Integer> ofB(c, a, firstX, firstY);
    Edge<Integer> ofC(a, b, firstX, firstY);
    const float unit = 1 / static_cast<float>(ofA.value + ofB.value + ofC.value);
    const float slopeB = (b.nearness - a.nearness) * unit;
    const float slopeC = (c.nearness - a.nearness) * unit;
    Sample* row = raster_.samples.data() +
                  static_cast<std::ptrdiff_t>(firstY) * static_cast<std::ptrdiff_t>(raster_.width);
    for (int y = firstY; y <= lastY; ++y, row += raster_.width) {
      Integer inA = ofA.value;
      Integer inB = ofB.value;
      Integer inC = ofC.value;
      for (int x = firstX; x <= lastX; ++x) {
        if ((inA | inB | inC) >= 0) {
          const float nearness =
              a.nearness + slopeB * static_cast<float>(inB) + slopeC * static_cast<float>(inC);
          if (nearness > row[x].nearness) {
            row[x] = {nearness, face_};
          }
        }
        inA += ofA.perX;
        inB += ofB.perX;
        inC += ofC.perX;
      }
      ofA.value += ofA.perY;
      ofB.value += ofB.perY;
      ofC.value += ofC.perY;
    }
  }

  Raster& raster_;
  std::vector<PixelPlace> places_;
  Index face_ = 0;
};

// Model space to camera space.
std::vector<Vector> inCameraSpace(std::span<const Point> points, const PictureCamera& camera) {
  const ViewFrame frame = viewFrame(camera);
  const double distance = (camera.pivot - camera.position).stableNorm();
  Eigen::Matrix3d rows;
  rows.row(0) = frame.right;
  rows.row(1) = frame.up;
  rows.row(2) = frame.into;
  rows /= distance > 0 ? distance : 1;
  std::vector<Vector> result;
  result.reserve(points.size());
  for (const Point& p : points) {
    result.emplace_back((rows * (p - camera.position)).cast<float>());
  }
  return result;
}

}  // namespace

Raster rasterise(std::span<const Point> points, std::span<const Face> faces, const PictureCamera& camera,
                 int width, int height) {
  Raster raster;
  raster.width = width;
  raster.height = height;
  raster.lens.centreX = static_cast<float>(width - 1) / 2;
  raster.lens.centreY = static_cast<float>(height - 1) / 2;
  raster.lens.step = static_cast<float>(2 * std::tan(camera.viewAngle / 2) / height);
  raster.points = inCameraSpace(points, camera);
  raster.samples.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  Rasteriser(raster).draw(faces);
  return raster;
}

}  // namespace graftsman::picture_detail
