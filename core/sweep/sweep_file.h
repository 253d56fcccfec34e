#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/picture/fusion_view.h"
#include "core/picture/picture.h"
#include "core/sweep/sweep.h"

namespace graftsman {

/// Pictures of a sweep's results: all by one camera, which shows the base fusion (cameraFor()).
struct SweepPicture {
  PictureSize size = {512, 384};
  FusionView view = FusionView::Tile;
  std::optional<bool> yUp = {};                 // which way is up; without it see guessYUp()
  std::optional<Eigen::Vector3d> towards = {};  // as ViewDirection's; without it see firstDirection()
};

/// What is written of each result besides its row in the table.
struct SweepOutput {
  std::string mesh = "ply";  // the ending of a format that writeResult() knows; empty: no mesh
  std::optional<SweepPicture> picture = {};
};

/// A sweep as plain text, before its meshes are read.
struct SweepFile {
  std::filesystem::path fusion;  // scenario or project, resolved against the sweep's folder
  /// Without base; parts without mesh, their CVs in the files' own numbers. Without source: the base
  /// fusion's.
  Sweep sweep;
  SweepOutput output;
};

/// A sweep that can be run.
struct LoadedSweep {
  Sweep sweep;
  SweepOutput output;
  ViewDirection direction;                     // of the pictures
  std::vector<std::filesystem::path> sources;  // the files that it was read from
  std::string fingerprint;                     // sixteen digits that stand for the sweep with its meshes
};

/// Parses the JSON text of a sweep. Keys:
///   fusion           the base fusion: a scenario or project, relative to the sweep's file; required
///   parts            a list of parts: {"m1": mesh, "cvp": pairs as in a scenario, "name": …}; {"name": …}
///   alone is
///                    the base fusion's own; without name the mesh's file name counts
///   embedding        a list of a scenario's values
///   shift            a list of whole numbers: by how many CVs the correspondence is turned
///   adjustment       a list of objects as in a scenario, each with or without "name"; what one leaves out
///   has
///                    its default
///   deform_exponent  a list of falloffs
///   fcf              a list of curves: a preset's name, points [[s, f], …], or {"name": …, "fcf": points}
///   monotone         a list of true and false
///   mesh             "obj", "ply" (the default), "stl", "off", "glb" or "none"
///   picture          true, false (the default), or {"size": [width, height], "view": "tile" | "whole",
///                    "up": "y" | "z", "towards": [x, y, z]}
///   note             is ignored
/// A list has at least one entry. Error: ScenarioMalformed with the key (and for broken JSON the line): also
/// for a key that is none of these, at any level, and for one given twice; the curve's own errors; those of
/// check(). `path` gives the folder, and stands in messages.
[[nodiscard]] Result<SweepFile> parseSweep(std::string_view text, const std::filesystem::path& path);

/// The JSON text of a sweep that would be saved at `path`: parseSweep() of it with the same path gives an
/// equal sweep. Ends with a newline.
[[nodiscard]] std::string formatSweep(const SweepFile& file, const std::filesystem::path& path);

/// Reads a sweep, its base fusion and the meshes of its parts, each file once. Errors: those of parseSweep(),
/// readFusion() and readMesh(), and LoopIndexOutOfRange; the part concerned is named.
[[nodiscard]] Result<LoadedSweep> readSweep(const std::filesystem::path& path, const Progress& progress);

/// A sweep of values in memory made ready: checked, and with its fingerprint. `isObj` as for guessYUp().
/// Errors: those of check().
[[nodiscard]] Result<LoadedSweep> loadSweep(Sweep sweep, SweepOutput output, bool isObj);

}  // namespace graftsman
