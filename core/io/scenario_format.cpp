#include "core/io/fusion_json.h"
#include "core/io/scenario.h"

namespace graftsman {

std::string formatScenario(const Scenario& scenario, const std::filesystem::path& path) {
  const std::filesystem::path folder = path.parent_path();
  fusion_json::Ordered object;
  object["name"] = scenario.name;
  object["m1"] = fusion_json::relativeName(scenario.part, folder);
  object["m2"] = fusion_json::relativeName(scenario.base, folder);
  fusion_json::writeInputs(object, scenario.inputs);
  return object.dump(2, ' ', false, fusion_json::Ordered::error_handler_t::replace) + "\n";
}

}  // namespace graftsman
