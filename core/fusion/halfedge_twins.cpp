#include "core/fusion/halfedge_twins.h"

#include <algorithm>
#include <utility>

namespace graftsman {
namespace {

/// A halfedge, listed at its smaller vertex.
struct Listed {
  Index larger;
  Index halfedge;
  bool operator<(const Listed& other) const {
    return larger != other.larger ? larger < other.larger : halfedge < other.halfedge;
  }
};

// Most vertices are the smaller end of about six halfedges: comparing all pairs beats sorting there.
constexpr std::ptrdiff_t kFewTwins = 24;

void pairListed(Listed* begin, Listed* end, std::vector<Index>& twins) {
  const auto pair = [&](const Listed& a, const Listed& b) {
    twins[static_cast<std::size_t>(a.halfedge)] = b.halfedge;
    twins[static_cast<std::size_t>(b.halfedge)] = a.halfedge;
  };
  if (end - begin > kFewTwins) {
    std::sort(begin, end);
    for (Listed* a = begin; a + 1 < end; ++a) {
      if (a[0].larger == a[1].larger) {
        pair(a[0], a[1]);
      }
    }
    return;
  }
  for (Listed* a = begin; a < end; ++a) {
    for (Listed* b = a + 1; b < end; ++b) {
      if (a->larger == b->larger) {
        pair(*a, *b);
        break;
      }
    }
  }
}

}  // namespace

std::vector<Index> pairHalfedges(std::span<const Face> faces, Index vertexCount) {
  std::vector<Index> start(static_cast<std::size_t>(vertexCount) + 2, 0);
  for (const auto& [a, b, c] : faces) {
    ++start[static_cast<std::size_t>(std::min(a, b)) + 2];
    ++start[static_cast<std::size_t>(std::min(b, c)) + 2];
    ++start[static_cast<std::size_t>(std::min(c, a)) + 2];
  }
  for (std::size_t v = 2; v < start.size(); ++v) {
    start[v] += start[v - 1];
  }
  std::vector<Listed> listed(3 * faces.size());
  Index h = 0;
  for (const Face& face : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(face[k], face[(k + 1) % 3]);
      listed[static_cast<std::size_t>(start[static_cast<std::size_t>(low) + 1]++)] = {high, h++};
    }
  }
  std::vector<Index> twins(3 * faces.size(), -1);
  for (std::size_t v = 0; v + 1 < start.size(); ++v) {
    pairListed(listed.data() + start[v], listed.data() + start[v + 1], twins);
  }
  return twins;
}

}  // namespace graftsman
