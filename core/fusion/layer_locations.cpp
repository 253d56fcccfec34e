#include "core/fusion/layer_locations.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/fusion/overlay_predicates.h"

namespace graftsman::overlay_detail {

LayerLocations::LayerLocations(const Layer& layer, std::span<const Point> points)
    : layer_(layer), points_(points.begin(), points.end()) {
  assert(points.size() + layer.embedding->added.size() == layer.embedding->uv.size());
  points_.reserve(layer.embedding->uv.size());
  for (const AddedVertex& added : layer.embedding->added) {
    const auto corner = [&](std::size_t k) -> const Point& {
      return points_[static_cast<std::size_t>(added.corners[k])];
    };
    Point point = corner(0);
    for (const int k : {1, 2}) {
      if (added.weights[k] != 0) {
        point += added.weights[k] * (corner(static_cast<std::size_t>(k)) - corner(0));
      }
    }
    points_.push_back(point);
  }
}

bool LayerLocations::isEmbeddingVertex(Index v) const {
  return v >= layer_.seamSize() || layer_.seam[static_cast<std::size_t>(v)].t == 0;
}

Index LayerLocations::embeddingVertex(Index v) const {
  return v >= layer_.seamSize() ? layer_.embeddingVertex(v) : layer_.seam[static_cast<std::size_t>(v)].edge;
}

TileLocation LayerLocations::atVertex(Index v) const {
  if (isEmbeddingVertex(v)) {
    return {TileLocation::Kind::OnVertex, {embeddingVertex(v), -1, -1}, {1, 0, 0}};
  }
  const auto& [edge, t] = layer_.seam[static_cast<std::size_t>(v)];
  const Index end = (edge + 1) % static_cast<Index>(layer_.embedding->boundary.size());
  return {TileLocation::Kind::OnEdge, {edge, end, -1}, {1 - t, t, 0}};
}

TileLocation LayerLocations::onEdge(Index h, double t) const {
  const Index from = layer_.from(h);
  const Index to = layer_.to(h);
  if (isEmbeddingVertex(from) && isEmbeddingVertex(to)) {
    return {TileLocation::Kind::OnEdge, {embeddingVertex(from), embeddingVertex(to), -1}, {1 - t, t, 0}};
  }
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  // an edge that divides a face of the embedding
  weights[h % 3] = 1 - t;
  weights[Layer::next(h) % 3] = t;
  return inDividedFace(h / 3, weights);
}

TileLocation LayerLocations::inFace(Index f, const Point2& uv) const {
  const Face& face = layer_.faces[static_cast<std::size_t>(f)];
  const Point2& a = layer_.at(face[0]);
  const Point2& b = layer_.at(face[1]);
  const Point2& c = layer_.at(face[2]);
  Eigen::Vector3d weights(doubleArea(b, c, uv), doubleArea(c, a, uv), doubleArea(a, b, uv));
  weights = weights.cwiseMax(0);
  const double sum = weights.sum();
  weights = sum > 0 ? Eigen::Vector3d(weights / sum) : Eigen::Vector3d(1, 0, 0);
  if (std::all_of(face.begin(), face.end(), [&](Index v) { return isEmbeddingVertex(v); })) {
    return {TileLocation::Kind::InFace,
            {embeddingVertex(face[0]), embeddingVertex(face[1]), embeddingVertex(face[2])},
            weights};
  }
  return inDividedFace(f, weights);
}

TileLocation LayerLocations::inDividedFace(Index f, const Eigen::Vector3d& weights) const {
  const Face& piece = layer_.faces[static_cast<std::size_t>(f)];
  const auto origin = static_cast<std::size_t>(layer_.origins[static_cast<std::size_t>(f)]);
  TileLocation location{TileLocation::Kind::InFace, layer_.embedding->faces[origin], Eigen::Vector3d::Zero()};
  for (std::size_t k = 0; k < 3; ++k) {
    const TileLocation corner = atVertex(piece[k]);
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (location.corners[j] == corner.corners[i]) {
          location.weights[static_cast<Eigen::Index>(j)] +=
              weights[static_cast<Eigen::Index>(k)] * corner.weights[static_cast<Eigen::Index>(i)];
        }
      }
    }
  }
  return location;
}

double LayerLocations::fraction(Index h, const Point2& uv) const {
  const Point2& a = layer_.at(layer_.from(h));
  const Point2 along = layer_.at(layer_.to(h)) - a;
  return std::clamp((uv - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
}

Point LayerLocations::position(const TileLocation& location) const {
  const auto corner = [&](std::size_t k) -> const Point& {
    return points_[static_cast<std::size_t>(location.corners[k])];
  };
  const Point& a = corner(0);
  switch (location.kind) {
    case TileLocation::Kind::OnVertex:
      return a;
    case TileLocation::Kind::OnEdge:
      return a + location.weights[1] * (corner(1) - a);
    case TileLocation::Kind::InFace:
      break;
  }
  return a + (location.weights[1] * (corner(1) - a) + location.weights[2] * (corner(2) - a));
}

}  // namespace graftsman::overlay_detail
