#include "core/project/evaluate.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <utility>

#include "core/fusion/path_position.h"
#include "core/mesh/attach.h"

namespace graftsman {
namespace {

// As a fraction of the mesh's diagonal: farther than this a person should look at the CV.
constexpr double kNoticeable = 0.01;

void resolveSide(Fusion& fusion, Side side, const ResultAssets& assets) {
  const FusionId upstream = fusion.upstream(side);
  const auto found = assets.find(upstream);
  if (upstream == 0 || (found != assets.end() && fusion.of(side) == found->second)) {
    return;
  }
  if (found == assets.end() || !found->second) {
    MeshAsset missing = *fusion.of(side);
    missing.mesh = nullptr;
    setAsset(fusion, side, std::make_shared<const MeshAsset>(std::move(missing)));
    return;
  }
  setAsset(fusion, side, found->second);
  for (CVP& pair : fusion.inputs.loop) {
    SurfacePoint& point = side == Side::Part ? pair.part : pair.base;
    if (point.place) {
      point = attach(*found->second->mesh, point);
    }
  }
}

bool canFuse(const Fusion& fusion) {
  return fusion.closed && fusion.inputs.part && fusion.inputs.base;
}

// The result as a mesh for other fusions: the same object until the result is another.
std::shared_ptr<const MeshAsset> assetOf(const Fusion& fusion, Evaluated::One& one) {
  if (!one.results.fused || one.results.error) {
    return nullptr;
  }
  if (!one.asset || one.of != one.results.fused || one.asset->name != label(fusion)) {
    auto asset = std::make_shared<MeshAsset>();
    asset->name = label(fusion);
    asset->result = fusion.id;
    asset->report.format = fusion.base->report.format;
    asset->mesh =
        one.asset && one.of == one.results.fused
            ? one.asset->mesh
            : std::make_shared<const TriangleMesh>(one.results.fused->points, one.results.fused->faces());
    one.of = one.results.fused;
    one.asset = std::move(asset);
  }
  return one.asset;
}

// Why `fusion` cannot be computed: `upstream`, which it is made of at some remove, has no result.
Error unfused(const Fusion& fusion, const Fusion& upstream, const FusionResults& results) {
  std::string why = !upstream.closed ? "its loop is open." : "it lacks a mesh.";
  Error error{ErrorCode::SourceUnfused, {}};
  if (results.error) {
    why = results.error->message;
    error.code = results.error->code == ErrorCode::Cancelled ? ErrorCode::Cancelled : error.code;
  }
  for (const Side side : {Side::Part, Side::Base}) {
    if (fusion.upstream(side) == upstream.id) {
      error.side = side;
    }
  }
  error.message =
      "“" + label(upstream) + "”, which this fusion is made of, has no result: " + why + " Mend it first.";
  return error;
}

}  // namespace

void Evaluated::prune(const FusionList& list) {
  std::erase_if(fusions, [&](const auto& one) { return find(list, one.first) == nullptr; });
}

Fusion resolve(Fusion fusion, const ResultAssets& assets) {
  resolveSide(fusion, Side::Part, assets);
  resolveSide(fusion, Side::Base, assets);
  return fusion;
}

std::vector<Error> movedCVs(const Fusion& resolved) {
  std::vector<Error> moved;
  for (const Side side : {Side::Part, Side::Base}) {
    const auto& asset = resolved.of(side);
    if (!asset || asset->result == 0 || !asset->mesh) {
      continue;
    }
    Error error{ErrorCode::LoopPointMoved, {}, side};
    double greatest = 0;
    std::string numbers;
    for (std::size_t i = 0; i < resolved.inputs.loop.size(); ++i) {
      const CVP& pair = resolved.inputs.loop[i];
      const SurfacePoint& point = side == Side::Part ? pair.part : pair.base;
      const double distance = point.place ? (positionOf(*asset->mesh, point) - *point.place).norm() : 0;
      if (distance > kNoticeable * asset->mesh->diagonal()) {
        error.cvs.push_back(static_cast<int>(i));
        numbers += (numbers.empty() ? "" : ", ") + std::to_string(i);
        greatest = std::max(greatest, distance / asset->mesh->diagonal());
      }
    }
    if (!error.cvs.empty()) {
      std::array<char, 16> percent = {};
      std::snprintf(percent.data(), percent.size(), "%.2g", 100 * greatest);
      error.message = "“" + asset->name + "” has changed: CV " + numbers + " on the " + name(side) +
                      " moved by up to " + percent.data() + " % of its size. Look at the loop.";
      moved.push_back(std::move(error));
    }
  }
  return moved;
}

Upstream evaluateUpstream(const FusionList& fusions, FusionId id, Evaluated& known, const Progress& progress,
                          const StageStarted& started) {
  known.prune(fusions);
  std::vector<FusionId> order = upstreamOf(fusions, id);
  order.pop_back();
  Upstream upstream;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Fusion fusion = resolve(*find(fusions, order[i]), upstream.assets);
    Evaluated::One& one = known.fusions[fusion.id];
    const bool can = canFuse(fusion);
    if (can) {
      const auto share = [&](std::size_t done) {
        return static_cast<double>(done) / static_cast<double>(order.size());
      };
      one.results = update(fusion.inputs, one.results, progress.span(share(i), share(i + 1)), started);
    }
    if (const auto asset = can ? assetOf(fusion, one) : nullptr) {
      upstream.assets[fusion.id] = asset;
    } else {
      upstream.error = unfused(*find(fusions, id), fusion, can ? one.results : FusionResults());
      // A cancelled run says nothing of those that it did not come to.
      for (; upstream.error->code != ErrorCode::Cancelled && i < order.size(); ++i) {
        upstream.assets[order[i]] = nullptr;
      }
      break;
    }
  }
  return upstream;
}

Evaluation evaluate(const FusionList& fusions, FusionId id, Evaluated& known, const Progress& progress,
                    const StageStarted& started) {
  const bool stacked = upstreamOf(fusions, id).size() > 1;
  const double share = stacked ? 0.5 : 0;
  Upstream upstream = evaluateUpstream(fusions, id, known, progress.span(0, share), started);
  Evaluation evaluation{resolve(*find(fusions, id), upstream.assets), std::move(upstream.assets), {}};
  if (upstream.error) {
    evaluation.results.error = std::move(upstream.error);
  } else if (canFuse(evaluation.fusion)) {
    FusionResults& results = known.fusions[id].results;
    results = update(evaluation.fusion.inputs, results, progress.span(share, 1), started);
    evaluation.results = results;
  }
  return evaluation;
}

}  // namespace graftsman
