#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/io/fusion_json.h"
#include "core/io/printable.h"
#include "core/io/scenario_keys.h"

namespace graftsman::fusion_json {
namespace {

// Deepest nesting of a file of ours; cvp's barycentric coordinates need 7.
constexpr int kDeepest = 64;

std::string item(const std::string& key, std::size_t i) {
  return key + "[" + std::to_string(i) + "]";
}

template <class Table>
auto oneOf(const json& value, const std::string& key, const Table& table) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const auto& entry) {
    return value.is_string() && value.get_ref<const std::string&>() == entry.first;
  });
  if (found == table.end()) {
    std::string choices;
    for (const auto& [word, meaning] : table) {
      choices += (choices.empty() ? "\"" : ", \"") + std::string(word) + "\"";
    }
    malformed(key, "one of " + choices);
  }
  return found->second;
}

// A point by its place; its numbers are those of no mesh yet.
SurfacePoint placedPoint(const json& at, const json& value, const std::string& key) {
  if (!at.is_array() || at.size() != 3) {
    malformed(key + ".at", "three numbers [x, y, z]");
  }
  Point place = Point::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    place[static_cast<Eigen::Index>(i)] = number(at[i], item(key + ".at", i));
  }
  SurfacePoint point;
  point.place = place;
  const json* vertex = find(value, "vertex");
  if (vertex == nullptr || boolean(*vertex, key + ".vertex")) {
    point.vertex = 0;
  } else {
    point.face = 0;
    point.bary = Eigen::Vector3d::UnitX();
  }
  return point;
}

SurfacePoint surfacePoint(const json& value, const std::string& key, Side side, Places places) {
  const std::string place = std::string(" of the ") + name(side);
  if (const json* at = value.is_object() && places == Places::Known ? find(value, "at") : nullptr) {
    return placedPoint(*at, value, key);
  }
  if (!value.is_object()) {
    const std::string expected =
        "a vertex number" + place + " (a whole number from 0 on) or {\"face\": number, \"bary\": [a, b, c]}";
    return SurfacePoint::atVertex(index(value, key, expected.c_str()));
  }
  const json* face = find(value, "face");
  const json* bary = find(value, "bary");
  if (face == nullptr || bary == nullptr || !bary->is_array() || bary->size() != 3) {
    malformed(key, "{\"face\": number, \"bary\": [a, b, c]} with three numbers, a point" + place);
  }
  SurfacePoint point;
  point.face = index(*face, key + ".face", ("a face number" + place + ", a whole number from 0 on").c_str());
  for (std::size_t i = 0; i < 3; ++i) {
    point.bary[static_cast<Eigen::Index>(i)] = number((*bary)[i], item(key + ".bary", i));
  }
  return point;
}

FCF takeCurve(Result<FCF> curve, const std::string& key) {
  if (!curve) {
    throw Malformed{curve.error().code, "\"" + key + "\": " + curve.error().message};
  }
  return std::move(*curve);
}

// Whether brackets outside strings nest deeper than a file of ours may.
bool nestsTooDeep(std::string_view text) {
  int depth = 0;
  bool inString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inString) {
      i += c == '\\' ? 1 : 0;
      inString = c != '"';
    } else if (c == '"') {
      inString = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kDeepest) {
        return true;
      }
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

// " at line 3, column 5: unexpected …", or where the library names no place ": number overflow …", of its
// message "[json.exception.…] parse error at line 3, …".
std::string reason(std::string_view what) {
  const std::size_t line = what.find("line ");
  if (line != std::string_view::npos) {
    return " at " + printable(what.substr(line), 240);
  }
  const std::size_t tag = what.find("] ");
  return ": " + printable(tag == std::string_view::npos ? what : what.substr(tag + 2), 240);
}

}  // namespace

[[noreturn]] void malformed(const std::string& key, const std::string& expected) {
  throw Malformed{ErrorCode::ScenarioMalformed, "\"" + key + "\" must be " + expected + "."};
}

const json* find(const json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

const json& demand(const json& object, const char* key, const char* expected) {
  const json* value = find(object, key);
  if (value == nullptr) {
    throw Malformed{ErrorCode::ScenarioMalformed,
                    std::string("\"") + key + "\" is missing; it must be " + expected + "."};
  }
  return *value;
}

double number(const json& value, const std::string& key, const char* expected) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) {
    malformed(key, expected);
  }
  return value.get<double>();
}

bool boolean(const json& value, const std::string& key) {
  if (!value.is_boolean()) {
    malformed(key, "true or false");
  }
  return value.get<bool>();
}

std::string string(const json& value, const std::string& key, const char* expected) {
  if (!value.is_string()) {
    malformed(key, expected);
  }
  return value.get<std::string>();
}

Index index(const json& value, const std::string& key, const char* expected) {
  constexpr auto kGreatest = static_cast<std::uint64_t>(std::numeric_limits<Index>::max());
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > kGreatest) {
    malformed(key, expected);
  }
  return static_cast<Index>(value.get<std::uint64_t>());
}

json parse(std::string_view text) {
  if (nestsTooDeep(text)) {
    throw Malformed{ErrorCode::ScenarioMalformed, "its JSON is nested too deep."};
  }
  try {
    return json::parse(text);
  } catch (const json::exception& exception) {
    throw Malformed{ErrorCode::ScenarioMalformed, "not valid JSON" + reason(exception.what())};
  }
}

