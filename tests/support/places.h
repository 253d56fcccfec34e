#pragma once

#include <filesystem>

/// Where the checkout's and the build's files are. Said in one source alone: all others compile to the same
/// wherever the checkout is, and a compiler cache has them.
namespace graftsman::places {

[[nodiscard]] std::filesystem::path samples();   // resources/samples
[[nodiscard]] std::filesystem::path testData();  // tests/data
[[nodiscard]] std::filesystem::path commandLine();

}  // namespace graftsman::places
