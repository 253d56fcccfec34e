#include "core/io/fusion_json.h"
#include "core/io/scenario.h"

namespace graftsman {
namespace {

// `file` as seen from the scenario's folder where names alone can say that, otherwise its full path.
std::string relativeName(const std::filesystem::path& file, const std::filesystem::path& folder) {
  if (folder.empty()) {
    return file.generic_string();
  }
  const std::filesystem::path relative = file.lexically_relative(folder);
  std::error_code error;
  return (relative.empty() ? std::filesystem::absolute(file, error) : relative).generic_string();
}

}  // namespace

std::string formatScenario(const Scenario& scenario, const std::filesystem::path& path) {
  const std::filesystem::path folder = path.parent_path();
  fusion_json::Ordered object;
  object["name"] = scenario.name;
  object["m1"] = relativeName(scenario.part, folder);
  object["m2"] = relativeName(scenario.base, folder);
  fusion_json::writeInputs(object, scenario.inputs);
  return object.dump(2, ' ', false, fusion_json::Ordered::error_handler_t::replace) + "\n";
}

}  // namespace graftsman
