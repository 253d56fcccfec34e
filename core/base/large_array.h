#pragma once

#include <cstddef>
#include <vector>

namespace graftsman {

/// Asks the system to back this memory, not yet written to, by large pages: taking them costs a tenth of what
/// as many small ones do. A hint, without effect where the system has none.
void preferLargePages(void* begin, std::size_t bytes);

/// Makes room for `count` elements in an empty vector.
template <class T>
void reserveLarge(std::vector<T>& values, std::size_t count) {
  values.reserve(count);
  preferLargePages(values.data(), count * sizeof(T));
}

}  // namespace graftsman
