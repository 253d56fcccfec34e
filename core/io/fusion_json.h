#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/fusion/update.h"
#include "core/io/mesh_file.h"

/// A fusion's values as JSON: what scenarios, projects and reports have in common.
namespace graftsman::fusion_json {

using nlohmann::json;
/// Keeps the keys in the order in which they are written.
using Ordered = nlohmann::ordered_json;

/// Thrown by the readers below and caught in the function that parses the whole file.
struct Malformed {
  ErrorCode code;
  std::string what;
};

/// Throws ScenarioMalformed: the key must be what is expected.
[[noreturn]] void malformed(const std::string& key, const std::string& expected);

/// The JSON value that the text is. Throws Malformed with line and column, or if it nests deeper than any
/// file of ours, which would only wear down the stack.
[[nodiscard]] json parse(std::string_view text);

/// The value of the key, or null if the object lacks it.
[[nodiscard]] const json* find(const json& object, const char* key);
/// The value of the key. Throws Malformed.
[[nodiscard]] const json& demand(const json& object, const char* key, const char* expected);

/// Values of one type; `key` stands in the message. Each throws Malformed.
[[nodiscard]] double number(const json& value, const std::string& key,
                            const char* expected = "a finite number");
[[nodiscard]] bool boolean(const json& value, const std::string& key);
[[nodiscard]] std::string string(const json& value, const std::string& key, const char* expected);
/// A vertex, face or other count from 0 to the greatest Index.
[[nodiscard]] Index index(const json& value, const std::string& key, const char* expected);

/// Whether a list "cvp" may name points by their places, {"at": [x, y, z], "vertex": true}: those on another
/// fusion's result, which a project has and a scenario has not.
enum class Places { Refused, Known };
/// The list "cvp" of pairs [part's, base's], each a vertex number or {"face": i, "bary": [a, b, c]}. Whether
/// the meshes have them is not known here. Throws Malformed.
[[nodiscard]] Loop loop(const json& value, Places places = Places::Refused);
[[nodiscard]] Ordered toJson(const Loop& loop);

/// Single settings; `key` stands in the message. Each throws Malformed.
/// A curve: a preset's name or a list of points [s, f]; null: linear.
[[nodiscard]] FCF curve(const json* value, bool monotone, const std::string& key = "fcf");
[[nodiscard]] double falloff(const json& value, const std::string& key = "deform_exponent");
/// The settings with those that the object has; other keys of it are ignored.
[[nodiscard]] AdjustmentSettings adjustment(const json& value, AdjustmentSettings settings,
                                            const std::string& key = "adjustment");
[[nodiscard]] EmbeddingSettings::Method embeddingMethod(const json& value,
                                                        const std::string& key = "embedding");
[[nodiscard]] Ordered toJson(const FCF& curve);
[[nodiscard]] Ordered toJson(const AdjustmentSettings& settings);

/// Reads every setting of a fusion that the object has into `inputs`: fcf, monotone, deform_exponent, paths,
/// allow_large_tile, adjustment, embedding. What is malformed is given to `complain` and leaves its setting
/// as it was; `complain` may throw.
void readSettings(const json& object, FusionInputs& inputs,
                  const std::function<void(const Malformed&)>& complain);
/// Writes every one of them, and cvp.
void writeInputs(Ordered& object, const FusionInputs& inputs);

/// A file's name in a text that is saved in `folder`: as seen from there where names alone can say that,
/// otherwise its full path. Without folder as it is.
[[nodiscard]] std::string relativeName(const std::filesystem::path& file,
                                       const std::filesystem::path& folder);

[[nodiscard]] Ordered toJson(const ReadReport& report);
/// What toJson() wrote; what is absent keeps its default. Throws Malformed.
[[nodiscard]] ReadReport readReport(const json& value);

}  // namespace graftsman::fusion_json
