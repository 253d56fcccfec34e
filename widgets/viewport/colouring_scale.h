#pragma once

#include <QColor>
#include <cstdint>

namespace graftsman {

/// What the colours of the result mean.
enum class Colouring {
  Plain,
  FusionCurve,  // f at each vertex: from the base's colour to the part's
  Origin,       // rest of the base, tile by the base's vertices, by the part's, by both
  SeamAngle,    // the jump of the normals across the seam
  Quality,      // smallest angle of each triangle
};

/// A colour as the graphics card takes it.
struct Rgba {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  std::uint8_t a = 255;
  friend bool operator==(const Rgba&, const Rgba&) = default;
};

[[nodiscard]] inline Rgba rgba(const QColor& colour) {
  return {static_cast<std::uint8_t>(colour.red()), static_cast<std::uint8_t>(colour.green()),
          static_cast<std::uint8_t>(colour.blue()), static_cast<std::uint8_t>(colour.alpha())};
}
[[nodiscard]] inline QColor toQColor(const Rgba& colour) {
  return {colour.r, colour.g, colour.b, colour.a};
}

/// (1 − x) a + x b; exactly a at 0 and b at 1. x in [0, 1].
[[nodiscard]] inline Rgba mixed(const Rgba& a, const Rgba& b, float x) {
  const int share = static_cast<int>(x * 256);
  const auto mix = [share](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>((from * (256 - share) + to * share + 128) / 256);
  };
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), mix(a.a, b.a)};
}

/// A scale from dark violet (0) over green to bright yellow (1) that gets lighter evenly, so that
/// colour-blind people, and a print in grey, keep the order ("viridis" of van der Walt and Smith). x is
/// clamped.
[[nodiscard]] Rgba sequentialColour(double x);

/// A scale from blue (−1) over near white (0) to red (1), of the same lightness on both sides, that
/// colour-blind people tell apart ("RdBu" of ColorBrewer). x is clamped.
[[nodiscard]] Rgba divergingColour(double x);

}  // namespace graftsman
