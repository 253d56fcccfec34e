#pragma once

#include <cstddef>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// The place of element i ≥ 0 in a container: `depth[at(v)]`.
[[nodiscard]] constexpr std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

}  // namespace graftsman
