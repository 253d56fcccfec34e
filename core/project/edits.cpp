#include "core/project/edits.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/fusion/path_position.h"
#include "core/mesh/attach.h"

namespace graftsman::edits {
namespace {

const SurfacePoint& pointOf(const CVP& pair, Side side) {
  return side == Side::Part ? pair.part : pair.base;
}

// Error if CV `number` of that side lies nowhere on the mesh, or where another CV is.
Result<void> checkCV(const Fusion& fusion, std::size_t number, Side side) {
  const Loop& loop = fusion.inputs.loop;
  const SurfacePoint& point = pointOf(loop[number], side);
  const auto& mesh = side == Side::Part ? fusion.inputs.part : fusion.inputs.base;
  const Index count = !mesh ? 0 : point.vertex >= 0 ? mesh->vertexCount() : mesh->faceCount();
  const Index index = point.vertex >= 0 ? point.vertex : point.face;
  const std::string cv = "CV " + std::to_string(number) + " on the " + name(side);
  if (index < 0 || index >= count) {
    return fail(Error{ErrorCode::LoopIndexOutOfRange,
                      cv + " is no point of the mesh. Pick it anew.",
                      side,
                      {static_cast<int>(number)}});
  }
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (i != number && pointOf(loop[i], side) == point) {
      return fail(Error{ErrorCode::LoopRepeatsPoint,
                        cv + " would be where CV " + std::to_string(i) + " is. Pick another point.",
                        side,
                        {static_cast<int>(i), static_cast<int>(number)}});
    }
  }
  return {};
}

// On a mesh that is computed, the CV is found again by its place: already now, so that it is the very same
// point whenever the fusion is resolved.
void rememberPlace(const Fusion& fusion, Side side, SurfacePoint& point) {
  point.place.reset();
  if (fusion.upstream(side) != 0) {
    const TriangleMesh& mesh = *fusion.of(side)->mesh;
    point.place = positionOf(mesh, point);
    point = attach(mesh, point);
  }
}

}  // namespace

Fusion loadMesh(Fusion fusion, Side side, std::shared_ptr<const MeshAsset> asset) {
  if (fusion.of(side)) {
    fusion = clearLoop(std::move(fusion));
  }
  setAsset(fusion, side, std::move(asset));
  return fusion;
}

Result<Fusion> insertPair(Fusion fusion, std::size_t at, const CVP& pair) {
  Loop& loop = fusion.inputs.loop;
  loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(at), pair);
  for (const Side side : {Side::Part, Side::Base}) {
    if (Result<void> legal = checkCV(fusion, at, side); !legal) {
      return fail(std::move(legal.error()));
    }
    CVP& inserted = loop[at];
    rememberPlace(fusion, side, side == Side::Part ? inserted.part : inserted.base);
  }
  return fusion;
}

Result<Fusion> moveCV(Fusion fusion, std::size_t number, Side side, const SurfacePoint& to) {
  CVP& pair = fusion.inputs.loop[number];
  SurfacePoint& point = side == Side::Part ? pair.part : pair.base;
  point = to;
  point.place.reset();  // of somewhere else
  if (Result<void> legal = checkCV(fusion, number, side); !legal) {
    return fail(std::move(legal.error()));
  }
  rememberPlace(fusion, side, point);
  return fusion;
}

Fusion removePairs(Fusion fusion, const std::set<int>& numbers) {
  Loop& loop = fusion.inputs.loop;
  for (auto number = numbers.rbegin(); number != numbers.rend(); ++number) {
    loop.erase(loop.begin() + *number);
  }
  fusion.closed = fusion.closed && loop.size() >= 3;
  return fusion;
}

Result<Fusion> closeLoop(Fusion fusion) {
  const std::size_t pairs = fusion.inputs.loop.size();
  if (pairs < 3) {
    return fail(ErrorCode::LoopTooShort, "The loop has " + std::to_string(pairs) +
                                             (pairs == 1 ? " pair" : " pairs") +
                                             " and needs at least 3: pick more.");
  }
  fusion.closed = true;
  return fusion;
}

Fusion openLoop(Fusion fusion) {
  fusion.closed = false;
  return fusion;
}

Fusion reverseLoop(Fusion fusion) {
  Loop& loop = fusion.inputs.loop;
  if (!loop.empty()) {
    std::reverse(loop.begin() + 1, loop.end());
  }
  return fusion;
}

Fusion shiftCorrespondence(Fusion fusion) {
  const Loop before = fusion.inputs.loop;
  for (std::size_t i = 0; i < before.size(); ++i) {
    fusion.inputs.loop[(i + 1) % before.size()].part = before[i].part;
  }
  return fusion;
}

Fusion mirrorCorrespondence(Fusion fusion) {
  const Loop before = fusion.inputs.loop;
  for (std::size_t i = 1; i < before.size(); ++i) {
    fusion.inputs.loop[i].part = before[before.size() - i].part;
  }
  return fusion;
}

Fusion clearLoop(Fusion fusion) {
  fusion.inputs.loop.clear();
  fusion.closed = false;
  return fusion;
}

}  // namespace graftsman::edits
