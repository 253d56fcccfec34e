#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace graftsman {

/// Red, green and blue as a screen shows them (sRGB).
using Colour = std::array<std::uint8_t, 3>;

/// In pixels, each at least 1.
struct PictureSize {
  int width = 256;
  int height = 192;
  friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

/// Sides that a picture may have: what is larger costs memory and shows no more.
inline constexpr int kGreatestPictureSide = 8192;

/// A picture without transparency.
struct Picture {
  PictureSize size;
  std::vector<Colour> pixels;  // height × width, row by row from the top left

  [[nodiscard]] const Colour& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                  static_cast<std::size_t>(x)];
  }
};

/// The bytes of a PNG file with 8 bits a channel, sRGB. Equal pictures give equal bytes. Error: OutOfMemory.
[[nodiscard]] Result<std::string> formatPng(const Picture& picture);

}  // namespace graftsman
