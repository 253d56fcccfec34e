#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

namespace graftsman {

/// What a user, a file or the machine can cause. A bug is an assert instead.
enum class ErrorCode {
  // files
  FileUnreadable,     // cannot be opened or read
  FileUnwritable,     // cannot be created, written or renamed
  FormatUnknown,      // the name's ending is none that we read or write
  FileMalformed,      // the content breaks its format; the message names line or byte
  MeshOutOfRange,     // so large or so small that squares of its lengths leave the doubles
  MeshEmpty,          // a readable file without a face
  ScenarioMalformed,  // a scenario's JSON or one of its values; the message names the key
  ProjectTooNew,      // a project file that needs a newer version of the program
  // loop
  LoopTooShort,         // fewer than three pairs
  LoopIndexOutOfRange,  // a CV names a vertex or face that the mesh lacks
  LoopPointInvalid,     // barycentric coordinates that are no point of the face
  LoopRepeatsPoint,     // two CVs of one mesh are the same surface point
  LoopPointSingular,    // a CV lies where the mesh is not manifold, or on no face
  LoopPointMoved,       // a warning: a CV on another fusion's result was found again elsewhere
  // paths
  PathImpossible,  // two neighbouring CVs lie on different components
  PathsCross,      // no simple closed curve goes through the CVs in this order
  // tile
  TileNotSeparated,  // the loop does not divide the surface: it runs round a handle
  TileHasHandle,
  TileHasHole,
  TileNotManifold,
  TileEmpty,      // nothing lies left of the loop
  TileClockwise,  // the loop on the base encloses most of a closed mesh
  // later stages
  LoopDegenerate,       // the CVs coincide, so that no scale or frame is defined
  EmbeddingFailed,      // no valid embedding in double precision was found
  CombinedTileTooFine,  // the two embeddings cannot be overlaid in double precision
  // curve
  CurveTooShort,       // fewer than four points
  CurveEndsWrong,      // first point not at s = 0 or last not at s = 1
  CurveNotIncreasing,  // equal or falling s
  CurveOutOfRange,     // f outside [0, 1], or not finite
  // document
  SourcesInCircle,  // a fusion would be made of its own result
  SourceUnfused,    // a fusion's part or base is the result of one that has none
  // settings and machine
  SettingOutOfRange,
  Cancelled,
  OutOfMemory,
  Unexpected,  // an exception of a library, with its text
};

/// Which of the two meshes something concerns.
enum class Side { Part, Base };

/// "part" or "base".
[[nodiscard]] inline const char* name(Side side) {
  return side == Side::Part ? "part" : "base";
}

/// What went wrong, for a person: one sentence what and where, one how to mend it. No trailing newline.
struct Error {
  ErrorCode code;
  std::string message;
  std::optional<Side> side = {};  // the mesh concerned, where it is one
  std::vector<int> cvs = {};      // numbers of the CVs concerned
  std::vector<int> paths = {};    // numbers of the paths concerned; path i leads from CV i to CV i+1
};

template <class T>
using Result = tl::expected<T, Error>;

/// The Error as a Result: `return fail(ErrorCode::MeshEmpty, "…");`
[[nodiscard]] inline tl::unexpected<Error> fail(ErrorCode code, std::string message) {
  return tl::unexpected<Error>(Error{code, std::move(message)});
}

/// The same for an Error with its place filled in.
[[nodiscard]] inline tl::unexpected<Error> fail(Error error) {
  return tl::unexpected<Error>(std::move(error));
}

}  // namespace graftsman
