#pragma once

#include <algorithm>
#include <cassert>
#include <memory>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "core/fusion/loop.h"
#include "core/fusion/paths.h"

/// Loops made without a path finder, for tests of the stages behind it.
namespace graftsman::loops {

inline EdgePoint vertex(Index v) {
  return {v, -1, 0};
}

/// The point at fraction t from vertex a to vertex b of an edge.
inline EdgePoint between(const TriangleMesh& mesh, Index a, Index b, double t) {
  const Index h = mesh.halfedgeBetween(a, b);
  const Index back = mesh.halfedgeBetween(b, a);
  const bool asGiven = back < 0 || (h >= 0 && h < back);
  return {-1, asGiven ? h : back, asGiven ? t : 1 - t};
}

/// Paths of the given points, each from one vertex to the next path's first.
inline LoopPaths paths(const std::vector<std::vector<EdgePoint>>& points) {
  LoopPaths result;
  for (const auto& p : points) {
    result.paths.push_back(std::make_shared<const Path>(Path{p, 0}));
  }
  result.direct = result.paths;
  return result;
}

/// The loop through a closed chain of points, with CVs at those of its vertices that are listed.
inline LoopPaths fromChain(std::vector<EdgePoint> chain, const std::vector<Index>& cvs) {
  const auto isCV = [&](const EdgePoint& p) {
    return p.isVertex() && std::find(cvs.begin(), cvs.end(), p.vertex) != cvs.end();
  };
  std::rotate(chain.begin(), std::find(chain.begin(), chain.end(), vertex(cvs[0])), chain.end());
  chain.push_back(chain.front());
  std::vector<std::vector<EdgePoint>> parts;
  for (const EdgePoint& p : chain) {
    if (!parts.empty()) {
      parts.back().push_back(p);
    }
    if (isCV(p)) {
      parts.push_back({p});
    }
  }
  parts.pop_back();
  return paths(parts);
}

/// The loop along edges through these vertices, every one of them a CV.
inline LoopPaths throughVertices(const std::vector<Index>& vertices) {
  std::vector<EdgePoint> chain;
  for (const Index v : vertices) {
    chain.push_back(vertex(v));
  }
  return fromChain(chain, vertices);
}

/// The same curve the other way round, from the same CV 0.
inline LoopPaths reversed(const LoopPaths& loop) {
  std::vector<std::vector<EdgePoint>> parts;
  for (auto path = loop.paths.rbegin(); path != loop.paths.rend(); ++path) {
    parts.emplace_back((*path)->points.rbegin(), (*path)->points.rend());
  }
  return paths(parts);
}

/// A double spiral round vertex 0 of a tetrahedron with the faces 0 2 1, 0 1 3, 1 2 3, 0 3 2, and its end:
/// from vertex 1 inwards to 0, outwards to 3, and along the edge to 1.
inline LoopPaths doubleSpiral(const TriangleMesh& mesh, int turns) {
  static constexpr std::array<Index, 3> kSpokes = {1, 3, 2};  // counter-clockwise
  const int last = 3 * turns;
  const auto point = [&](int step, int firstSpoke) {
    return between(mesh, 0, kSpokes[static_cast<std::size_t>((step + firstSpoke) % 3)],
                   1 - (step + 1.0) / (last + 2));
  };
  std::vector<EdgePoint> chain = {vertex(1)};
  for (int step = 0; step <= last; ++step) {
    chain.push_back(point(step, 0));
  }
  chain.push_back(vertex(0));
  for (int step = last; step >= 0; --step) {
    chain.push_back(point(step, 1));
  }
  chain.push_back(vertex(3));
  return fromChain(chain, {1, 0, 3});
}

/// The straight segment between the vertices (i, j) and (k, l) of shapes::grid(n): exact crossings, in
/// integers.
inline std::vector<EdgePoint> straight(const TriangleMesh& grid, Index n, std::pair<Index, Index> from,
                                       std::pair<Index, Index> to) {
  const long x = from.first;
  const long y = from.second;
  const long dx = to.first - x;
  const long dy = to.second - y;
  std::vector<std::pair<long, long>> crossings;  // parameter as a fraction with positive denominator
  const auto cross = [&](long start, long step) {
    for (long k = std::min(start, start + step) + 1; k < std::max(start, start + step); ++k) {
      const long sign = step > 0 ? 1 : -1;
      crossings.emplace_back(sign * (k - start), sign * step);
    }
  };
  cross(x, dx);
  cross(y, dy);
  cross(x - y, dx - dy);
  const auto less = [](const auto& a, const auto& b) { return a.first * b.second < b.first * a.second; };
  std::sort(crossings.begin(), crossings.end(), less);
  const auto number = [&](long i, long j) { return static_cast<Index>(j * (n + 1) + i); };
  std::vector<EdgePoint> points = {vertex(number(x, y))};
  for (std::size_t c = 0; c < crossings.size(); ++c) {
    if (c > 0 && !less(crossings[c - 1], crossings[c])) {
      continue;
    }
    const auto [num, den] = crossings[c];
    const long px = x * den + num * dx;  // times den
    const long py = y * den + num * dy;
    const long i = px / den;
    const long j = py / den;
    const double u = static_cast<double>(px % den) / static_cast<double>(den);
    const double v = static_cast<double>(py % den) / static_cast<double>(den);
    if (px % den == 0 && py % den == 0) {
      points.push_back(vertex(number(i, j)));
    } else if (py % den == 0) {
      points.push_back(between(grid, number(i, j), number(i + 1, j), u));
    } else if (px % den == 0) {
      points.push_back(between(grid, number(i, j), number(i, j + 1), v));
    } else {
      points.push_back(between(grid, number(i, j), number(i + 1, j + 1), u));
    }
  }
  points.push_back(vertex(number(to.first, to.second)));
  return points;
}

/// The polygon of straight segments between vertices (i, j) of shapes::grid(n).
inline LoopPaths polygon(const TriangleMesh& grid, Index n,
                         const std::vector<std::pair<Index, Index>>& corners) {
  std::vector<std::vector<EdgePoint>> parts;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    parts.push_back(straight(grid, n, corners[i], corners[(i + 1) % corners.size()]));
  }
  return paths(parts);
}

