#pragma once

#include "app/document/document_commands.h"
#include "core/project/evaluate.h"
#include "tests/support/random_edits.h"

/// Random edits of a document whose fusions are made of fusions, for tests.
namespace graftsman {

/// Shows fusion `id` as it is computed. Returns its results.
inline FusionResults showResolved(DocumentModel& model, FusionId id, Evaluated& known) {
  model.show(id);
  const Evaluation evaluation = evaluate(model.document().fusions, id, known, {});
  model.setResultAssets(evaluation.assets, evaluation.fusion);
  return evaluation.results;
}

/// Moves a random CV a step along an edge, or into a face, so that the loop has a good chance to hold.
inline void nudgeCV(DocumentModel& model, std::mt19937& random) {
  const Fusion& now = model.committed();
  const Side side = random() % 2 == 0 ? Side::Part : Side::Base;
  const auto& mesh = now.of(side) ? now.of(side)->mesh : nullptr;
  if (!mesh || now.inputs.loop.empty()) {
    return;
  }
  const std::size_t number = random() % now.inputs.loop.size();
  const CVP& pair = now.inputs.loop[number];
  const SurfacePoint& from = side == Side::Part ? pair.part : pair.base;
  const Index vertex = from.vertex >= 0 ? from.vertex : mesh->face(from.face)[0];
  const Index edge = mesh->outgoing(vertex);
  const SurfacePoint to =
      random() % 2 == 0 ? SurfacePoint::atVertex(mesh->to(edge))
                        : SurfacePoint{-1, TriangleMesh::faceOf(edge), Eigen::Vector3d(0.5, 0.3, 0.2), {}};
  if (auto after = edits::moveCV(now, number, side, to)) {
    model.push(std::make_unique<MoveCVP>(model, std::move(*after), static_cast<int>(number), side));
  }
}

/// Makes a random edit of a random fusion, or of the whole document, that is legal, or none. Returns whether
/// it took the result from a fusion that had one.
inline bool randomStackedEdit(DocumentModel& model, std::mt19937& random, Evaluated& known) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const auto any = [&] { return model.document().fusions[below(model.document().fusions.size())]->id; };
  const bool worked = showResolved(model, any(), known).fused != nullptr;
  const Fusion& now = model.committed();
  const int before = model.history()->index();
  const std::size_t count = model.document().fusions.size();
  switch (below(14)) {
    case 0:
      model.push(std::make_unique<RenameFusion>(model, now.id, QString("Name %1").arg(below(100))));
      break;
    case 1: {
      const FusionId source = any();
      const Side side = below(2) == 0 ? Side::Part : Side::Base;
      if (auto after = edits::takeResult(model.document(), now.id, side, source)) {
        model.push(std::make_unique<TakeResult>(model, std::move(*after), now.id, side, source));
      }
      break;
    }
    case 2:
      if (count > 3) {
        model.push(std::make_unique<RemoveFusion>(model, now.id));
      }
      break;
    case 3:
      if (count < 7) {
        model.push(std::make_unique<AddFusion>(model, now.part, edits::resultAsset(now)));
      }
      break;
    case 4:
      if (auto closed = edits::closeLoop(now); closed && !now.closed) {
        model.push(std::make_unique<CloseLoop>(model, std::move(*closed)));
      }
      break;
    case 5:
    case 6:
    case 7:
    case 8:
    case 9:
      nudgeCV(model, random);
      break;
    default:
      if (now.part && now.base && now.part->mesh && now.base->mesh) {
        randomEdit(model, random);
      }
      break;
  }
  return worked && model.history()->index() > before && !showResolved(model, model.shown(), known).fused;
}

}  // namespace graftsman
