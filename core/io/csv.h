#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

/// Tables as text with commas (RFC 4180): rows end with CR LF; a cell with a comma, a quote or a line break
/// stands in quotes, and quotes in it are doubled.
namespace graftsman::csv {

using Row = std::vector<std::string>;

/// Appends the row to the text.
void append(std::string& text, const Row& row);

/// The rows of a text; a line feed alone ends a row, too. Error: FileMalformed with the line (a quote in the
/// middle of a cell, one that is never closed); `path` stands in messages.
[[nodiscard]] Result<std::vector<Row>> parse(std::string_view text, std::string_view path);

}  // namespace graftsman::csv
