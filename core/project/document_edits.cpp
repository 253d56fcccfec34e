#include "core/project/document_edits.h"

#include <algorithm>
#include <utility>

#include "core/mesh/attach.h"

namespace graftsman::edits {
namespace {

template <class List, class Value>
void replace(List& list, Value value) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const auto& one) { return one->id == value.id; });
  *found = std::make_shared<const Value>(std::move(value));
}

VariantId nextVariant(const VariantList& variants) {
  VariantId next = 1;
  for (const auto& variant : variants) {
    next = std::max(next, variant->id + 1);
  }
  return next;
}

// Takes `asset` for a side whose mesh is no longer computed, or computed by another fusion. The CVs there are
// found again; without a mesh to find them on they keep their places until there is one.
void changeSource(Fusion& fusion, Side side, const std::shared_ptr<const MeshAsset>& asset) {
  setAsset(fusion, side, asset);
  if (!asset) {
    fusion.inputs.loop.clear();
    fusion.closed = false;
    return;
  }
  for (CVP& pair : fusion.inputs.loop) {
    SurfacePoint& point = side == Side::Part ? pair.part : pair.base;
    if (point.place && asset->mesh) {
      point = attach(*asset->mesh, point);
    }
    if (asset->result == 0) {
      point.place.reset();
    }
  }
}

}  // namespace

Document withFusion(Document document, Fusion fusion) {
  replace(document.fusions, std::move(fusion));
  return document;
}

FusionId nextFusion(const Document& document) {
  FusionId next = 1;
  const auto pass = [&next](const FusionList& fusions) {
    for (const auto& fusion : fusions) {
      next = std::max(next, fusion->id + 1);
    }
  };
  pass(document.fusions);
  for (const auto& variant : document.variants) {
    pass(variant->fusions);
  }
  return next;
}

Document addFusion(Document document, std::shared_ptr<const MeshAsset> part,
                   std::shared_ptr<const MeshAsset> base) {
  Fusion fusion;
  fusion.id = nextFusion(document);
  setAsset(fusion, Side::Part, std::move(part));
  setAsset(fusion, Side::Base, std::move(base));
  document.fusions.push_back(std::make_shared<const Fusion>(std::move(fusion)));
  return document;
}

std::shared_ptr<const MeshAsset> resultAsset(const Fusion& fusion) {
  MeshAsset asset;
  asset.name = label(fusion);
  asset.result = fusion.id;
  if (fusion.base) {
    asset.report.format = fusion.base->report.format;  // what is up in it is so in the result
  }
  return std::make_shared<const MeshAsset>(std::move(asset));
}

Result<Document> takeResult(Document document, FusionId id, Side side, FusionId upstream) {
  const std::vector<FusionId> needed = upstreamOf(document.fusions, upstream);
  const Fusion& source = *find(document.fusions, upstream);
  Fusion fusion = *find(document.fusions, id);
  if (std::find(needed.begin(), needed.end(), id) != needed.end()) {
    return fail(ErrorCode::SourcesInCircle, "“" + label(source) + "” is itself made of “" + label(fusion) +
                                                "”, so it cannot be its " + name(side) +
                                                ". Take another fusion, or a mesh.");
  }
  if (fusion.of(side)) {
    fusion.inputs.loop.clear();
    fusion.closed = false;
  }
  setAsset(fusion, side, resultAsset(source));
  return withFusion(std::move(document), std::move(fusion));
}

Document removeFusion(Document document, FusionId id) {
  const Fusion* found = find(document.fusions, id);
  if (found == nullptr) {
    return document;
  }
  const std::shared_ptr<const MeshAsset> instead = found->base;
  std::erase_if(document.fusions, [id](const auto& fusion) { return fusion->id == id; });
  for (auto& fusion : document.fusions) {
    for (const Side side : {Side::Part, Side::Base}) {
      if (fusion->upstream(side) == id) {
        Fusion changed = *fusion;
        changeSource(changed, side, instead);
        fusion = std::make_shared<const Fusion>(std::move(changed));
      }
    }
  }
  if (document.fusions.empty()) {
    document = addFusion(std::move(document), nullptr, nullptr);
  }
  return document;
}

Document renameFusion(Document document, FusionId id, const std::string& name) {
  Fusion fusion = *find(document.fusions, id);
  fusion.name = name;
  return withFusion(std::move(document), std::move(fusion));
}

Document addVariant(Document document, const FusionList& fusions, FusionId shown, const std::string& name) {
  Variant variant;
  variant.id = nextVariant(document.variants);
  variant.name = name.empty() ? "Variant " + std::to_string(variant.id) : name;
  variant.shown = shown;
  variant.fusions = fusions;
  document.variants.push_back(std::make_shared<const Variant>(std::move(variant)));
  return document;
}

Document addVariant(Document document, FusionId shown, const std::string& name) {
  const FusionList fusions = document.fusions;
  return addVariant(std::move(document), fusions, shown, name);
}

Document withVariant(Document document, Variant variant) {
  replace(document.variants, std::move(variant));
  return document;
}

Document removeVariants(Document document, const std::set<VariantId>& ids) {
  std::erase_if(document.variants, [&](const auto& variant) { return ids.contains(variant->id); });
  return document;
}

Document applyVariant(Document document, VariantId id) {
  document.fusions = find(document.variants, id)->fusions;
  return document;
}

Document changeVariants(Document document, const std::set<VariantId>& ids,
                        const std::function<void(Fusion&)>& change) {
  for (auto& variant : document.variants) {
    if (!ids.contains(variant->id)) {
      continue;
    }
    Variant changed = *variant;
    for (auto& fusion : changed.fusions) {
      if (fusion->id == changed.shown) {
        Fusion edited = *fusion;
        change(edited);
        fusion = std::make_shared<const Fusion>(std::move(edited));
      }
    }
    variant = std::make_shared<const Variant>(std::move(changed));
  }
  return document;
}

Document crossVariants(Document document, VariantId first, VariantId second) {
  const Variant& loops = *find(document.variants, first);
  const Variant& curves = *find(document.variants, second);
  const FCF curve = find(curves.fusions, curves.shown)->inputs.fcf;
  const VariantId added = nextVariant(document.variants);
  document = addVariant(std::move(document), loops.fusions, loops.shown, loops.name + " × " + curves.name);
  return changeVariants(std::move(document), {added}, [&](Fusion& fusion) { fusion.inputs.fcf = curve; });
}

}  // namespace graftsman::edits
