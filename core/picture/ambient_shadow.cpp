#include "core/picture/ambient_shadow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace graftsman::picture_detail {
namespace {

using Vector = Eigen::Vector3f;

constexpr int kPattern = 4;     // pixels; the looks are turned from pixel to pixel, over squares of this side
constexpr int kLooks = 12;      // of a pixel
constexpr float kReach = 0.1F;  // of the picture's height
constexpr float kStrength = 1.1F;
constexpr float kBias = 4e-3F;      // of the depth: roughness of faces that casts no shadow
constexpr float kSoftness = 1e-4F;  // of the squared depth: keeps what is close from weighing without bound
constexpr float kSameSurface = 0.02F;  // of the depth: how far apart pixels that are averaged may be

// The pixels as points in camera space with a margin of background all round, so that every look stays
// inside.
struct Field {
  int margin = 0;
  int stride = 0;
  std::vector<Vector> points;  // z = 0: background

  Field(const std::vector<PixelSurface>& pixels, int width, int height, int widest, const Lens& lens)
      : margin(widest), stride(width + 2 * widest) {
    points.assign(static_cast<std::size_t>(stride) * static_cast<std::size_t>(height + 2 * widest),
                  Vector::Zero());
    std::size_t i = 0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x, ++i) {
        points[indexOf(x, y)] = pixels[i].depth * lens.ray(x, y);
      }
    }
  }

  [[nodiscard]] std::size_t indexOf(int x, int y) const {
    return static_cast<std::size_t>(y + margin) * static_cast<std::size_t>(stride) +
           static_cast<std::size_t>(x + margin);
  }
};

// For each pixel of the pattern, places on a spiral, as steps in a field.
using Looks = std::array<std::array<std::ptrdiff_t, kLooks>, kPattern * kPattern>;

Looks looksWithin(float radius, int stride) {
  constexpr std::array<int, kPattern* kPattern> kOrder = {0, 8,  2, 10, 12, 4, 14, 6,
                                                          3, 11, 1, 9,  15, 7, 13, 5};
  constexpr float kTurns = 5;
  Looks looks;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const float phase = static_cast<float>(kOrder[i]) / (kPattern * kPattern);
    for (std::size_t k = 0; k < kLooks; ++k) {
      const float fraction = (static_cast<float>(k) + phase + 0.5F) / (kLooks + 1);
      const float angle = 2 * std::numbers::pi_v<float> * (fraction * kTurns + phase);
      const float far = std::max(radius * fraction, 1.0F);
      looks[i][k] = std::lrint(far * std::sin(angle)) * stride + std::lrint(far * std::cos(angle));
    }
  }
  return looks;
}

class Obscurance {
 public:
  Obscurance(const std::vector<PixelSurface>& pixels, int width, int height, const Lens& lens)
      : pixels_(pixels),
        width_(width),
        height_(height),
        radius_(kReach * static_cast<float>(height)),
        field_(pixels, width, height, std::max(static_cast<int>(radius_) + 1, kPattern), lens),
        looks_(looksWithin(radius_, field_.stride)),
        // In units of the disc's radius, so that the shadow does not depend on the scale.
        weight_(2 * kStrength * radius_ * lens.step / kLooks) {}

  [[nodiscard]] std::vector<float> run() const {
    std::vector<float> raw(field_.points.size(), 1);
    std::size_t i = 0;
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x, ++i) {
        if (pixels_[i].depth > 0) {
          const auto& looks = looks_[static_cast<std::size_t>(y % kPattern) * kPattern +
                                     static_cast<std::size_t>(x % kPattern)];
          raw[field_.indexOf(x, y)] =
              opennessAt(field_.points.data() + field_.indexOf(x, y), pixels_[i].normal, looks);
        }
      }
    }
    return smoothed(raw);
  }

 private:
  [[nodiscard]] float opennessAt(const Vector* here, const Vector& normal,
                                 const std::array<std::ptrdiff_t, kLooks>& looks) const {
    const float bias = kBias * here->z();
    const float softness = kSoftness * here->z() * here->z();
    float sum = 0;
    for (const std::ptrdiff_t look : looks) {
      const Vector& there = here[look];
      const Vector v = there - *here;
      const float above = v.dot(normal) - bias;
      if (above > 0 && there.z() > 0) {
        sum += above / (v.squaredNorm() + softness);
      }
    }
    return std::max(1 - weight_ * here->z() * sum, 0.0F);
  }

  // The mean over a square of the pattern's size, of pixels that belong together: it takes the pattern out.
  [[nodiscard]] std::vector<float> smoothed(const std::vector<float>& raw) const {
    std::vector<float> result(pixels_.size(), 1);
    std::size_t i = 0;
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x, ++i) {
        const float depth = pixels_[i].depth;
        if (depth <= 0) {
          continue;
        }
        float sum = 0;
        float count = 0;
        for (int dy = -kPattern / 2; dy < kPattern / 2; ++dy) {
          const std::size_t row = field_.indexOf(x - kPattern / 2, y + dy);
          for (std::size_t k = row; k < row + kPattern; ++k) {
            const float same = std::abs(field_.points[k].z() - depth) <= kSameSurface * depth ? 1 : 0;
            sum += same * raw[k];
            count += same;
          }
        }
        result[i] = sum / count;  // of one at least: its own
      }
    }
    return result;
  }

  const std::vector<PixelSurface>& pixels_;
  int width_;
  int height_;
  float radius_;  // of the disc, in pixels
  Field field_;
  Looks looks_;
  float weight_;
};

}  // namespace

std::vector<float> openness(const std::vector<PixelSurface>& pixels, int width, int height,
                            const Lens& lens) {
  return Obscurance(pixels, width, height, lens).run();
}

}  // namespace graftsman::picture_detail
