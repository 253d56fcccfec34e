#include "core/base/large_array.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstdint>

namespace graftsman {

void preferLargePages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
  // Whole pages within the array, so that nobody else's memory grows.
  constexpr std::uintptr_t kLargePage = std::uintptr_t{2} << 20;
  const auto from = (reinterpret_cast<std::uintptr_t>(begin) + kLargePage - 1) / kLargePage * kLargePage;
  const auto to = (reinterpret_cast<std::uintptr_t>(begin) + bytes) / kLargePage * kLargePage;
  if (to > from) {
    // The address as the system wants it; what it answers changes nothing.
    (void)madvise(reinterpret_cast<void*>(from), to - from,
                  MADV_HUGEPAGE);  // NOLINT(performance-no-int-to-ptr)
  }
#endif
}

}  // namespace graftsman
