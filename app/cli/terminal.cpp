#include "app/cli/terminal.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

using graftsman::Progress;

namespace {

void printLine(const char* kind, std::string line) {
  clearProgress();
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  std::fprintf(stderr, "graftsman-cli: %s: %s\n", kind, line.c_str());
}

}  // namespace

int reportError(const graftsman::Error& error) {
  printLine("error", error.message);
  return 1;
}

void reportWarning(const std::string& message) {
  printLine("warning", message);
}

void showStep(std::size_t step, std::size_t steps, const std::string& name) {
  if (isatty(STDERR_FILENO) != 0) {
    std::fprintf(stderr, "\r\033[K%zu of %zu: %s", step, steps, name.c_str());
  }
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
