#include "core/mesh/mesh_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

#include "core/base/predicates.h"

namespace graftsman {
namespace {

constexpr std::size_t kMostListed = 100;  // defects of a kind that are listed

std::size_t asSize(Index i) {
  return static_cast<std::size_t>(i);
}

// A halfedge without a twin.
struct LooseHalfedge {
  Index low;  // the edge's smaller vertex
  Index high;
  Index halfedge;
  auto operator<=>(const LooseHalfedge&) const = default;
};

// Fills in everything about edges. Returns each halfedge's partner: the other one of an edge with exactly two
// faces, in whatever direction they run; −1 for a border edge, −2 for an edge of many faces.
std::vector<Index> pairEdges(const TriangleMesh& mesh, MeshCheck& check) {
  std::vector<Index> partners(asSize(mesh.halfedgeCount()));
  std::vector<LooseHalfedge> loose;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h) {
    partners[asSize(h)] = mesh.twin(h);
    if (mesh.twin(h) < 0) {
      loose.push_back({std::min(mesh.from(h), mesh.to(h)), std::max(mesh.from(h), mesh.to(h)), h});
    }
  }
  check.edges = static_cast<Index>((asSize(mesh.halfedgeCount()) - loose.size()) / 2);
  std::sort(loose.begin(), loose.end());
  for (auto first = loose.begin(); first != loose.end();) {
    const auto last = std::find_if(
        first, loose.end(), [&](const auto& l) { return l.low != first->low || l.high != first->high; });
    ++check.edges;
    if (last - first == 1) {
      ++check.borderEdges;
    } else if (last - first == 2) {
      partners[asSize(first->halfedge)] = first[1].halfedge;
      partners[asSize(first[1].halfedge)] = first->halfedge;
      if (check.misorientedEdgesCount++ < kMostListed) {
        check.misorientedEdges.push_back({first->low, first->high});
      }
    } else {
      std::for_each(first, last, [&](const auto& l) { partners[asSize(l.halfedge)] = -2; });
      if (check.edgesOfManyFacesCount++ < kMostListed) {
        check.edgesOfManyFaces.push_back({first->low, first->high});
      }
    }
    first = last;
  }
  return partners;
}

// From an edge without partner round its end `pivot`, across the fan of faces there, to the next one.
Index nextAlongBorder(const TriangleMesh& mesh, const std::vector<Index>& partners, Index h, Index pivot) {
  while (true) {
    const Index other = mesh.to(h) == pivot ? TriangleMesh::next(h) : TriangleMesh::prev(h);
    const Index partner = partners[asSize(other)];
    if (partner < 0) {
      return other;
    }
    h = partner;
  }
}

Index countBorderLoops(const TriangleMesh& mesh, const std::vector<Index>& partners) {
  Index loops = 0;
  std::vector<bool> seen(partners.size(), false);
  for (Index first = 0; first < mesh.halfedgeCount(); ++first) {
    if (partners[asSize(first)] != -1 || seen[asSize(first)]) {
      continue;
    }
    ++loops;
    Index pivot = mesh.to(first);
    Index h = first;
    do {
      h = nextAlongBorder(mesh, partners, h, pivot);
      seen[asSize(h)] = true;
      pivot = mesh.to(h) == pivot ? mesh.from(h) : mesh.to(h);
    } while (h != first);
  }
  return loops;
}

// Can faces be turned over so that partners run in opposite directions?
bool canBeOriented(const TriangleMesh& mesh, const std::vector<Index>& partners) {
  enum : char { Unknown, Kept, Turned };
  std::vector<char> sides(asSize(mesh.faceCount()), Unknown);
  std::vector<Index> pending;
  for (Index seed = 0; seed < mesh.faceCount(); ++seed) {
    if (sides[asSize(seed)] != Unknown) {
      continue;
    }
    sides[asSize(seed)] = Kept;
    pending.push_back(seed);
    while (!pending.empty()) {
      const Index face = pending.back();
      pending.pop_back();
      for (Index h = 3 * face; h < 3 * face + 3; ++h) {
        const Index partner = partners[asSize(h)];
        if (partner < 0) {
          continue;
        }
        const bool agree = mesh.from(h) != mesh.from(partner);
        const char wanted = (sides[asSize(face)] == Kept) == agree ? Kept : Turned;
        char& side = sides[asSize(TriangleMesh::faceOf(partner))];
        if (side == Unknown) {
          side = wanted;
          pending.push_back(TriangleMesh::faceOf(partner));
        } else if (side != wanted) {
          return false;
        }
      }
    }
  }
  return true;
}

Index countComponents(const TriangleMesh& mesh) {
  std::vector<Index> parents(asSize(mesh.vertexCount()));
  std::iota(parents.begin(), parents.end(), 0);
  const auto root = [&](Index v) {
    while (parents[asSize(v)] != v) {
      parents[asSize(v)] = parents[asSize(parents[asSize(v)])];
      v = parents[asSize(v)];
    }
    return v;
  };
  // The smaller root stays one: with the halving of paths above that is nearly linear.
  for (const Face& face : mesh.faces()) {
    for (const int k : {1, 2}) {
      const Index a = root(face[0]);
      const Index b = root(face[asSize(k)]);
      parents[asSize(std::max(a, b))] = std::min(a, b);
    }
  }
  Index components = 0;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    components += mesh.outgoing(v) >= 0 && parents[asSize(v)] == v ? 1 : 0;
  }
  return components;
}

