#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/io/scenario.h"

// Whatever the bytes: a scenario that survives formatting and parsing again, or an error with a message.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace graftsman;
  const std::filesystem::path path = "folder/fuzz.json";
  const Result<Scenario> scenario = parseScenario({reinterpret_cast<const char*>(data), size}, path);
  if (!scenario) {
    return scenario.error().message.empty() ? std::abort(), 0 : 0;
  }
  const std::string text = formatScenario(*scenario, path);
  const Result<Scenario> back = parseScenario(text, path);
  if (!back || back->inputs.loop != scenario->inputs.loop || !(back->inputs.fcf == scenario->inputs.fcf) ||
      back->inputs.adjustment != scenario->inputs.adjustment || formatScenario(*back, path) != text) {
    std::abort();
  }
  return 0;
}
