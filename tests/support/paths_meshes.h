#pragma once

#include <QtTest>
#include <algorithm>
#include <random>

#include "core/base/parallel.h"
#include "core/fusion/paths.h"
#include "tests/support/samples.h"
#include "tests/support/shapes.h"
#include "tests/support/simple_loop.h"

namespace graftsman {

using shapes::MeshPtr;

inline MeshPtr meshOf(std::vector<Point> points, std::vector<Face> faces) {
  return std::make_shared<TriangleMesh>(std::move(points), std::move(faces));
}

inline MeshPtr octahedron() {
  return meshOf({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
}

inline std::shared_ptr<const Path> path(const TriangleMesh& mesh, Index from, Index to,
                                        PathMode mode = PathMode::Straightened) {
  const auto found = findPath(mesh, from, to, mode, {});
  if (!found) {
    qFatal("%s", found.error().message.c_str());
  }
  return *found;
}

inline Result<std::shared_ptr<const LoopPaths>> loop(const TriangleMesh& mesh, const std::vector<Index>& cvs,
                                                     PathMode mode = PathMode::Straightened) {
  return findPaths(mesh, cvs, mode, Side::Base, nullptr, {}, {});
}

/// What is wrong with the loop through these CVs, the error if there is one; empty if it is simple.
inline QByteArray faultOfLoop(const TriangleMesh& mesh, const std::vector<Index>& cvs,
                              PathMode mode = PathMode::Straightened) {
  const auto found = loop(mesh, cvs, mode);
  return QByteArray::fromStdString(found ? simple_loop::fault(mesh, cvs, **found) : found.error().message);
}

/// So many different vertices, none singular.
inline std::vector<Index> randomVertices(const TriangleMesh& mesh, std::size_t count, std::mt19937& random) {
  std::vector<Index> result;
  while (result.size() < count) {
    const auto v = static_cast<Index>(random() % static_cast<std::uint32_t>(mesh.vertexCount()));
    if (!mesh.singular(v) && std::find(result.begin(), result.end(), v) == result.end()) {
      result.push_back(v);
    }
  }
  return result;
}

}  // namespace graftsman
