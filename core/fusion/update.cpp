#include "core/fusion/update.h"

#include <chrono>
#include <exception>
#include <new>
#include <string>
#include <utility>

#include "core/fusion/blend.h"

namespace graftsman {
namespace {

std::vector<Point> positionsOf(const TriangleMesh& mesh, const std::vector<Index>& vertices) {
  std::vector<Point> positions;
  positions.reserve(vertices.size());
  for (const Index v : vertices) {
    positions.push_back(mesh.point(v));
  }
  return positions;
}

bool samePoints(const Loop& a, const Loop& b, Side side) {
  if (a.size() != b.size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (side == Side::Part ? !(a[i].part == b[i].part) : !(a[i].base == b[i].base)) {
      return false;
    }
  }
  return true;
}

// Lengths between these, in any unit, can be squared, and their products summed, without leaving the doubles.
constexpr double kSmallestDiagonal = 1e-75;
constexpr double kGreatestDiagonal = 1e75;

Result<void> checkExtent(const TriangleMesh& mesh, Side side) {
  if (mesh.diagonal() >= kSmallestDiagonal && mesh.diagonal() <= kGreatestDiagonal) {
    return {};
  }
  return fail(
      ErrorCode::MeshOutOfRange,
      std::string("The ") + name(side) +
          "'s bounding box has a diagonal outside 1e-75 to 1e75: computing with it would leave the range of "
          "double precision. Scale the model, or correct its coordinates.");
}

// A value as a shared object; an Error as it is.
template <class T>
Result<std::shared_ptr<const T>> shared(Result<T> result) {
  return std::move(result).map([](T&& value) { return std::make_shared<const T>(std::move(value)); });
}

// Runs the stages in their order. After a failure it goes on, but only takes over what is still true.
class Updater {
 public:
  Updater(const FusionInputs& inputs, const FusionResults& previous, const Progress& progress,
          const StageStarted& started)
      : before_(previous), progress_(progress), started_(started) {
    now_.inputs = inputs;
  }

  FusionResults run() {
    gather(Side::Part, progress_.span(0, 0.25));
    gather(Side::Base, progress_.span(0.25, 0.5));
    adjustPart(progress_.span(0.5, 0.55));
    embedBase(progress_.span(0.55, 0.7));
    fitPart(progress_.span(0.7, 0.75));
    embedPart(progress_.span(0.75, 0.85));
    combine(progress_.span(0.85, 0.97));
    fuse(progress_.span(0.97, 1));
    return std::move(now_);
  }

 private:
  // Takes `before` over if `same`, otherwise computes `out`, unless an earlier stage has failed.
  template <class T, class Compute>
  void stage(Stage stage, std::optional<Side> side, bool same, std::shared_ptr<const T>& out,
             const std::shared_ptr<const T>& before, const Progress& progress, Compute compute) {
    if (same && before) {
      out = before;
      return;
    }
    if (now_.error) {
      return;
    }
    if (started_) {
      started_(stage, side);
    }
    const auto start = std::chrono::steady_clock::now();
    Result<std::shared_ptr<const T>> result =
        progress.keepGoing(0) ? attempt<T>(compute) : fail(ErrorCode::Cancelled, "The fusion was cancelled.");
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
    StageRun& run = now_.runs[static_cast<std::size_t>(stage)];
    run.ran = true;
    run.milliseconds += elapsed.count();
    if (side == Side::Part) {
      run.partMilliseconds += elapsed.count();
    }
    if (result) {
      out = std::move(*result);
    } else {
      now_.error = std::move(result.error());
      now_.failedAt = stage;
      if (side && !now_.error->side) {
        now_.error->side = side;
      }
    }
  }

  // The one place where exceptions of libraries become errors.
  template <class T, class Compute>
  static Result<std::shared_ptr<const T>> attempt(const Compute& compute) {
    try {
      return compute();
    } catch (const std::bad_alloc&) {
      return fail(ErrorCode::OutOfMemory,
                  "There is not enough memory for this fusion. Close other programs, or use coarser meshes.");
    } catch (const std::exception& exception) {
      return fail(ErrorCode::Unexpected, std::string("A geometric computation failed: ") + exception.what());
    }
  }

  // Anchor, paths, cut and tile of one mesh.
  void gather(Side side, const Progress& progress) {
    const bool isPart = side == Side::Part;
    SideResults& now = isPart ? now_.part : now_.base;
    const SideResults& before = isPart ? before_.part : before_.base;
    const FusionInputs& inputs = now_.inputs;
    const auto& mesh = isPart ? inputs.part : inputs.base;
    const bool sameMesh = mesh == (isPart ? before_.inputs.part : before_.inputs.base);

    stage<AnchoredLoop>(Stage::Anchor, side, sameMesh && samePoints(inputs.loop, before_.inputs.loop, side),
                        now.anchored, before.anchored, progress,
                        [&]() -> Result<std::shared_ptr<const AnchoredLoop>> {
                          if (Result<void> fits = checkExtent(*mesh, side); !fits) {
                            return fail(std::move(fits.error()));
                          }
                          return shared(anchorLoop(mesh, inputs.loop, side));
                        });
    const bool sameMode = inputs.paths == before_.inputs.paths;
    stage<LoopPaths>(
        Stage::Paths, side, now.anchored == before.anchored && sameMode, now.paths, before.paths,
        progress.span(0.05, 0.7), [&]() -> Result<std::shared_ptr<const LoopPaths>> {
          const bool reusable = before.paths && sameMode && before.anchored->mesh == now.anchored->mesh;
          return findPaths(*now.anchored->mesh, now.anchored->cvs, inputs.paths, side,
                           reusable ? before.paths.get() : nullptr,
                           reusable ? before.anchored->cvs : std::vector<Index>(), progress.span(0.05, 0.7));
        });
    stage<Cut>(Stage::Cut, side, now.anchored == before.anchored && now.paths == before.paths, now.cut,
               before.cut, progress.span(0.7, 0.8), [&]() -> Result<std::shared_ptr<const Cut>> {
                 return std::make_shared<const Cut>(cutMesh(*now.anchored->mesh, *now.paths));
               });
    const bool sameOptions = isPart || inputs.tile.allowLargeTile == before_.inputs.tile.allowLargeTile;
    stage<Tile>(
        Stage::Tile, side, now.cut == before.cut && sameOptions, now.tile, before.tile, progress.span(0.8, 1),
        [&] {
          return shared(gatherTile(*now.anchored->mesh, *now.cut, side, inputs.tile, progress.span(0.8, 1)));
        });
  }

