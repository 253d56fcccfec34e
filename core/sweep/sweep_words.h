#pragma once

#include <string>
#include <string_view>

/// Words and numbers in the names and tables of a sweep.
namespace graftsman::sweep_words {

/// A name as part of a file's name: letters (all but A to z as they are), digits, points and hyphens;
/// whatever else becomes a hyphen. At most 40 bytes; never empty.
[[nodiscard]] std::string fileWord(std::string_view name);

/// The fewest digits that read back as the same double.
[[nodiscard]] std::string number(double value);

/// With A to Z in small letters.
[[nodiscard]] std::string lowered(std::string text);

}  // namespace graftsman::sweep_words
