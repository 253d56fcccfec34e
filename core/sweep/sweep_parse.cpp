#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <set>

#include "core/io/fusion_json.h"
#include "core/io/printable.h"
#include "core/io/result_file.h"
#include "core/sweep/sweep_file.h"

namespace graftsman {

using namespace fusion_json;

namespace {

using Keys = std::initializer_list<std::string_view>;

std::string element(const std::string& key, std::size_t i) {
  return key + "[" + std::to_string(i) + "]";
}

// Throws if an object gives a key twice, of which the last would count.
void refuseRepeatedKeys(std::string_view text) {
  std::vector<std::set<std::string>> open;
  const json::parser_callback_t look = [&](int, json::parse_event_t event, json& parsed) {
    if (event == json::parse_event_t::object_start) {
      open.emplace_back();
    } else if (event == json::parse_event_t::object_end) {
      open.pop_back();
    } else if (event == json::parse_event_t::key &&
               !open.back().insert(parsed.get_ref<const std::string&>()).second) {
      throw Malformed{ErrorCode::ScenarioMalformed, "\"" + printable(parsed.get<std::string>()) +
                                                        "\" is given twice; leave one of them out."};
    }
    return true;
  };
  const json parsedAgain = json::parse(text, look);
}

// Throws if the object, which stands at `place` (empty: it is the whole), has another key.
void refuseOtherKeys(const json& object, const std::string& place, Keys known) {
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) {
      continue;
    }
    std::string message = "\"" + (place.empty() ? "" : place + ".") + printable(key) + "\" is no key of ";
    message += place.empty() ? "a sweep, which has " : "it; there may be ";
    for (const std::string_view each : known) {
      message += std::string(each) + (each.data() == (known.end() - 1)->data() ? "." : ", ");
    }
    throw Malformed{ErrorCode::ScenarioMalformed, message};
  }
}

// Calls read(entry, key of the entry) for each entry of the list under the key, if there is one.
template <class Read>
void eachOf(const json& object, const char* key, const char* entries, Read read) {
  const json* list = find(object, key);
  if (list == nullptr) {
    return;
  }
  if (!list->is_array() || list->empty()) {
    malformed(key, std::string("a list of at least one of ") + entries);
  }
  for (std::size_t i = 0; i < list->size(); ++i) {
    read((*list)[i], element(key, i), i);
  }
}

std::string nameOf(const json& object, const std::string& key, const std::string& otherwise) {
  const json* given = find(object, "name");
  if (given == nullptr) {
    return otherwise;
  }
  std::string name = string(*given, key + ".name", "a text");
  if (name.empty()) {
    malformed(key + ".name", "a text of at least one letter");
  }
  return name;
}

std::filesystem::path fileName(const json& value, const std::string& key, const char* expected,
                               const std::filesystem::path& folder) {
  const std::string file = string(value, key, expected);
  if (file.empty() || file.find('\0') != std::string::npos) {
    malformed(key, expected);
  }
  return folder / std::filesystem::path(file);
}

SweepPart part(const json& value, const std::string& key, const std::filesystem::path& folder) {
  if (!value.is_object()) {
    malformed(
        key,
        R"(an object {"m1": mesh, "cvp": pairs, "name": …}, or {"name": …} for the base fusion's own part)");
  }
  refuseOtherKeys(value, key, {"name", "m1", "cvp"});
  const json* mesh = find(value, "m1");
  const json* pairs = find(value, "cvp");
  if ((mesh == nullptr) != (pairs == nullptr)) {
    malformed(key, "an object with both \"m1\" and \"cvp\", or with neither of them");
  }
  SweepPart result;
  if (mesh != nullptr) {
    result.source = fileName(*mesh, key + ".m1", "a mesh file's name, relative to the sweep's file", folder);
    try {
      result.loop = loop(*pairs);
    } catch (const Malformed& wrong) {
      throw Malformed{wrong.code, "In \"" + key + "\": " + wrong.what};
    }
  }
  result.name = nameOf(value, key, mesh == nullptr ? "own" : result.source.stem().string());
  return result;
}

SweepCurve sweepCurve(const json& value, const std::string& key, std::size_t number) {
  const std::string numbered = "curve-" + std::to_string(number + 1);
  if (!value.is_object()) {
    return {value.is_string() ? value.get<std::string>() : numbered, curve(&value, true, key)};
  }
  refuseOtherKeys(value, key, {"name", "fcf"});
  const json* points = find(value, "fcf");
  if (points == nullptr) {
    malformed(key + ".fcf", "a preset's name or a list of points [s, f]");
  }
  return {nameOf(value, key, points->is_string() ? points->get<std::string>() : numbered),
          curve(points, true, key + ".fcf")};
}

SweepAdjustment sweepAdjustment(const json& value, const std::string& key, std::size_t number) {
  AdjustmentSettings settings = adjustment(value, {}, key);
  refuseOtherKeys(value, key,
                  {"name", "rigid", "scale", "line_field", "exact_fit", "epsilon", "max_iterations"});
  return {nameOf(value, key, "adjustment-" + std::to_string(number + 1)), settings};
}

int shift(const json& value, const std::string& key) {
  constexpr int kMost = 1'000'000;
  if (!value.is_number_integer() || value.get<double>() < -kMost || value.get<double>() > kMost) {
    malformed(key, "a whole number of CVs, such as 1 or -2");
  }
  return value.get<int>();
}

int side(const json& value, const std::string& key) {
  const Index pixels = value.is_number_unsigned() && value.get<std::uint64_t>() <= kGreatestPictureSide
                           ? static_cast<Index>(value.get<std::uint64_t>())
                           : 0;
  if (pixels < 1) {
    malformed(key, "a whole number of pixels from 1 to " + std::to_string(kGreatestPictureSide));
  }
  return pixels;
}

