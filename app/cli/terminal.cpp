#include "app/cli/terminal.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

using graftsman::Progress;

int reportError(const graftsman::Error& error) {
  clearProgress();
  std::string line = error.message;
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  std::fprintf(stderr, "graftsman-cli: error: %s\n", line.c_str());
  return 1;
}

Progress terminalProgress(const char* task) {
  if (isatty(STDERR_FILENO) == 0) {
    return {};
  }
  const auto start = std::chrono::steady_clock::now();
  return Progress([=](double done) {
    if (std::chrono::steady_clock::now() - start > std::chrono::seconds(1)) {
      std::fprintf(stderr, "\r\033[K%s: %3.0f %%", task, 100 * done);
    }
    return true;
  });
}

void clearProgress() {
  if (isatty(STDERR_FILENO) != 0) {
    std::fputs("\r\033[K", stderr);
  }
}
