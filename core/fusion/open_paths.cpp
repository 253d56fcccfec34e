#include "core/fusion/open_paths.h"

#include <exception>
#include <new>
#include <string>
#include <utility>

namespace graftsman {
namespace {

// The path of `previous` between the same two vertices, null if it has none.
std::shared_ptr<const Path> known(const OpenPaths& previous, Index from, Index to) {
  for (std::size_t i = 0; i < previous.paths.size(); ++i) {
    const std::vector<Index>& cvs = previous.anchored->cvs;
    if (previous.paths[i] && cvs[i] == from && cvs[(i + 1) % cvs.size()] == to) {
      return previous.paths[i];
    }
  }
  return nullptr;
}

void find(OpenPaths& now, const Loop& pairs, bool closed, Side side, const OpenPaths& previous,
          const Progress& progress) {
  Result<AnchoredLoop> anchored = anchorPoints(now.source, pairs, side);
  if (!anchored) {
    now.error = std::move(anchored.error());
    return;
  }
  now.anchored = std::make_shared<const AnchoredLoop>(std::move(*anchored));
  const bool reusable =
      previous.anchored && previous.mode == now.mode && previous.anchored->mesh == now.anchored->mesh;
  const std::vector<Index>& cvs = now.anchored->cvs;
  now.paths.resize(cvs.size() < 2 ? 0 : closed ? cvs.size() : cvs.size() - 1);
  for (std::size_t i = 0; i < now.paths.size(); ++i) {
    const Index from = cvs[i];
    const Index to = cvs[(i + 1) % cvs.size()];
    if (reusable) {
      now.paths[i] = known(previous, from, to);
    }
    if (now.paths[i]) {
      continue;
    }
    const double count = static_cast<double>(now.paths.size());
    Result<std::shared_ptr<const Path>> path =
        findPath(*now.anchored->mesh, from, to, now.mode,
                 progress.span(static_cast<double>(i) / count, static_cast<double>(i + 1) / count));
    if (path) {
      now.paths[i] = std::move(*path);
      continue;
    }
    if (!now.error) {
      now.error = std::move(path.error());
      now.error->side = side;
      now.error->paths = {static_cast<int>(i)};
    }
    if (progress.cancelled()) {
      return;
    }
  }
}

}  // namespace

OpenPaths findOpenPaths(const std::shared_ptr<const TriangleMesh>& mesh, const Loop& pairs, bool closed,
                        Side side, PathMode mode, const OpenPaths& previous, const Progress& progress) {
  OpenPaths now{mesh, mode, nullptr, {}, {}};
  try {
    find(now, pairs, closed, side, previous, progress);
  } catch (const std::bad_alloc&) {
    now.error = Error{ErrorCode::OutOfMemory,
                      "There is not enough memory for the paths. Close other programs.", side};
  } catch (const std::exception& exception) {
    now.error = Error{ErrorCode::Unexpected,
                      std::string("A geometric computation failed: ") + exception.what(), side};
  }
  return now;
}

}  // namespace graftsman