// A corner of a face: the vertex, and the halfedge that leaves it in this face.
struct Corner {
  Index vertex;
  Index halfedge;
  auto operator<=>(const Corner&) const = default;
};

// Do the faces at a vertex, given all its corners, make one fan, closed or open, whichever way each runs?
bool makeOneFan(const TriangleMesh& mesh, const std::vector<Index>& partners,
                std::span<const Corner> corners) {
  const Corner& first = corners.front();
  std::size_t reached = 1;
  for (Index h : {first.halfedge, TriangleMesh::prev(first.halfedge)}) {  // away across either edge
    while (partners[asSize(h)] >= 0) {
      const Index partner = partners[asSize(h)];
      if (TriangleMesh::faceOf(partner) == TriangleMesh::faceOf(first.halfedge)) {
        return reached == corners.size();
      }
      ++reached;
      h = mesh.to(partner) == first.vertex ? TriangleMesh::next(partner) : TriangleMesh::prev(partner);
    }
    if (partners[asSize(h)] == -2) {
      return false;
    }
  }
  return reached == corners.size();
}

// The mesh itself calls a vertex singular already where its faces run in different directions.
void checkVertices(const TriangleMesh& mesh, const std::vector<Index>& partners, MeshCheck& check) {
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    check.isolatedVertices += mesh.outgoing(v) < 0 ? 1 : 0;
  }
  std::vector<Corner> corners;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h) {
    if (mesh.singular(mesh.from(h))) {
      corners.push_back({mesh.from(h), h});
    }
  }
  std::sort(corners.begin(), corners.end());
  for (auto first = corners.begin(); first != corners.end();) {
    const auto last =
        std::find_if(first, corners.end(), [&](const Corner& c) { return c.vertex != first->vertex; });
    if (!makeOneFan(mesh, partners, {first, last}) && check.singularVerticesCount++ < kMostListed) {
      check.singularVertices.push_back(first->vertex);
    }
    first = last;
  }
}

// Exactly: three points lie on one line if they do in every coordinate plane.
bool hasNoArea(const Point& a, const Point& b, const Point& c) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto plane = [&](const Point& p) { return Eigen::Vector2d(p[axis], p[(axis + 1) % 3]); };
    if (orient2d(plane(a), plane(b), plane(c)) != 0) {
      return false;
    }
  }
  return true;
}

