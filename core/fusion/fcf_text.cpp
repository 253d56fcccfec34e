#include <fast_float/fast_float.h>

#include <algorithm>
#include <string>

#include "core/fusion/fcf.h"

namespace graftsman {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  return begin == std::string_view::npos ? std::string_view()
                                         : text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

std::optional<double> number(std::string_view text) {
  text = trimmed(text);
  double value = 0;
  const auto [end, code] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  return code == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::optional<FCFPoint> point(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) {
    return std::nullopt;
  }
  const std::optional<double> s = number(text.substr(0, comma));
  const std::optional<double> f = number(text.substr(comma + 1));
  return s && f ? std::optional(FCFPoint{*s, *f}) : std::nullopt;
}

}  // namespace

Result<FCF> parseFCF(std::string_view text) {
  if (const std::optional<FCF::Preset> preset = presetNamed(trimmed(text))) {
    return FCF::preset(*preset);
  }
  if (text.find_first_of(",;") == std::string_view::npos) {
    return fail(
        ErrorCode::CurveTooShort,
        "The fusion curve is neither a preset (linear, paste, keep-base-slope, half) nor a list of points; "
        "give at least four points as \"s,f;s,f;s,f;s,f\".");
  }
  std::vector<FCFPoint> points;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    const std::optional<FCFPoint> next = point(text.substr(begin, end - begin));
    if (!next) {
      return fail(ErrorCode::CurveOutOfRange, "Point " + std::to_string(points.size()) +
                                                  " of the fusion curve is not a pair of numbers; write each "
                                                  "point as \"s,f\" and a semicolon between points.");
    }
    points.push_back(*next);
    begin = end + 1;
  }
  return FCF::through(std::move(points));
}

}  // namespace graftsman
