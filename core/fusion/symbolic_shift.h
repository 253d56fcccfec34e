#pragma once

#include <span>

#include "core/fusion/overlay_predicates.h"
#include "core/fusion/seam_merge.h"

namespace graftsman::overlay_detail {

/// Orientations as if the base's interior vertices were shifted by δ = (ε, ε²) for an infinitely small ε > 0.
/// Where the exact orientation is not 0, its sign is the answer. Where it is 0, the answer is the sign of its
/// change, which is linear in δ: ε · A + ε² · B, so the sign of A, or of B where A = 0. In each case below
/// (A, B) is, up to order and sign, the difference of two distinct points: never both 0.
struct Sign {
  int shifted;  // −1 or 1
  bool exact0;  // the exact orientation, without the shift, is 0

  static Sign of(int exact, double dx, double dy) {
    if (exact != 0) {
      return {exact, false};
    }
    return {dy != 0 ? (dy > 0 ? 1 : -1) : (dx < 0 ? 1 : (dx > 0 ? -1 : 0)), true};
  }
};

/// On which side of the base edge from vertex `from` to `to` the part's vertex w lies: 1 left, −1 right.
/// Precondition: w is not a seam vertex at an end of the edge, and an end of it is interior.
inline Sign sideOfBaseEdge(const Layers& layers, Index from, Index to, Index w) {
  const Layer& base = layers.base;
  const Point2& a = base.at(from);
  const Point2& b = base.at(to);
  const Point2& p = layers.part.at(w);
  const int exact = orientation(a, b, p);
  if (exact != 0) {
    return {exact, false};
  }
  const bool shiftsFrom = from >= base.seamSize();
  const bool shiftsTo = to >= base.seamSize();
  // orient(a + δ, b + δ, p) − orient(a, b, p) = −(b − a) × δ =  ε (b − a)_y − ε² (b − a)_x
  // orient(a, b + δ, p)     − orient(a, b, p) =  δ × (p − a) =  ε (p − a)_y − ε² (p − a)_x
  // orient(a + δ, b, p)     − orient(a, b, p) =  (p − b) × δ = −ε (p − b)_y + ε² (p − b)_x
  const Point2 d = shiftsFrom && shiftsTo ? Point2(b - a) : shiftsTo ? Point2(p - a) : Point2(b - p);
  return Sign::of(0, d.x(), d.y());
}

/// On which side of the part's halfedge h the base's interior vertex v lies.
inline Sign sideOfPartEdge(const Layers& layers, Index h, Index v) {
  const Point2& a = layers.part.at(layers.part.from(h));
  const Point2& b = layers.part.at(layers.part.to(h));
  const int exact = orientation(a, b, layers.base.at(v));
  // orient(a, b, p + δ) − orient(a, b, p) = (b − a) × δ = −ε (b − a)_y + ε² (b − a)_x
  return Sign::of(exact, a.x() - b.x(), a.y() - b.y());
}

}  // namespace graftsman::overlay_detail
