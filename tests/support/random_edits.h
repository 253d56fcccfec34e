#pragma once

#include <random>

#include "app/document/commands.h"
#include "app/document/document_model.h"
#include "core/project/edits.h"

/// Random edits of a document, for tests.
namespace graftsman {

/// Makes a random edit that is legal, or none.
inline void randomEdit(DocumentModel& model, std::mt19937& random) {
  const Fusion& now = model.committed();
  const auto below = [&](std::size_t n) { return static_cast<int>(random() % n); };
  const auto vertexOf = [&](const TriangleMesh& mesh) {
    return SurfacePoint::atVertex(below(static_cast<std::size_t>(mesh.vertexCount())));
  };
  const std::size_t pairs = now.inputs.loop.size();
  switch (below(9)) {
    case 0:
      if (pairs > 0) {
        const int cv = below(pairs);
        const Side side = below(2) == 0 ? Side::Part : Side::Base;
        const auto& mesh = side == Side::Part ? now.inputs.part : now.inputs.base;
        if (auto after = edits::moveCV(now, static_cast<std::size_t>(cv), side, vertexOf(*mesh))) {
          model.push(std::make_unique<MoveCVP>(model, *after, cv, side));
        }
      }
      return;
    case 1:
      if (auto after =
              edits::insertPair(now, pairs, {vertexOf(*now.inputs.part), vertexOf(*now.inputs.base)})) {
        model.push(std::make_unique<AddCVP>(model, *after, static_cast<int>(pairs)));
      }
      return;
    case 2:
      if (pairs > 0) {
        const int cv = below(pairs);
        model.push(std::make_unique<RemoveCVP>(model, edits::removePairs(now, {cv}), cv, 1));
      }
      return;
    case 3:
      model.push(std::make_unique<ReverseLoop>(model, edits::reverseLoop(now)));
      return;
    case 4:
      model.push(std::make_unique<ShiftCorrespondence>(model, edits::shiftCorrespondence(now)));
      return;
    case 5:
      model.push(std::make_unique<SetFCFPreset>(model, static_cast<FCF::Preset>(below(4))));
      return;
    case 6: {
      std::vector<FCFPoint> points = now.inputs.fcf.points();
      const int point = below(points.size());
      points[static_cast<std::size_t>(point)].f = below(101) / 100.0;
      model.push(std::make_unique<MoveFCFPoint>(model, *FCF::through(points), point));
      return;
    }
    case 7: {
      AdjustmentSettings settings = now.inputs.adjustment;
      settings.falloff = 1 + below(9);
      model.push(std::make_unique<SetAdjustment>(model, settings));
      return;
    }
    default:
      model.push(std::make_unique<RunAdjustment>(model));
      return;
  }
}

}  // namespace graftsman
