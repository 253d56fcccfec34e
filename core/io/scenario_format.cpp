#include <nlohmann/json.hpp>

#include "core/io/scenario.h"
#include "core/io/scenario_keys.h"

namespace graftsman {
namespace {

using Json = nlohmann::ordered_json;

template <class Table, class Value>
std::string wordFor(const Table& table, Value value) {
  for (const auto& [word, meaning] : table) {
    if (meaning == value) {
      return std::string(word);
    }
  }
  return {};
}

// `file` as seen from the scenario's folder where names alone can say that, otherwise its full path.
std::string relativeName(const std::filesystem::path& file, const std::filesystem::path& folder) {
  if (folder.empty()) {
    return file.generic_string();
  }
  const std::filesystem::path relative = file.lexically_relative(folder);
  std::error_code error;
  return (relative.empty() ? std::filesystem::absolute(file, error) : relative).generic_string();
}

Json surfacePoint(const SurfacePoint& point) {
  if (point.vertex >= 0) {
    return point.vertex;
  }
  return {{"face", point.face}, {"bary", {point.bary[0], point.bary[1], point.bary[2]}}};
}

}  // namespace

std::string formatScenario(const Scenario& scenario, const std::filesystem::path& path) {
  const FusionInputs& inputs = scenario.inputs;
  const std::filesystem::path folder = path.parent_path();
  Json object;
  object["name"] = scenario.name;
  object["m1"] = relativeName(scenario.part, folder);
  object["m2"] = relativeName(scenario.base, folder);
  object["cvp"] = Json::array();
  for (const CVP& cvp : inputs.loop) {
    object["cvp"].push_back(Json::array({surfacePoint(cvp.part), surfacePoint(cvp.base)}));
  }
  object["fcf"] = Json::array();
  for (const FCFPoint& point : inputs.fcf.points()) {
    object["fcf"].push_back(Json::array({point.s, point.f}));
  }
  object["monotone"] = inputs.fcf.monotone();
  object["deform_exponent"] = inputs.adjustment.falloff;
  object["paths"] = wordFor(scenario_keys::kPathModes, inputs.paths);
  object["allow_large_tile"] = inputs.tile.allowLargeTile;
  object["adjustment"] = {
      {"rigid", inputs.adjustment.rigid},          {"scale", inputs.adjustment.scale},
      {"line_field", inputs.adjustment.lineField}, {"exact_fit", inputs.adjustment.exactFit},
      {"epsilon", inputs.adjustment.epsilon},      {"max_iterations", inputs.adjustment.maxIterations}};
  object["embedding"] = wordFor(scenario_keys::kEmbeddingMethods, inputs.embedding.method);
  return object.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace graftsman
