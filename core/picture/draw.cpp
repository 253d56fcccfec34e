#include "core/picture/draw.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/picture/ambient_shadow.h"
#include "core/picture/corner_normals.h"
#include "core/picture/raster.h"

namespace graftsman {

using namespace picture_detail;

namespace {

using Vector = Eigen::Vector3f;

constexpr int kToneSteps = 4096;

float toLinear(float tone) {
  return tone <= 0.04045F ? tone / 12.92F : std::pow((tone + 0.055F) / 1.055F, 2.4F);
}

float toTone(float linear) {
  return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F;
}

// Between bytes as a screen shows them and amounts of light.
struct Tones {
  std::array<float, 256> linear;
  std::array<std::uint8_t, kToneSteps + 1> bytes;

  Tones() {
    for (std::size_t i = 0; i < linear.size(); ++i) {
      linear[i] = toLinear(static_cast<float>(i) / 255);
    }
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      bytes[i] = static_cast<std::uint8_t>(std::lrint(255 * toTone(static_cast<float>(i) / kToneSteps)));
    }
  }

  [[nodiscard]] Vector light(const Colour& colour) const {
    return {linear[colour[0]], linear[colour[1]], linear[colour[2]]};
  }
  [[nodiscard]] Colour colour(const Vector& light) const {
    Colour result;
    for (std::size_t k = 0; k < 3; ++k) {
      const float clamped = std::clamp(light[static_cast<Eigen::Index>(k)], 0.0F, 1.0F);
      result[k] = bytes[static_cast<std::size_t>(std::lround(clamped * kToneSteps))];
    }
    return result;
  }
};

// The studio, in camera space: z into the picture.
struct Studio {
  Vector key = Vector(-0.45F, 0.62F, -0.65F).normalized();
  Vector fill = Vector(0.85F, 0.05F, -0.52F).normalized();
  // Between the key light and the camera, which is taken to be far.
  Vector half = (key - Vector::UnitZ()).normalized();
  static constexpr float kKey = 1.02F;
  static constexpr float kFill = 0.22F;
  static constexpr float kSky = 0.32F;
  static constexpr float kGround = 0.10F;
  static constexpr float kWrap = 0.12F;  // how far the lights reach round the shape: they are large
  static constexpr float kShine = 0.12F;

  // Light that comes off a white surface, and what shines on any.
  struct Lit {
    float diffuse;
    float shine;
  };

  [[nodiscard]] Lit operator()(const Vector& normal, float open) const {
    const auto from = [&](const Vector& light) {
      return std::max((normal.dot(light) + kWrap) / (1 + kWrap), 0.0F);
    };
    const float up = (normal.y() + 1) / 2;
    const float ambient = (kGround + (kSky - kGround) * up) * open;
    const float direct = kKey * from(key) + kFill * from(fill);
    float shine = std::max(normal.dot(half), 0.0F);
    for (int i = 0; i < 5; ++i) {  // to the 32nd power
      shine *= shine;
    }
    return {ambient + direct * (0.55F + 0.45F * open), kShine * shine * open};
  }
};

class Painter {
 public:
  Painter(std::span<const Point> points, std::span<const Face> faces, const PictureCamera& camera,
          PictureSize size, const PictureShading& shading)
      : faces_(faces),
        size_(size),
        shading_(shading),
        finer_(std::clamp(shading.supersampling, 1, 4)),
        normals_(cornerNormals(points, faces, shading.creaseAngle)),
        raster_(rasterise(points, faces, camera, size.width * finer_, size.height * finer_)) {
    const ViewFrame frame = viewFrame(camera);
    Eigen::Matrix3f rows;
    rows.row(0) = frame.right.cast<float>();
    rows.row(1) = frame.up.cast<float>();
    rows.row(2) = frame.into.cast<float>();
    for (Vector& normal : normals_.normals) {
      normal = rows * normal;
    }
    pixelLens_ = raster_.lens;
    const auto finer = static_cast<float>(finer_);
    pixelLens_.step *= finer;
    pixelLens_.centreX = static_cast<float>(size.width - 1) / 2;
    pixelLens_.centreY = static_cast<float>(size.height - 1) / 2;
  }

  Picture paint() {
    findSurfaces();
    if (shading_.shadows) {
      open_ = openness(surfaces_, size_.width, size_.height, pixelLens_);
    }
    Picture picture;
    picture.size = size_;
    picture.pixels.reserve(static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height));
    for (int y = 0; y < size_.height; ++y) {
      const float down = static_cast<float>(y) / static_cast<float>(std::max(size_.height - 1, 1));
      const Vector background =
          (1 - down) * tones_.light(shading_.backgroundTop) + down * tones_.light(shading_.backgroundBottom);
      for (int x = 0; x < size_.width; ++x) {
        picture.pixels.push_back(tones_.colour(pixel(x, y, background)));
      }
    }
    return picture;
  }

 private:
  // Where a sample's ray meets its face.
  struct Hit {
    Vector weights;  // of the face's corners
    Vector normal;   // of length 1, towards the camera
  };

