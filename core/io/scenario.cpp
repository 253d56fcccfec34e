#include "core/io/scenario.h"

#include "core/io/fusion_json.h"
#include "core/io/printable.h"
#include "core/io/scenario_check.h"

namespace graftsman {

using namespace fusion_json;

namespace {

std::filesystem::path meshPath(const json& object, const char* key, const std::filesystem::path& folder) {
  constexpr const char* kExpected = "a mesh file's name, relative to the scenario file";
  const std::string file = string(demand(object, key, kExpected), key, kExpected);
  if (file.empty() || file.find('\0') != std::string::npos) {
    malformed(key, kExpected);
  }
  return folder / std::filesystem::path(file);
}

Scenario scenarioOf(const json& object, const std::filesystem::path& path) {
  if (!object.is_object()) {
    throw Malformed{ErrorCode::ScenarioMalformed, "A scenario must be a JSON object, {\"m1\": …, …}."};
  }
  Scenario scenario;
  const json* given = find(object, "name");
  scenario.name = given == nullptr ? path.stem().string() : string(*given, "name", "a text");
  scenario.part = meshPath(object, "m1", path.parent_path());
  scenario.base = meshPath(object, "m2", path.parent_path());
  scenario.inputs.loop = loop(demand(object, "cvp", "a list of pairs [part vertex, base vertex]"));
  readSettings(object, scenario.inputs, [](const Malformed& what) { throw what; });
  return scenario;
}

}  // namespace

Result<Scenario> parseScenario(std::string_view text, const std::filesystem::path& path) {
  const auto error = [&](ErrorCode code, const std::string& what) {
    return fail(code, printable(path.string(), 400) + ": " + what);
  };
  try {
    Scenario scenario = scenarioOf(parse(text), path);
    const std::string slip = slipIn(text);
    return slip.empty() ? Result<Scenario>(std::move(scenario)) : error(ErrorCode::ScenarioMalformed, slip);
  } catch (const Malformed& wrong) {
    return error(wrong.code, wrong.what);
  }
}

}  // namespace graftsman
