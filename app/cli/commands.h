#pragma once

#include <optional>
#include <string>

/// What `graftsman-cli fuse` was asked for.
struct FuseOptions {
  std::string input;  // a project if it ends in .graft, otherwise a scenario
  std::string output;
  std::optional<std::string> report;  // "-": standard output
  std::optional<std::string> curve;   // replaces the input's
};

/// What `graftsman-cli check` was asked for.
struct CheckOptions {
  std::string mesh;
  bool json = false;
};

/// Each does what its command says and returns the exit code: 0, or 1 with one line on stderr.
[[nodiscard]] int fuse(const FuseOptions& options);
[[nodiscard]] int check(const CheckOptions& options);
