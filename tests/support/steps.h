#pragma once

namespace graftsman {

/// How many of n random steps a test takes: all, or a quarter under a sanitizer, where each takes some twenty
/// times as long.
constexpr int steps(int n) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return n / 4;
#else
  return n;
#endif
}

}  // namespace graftsman
