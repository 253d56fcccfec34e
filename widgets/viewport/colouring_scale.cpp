#include "widgets/viewport/colouring_scale.h"

#include <algorithm>
#include <array>

namespace graftsman {
namespace {

template <std::size_t N>
Rgba betweenKeys(const std::array<Rgba, N>& keys, double x) {
  const double at = std::clamp(x, 0.0, 1.0) * (N - 1);
  const auto key = std::min(static_cast<std::size_t>(at), N - 2);
  return mixed(keys[key], keys[key + 1], static_cast<float>(at - static_cast<double>(key)));
}

}  // namespace

Rgba sequentialColour(double x) {
  static constexpr std::array<Rgba, 10> kKeys = {{{0x44, 0x01, 0x54},
                                                  {0x48, 0x28, 0x78},
                                                  {0x3E, 0x49, 0x89},
                                                  {0x31, 0x68, 0x8E},
                                                  {0x26, 0x82, 0x8E},
                                                  {0x1F, 0x9E, 0x89},
                                                  {0x35, 0xB7, 0x79},
                                                  {0x6E, 0xCE, 0x58},
                                                  {0xB5, 0xDE, 0x2B},
                                                  {0xFD, 0xE7, 0x25}}};
  return betweenKeys(kKeys, x);
}

Rgba divergingColour(double x) {
  static constexpr std::array<Rgba, 9> kKeys = {{{0x21, 0x66, 0xAC},
                                                 {0x43, 0x93, 0xC3},
                                                 {0x92, 0xC5, 0xDE},
                                                 {0xD1, 0xE5, 0xF0},
                                                 {0xF7, 0xF7, 0xF7},
                                                 {0xFD, 0xDB, 0xC7},
                                                 {0xF4, 0xA5, 0x82},
                                                 {0xD6, 0x60, 0x4D},
                                                 {0xB2, 0x18, 0x2B}}};
  return betweenKeys(kKeys, (x + 1) / 2);
}

}  // namespace graftsman
