#include "core/fusion/embedding.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <string>

#include "core/fusion/embedding_boundary.h"
#include "core/fusion/embedding_layout.h"
#include "core/fusion/embedding_tile.h"
#include "core/fusion/embedding_weights.h"
#include "core/fusion/low_stretch.h"

namespace graftsman {
namespace {

using Method = EmbeddingSettings::Method;

/// A layout with the weights it came from.
struct Candidate {
  Layout layout;
  EmbeddingWeights weights = EmbeddingWeights::Cotangent;
};

/// Tries one kind of weights after the other; every step gives nothing if it was cancelled.
class Search {
 public:
  Search(const LayoutProblem& problem, const Progress& progress) : problem_(problem), progress_(progress) {}

  [[nodiscard]] Index flippedCotangent() const { return flippedCotangent_; }

  std::optional<Candidate> cotangent(Effort effort) {
    auto layout = layOut(problem_, cotangentWeights(problem_.tile, problem_.stars), MatrixKind::Symmetric, {},
                         effort, nextPart());
    if (!layout) {
      return {};
    }
    flippedCotangent_ = layout->check.flippedFaces;
    return Candidate{std::move(*layout), EmbeddingWeights::Cotangent};
  }

  std::optional<Candidate> meanValue(Effort effort) {
    auto layout = layOut(problem_, meanValueWeights(problem_.tile, problem_.stars),
                         MatrixKind::NearlySymmetric, {}, effort, nextPart());
    return layout ? std::optional(Candidate{std::move(*layout), EmbeddingWeights::MeanValue}) : std::nullopt;
  }

  std::optional<Candidate> lowStretch(const SlotWeights& base, Layout start) {
    auto layout = lowStretchLayout(problem_, base, std::move(start), nextPart());
    return layout ? std::optional(Candidate{std::move(*layout), EmbeddingWeights::LowStretch}) : std::nullopt;
  }

  std::optional<Candidate> lowStretchFromUniform() {
    const SlotWeights uniform = uniformWeights(problem_.stars);
    auto start = layOut(problem_, uniform, MatrixKind::NearlySymmetric, {}, Effort::Decide, nextPart());
    return start ? lowStretch(uniform, std::move(*start)) : std::nullopt;
  }

  std::optional<Candidate> only(Method method) {
    if (method == Method::MeanValue) {
      return meanValue(Effort::Full);
    }
    auto harmonic = cotangent(method == Method::Cotangent ? Effort::Full : Effort::Decide);
    if (!harmonic || method == Method::Cotangent) {
      return harmonic;
    }
    return lowStretch(meanValueWeights(problem_.tile, problem_.stars), std::move(harmonic->layout));
  }

  std::optional<Candidate> automatic() {
    auto best = cotangent(Effort::Decide);
    if (!best || isGood(*best)) {
      return best;
    }
    if (!best->layout.check.squeezes()) {
      auto candidate = meanValue(Effort::Decide);
      if (!candidate || isGood(*candidate)) {
        return candidate;
      }
      best = std::move(candidate);
    }
    auto open = lowStretch(meanValueWeights(problem_.tile, problem_.stars), best->layout);
    if (!open || open->layout.check.valid() || best->layout.check.valid()) {
      return !open || open->layout.check.valid() ? std::move(open) : std::move(best);
    }
    return rescue();
  }

 private:
  static bool isGood(const Candidate& c) { return c.layout.check.valid() && !c.layout.check.squeezes(); }

  /// Whatever is valid, at any cost.
  std::optional<Candidate> rescue() {
    auto candidate = meanValue(Effort::Full);
    if (!candidate || candidate->layout.check.valid()) {
      return candidate;
    }
    return lowStretchFromUniform();
  }

  /// A half of what is left: few tiles need a second part.
  Progress nextPart() {
    const double from = done_;
    done_ += (1 - done_) / 2;
    return progress_.span(from, done_);
  }

  const LayoutProblem& problem_;
  const Progress& progress_;
  double done_ = 0;
  Index flippedCotangent_ = 0;
};

tl::unexpected<Error> failure(const LayoutCheck& check, const EmbeddingTile& tile, Method method) {
  const Face& face = tile.faces[static_cast<std::size_t>(check.badFaces.front())];
  const auto text = [](auto number) { return std::to_string(number); };
  return fail(
      ErrorCode::EmbeddingFailed,
      "The region cannot be laid out flat: " + text(check.badFaces.size()) + " of its " +
          text(tile.faces.size()) + " triangles would fold over, the first at vertices " + text(face[0]) +
          ", " + text(face[1]) + ", " + text(face[2]) + " of the region. " +
          (method == Method::Automatic ? "Remesh or simplify the model there, or choose a smaller region."
                                       : "Let the embedding's method be chosen automatically."));
}

tl::unexpected<Error> cancelled() {
  return fail(ErrorCode::Cancelled, "The embedding was cancelled.");
}

}  // namespace

Result<Embedding> embed(std::span<const Point> points, std::span<const Face> faces, Index boundarySize,
                        std::span<const Index> corners, const EmbeddingSettings& settings,
                        const Progress& progress) {
  assert(corners.size() >= 3 && corners[0] == 0 && corners.back() < boundarySize);
  return embed(points, faces, layOutBoundary(points, boundarySize, corners),
               static_cast<Index>(corners.size()), settings, progress);
}

Result<Embedding> embed(std::span<const Point> points, std::span<const Face> faces,
                        std::vector<BoundaryPosition> boundaryPositions, Index sides,
                        const EmbeddingSettings& settings, const Progress& progress) {
  assert(!faces.empty());
  const auto bad = std::find_if(points.begin(), points.end(), [](const Point& p) { return !p.allFinite(); });
  if (bad != points.end()) {
    return fail(ErrorCode::EmbeddingFailed,
                "Vertex " + std::to_string(bad - points.begin()) +
                    " of the region has a coordinate that is no number. Repair the model.");
  }
  if (!progress.keepGoing(0)) {
    return cancelled();
  }
  EmbeddingTile tile = prepareTile(points, faces, static_cast<Index>(boundaryPositions.size()));
  if (!progress.keepGoing(0.05)) {
    return cancelled();
  }
  const Stars stars = gatherStars(tile);
  Embedding embedding;
  embedding.sides = sides;
  embedding.boundary = std::move(boundaryPositions);
  std::vector<Point2> boundary(embedding.boundary.size());
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    boundary[i] = boundaryPoint(embedding.sides, embedding.boundary[i]);
  }
  const LayoutProblem problem{tile, stars, boundary, embedding.sides};
  const Progress rest = progress.span(0.1, 1);
  Search search(problem, rest);
  auto found = settings.method == Method::Automatic ? search.automatic() : search.only(settings.method);
  if (!found || !progress.keepGoing(1)) {
    return cancelled();
  }
  if (!found->layout.check.valid()) {
    return failure(found->layout.check, tile, settings.method);
  }
  embedding.uv = std::move(found->layout.uv);
  embedding.faces = std::move(tile.faces);
  embedding.parents = std::move(tile.parents);
  embedding.added = std::move(tile.added);
  embedding.weights = found->weights;
  embedding.flippedCotangent = search.flippedCotangent();
  embedding.smallestAreaRatio = found->layout.check.smallestAreaRatio;
  return embedding;
}

}  // namespace graftsman