Loop loop(const json& value, Places places) {
  if (!value.is_array()) {
    malformed("cvp", "a list of pairs [part vertex, base vertex]");
  }
  Loop result;
  result.reserve(value.size());
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::string key = item("cvp", i);
    const json& pair = value[i];
    if (!pair.is_array() || pair.size() != 2) {
      malformed(key, "a pair [part vertex, base vertex]");
    }
    result.push_back({surfacePoint(pair[0], item(key, 0), Side::Part, places),
                      surfacePoint(pair[1], item(key, 1), Side::Base, places)});
  }
  return result;
}

FCF curve(const json* value, bool monotone, const std::string& key) {
  constexpr const char* kExpected =
      "a list of at least four points [s, f], or \"linear\", \"paste\", \"keep-base-slope\" or \"half\"";
  if (value == nullptr || value->is_string()) {
    const auto preset =
        value == nullptr ? FCF::Preset::Linear : presetNamed(value->get_ref<const std::string&>());
    if (!preset) {
      malformed(key, kExpected);
    }
    return takeCurve(FCF::through(FCF::preset(*preset).points(), monotone), key);
  }
  if (!value->is_array()) {
    malformed(key, kExpected);
  }
  std::vector<FCFPoint> points;
  points.reserve(value->size());
  for (std::size_t i = 0; i < value->size(); ++i) {
    const json& pair = (*value)[i];
    const std::string place = item(key, i);
    if (!pair.is_array() || pair.size() != 2) {
      malformed(place, "a pair of numbers [s, f]");
    }
    points.push_back({number(pair[0], item(place, 0)), number(pair[1], item(place, 1))});
  }
  return takeCurve(FCF::through(std::move(points), monotone), key);
}

double falloff(const json& value, const std::string& key) {
  constexpr const char* kExpected = "a number greater than 0";
  const double falloff = number(value, key, kExpected);
  if (!(falloff > 0)) {
    malformed(key, kExpected);
  }
  return falloff;
}

AdjustmentSettings adjustment(const json& value, AdjustmentSettings settings, const std::string& key) {
  if (!value.is_object()) {
    malformed(key, "an object with rigid, scale, line_field, exact_fit, epsilon or max_iterations");
  }
  const auto flag = [&](const char* name, bool& target) {
    if (const json* found = find(value, name)) {
      target = boolean(*found, key + "." + name);
    }
  };
  flag("rigid", settings.rigid);
  flag("scale", settings.scale);
  flag("line_field", settings.lineField);
  flag("exact_fit", settings.exactFit);
  if (const json* epsilon = find(value, "epsilon")) {
    settings.epsilon = number(*epsilon, key + ".epsilon", "a number, 0 or more");
    if (settings.epsilon < 0) {
      malformed(key + ".epsilon", "a number, 0 or more");
    }
  }
  if (const json* iterations = find(value, "max_iterations")) {
    constexpr const char* kExpected = "a whole number from 1 on";
    settings.maxIterations = index(*iterations, key + ".max_iterations", kExpected);
    if (settings.maxIterations < 1) {
      malformed(key + ".max_iterations", kExpected);
    }
  }
  return settings;
}

EmbeddingSettings::Method embeddingMethod(const json& value, const std::string& key) {
  return oneOf(value, key, scenario_keys::kEmbeddingMethods);
}

void readSettings(const json& object, FusionInputs& inputs,
                  const std::function<void(const Malformed&)>& complain) {
  const auto attempt = [&](const auto& setting) {
    try {
      setting();
    } catch (const Malformed& malformed) {
      complain(malformed);
    }
  };
  const auto read = [&](const char* key, const auto& setting) {
    if (const json* value = find(object, key)) {
      attempt([&] { setting(*value); });
    }
  };
  bool monotone = true;
  read("monotone", [&](const json& value) { monotone = boolean(value, "monotone"); });
  attempt([&] { inputs.fcf = curve(find(object, "fcf"), monotone); });
  read("deform_exponent", [&](const json& value) { inputs.adjustment.falloff = falloff(value); });
  read("paths", [&](const json& value) { inputs.paths = oneOf(value, "paths", scenario_keys::kPathModes); });
  read("allow_large_tile",
       [&](const json& value) { inputs.tile.allowLargeTile = boolean(value, "allow_large_tile"); });
  read("adjustment", [&](const json& value) { inputs.adjustment = adjustment(value, inputs.adjustment); });
  read("embedding", [&](const json& value) { inputs.embedding.method = embeddingMethod(value); });
}

ReadReport readReport(const json& value) {
  if (!value.is_object()) {
    malformed("report", "an object");
  }
  ReadReport report;
  if (const json* format = find(value, "format")) {
    report.format = oneOf(*format, "report.format", scenario_keys::kMeshFormats);
  }
  if (const json* binary = find(value, "binary")) {
    report.binary = boolean(*binary, "report.binary");
  }
  for (const auto& [key, count] : scenario_keys::kReportCounts) {
    if (const json* given = find(value, key)) {
      if (!given->is_number_unsigned()) {
        malformed(std::string("report.") + key, "a whole number from 0 on");
      }
      report.*count = given->get<std::size_t>();
    }
  }
  return report;
}

}  // namespace graftsman::fusion_json
