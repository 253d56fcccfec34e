#include "core/project/edits.h"

#include <algorithm>
#include <string>
#include <utility>

namespace graftsman::edits {
namespace {

const SurfacePoint& pointOf(const CVP& pair, Side side) {
  return side == Side::Part ? pair.part : pair.base;
}

// Error if CV `number` of that side lies nowhere on the mesh, or where another CV is.
Result<void> checkCV(const Document& document, std::size_t number, Side side) {
  const Loop& loop = document.inputs.loop;
  const SurfacePoint& point = pointOf(loop[number], side);
  const auto& mesh = side == Side::Part ? document.inputs.part : document.inputs.base;
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

}  // namespace

Document loadMesh(Document document, Side side, std::shared_ptr<const MeshAsset> asset) {
  auto& slot = side == Side::Part ? document.part : document.base;
  auto& mesh = side == Side::Part ? document.inputs.part : document.inputs.base;
  if (mesh) {
    document = clearLoop(std::move(document));
  }
  mesh = asset ? asset->mesh : nullptr;
  slot = std::move(asset);
  return document;
}

Result<Document> insertPair(Document document, std::size_t at, const CVP& pair) {
  Loop& loop = document.inputs.loop;
  loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(at), pair);
  for (const Side side : {Side::Part, Side::Base}) {
    if (Result<void> legal = checkCV(document, at, side); !legal) {
      return fail(std::move(legal.error()));
    }
  }
  return document;
}

Result<Document> moveCV(Document document, std::size_t number, Side side, const SurfacePoint& to) {
  CVP& pair = document.inputs.loop[number];
  (side == Side::Part ? pair.part : pair.base) = to;
  if (Result<void> legal = checkCV(document, number, side); !legal) {
    return fail(std::move(legal.error()));
  }
  return document;
}

Document removePairs(Document document, const std::set<int>& numbers) {
  Loop& loop = document.inputs.loop;
  for (auto number = numbers.rbegin(); number != numbers.rend(); ++number) {
    loop.erase(loop.begin() + *number);
  }
  document.closed = document.closed && loop.size() >= 3;
  return document;
}

Result<Document> closeLoop(Document document) {
  const std::size_t pairs = document.inputs.loop.size();
  if (pairs < 3) {
    return fail(ErrorCode::LoopTooShort, "The loop has " + std::to_string(pairs) +
                                             (pairs == 1 ? " pair" : " pairs") +
                                             " and needs at least 3: pick more.");
  }
  document.closed = true;
  return document;
}

Document openLoop(Document document) {
  document.closed = false;
  return document;
}

Document reverseLoop(Document document) {
  Loop& loop = document.inputs.loop;
  if (!loop.empty()) {
    std::reverse(loop.begin() + 1, loop.end());
  }
  return document;
}

Document shiftCorrespondence(Document document) {
  const Loop before = document.inputs.loop;
  for (std::size_t i = 0; i < before.size(); ++i) {
    document.inputs.loop[(i + 1) % before.size()].part = before[i].part;
  }
  return document;
}

Document mirrorCorrespondence(Document document) {
  const Loop before = document.inputs.loop;
  for (std::size_t i = 1; i < before.size(); ++i) {
    document.inputs.loop[i].part = before[before.size() - i].part;
  }
  return document;
}

Document clearLoop(Document document) {
  document.inputs.loop.clear();
  document.closed = false;
  return document;
}

}  // namespace graftsman::edits
