#pragma once

#include <cstddef>
#include <functional>

namespace graftsman {

/// Sets how many threads one stage's loop may use: 0 for all of the machine's. The result never depends on
/// it.
void setThreadCount(int count);

/// The number of threads in force, at least 1.
[[nodiscard]] int threadCount();

/// Calls body(i) once for every i in [0, count), on up to threadCount() threads, and returns when all are
/// done. The calls must not depend on each other. An exception of one call is rethrown here after all have
/// stopped.
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body);

/// Calls body(begin, end) for consecutive ranges of `grain` indices that cover [0, count), likewise.
void parallelRanges(std::size_t count, std::size_t grain,
                    const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace graftsman