  [[nodiscard]] Hit hitAt(int x, int y, Index face) const {
    const auto f = static_cast<std::size_t>(face);
    const auto corner = [&](std::size_t k) -> const Vector& {
      return raster_.points[static_cast<std::size_t>(faces_[f][k])];
    };
    Hit hit;
    const Vector ray = raster_.lens.ray(x, y);
    // Möller and Trumbore 1997; places are rounded, so that the ray may just miss.
    const Vector u = corner(1) - corner(0);
    const Vector v = corner(2) - corner(0);
    const Vector across = ray.cross(v);
    const float volume = u.dot(across);
    const float scale = volume != 0 ? 1 / volume : 0;
    const float b = std::clamp(-corner(0).dot(across) * scale, 0.0F, 1.0F);
    const float c = std::clamp(ray.dot(u.cross(corner(0))) * scale, 0.0F, 1 - b);
    hit.weights = {1 - b - c, b, c};
    const Face& normals = normals_.corners[f];
    const auto normal = [&](std::size_t k) -> const Vector& {
      return normals_.normals[static_cast<std::size_t>(normals[k])];
    };
    hit.normal = hit.weights[0] * normal(0) + hit.weights[1] * normal(1) + hit.weights[2] * normal(2);
    const float squared = hit.normal.squaredNorm();
    hit.normal *= squared > 0 ? 1 / std::sqrt(squared) : 0;
    // The side of the face that the camera sees decides, so that a smooth rim does not flip.
    if (volume > 0) {
      hit.normal = -hit.normal;
    }
    return hit;
  }

  // What the middle of each pixel shows.
  void findSurfaces() {
    surfaces_.resize(static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height));
    std::size_t i = 0;
    for (int y = 0; y < size_.height; ++y) {
      for (int x = 0; x < size_.width; ++x, ++i) {
        const int sampleX = x * finer_ + finer_ / 2;
        const int sampleY = y * finer_ + finer_ / 2;
        const Sample& sample = raster_.at(sampleX, sampleY);
        if (sample.face >= 0) {
          surfaces_[i] = {1 / sample.nearness, hitAt(sampleX, sampleY, sample.face).normal};
        }
      }
    }
  }

  // Whether all samples of a pixel show one surface, without a rim between them.
  [[nodiscard]] bool isPlain(int x, int y) const {
    constexpr float kSameSurface = 0.98F;
    float nearest = 0;
    float farthest = std::numeric_limits<float>::max();
    for (int sampleY = y * finer_; sampleY < (y + 1) * finer_; ++sampleY) {
      for (int sampleX = x * finer_; sampleX < (x + 1) * finer_; ++sampleX) {
        nearest = std::max(nearest, raster_.at(sampleX, sampleY).nearness);
        farthest = std::min(farthest, raster_.at(sampleX, sampleY).nearness);
      }
    }
    return farthest > kSameSurface * nearest;
  }

  // The light of a pixel: the mean of its samples', of those on its diagonal where they are enough.
  [[nodiscard]] Vector pixel(int x, int y, const Vector& background) const {
    const auto i =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) + static_cast<std::size_t>(x);
    const float open = open_.empty() ? 1 : open_[i];
    Vector sum = Vector::Zero();
    if (isPlain(x, y)) {
      for (int k = 0; k < finer_; ++k) {
        const bool known = k == finer_ / 2 && shading_.vertexColours.empty();
        sum += known ? lightOf({{}, surfaces_[i].normal}, -1, open)
                     : lightAt(x * finer_ + k, y * finer_ + k, background, open);
      }
      return sum / static_cast<float>(finer_);
    }
    for (int sampleY = y * finer_; sampleY < (y + 1) * finer_; ++sampleY) {
      for (int sampleX = x * finer_; sampleX < (x + 1) * finer_; ++sampleX) {
        sum += lightAt(sampleX, sampleY, background, open);
      }
    }
    return sum / static_cast<float>(finer_ * finer_);
  }

  [[nodiscard]] Vector lightAt(int x, int y, const Vector& background, float open) const {
    const Index face = raster_.at(x, y).face;
    return face < 0 ? background : lightOf(hitAt(x, y, face), face, open);
  }

  [[nodiscard]] Vector lightOf(const Hit& hit, Index face, float open) const {
    const Studio::Lit lit = studio_(hit.normal, open);
    return lit.diffuse * colourOf(hit, face) + Vector::Constant(lit.shine);
  }

  [[nodiscard]] Vector colourOf(const Hit& hit, Index face) const {
    if (shading_.vertexColours.empty()) {
      return mesh_;
    }
    Vector sum = Vector::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(faces_[static_cast<std::size_t>(face)][k]);
      sum += hit.weights[static_cast<Eigen::Index>(k)] * tones_.light(shading_.vertexColours[v]);
    }
    return sum;
  }

  std::span<const Face> faces_;
  PictureSize size_;
  const PictureShading& shading_;
  int finer_;
  CornerNormals normals_;  // in camera space
  Raster raster_;
  Lens pixelLens_;
  std::vector<PixelSurface> surfaces_;  // of each pixel
  std::vector<float> open_;             // likewise; empty without shadows
  Tones tones_;
  Studio studio_;
  Vector mesh_ = tones_.light(shading_.mesh);
};

}  // namespace

Picture draw(std::span<const Point> points, std::span<const Face> faces, const PictureCamera& camera,
             PictureSize size, const PictureShading& shading) {
  assert(size.width >= 1 && size.height >= 1 && size.width <= kGreatestPictureSide &&
         size.height <= kGreatestPictureSide);
  assert(shading.vertexColours.empty() || shading.vertexColours.size() == points.size());
  return Painter(points, faces, camera, size, shading).paint();
}

}  // namespace graftsman
