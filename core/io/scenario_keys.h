#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "core/fusion/embedding.h"
#include "core/fusion/paths.h"

/// The words that scenarios use for settings: one table for parsing and formatting.
namespace graftsman::scenario_keys {

inline constexpr std::array<std::pair<std::string_view, PathMode>, 2> kPathModes = {
    {{"straightened", PathMode::Straightened}, {"paper", PathMode::Paper}}};

inline constexpr std::array<std::pair<std::string_view, EmbeddingSettings::Method>, 4> kEmbeddingMethods = {
    {{"automatic", EmbeddingSettings::Method::Automatic},
     {"cotangent", EmbeddingSettings::Method::Cotangent},
     {"mean-value", EmbeddingSettings::Method::MeanValue},
     {"low-stretch", EmbeddingSettings::Method::LowStretch}}};

}  // namespace graftsman::scenario_keys
