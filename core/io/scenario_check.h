#pragma once

#include <string>
#include <string_view>

namespace graftsman {

/// What a person who typed this scenario, whose JSON is valid, surely did not mean: a key given twice, of
/// which the last would count, or one inside "adjustment" that is none of its settings. One sentence that
/// names the key; empty if there is nothing of that kind. Unknown keys beside "adjustment" are ignored, and
/// with them what they hold.
[[nodiscard]] std::string slipIn(std::string_view scenario);

}  // namespace graftsman
