#include "app/workbench/loop_view.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

#include "app/document/commands.h"

namespace graftsman {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("graftsman::LoopView", text);
}

const SideResults* resultsOf(const Outcome& outcome, Side side) {
  return !outcome.results ? nullptr : side == Side::Part ? &outcome.results->part : &outcome.results->base;
}

// The paths that are known of one side, with the mesh that they run on.
struct KnownPaths {
  const std::vector<std::shared_ptr<const Path>>* paths = nullptr;
  const TriangleMesh* mesh = nullptr;
};

KnownPaths knownPaths(const Outcome& outcome, Side side) {
  const auto& open = side == Side::Part ? outcome.openPart : outcome.openBase;
  if (open && open->anchored) {
    return {&open->paths, open->anchored->mesh.get()};
  }
  const SideResults* results = resultsOf(outcome, side);
  if (results && results->paths && results->anchored) {
    return {&results->paths->paths, results->anchored->mesh.get()};
  }
  return {};
}

bool concerns(const std::vector<int>& numbers, std::size_t i) {
  return std::find(numbers.begin(), numbers.end(), static_cast<int>(i)) != numbers.end();
}

bool concerns(const Error* error, Side side) {
  return error && (!error->side || error->side == side);
}

Remedy remedyFor(const Error& error) {
  switch (error.code) {
    case ErrorCode::TileClockwise:
    case ErrorCode::TileEmpty:
      return Remedy::ReverseLoop;
    case ErrorCode::TileHasHandle:
    case ErrorCode::TileHasHole:
      // Core looked at the other side of the loop, too.
      return error.message.find("everse") != std::string::npos ? Remedy::ReverseLoop : Remedy::None;
    case ErrorCode::TileNotSeparated:
      return Remedy::OpenLoop;
    default:
      return error.cvs.empty() ? Remedy::None : Remedy::ShowCV;
  }
}

// The CV that the message asks to move; −1: none.
int cvToShow(const Error& error) {
  if (error.cvs.empty()) {
    return -1;
  }
  return error.code == ErrorCode::PathsCross ? error.cvs[1] : error.cvs[0];
}

Verdict guidance(Side side, const Fusion& fusion, const std::optional<HalfPair>& half) {
  const std::size_t pairs = fusion.inputs.loop.size();
  const QString here = label(side);
  if (!fusion.of(side)) {
    return {tr("Load or drop a mesh here"), false, Remedy::None};
  }
  if (!fusion.part || !fusion.base) {
    return {tr("Load the other mesh, too"), false, Remedy::None};
  }
  if (half) {
    return {half->side == side ? tr("Now click its partner on the %1 (Esc abandons it)")
                                     .arg(label(side == Side::Part ? Side::Base : Side::Part))
                               : tr("Click the partner of CV %1 here").arg(pairs),
            false, Remedy::None};
  }
  if (pairs == 0) {
    return {tr("Click the first point on the %1, counter-clockwise round the region").arg(here), false,
            Remedy::None};
  }
  if (pairs < 3) {
    return {tr("Click the next point on the %1").arg(here), false, Remedy::None};
  }
  return {tr("Click the next point, or CV 0 (or press Enter) to close the loop"), false, Remedy::CloseLoop};
}

}  // namespace

const Error* errorOf(const Outcome* outcome) {
  if (!outcome) {
    return nullptr;
  }
  if (outcome->results && outcome->results->error) {
    return &*outcome->results->error;
  }
  for (const auto& open : {outcome->openPart, outcome->openBase}) {
    if (open && open->error) {
      return &*open->error;
    }
  }
  return nullptr;
}

SideView viewLoop(Side side, const Fusion& fusion, const Outcome* outcome,
                  const std::optional<HalfPair>& half, const QSet<int>& selection) {
  SideView view;
  const bool current = outcome && outcome->fusion.of(side) == fusion.of(side) && fusion.of(side);
  const Error* error = current ? errorOf(outcome) : nullptr;
  if (!concerns(error, side) || (error && error->code == ErrorCode::Cancelled)) {
    error = nullptr;
  }
  const Loop& loop = fusion.inputs.loop;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int number = static_cast<int>(i);
    view.marks.cvs.push_back({side == Side::Part ? loop[i].part : loop[i].base, number, false,
                              selection.contains(number), error && concerns(error->cvs, i)});
  }
  if (half && half->side == side) {
    view.marks.cvs.push_back({half->at, static_cast<int>(loop.size()), true, false, false});
  }
  if (current && !loop.empty()) {
    const KnownPaths known = knownPaths(*outcome, side);
    for (std::size_t i = 0; known.paths && i < known.paths->size(); ++i) {
      if (const auto& path = (*known.paths)[i]) {
        PathMark mark{{}, static_cast<int>(i), error && concerns(error->paths, i)};
        mark.points.reserve(path->points.size());
        for (const EdgePoint& point : path->points) {
          mark.points.push_back(position(*known.mesh, point));
        }
        view.marks.paths.push_back(std::move(mark));
      }
    }
    const SideResults* results = resultsOf(*outcome, side);
    view.marks.tile = fusion.closed && results ? results->tile : nullptr;
  }
  if (error) {
    view.verdict = {QString::fromStdString(error->message), true, remedyFor(*error), cvToShow(*error)};
  } else if (fusion.closed && view.marks.tile) {
    view.verdict.text =
        tr("The tile is a disk of %1 faces").arg(QLocale().toString(view.marks.tile->faces.size()));
  } else if (!fusion.closed) {
    view.verdict = guidance(side, fusion, half);
  }
  return view;
}

std::vector<PairRow> pairRows(const Fusion& fusion, const Outcome* outcome,
                              const std::optional<HalfPair>& half) {
  std::vector<PairRow> rows;
  const Error* error = errorOf(outcome);
  const auto length = [&](Side side, std::size_t i) -> std::optional<double> {
    if (!outcome || outcome->fusion.of(side) != fusion.of(side)) {
      return {};
    }
    const KnownPaths known = knownPaths(*outcome, side);
    return known.paths && i < known.paths->size() && (*known.paths)[i]
               ? std::optional((*known.paths)[i]->length)
               : std::nullopt;
  };
  const Loop& loop = fusion.inputs.loop;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    PairRow row{loop[i].part, loop[i].base, length(Side::Part, i), length(Side::Base, i), {}};
    if (error && (concerns(error->cvs, i) || concerns(error->paths, i))) {
      row.problem = QString::fromStdString(error->message);
    }
    rows.push_back(std::move(row));
  }
  if (half) {
    PairRow row;
    (half->side == Side::Part ? row.part : row.base) = half->at;
    rows.push_back(std::move(row));
  }
  return rows;
}

QString remedyText(const Verdict& verdict) {
  switch (verdict.remedy) {
    case Remedy::None:
      return {};
    case Remedy::ReverseLoop:
      return tr("Reverse the loop");
    case Remedy::OpenLoop:
      return tr("Open the loop");
    case Remedy::CloseLoop:
      return tr("Close the loop");
    case Remedy::ShowCV:
      return tr("Show CV %1").arg(verdict.cv);
  }
  return {};
}

}  // namespace graftsman
