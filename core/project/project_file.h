#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/project/document.h"
#include "core/project/history.h"

namespace graftsman {

/// What a project file holds that this version does not know: carried from reading to writing untouched.
struct ProjectRemains;

/// A document with what goes with it into its file.
struct Project {
  Document document;
  FusionId shown = 1;     // the fusion that is open in the window, and that the command line fuses
  std::string thumbnail;  // PNG bytes; may be empty
  std::map<VariantId, std::string> variantPictures;  // PNG bytes of those variants that have one
  std::string viewState;  // JSON text of the interface's own (cameras, mode, …); may be empty
  std::shared_ptr<const ProjectRemains> remains;  // null for a new project
  History history;  // undo and redo; its present state is the document, or else it is not written
};

/// A project as read.
struct LoadedProject {
  Project project;
  /// What was damaged and left out, one Error for each entry; the rest of the project is whole.
  std::vector<Error> damage;
  /// All that makes the fusions' results (meshes, loops, settings, curves) is as it was saved: no damage
  /// concerns it, unless it is the variants'.
  bool fusionIntact = true;
};

/// Writes a .graft file (DESIGN.md §5): a zip whose first entry, uncompressed, is `mimetype`
/// ("application/x-graftsman"), then document.json (format version, least version of a reader, required
/// features), meshes/*.mesh (binary, little-endian, with checksums), thumbnail.png, variants/*.png,
/// view.json, history.json (bounded, see history.h). The same Project gives the same bytes. Atomic: writes
/// beside, flushes, renames; killed at any moment the file is the old or the new one, whole. Errors:
/// FileUnwritable, Cancelled, OutOfMemory.
[[nodiscard]] Result<void> writeProject(const std::filesystem::path& path, const Project& project,
                                        const Progress& progress);

/// What is wanted of a project.
enum class Wanted {
  Everything,
  Results,  // the fusions and variants, to be computed, not to be saved again: no history, no pictures
};

/// Reads a .graft file. Errors: FileUnreadable; FileMalformed (no zip, no document.json, or one that cannot
/// be understood; names the entry and the key); ProjectTooNew (needs a newer program: says which); Cancelled;
/// OutOfMemory. Memory: in proportion to the file (an entry that claims to inflate beyond reason is damage).
[[nodiscard]] Result<LoadedProject> readProject(const std::filesystem::path& path, const Progress& progress,
                                                Wanted wanted = Wanted::Everything);

}  // namespace graftsman
