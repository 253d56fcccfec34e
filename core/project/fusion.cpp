#include "core/project/fusion.h"

#include <utility>

namespace graftsman {
namespace {

bool sameSettings(const FusionInputs& a, const FusionInputs& b) {
  return a.loop == b.loop && a.paths == b.paths && a.tile.allowLargeTile == b.tile.allowLargeTile &&
         a.adjustment == b.adjustment && a.embedding == b.embedding && a.fcf == b.fcf;
}

std::string stem(const MeshAsset& asset) {
  return asset.result != 0 ? asset.name : std::filesystem::path(asset.name).stem().string();
}

}  // namespace

bool same(const std::shared_ptr<const MeshAsset>& a, const std::shared_ptr<const MeshAsset>& b) {
  return a == b || (a && b && a->result != 0 && a->result == b->result);
}

bool same(const FusionInputs& a, const FusionInputs& b) {
  return a.part == b.part && a.base == b.base && sameSettings(a, b);
}

bool operator==(const Fusion& a, const Fusion& b) {
  return a.id == b.id && a.name == b.name && same(a.part, b.part) && same(a.base, b.base) &&
         a.closed == b.closed && sameSettings(a.inputs, b.inputs);
}

void setAsset(Fusion& fusion, Side side, std::shared_ptr<const MeshAsset> asset) {
  (side == Side::Part ? fusion.inputs.part : fusion.inputs.base) = asset ? asset->mesh : nullptr;
  (side == Side::Part ? fusion.part : fusion.base) = std::move(asset);
}

std::string label(const Fusion& fusion) {
  if (!fusion.name.empty()) {
    return fusion.name;
  }
  if (fusion.part && fusion.base) {
    return stem(*fusion.part) + " on " + stem(*fusion.base);
  }
  return "Fusion " + std::to_string(fusion.id);
}

}  // namespace graftsman