/// Where the field with these values at the vertices is zero on halfedge h. Precondition: it is negative at
/// the start and positive at the end.
inline EdgePoint zeroOn(const TriangleMesh& mesh, const std::vector<double>& field, Index h) {
  const double start = field[static_cast<std::size_t>(mesh.from(h))];
  const double t = start / (start - field[static_cast<std::size_t>(mesh.to(h))]);
  const Index twin = mesh.twin(h);
  return twin >= 0 && twin < h ? EdgePoint{-1, twin, 1 - t} : EdgePoint{-1, h, t};
}

/// Follows the curve where a field with these values at the vertices is zero, its positive side on the left,
/// from the given point on (a vertex or an edge point of the curve) until it closes; empty if it meets the
/// border. Precondition: no two neighbouring vertices have value zero, none is singular.
inline std::vector<EdgePoint> traceZero(const TriangleMesh& mesh, const std::vector<double>& field,
                                        const EdgePoint& start) {
  const auto value = [&](Index v) { return field[static_cast<std::size_t>(v)]; };
  std::vector<EdgePoint> chain;
  EdgePoint at = start;
  do {
    chain.push_back(at);
    Index exit =
        -1;  // the halfedge from minus to plus through which the curve leaves the face that it entered
    if (at.isVertex()) {
      Index h = mesh.outgoing(at.vertex);
      do {
        const Index opposite = TriangleMesh::next(h);
        if (value(mesh.from(opposite)) < 0 && value(mesh.to(opposite)) > 0) {
          exit = opposite;
        }
        h = mesh.twin(TriangleMesh::prev(h));
      } while (h >= 0 && h != mesh.outgoing(at.vertex));
    } else {
      const Index twin = mesh.twin(at.halfedge);
      const Index enter = value(mesh.from(at.halfedge)) > 0 ? at.halfedge : twin;
      if (enter < 0) {
        return {};
      }
      const Index third = mesh.to(TriangleMesh::next(enter));
      if (value(third) == 0) {
        at = vertex(third);
        continue;
      }
      exit = value(third) > 0 ? TriangleMesh::next(enter) : TriangleMesh::prev(enter);
    }
    if (exit < 0) {
      return {};
    }
    at = zeroOn(mesh, field, exit);
  } while (!(at == start) && chain.size() < static_cast<std::size_t>(mesh.halfedgeCount()));
  return chain;
}

