#pragma once

#include <cstddef>
#include <string>

#include "core/base/error.h"
#include "core/base/progress.h"

/// Prints "graftsman-cli: error: …" as one line on stderr and returns the exit code 1.
[[nodiscard]] int reportError(const graftsman::Error& error);

/// A Progress that shows `task` and a percentage on stderr if that is a terminal and the job takes longer
/// than a second.
[[nodiscard]] graftsman::Progress terminalProgress(const char* task);

/// Shows "7 of 24: name" on stderr if that is a terminal.
void showStep(std::size_t step, std::size_t steps, const std::string& name);

/// Prints "graftsman-cli: warning: …" as one line on stderr.
void reportWarning(const std::string& message);

/// Removes the progress line, if there is one.
void clearProgress();
