#pragma once

#include <cstddef>
#include <vector>

namespace graftsman {

/// Asks the system to back this memory, not yet written to, by large pages: taking them costs a tenth of what
/// as many small ones do. A hint, without effect where the system has none.
void preferLargePages(void* begin, std::size_t bytes);

/// Lets the process keep up to 64 MB of what it frees, rather than give it back to the system and fetch it
/// again at the next run: an overlay that is run again spends a seventh of its time on that. For a program's
/// main(), before its threads start. Without effect but with glibc.
void keepFreedMemory();

/// Makes room for `count` elements in an empty vector.
template <class T>
void reserveLarge(std::vector<T>& values, std::size_t count) {
  values.reserve(count);
  preferLargePages(values.data(), count * sizeof(T));
}

}  // namespace graftsman
