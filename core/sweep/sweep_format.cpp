#include "core/io/fusion_json.h"
#include "core/io/scenario_keys.h"
#include "core/sweep/sweep_file.h"

namespace graftsman {

using fusion_json::Ordered;

namespace {

template <class List, class Write>
void list(Ordered& object, const char* key, const List& entries, Write write) {
  if (!entries.empty()) {
    object[key] = Ordered::array();
    for (const auto& entry : entries) {
      object[key].push_back(write(entry));
    }
  }
}

Ordered toJson(const SweepPicture& picture) {
  Ordered object = {{"size", {picture.size.width, picture.size.height}},
                    {"view", picture.view == FusionView::Whole ? "whole" : "tile"}};
  if (picture.yUp) {
    object["up"] = *picture.yUp ? "y" : "z";
  }
  if (picture.towards) {
    object["towards"] = {picture.towards->x(), picture.towards->y(), picture.towards->z()};
  }
  return object;
}

}  // namespace

std::string formatSweep(const SweepFile& file, const std::filesystem::path& path) {
  const std::filesystem::path folder = path.parent_path();
  const Sweep& sweep = file.sweep;
  Ordered object;
  object["fusion"] = fusion_json::relativeName(file.fusion, folder);
  list(object, "parts", sweep.parts, [&](const SweepPart& part) {
    Ordered entry = {{"name", part.name}};
    if (!part.source.empty()) {
      entry["m1"] = fusion_json::relativeName(part.source, folder);
      entry["cvp"] = fusion_json::toJson(part.loop);
    }
    return entry;
  });
  list(object, "embedding", sweep.embeddings, [](EmbeddingSettings::Method method) {
    return Ordered(scenario_keys::wordFor(scenario_keys::kEmbeddingMethods, method));
  });
  list(object, "shift", sweep.shifts, [](int shift) { return Ordered(shift); });
  list(object, "adjustment", sweep.adjustments, [](const SweepAdjustment& adjustment) {
    Ordered entry = {{"name", adjustment.name}};
    entry.update(fusion_json::toJson(adjustment.settings));
    return entry;
  });
  list(object, "deform_exponent", sweep.falloffs, [](double falloff) { return Ordered(falloff); });
  list(object, "fcf", sweep.curves, [](const SweepCurve& curve) {
    return Ordered{{"name", curve.name}, {"fcf", fusion_json::toJson(curve.curve)}};
  });
  list(object, "monotone", sweep.monotone, [](bool on) { return Ordered(on); });
  object["mesh"] = file.output.mesh.empty() ? "none" : file.output.mesh;
  object["picture"] = file.output.picture ? toJson(*file.output.picture) : Ordered(false);
  return object.dump(2, ' ', false, Ordered::error_handler_t::replace) + "\n";
}

}  // namespace graftsman