// Which of two words the value is.
bool isSecond(const json& value, const std::string& key, const std::string& first,
              const std::string& second) {
  const std::string word = value.is_string() ? value.get<std::string>() : "";
  if (word != first && word != second) {
    malformed(key, "\"" + first + "\" or \"" + second + "\"");
  }
  return word == second;
}

std::optional<SweepPicture> picture(const json& value) {
  if (value.is_boolean()) {
    return value.get<bool>() ? std::optional(SweepPicture()) : std::nullopt;
  }
  if (!value.is_object()) {
    malformed("picture", "true, false, or an object with size, view, up or towards");
  }
  refuseOtherKeys(value, "picture", {"size", "view", "up", "towards"});
  SweepPicture result;
  if (const json* size = find(value, "size")) {
    if (!size->is_array() || size->size() != 2) {
      malformed("picture.size", "[width, height] in pixels");
    }
    result.size = {side((*size)[0], "picture.size[0]"), side((*size)[1], "picture.size[1]")};
  }
  if (const json* view = find(value, "view")) {
    result.view = isSecond(*view, "picture.view", "tile", "whole") ? FusionView::Whole : FusionView::Tile;
  }
  if (const json* up = find(value, "up")) {
    result.yUp = !isSecond(*up, "picture.up", "y", "z");
  }
  if (const json* towards = find(value, "towards")) {
    constexpr const char* kExpected = "three numbers [x, y, z], not all 0: from the shape to the camera";
    if (!towards->is_array() || towards->size() != 3) {
      malformed("picture.towards", kExpected);
    }
    Eigen::Vector3d direction;
    for (std::size_t i = 0; i < 3; ++i) {
      direction[static_cast<Eigen::Index>(i)] = number((*towards)[i], element("picture.towards", i));
    }
    if (direction.isZero(0)) {
      malformed("picture.towards", kExpected);
    }
    result.towards = direction;
  }
  return result;
}

std::string meshEnding(const json& value) {
  std::string ending = value.is_string() ? value.get<std::string>() : "";
  if (ending == "none") {
    return {};
  }
  if (ending.find_first_not_of("abcdefghijklmnopqrstuvwxyz") != std::string::npos ||
      !isResultName("a." + ending)) {
    malformed("mesh", R"("obj", "ply", "stl", "off", "glb" or "none")");
  }
  return ending;
}

SweepFile sweepOf(const json& object, const std::filesystem::path& path) {
  if (!object.is_object()) {
    throw Malformed{ErrorCode::ScenarioMalformed, "A sweep must be a JSON object, {\"fusion\": …, …}."};
  }
  refuseOtherKeys(object, "",
                  {"fusion", "parts", "embedding", "shift", "adjustment", "deform_exponent", "fcf",
                   "monotone", "mesh", "picture", "note"});
  constexpr const char* kFusion =
      "the name of a scenario (.json) or project (.graft), relative to the sweep's file";
  SweepFile file;
  const std::filesystem::path folder = path.parent_path();
  file.fusion = fileName(demand(object, "fusion", kFusion), "fusion", kFusion, folder);
  Sweep& sweep = file.sweep;
  eachOf(object, "parts", "{\"m1\": mesh, \"cvp\": pairs}",
         [&](const json& value, const std::string& key, std::size_t) {
           sweep.parts.push_back(part(value, key, folder));
         });
  eachOf(object, "embedding", R"("automatic", "cotangent", "mean-value", "low-stretch")",
         [&](const json& value, const std::string& key, std::size_t) {
           sweep.embeddings.push_back(embeddingMethod(value, key));
         });
  eachOf(object, "shift", "whole numbers", [&](const json& value, const std::string& key, std::size_t) {
    sweep.shifts.push_back(shift(value, key));
  });
  eachOf(object, "adjustment", "objects as in a scenario",
         [&](const json& value, const std::string& key, std::size_t i) {
           sweep.adjustments.push_back(sweepAdjustment(value, key, i));
         });
  eachOf(object, "deform_exponent", "numbers greater than 0",
         [&](const json& value, const std::string& key, std::size_t) {
           sweep.falloffs.push_back(falloff(value, key));
         });
  eachOf(object, "fcf", "presets' names, lists of points [s, f], {\"name\": …, \"fcf\": …}",
         [&](const json& value, const std::string& key, std::size_t i) {
           sweep.curves.push_back(sweepCurve(value, key, i));
         });
  eachOf(object, "monotone", "true, false", [&](const json& value, const std::string& key, std::size_t) {
    sweep.monotone.push_back(boolean(value, key));
  });
  if (const json* mesh = find(object, "mesh")) {
    file.output.mesh = meshEnding(*mesh);
  }
  if (const json* given = find(object, "picture")) {
    file.output.picture = picture(*given);
  }
  return file;
}

}  // namespace

Result<SweepFile> parseSweep(std::string_view text, const std::filesystem::path& path) {
  const auto error = [&](ErrorCode code, const std::string& what) {
    return fail(code, printable(path.string(), 400) + ": " + what);
  };
  try {
    const json object = parse(text);
    refuseRepeatedKeys(text);
    SweepFile file = sweepOf(object, path);
    if (const Result<void> checked = check(file.sweep); !checked) {
      return error(ErrorCode::ScenarioMalformed, checked.error().message);
    }
    return file;
  } catch (const Malformed& wrong) {
    return error(wrong.code, wrong.what);
  }
}

}  // namespace graftsman
