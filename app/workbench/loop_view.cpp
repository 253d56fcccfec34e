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

// The side is another fusion's result, and there is no mesh of it.
bool isUnresolved(const Fusion& fusion, Side side) {
  return fusion.upstream(side) != 0 && !fusion.of(side)->mesh;
}

// Whether the outcome is of the mesh that the fusion has on that side.
bool isOf(const Outcome* outcome, const Fusion& fusion, Side side) {
  return outcome && outcome->fusion.id == fusion.id && fusion.of(side) &&
         same(outcome->fusion.of(side), fusion.of(side)) &&
         outcome->fusion.of(side)->mesh == fusion.of(side)->mesh;
}

// The outcome's error where it is about that side; null: there is none to tell.
const Error* errorOf(const Outcome* outcome, const Fusion& fusion, Side side) {
  const Error* error = isOf(outcome, fusion, side) ? errorOf(outcome) : nullptr;
  if (!error || error->code == ErrorCode::Cancelled) {
    return nullptr;
  }
  const bool concerned = error->code == ErrorCode::SourceUnfused ? isUnresolved(fusion, side)
                                                                 : !error->side || error->side == side;
  return concerned ? error : nullptr;
}

// Of that side; null: none moved.
const Error* movedOn(Side side, const std::vector<Error>& moved) {
  const auto found = std::ranges::find(moved, std::optional(side), &Error::side);
  return found == moved.end() ? nullptr : &*found;
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
    case ErrorCode::SourceUnfused:
      return Remedy::ShowSource;
    case ErrorCode::LoopPointMoved:
      return Remedy::KeepPlaces;
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
  const Error* error = errorOf(outcome, fusion, side);
  const std::vector<Error> allMoved = movedCVs(fusion);
  const Error* moved = movedOn(side, allMoved);
  const Loop& loop = fusion.inputs.loop;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int number = static_cast<int>(i);
    view.marks.cvs.push_back({side == Side::Part ? loop[i].part : loop[i].base, number, false,
                              selection.contains(number),
                              (error && concerns(error->cvs, i)) || (moved && concerns(moved->cvs, i))});
  }
  if (half && half->side == side) {
    view.marks.cvs.push_back({half->at, static_cast<int>(loop.size()), true, false, false});
  }
  if (isOf(outcome, fusion, side) && !loop.empty()) {
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
  if (const Error* told = error ? error : moved) {
    view.verdict = {QString::fromStdString(told->message), true, remedyFor(*told), cvToShow(*told)};
  } else if (isUnresolved(fusion, side)) {
    view.verdict.text = tr("This result is being computed");
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
  const Error* error = outcome && outcome->fusion.id == fusion.id ? errorOf(outcome) : nullptr;
  const std::vector<Error> moved = movedCVs(fusion);
  const auto length = [&](Side side, std::size_t i) -> std::optional<double> {
    if (!isOf(outcome, fusion, side)) {
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
    for (const Error& one : moved) {
      if (row.problem.isEmpty() && concerns(one.cvs, i)) {
        row.problem = QString::fromStdString(one.message);
      }
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
    case Remedy::ShowSource:
      return tr("Show that fusion");
    case Remedy::KeepPlaces:
      return tr("Leave them there");
  }
  return {};
}

const char* remedyAction(Remedy remedy) {
  switch (remedy) {
    case Remedy::ReverseLoop:
      return "reverse";
    case Remedy::OpenLoop:
      return "openLoop";
    case Remedy::CloseLoop:
      return "closeLoop";
    default:
      return nullptr;
  }
}

}  // namespace graftsman
