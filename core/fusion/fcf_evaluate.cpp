#include <algorithm>
#include <cassert>

#include "core/base/vector_clones.h"
#include "core/fusion/fcf.h"

namespace graftsman {

// A curve of N segments, the constant at s = 1 included: goes through all of them for every s instead of
// looking the right one up, so that many s are done side by side.
template <std::size_t N>
GRAFTSMAN_INLINE void FCF::evaluateFew(std::span<const double> s, std::span<double> out) const {
  std::array<Segment, N> segments;
  std::copy_n(segments_.begin(), N, segments.begin());
  const double* const from = s.data();
  double* const to = out.data();
  const std::size_t count = s.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double at = inUnit(from[i]);
    Segment segment = segments[0];
    for (std::size_t k = 1; k < N; ++k) {
      const bool later = at >= segments[k].s;
      segment.s = later ? segments[k].s : segment.s;
      segment.f = later ? segments[k].f : segment.f;
      segment.c1 = later ? segments[k].c1 : segment.c1;
      segment.c2 = later ? segments[k].c2 : segment.c2;
      segment.c3 = later ? segments[k].c3 : segment.c3;
    }
    to[i] = segment(at);
  }
}

GRAFTSMAN_VECTOR_CLONES
void FCF::evaluate(std::span<const double> s, std::span<double> out) const {
  assert(s.size() == out.size());
  switch (segments_.size()) {
    case 4:
      return evaluateFew<4>(s, out);
    case 5:
      return evaluateFew<5>(s, out);
    case 6:
      return evaluateFew<6>(s, out);
    case 7:
      return evaluateFew<7>(s, out);
    case 8:
      return evaluateFew<8>(s, out);
    default:
      break;
  }
  for (std::size_t i = 0; i < s.size(); ++i) {
    out[i] = (*this)(s[i]);
  }
}

}  // namespace graftsman
