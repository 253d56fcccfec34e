#include "core/base/large_array.h"

#ifdef __linux__
#include <malloc.h>
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

void keepFreedMemory() {
#ifdef __GLIBC__
  constexpr int kMegabyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * kMegabyte);
  mallopt(M_TRIM_THRESHOLD, 64 * kMegabyte);
#endif
}

}  // namespace graftsman
