#include "core/fusion/tile_locations.h"

#include <algorithm>

#include "core/base/large_array.h"

namespace graftsman {

TileLocations::TileLocations(std::size_t count, std::size_t inFaces) : faces_(inFaces) {
  reserveLarge(places_, count);
  places_.resize(count);
}

TileLocation TileLocations::operator[](std::size_t vertex) const {
  using Kind = TileLocation::Kind;
  const Place& place = places_[vertex];
  if (place.to == kOnVertex) {
    return {Kind::OnVertex, {place.from, -1, -1}, {1, 0, 0}};
  }
  if (place.to != kInFace) {
    return {Kind::OnEdge, {place.from, place.to, -1}, {1 - place.t, place.t, 0}};
  }
  const InFace& face = faces_[static_cast<std::size_t>(place.from)];
  const Eigen::Vector2d& w = face.weights;
  return {Kind::InFace, face.corners, {std::max(0.0, 1 - (w[0] + w[1])), w[0], w[1]}};
}

void TileLocations::set(std::size_t vertex, const TileLocation& location, std::size_t slot) {
  Place& place = places_[vertex];
  place.t = location.weights[1];
  switch (location.kind) {
    case TileLocation::Kind::OnVertex:
      place.from = location.corners[0];
      place.to = kOnVertex;
      break;
    case TileLocation::Kind::OnEdge:
      place.from = location.corners[0];
      place.to = location.corners[1];
      break;
    case TileLocation::Kind::InFace:
      place.from = static_cast<Index>(slot);
      place.to = kInFace;
      faces_[slot] = {location.corners, location.weights.tail<2>()};
      break;
  }
}

}  // namespace graftsman