/// A loop of `cvs` CVs along the zero of a field, and the mesh on which it runs: the CVs are put on edges, so
/// the mesh is an anchored copy.
struct AnchoredLoopPaths {
  std::shared_ptr<const TriangleMesh> mesh;
  LoopPaths paths;  // empty if the curve is too short or not closed
};

/// The zero curve of the field through halfedge h, where it rises from negative to positive.
template <class Field>
AnchoredLoopPaths zeroLoop(const std::shared_ptr<const TriangleMesh>& mesh, const Field& field, Index h,
                           std::size_t cvs) {
  std::vector<double> values;
  for (const Point& p : mesh->points()) {
    const double v = field(p);
    values.push_back(v == 0 ? 1e-300 : v);
  }
  const EdgePoint start = zeroOn(*mesh, values, h);
  const std::vector<EdgePoint> chain = traceZero(*mesh, values, start);
  if (chain.size() < 6 * cvs) {  // so that no two CVs are neighbours
    return {mesh, {}};
  }
  Loop loop;
  for (std::size_t i = 0; i < cvs; ++i) {
    const EdgePoint& p = chain[i * chain.size() / cvs];
    SurfacePoint at{-1, p.halfedge / 3, Eigen::Vector3d::Zero()};
    at.bary[p.halfedge % 3] = 1 - p.t;
    at.bary[TriangleMesh::next(p.halfedge) % 3] = p.t;
    loop.push_back({at, at});
  }
  const auto anchored = anchorLoop(mesh, loop, Side::Base);
  if (!anchored) {
    return {mesh, {}};
  }
  values.resize(static_cast<std::size_t>(anchored->mesh->vertexCount()), 0);
  std::vector<EdgePoint> closed = traceZero(*anchored->mesh, values, vertex(anchored->cvs[0]));
  return {anchored->mesh, closed.empty() ? LoopPaths{} : fromChain(std::move(closed), anchored->cvs)};
}

/// A loop where a random sphere about a point of the mesh meets it, the same for the same seed: empty if none
/// of some hundred spheres meets it in a closed curve.
inline AnchoredLoopPaths randomLoop(const std::shared_ptr<const TriangleMesh>& mesh, unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&](Index count) { return static_cast<Index>(random() % static_cast<unsigned>(count)); };
  const auto pick = [&] { return mesh->point(mesh->face(below(mesh->faceCount()))[0]); };
  for (int sphere = 0; sphere < 300; ++sphere) {
    const Point centre = pick();
    const double radius = (pick() - centre).norm() * (0.1 + 0.5 * below(1000) / 1000.0);
    const auto field = [&](const Point& p) { return radius - (p - centre).norm(); };
    const Index first = below(mesh->halfedgeCount());
    for (Index i = 0; i < mesh->halfedgeCount(); ++i) {
      const Index h = (first + i) % mesh->halfedgeCount();
      if (field(mesh->point(mesh->from(h))) < 0 && field(mesh->point(mesh->to(h))) > 0) {
        AnchoredLoopPaths loop = zeroLoop(mesh, field, h, static_cast<std::size_t>(3 + below(6)));
        if (!loop.paths.paths.empty()) {
          return loop;
        }
        break;
      }
    }
  }
  return {mesh, {}};
}

}  // namespace graftsman::loops
