#pragma once

#include <QSet>
#include <QString>
#include <optional>
#include <vector>

#include "app/document/loop_editor.h"
#include "app/document/stage_runner.h"
#include "core/project/document.h"
#include "widgets/panels/pairs_model.h"
#include "widgets/viewport/mesh_pane.h"

namespace graftsman {

/// What a person can do about a loop that makes no fusion.
enum class Remedy { None, ReverseLoop, OpenLoop, CloseLoop, ShowCV, ShowSource, KeepPlaces };

/// What stands below a pane.
struct Verdict {
  QString text;
  bool problem = false;
  Remedy remedy = Remedy::None;
  int cv = -1;  // that ShowCV shows
};

/// One mesh's side of the loop, as the window shows it.
struct SideView {
  LoopMarks marks;
  Verdict verdict;
};

/// The loop of `fusion` as the window shows it. `outcome` is the last that a run gave (null: none yet): its
/// paths and tile are shown as far as they are of the present meshes, its error where it concerns this side;
/// without an error, which CVs moved with the result that they are on (movedCVs()).
[[nodiscard]] SideView viewLoop(Side side, const Fusion& fusion, const Outcome* outcome,
                                const std::optional<HalfPair>& half, const QSet<int>& selection);

/// A row for each pair, and one for the half-made pair.
[[nodiscard]] std::vector<PairRow> pairRows(const Fusion& fusion, const Outcome* outcome,
                                            const std::optional<HalfPair>& half);

/// Why there is no result; null: there is one, or nothing was tried.
[[nodiscard]] const Error* errorOf(const Outcome* outcome);

/// "Reverse the loop", …: the text of the remedy's button; empty for none.
[[nodiscard]] QString remedyText(const Verdict& verdict);

/// The object name of the action that does the same; null: there is none.
[[nodiscard]] const char* remedyAction(Remedy remedy);

}  // namespace graftsman