  void adjustPart(const Progress& progress) {
    const auto cvsOf = [](const SideResults& side) {
      return side.anchored ? positionsOf(*side.anchored->mesh, side.anchored->cvs) : std::vector<Point>();
    };
    const std::vector<Point> baseCvs = cvsOf(now_.base);
    const bool same = now_.part.tile == before_.part.tile && baseCvs == cvsOf(before_.base) &&
                      now_.inputs.adjustment == before_.inputs.adjustment;
    stage<Adjustment>(Stage::Adjust, std::nullopt, same, now_.adjustment, before_.adjustment, progress, [&] {
      return shared(
          adjust(now_.part.tile->points, cvsOf(now_.part), baseCvs, now_.inputs.adjustment, progress));
    });
  }

  void embedBase(const Progress& progress) {
    const bool same =
        now_.base.tile == before_.base.tile && now_.inputs.embedding == before_.inputs.embedding;
    stage<Embedding>(Stage::Embed, Side::Base, same, now_.base.embedding, before_.base.embedding, progress,
                     [&] {
                       const Tile& tile = *now_.base.tile;
                       return shared(embed(tile.points, tile.faces, tile.boundarySize, tile.corners,
                                           now_.inputs.embedding, progress));
                     });
  }

  void fitPart(const Progress& progress) {
    const bool exact = now_.inputs.adjustment.exactFit;
    const bool same = now_.part.tile == before_.part.tile && now_.adjustment == before_.adjustment &&
                      exact == before_.inputs.adjustment.exactFit &&
                      (!exact || now_.base.embedding == before_.base.embedding);
    stage<FittedTile>(Stage::Fit, Side::Part, same, now_.fitted, before_.fitted, progress, [&] {
      return shared(exact ? fitBoundary(*now_.part.tile, *now_.adjustment, *now_.base.tile,
                                        now_.base.embedding->boundary, progress)
                          : Result<FittedTile>(keepBoundary(*now_.part.tile, *now_.adjustment)));
    });
  }

  void embedPart(const Progress& progress) {
    const bool same = now_.fitted == before_.fitted && now_.inputs.embedding == before_.inputs.embedding;
    stage<Embedding>(
        Stage::Embed, Side::Part, same, now_.part.embedding, before_.part.embedding, progress, [&] {
          const FittedTile& tile = *now_.fitted;
          return shared(embed(tile.points, tile.faces, tile.boundary, static_cast<Index>(tile.corners.size()),
                              now_.inputs.embedding, progress));
        });
  }

  void combine(const Progress& progress) {
    const bool same = now_.part.embedding == before_.part.embedding && now_.fitted == before_.fitted &&
                      now_.base.embedding == before_.base.embedding && now_.base.tile == before_.base.tile;
    stage<CombinedTile>(Stage::Overlay, std::nullopt, same, now_.combined, before_.combined, progress, [&] {
      return shared(overlay({now_.fitted->points, *now_.part.embedding},
                            {now_.base.tile->points, *now_.base.embedding}, progress));
    });
  }

  void fuse(const Progress& progress) {
    const bool sameJoin = now_.combined == before_.combined && now_.base.anchored == before_.base.anchored &&
                          now_.base.cut == before_.base.cut && now_.base.tile == before_.base.tile;
    stage<Join>(Stage::Join, std::nullopt, sameJoin, now_.join, before_.join, progress,
                [&]() -> Result<std::shared_ptr<const Join>> {
                  return std::make_shared<const Join>(
                      join(*now_.base.anchored->mesh, *now_.base.cut, *now_.base.tile, *now_.combined));
                });
    const bool sameBlend = now_.join == before_.join && now_.inputs.fcf == before_.inputs.fcf;
    stage<FusedMesh>(Stage::Blend, std::nullopt, sameBlend, now_.fused, before_.fused, progress.span(0.6, 1),
                     [&]() -> Result<std::shared_ptr<const FusedMesh>> {
                       auto fused = std::make_shared<FusedMesh>(FusedMesh{now_.join->points, now_.join});
                       blend(*now_.combined, now_.inputs.fcf, now_.join->tileVertices, fused->points);
                       return fused;
                     });
  }

  const FusionResults& before_;
  const Progress& progress_;
  const StageStarted& started_;
  FusionResults now_;
};

}  // namespace

FusionResults update(const FusionInputs& inputs, const FusionResults& previous, const Progress& progress,
                     const StageStarted& started) {
  return Updater(inputs, previous, progress, started).run();
}

const char* name(Stage stage) {
  constexpr std::array<const char*, kStageCount> kNames = {"anchor", "paths", "cut",     "tile", "adjust",
                                                           "fit",    "embed", "overlay", "join", "blend"};
  return kNames[static_cast<std::size_t>(stage)];
}

}  // namespace graftsman
