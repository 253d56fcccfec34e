#include "widgets/viewport/colouring_scale.h"

#include <algorithm>
#include <array>

namespace graftsman {

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
  const double at = std::clamp(x, 0.0, 1.0) * (kKeys.size() - 1);
  const auto key = std::min(static_cast<std::size_t>(at), kKeys.size() - 2);
  return mixed(kKeys[key], kKeys[key + 1], static_cast<float>(at - static_cast<double>(key)));
}

}  // namespace graftsman
