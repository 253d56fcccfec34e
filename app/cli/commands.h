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

/// What `graftsman-cli sweep` was asked for.
struct SweepOptions {
  std::string input;
  std::string folder;
  std::string only;                 // "K/N"; empty: all
  bool dryRun = false;              // name the combinations alone
  std::optional<std::string> mesh;  // replaces the input's
  bool picture = false;             // also where the input does not ask for one
};

/// What `graftsman-cli frames` was asked for; either a turntable or a morph.
struct FramesOptions {
  std::string input;  // as FuseOptions'
  std::string folder;
  int turntable = 0;  // frames; 0: none
  int morph = 0;
  std::string size = "1280x720";
  std::string view;  // "tile" or "whole"; empty: whole for a turntable, tile for a morph
  std::string up;    // "y" or "z"; empty: guessed
};

/// Each does what its command says and returns the exit code: 0, or 1 with one line on stderr.
[[nodiscard]] int fuse(const FuseOptions& options);
[[nodiscard]] int check(const CheckOptions& options);
[[nodiscard]] int frames(const FramesOptions& options);
/// Exit code 0 also where some of the combinations do not fuse: each is told in one line on stderr and in the
/// table; 1 if none of them does.
[[nodiscard]] int sweep(const SweepOptions& options);
/// Joins the shares' tables in a folder.
[[nodiscard]] int mergeSweep(const std::string& folder);

/// K and N of "K/N" with 1 ≤ K ≤ N; nullopt: it is something else.
struct ShareNumbers {
  std::size_t number = 1;
  std::size_t of = 1;
};
[[nodiscard]] std::optional<ShareNumbers> parseShare(const std::string& text);
/// Width and height of "WxH", each from 1 to the greatest side of a picture; nullopt: it is something else.
struct SizeNumbers {
  int width = 1;
  int height = 1;
};
[[nodiscard]] std::optional<SizeNumbers> parseSize(const std::string& text);
