#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/project/document_read.h"
#include "core/project/history.h"

namespace graftsman {

/// The entry history.json: a table of the different states of single fusions, one of variants, and the states
/// of the document by the numbers of these tables. A state is told by what differs from its neighbour towards
/// the present one; meshes by their numbers in document.json.
struct HistoryFile {
  using json = fusion_json::json;

  /// What the program that wrote it must know at least; another's is left alone.
  static constexpr unsigned kFormat = 1;

  /// The values of a fusion as document.json has them, without its part and base.
  using Values = std::function<json(const Fusion&)>;
  /// What document.json says of a part or base; gives the mesh a number.
  using Source = std::function<json(const std::shared_ptr<const MeshAsset>&)>;

  /// As much of the history as the bounds allow (history.h); empty if it has no steps, or its present state
  /// is not `document`. `others`: an object of what else stands in it. Meshes get numbers only if their steps
  /// are written.
  [[nodiscard]] static std::string write(const History& history, const Document& document, const json& others,
                                         const Values& values, const Source& source);

  /// Whether it is of a format that is not known here. False where that cannot be told.
  [[nodiscard]] static bool isNewer(const json& text);
  /// The history, with the document's own fusions and variants where they are equal. Throws Malformed, one
  /// clause that says why there is none (also: its present state is not `document`); what `reader` loses must
  /// throw too. Memory: in proportion to the text and kMostListed.
  [[nodiscard]] static History read(const json& text, const Document& document, const DocumentReader& reader);
  /// What stands in it that is not known here.
  [[nodiscard]] static json others(json text);
};

}  // namespace graftsman
