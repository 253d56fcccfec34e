#include <string>

#include "core/io/fusion_json.h"
#include "core/io/scenario_keys.h"

namespace graftsman::fusion_json {
namespace {

Ordered surfacePoint(const SurfacePoint& point) {
  if (const auto& at = point.place) {
    return {{"at", {at->x(), at->y(), at->z()}}, {"vertex", point.vertex >= 0}};
  }
  if (point.vertex >= 0) {
    return point.vertex;
  }
  return {{"face", point.face}, {"bary", {point.bary[0], point.bary[1], point.bary[2]}}};
}

}  // namespace

Ordered toJson(const Loop& loop) {
  Ordered list = Ordered::array();
  for (const CVP& cvp : loop) {
    list.push_back(Ordered::array({surfacePoint(cvp.part), surfacePoint(cvp.base)}));
  }
  return list;
}

Ordered toJson(const FCF& curve) {
  Ordered list = Ordered::array();
  for (const FCFPoint& point : curve.points()) {
    list.push_back(Ordered::array({point.s, point.f}));
  }
  return list;
}

Ordered toJson(const AdjustmentSettings& settings) {
  return {{"rigid", settings.rigid},          {"scale", settings.scale},
          {"line_field", settings.lineField}, {"exact_fit", settings.exactFit},
          {"epsilon", settings.epsilon},      {"max_iterations", settings.maxIterations}};
}

void writeInputs(Ordered& object, const FusionInputs& inputs) {
  object["cvp"] = toJson(inputs.loop);
  object["fcf"] = toJson(inputs.fcf);
  object["monotone"] = inputs.fcf.monotone();
  object["deform_exponent"] = inputs.adjustment.falloff;
  object["paths"] = scenario_keys::wordFor(scenario_keys::kPathModes, inputs.paths);
  object["allow_large_tile"] = inputs.tile.allowLargeTile;
  object["adjustment"] = toJson(inputs.adjustment);
  object["embedding"] = scenario_keys::wordFor(scenario_keys::kEmbeddingMethods, inputs.embedding.method);
}

std::string relativeName(const std::filesystem::path& file, const std::filesystem::path& folder) {
  if (folder.empty()) {
    return file.generic_string();
  }
  const std::filesystem::path relative = file.lexically_relative(folder);
  std::error_code error;
  return (relative.empty() ? std::filesystem::absolute(file, error) : relative).generic_string();
}

Ordered toJson(const ReadReport& report) {
  Ordered object = {{"format", scenario_keys::wordFor(scenario_keys::kMeshFormats, report.format)},
                    {"binary", report.binary}};
  for (const auto& [key, count] : scenario_keys::kReportCounts) {
    object[key] = report.*count;
  }
  return object;
}

}  // namespace graftsman::fusion_json