// Scaled to a greatest coordinate of 1, so that products of it neither over- nor underflow.
Point scaled(const Point& p) {
  const double size = p.cwiseAbs().maxCoeff();
  return size > 0 ? Point(p / size) : p;
}

// In degrees: the angle opposite to the shortest edge.
double smallestAngle(const Point& a, const Point& b, const Point& c) {
  const std::array<Point, 3> corners = {a, b, c};
  std::array<double, 3> opposite = {};
  for (std::size_t k = 0; k < 3; ++k) {
    opposite[k] = (corners[(k + 2) % 3] - corners[(k + 1) % 3]).stableNorm();
  }
  const auto k =
      asSize(static_cast<Index>(std::min_element(opposite.begin(), opposite.end()) - opposite.begin()));
  const Point u = scaled(corners[(k + 1) % 3] - corners[k]);
  const Point v = scaled(corners[(k + 2) % 3] - corners[k]);
  return std::atan2(u.cross(v).norm(), u.dot(v)) * 180 / std::numbers::pi;
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return values.size() % 2 == 1 ? *middle : (*middle + *std::max_element(values.begin(), middle)) / 2;
}

void checkShape(const TriangleMesh& mesh, MeshCheck& check) {
  Eigen::AlignedBox3d box;
  for (const Face& face : mesh.faces()) {
    for (const Index v : face) {
      box.extend(mesh.point(v));
    }
  }
  check.boxMin = box.min();
  check.boxMax = box.max();
  // In units of a power of two near the greatest coordinate, so that no square leaves the doubles.
  int exponent = 0;
  std::frexp(std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff()), &exponent);
  const auto inUnits = [&](const Point& p) {
    return Point(std::ldexp(p.x(), -exponent), std::ldexp(p.y(), -exponent), std::ldexp(p.z(), -exponent));
  };
  const Point centre = (inUnits(box.min()) + inUnits(box.max())) / 2;
  std::vector<double> angles;
  angles.reserve(asSize(mesh.faceCount()));
  for (const Face& face : mesh.faces()) {
    const Point a = inUnits(mesh.point(face[0]));
    const Point b = inUnits(mesh.point(face[1]));
    const Point c = inUnits(mesh.point(face[2]));
    const Point doubled = (b - a).cross(c - a);
    check.area += doubled.norm() / 2;
    check.volume += doubled.dot(a - centre) / 6;
    const bool degenerate = hasNoArea(mesh.point(face[0]), mesh.point(face[1]), mesh.point(face[2]));
    check.degenerateFaces += degenerate ? 1 : 0;
    angles.push_back(degenerate ? 0 : smallestAngle(a, b, c));
  }
  check.area = std::ldexp(check.area, 2 * exponent);
  check.volume = std::ldexp(check.volume, 3 * exponent);
  check.smallestAngle = *std::min_element(angles.begin(), angles.end());
  check.medianSmallestAngle = median(angles);
}

}  // namespace

MeshCheck checkMesh(const TriangleMesh& mesh) {
  MeshCheck check;
  check.vertices = mesh.vertexCount();
  check.faces = mesh.faceCount();
  const std::vector<Index> partners = pairEdges(mesh, check);
  checkVertices(mesh, partners, check);
  check.components = countComponents(mesh);
  check.borderLoops = countBorderLoops(mesh, partners);
  check.eulerCharacteristic = static_cast<long>(check.vertices) - static_cast<long>(check.isolatedVertices) -
                              check.edges + check.faces;
  check.manifold = check.singularVerticesCount == 0;
  check.oriented = check.misorientedEdgesCount == 0 && check.edgesOfManyFacesCount == 0;
  check.orientable = check.edgesOfManyFacesCount == 0 && canBeOriented(mesh, partners);
  check.closed = check.borderEdges == 0;
  if (mesh.faceCount() > 0) {
    checkShape(mesh, check);
  }
  return check;
}

}  // namespace graftsman
