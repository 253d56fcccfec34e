#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"

/// Prints "graftsman-cli: error: …" as one line on stderr and returns the exit code 1.
[[nodiscard]] int reportError(const graftsman::Error& error);

/// A Progress that shows `task` and a percentage on stderr if that is a terminal and the job takes longer
/// than a second.
[[nodiscard]] graftsman::Progress terminalProgress(const char* task);

/// Removes the progress line, if there is one.
void clearProgress();
