#include "core/io/report.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/io/fusion_json.h"
#include "core/io/scenario_keys.h"

namespace graftsman {
namespace {

// Keeps the keys in the order in which they are written.
using Json = nlohmann::ordered_json;
using fusion_json::toJson;

Json counts(std::size_t vertices, std::size_t faces) {
  return {{"v", vertices}, {"f", faces}};
}

Json counts(const TriangleMesh& mesh) {
  return counts(mesh.points().size(), mesh.faces().size());
}

const char* name(EmbeddingWeights weights) {
  constexpr std::array<const char*, 3> kNames = {"cotangent", "mean-value", "low-stretch"};
  return kNames[static_cast<std::size_t>(weights)];
}

const char* name(AdjustmentStep step) {
  constexpr std::array<const char*, 4> kNames = {"none", "rigid", "scale", "line field"};
  return kNames[static_cast<std::size_t>(step)];
}

Json milliseconds(const FusionResults& results, const ReportContext& context) {
  const auto of = [&](Stage stage) { return results.run(stage).milliseconds; };
  return {{"read", context.readMilliseconds},
          {"paths", of(Stage::Anchor) + of(Stage::Paths)},
          {"cut", of(Stage::Cut) + of(Stage::Tile)},
          {"adjust", of(Stage::Adjust) + of(Stage::Fit)},
          {"embed", of(Stage::Embed)},
          {"overlay", of(Stage::Overlay)},
          {"join", of(Stage::Join)},
          {"blend", of(Stage::Blend)},
          {"write", context.writeMilliseconds},
          {"total", context.totalMilliseconds}};
}

Json tableTwo(const FusionResults& results) {
  return {{"M1", counts(*results.inputs.part)},
          {"M2", counts(*results.inputs.base)},
          {"F1", counts(results.part.tile->points.size(), results.part.tile->faces.size())},
          {"F2", counts(results.base.tile->points.size(), results.base.tile->faces.size())},
          {"Fc", counts(results.combined->part.size(), results.combined->faces.size())},
          {"Mc", counts(results.fused->points.size(), results.fused->faces().size())}};
}

Json toJson(const LoopPaths& paths) {
  Json list = Json::array();
  for (std::size_t i = 0; i < paths.paths.size(); ++i) {
    list.push_back({{"from", i},
                    {"to", (i + 1) % paths.paths.size()},
                    {"length", paths.paths[i]->length},
                    {"points", paths.paths[i]->points.size()},
                    {"rerouted", paths.paths[i] != paths.direct[i]}});
  }
  return list;
}

Json toJson(const AdjustmentReport& report, const FittedTile& fitted, bool exactFit) {
  Json rotation = Json::array();
  for (int row = 0; row < 3; ++row) {
    const Eigen::RowVector3d r = report.transform.rotation.row(row);
    rotation.push_back({r.x(), r.y(), r.z()});
  }
  const Eigen::Vector3d& c = report.transform.translation;
  return {{"reached", name(report.reached)},
          {"iterations", report.iterations},
          {"k", report.scale},
          {"rotation", rotation},
          {"translation", {c.x(), c.y(), c.z()}},
          {"loop_diameter", report.loopDiameter},
          {"mean_cv_distance",
           {{"before", report.distanceBefore},
            {"rigid", report.distanceAfterRigid},
            {"scale", report.distanceAfterScale},
            {"line_field", report.distanceAfterLineField}}},
          {"exact_fit",
           {{"applied", exactFit},
            {"mean_boundary_distance", fitted.meanDistance},
            {"greatest_boundary_distance", fitted.greatestDistance}}}};
}

Json toJson(const Embedding& embedding) {
  return {{"weights", name(embedding.weights)},
          {"flipped_cotangent", embedding.flippedCotangent},
          {"added_vertices", embedding.added.size()},
          {"smallest_area_ratio", embedding.smallestAreaRatio}};
}

Json toJson(const MeshCheck& check) {
  return {{"vertices", check.vertices},
          {"faces", check.faces},
          {"edges", check.edges},
          {"components", check.components},
          {"euler_characteristic", check.eulerCharacteristic},
          {"closed", check.closed},
          {"manifold", check.manifold},
          {"oriented", check.oriented},
          {"orientable", check.orientable},
          {"border_loops", check.borderLoops},
          {"border_edges", check.borderEdges},
          {"edges_of_many_faces", check.edgesOfManyFacesCount},
          {"misoriented_edges", check.misorientedEdgesCount},
          {"singular_vertices", check.singularVerticesCount},
          {"isolated_vertices", check.isolatedVertices},
          {"degenerate_faces", check.degenerateFaces},
          {"smallest_angle", check.smallestAngle},
          {"median_smallest_angle", check.medianSmallestAngle},
          {"area", check.area},
          {"volume", check.volume},
          {"box",
           {{check.boxMin.x(), check.boxMin.y(), check.boxMin.z()},
            {check.boxMax.x(), check.boxMax.y(), check.boxMax.z()}}}};
}

Json toJson(const Verification& verification) {
  return {{"all_hold", verification.holds()},
          {"base_distance", verification.baseDistance},
          {"part_distance", verification.partDistance},
          {"distance_tolerance", verification.tolerance},
          {"base_area_error", verification.baseAreaError},
          {"embedded_area_error", verification.embeddedAreaError},
          {"inverted_faces", verification.invertedFaces},
          {"base_unchanged", verification.baseUnchanged()},
          {"topology_kept", verification.topologyKept()},
          {"base", toJson(verification.base)},
          {"result", toJson(verification.result)}};
}

// File names may hold bytes that are no UTF-8; those are replaced.
std::string text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string formatReport(const FusionResults& results, const Verification& verification,
                         const ReportContext& context) {
  Json curve = Json::array();
  for (const FCFPoint& point : results.inputs.fcf.points()) {
    curve.push_back({point.s, point.f});
  }
  const StageRun& anchor = results.run(Stage::Anchor);
  const StageRun& paths = results.run(Stage::Paths);
  const double partPaths = anchor.partMilliseconds + paths.partMilliseconds;
  return text(
      {{"program", "graftsman-cli " + context.version},
       {"name", context.name},
       {"input", context.input},
       {"output", context.output},
       {"milliseconds", milliseconds(results, context)},
       {"paths_milliseconds",
        {{"part", partPaths}, {"base", anchor.milliseconds + paths.milliseconds - partPaths}}},
       {"cvps", results.inputs.loop.size()},
       {"counts", tableTwo(results)},
       {"curve", curve},
       {"paths", {{"part", toJson(*results.part.paths)}, {"base", toJson(*results.base.paths)}}},
       {"adjustment",
        toJson(results.adjustment->report, *results.fitted, results.inputs.adjustment.exactFit)},
       {"embedding", {{"part", toJson(*results.part.embedding)}, {"base", toJson(*results.base.embedding)}}},
       {"seam",
        {{"vertices", results.combined->seamSize},
         {"mean_normal_angle", verification.meanSeamAngle},
         {"greatest_normal_angle", verification.greatestSeamAngle}}},
       {"checks", toJson(verification)},
       {"reading", {{"part", toJson(context.partReport)}, {"base", toJson(context.baseReport)}}}});
}

std::string formatCheck(const MeshCheck& check, const ReadReport& read, const std::string& file) {
  Json json = {{"file", file}, {"reading", toJson(read)}, {"mesh", toJson(check)}};
  const auto edges = [](const auto& pairs) {
    Json list = Json::array();
    for (const auto& [a, b] : pairs) {
      list.push_back({a, b});
    }
    return list;
  };
  json["first_edges_of_many_faces"] = edges(check.edgesOfManyFaces);
  json["first_misoriented_edges"] = edges(check.misorientedEdges);
  json["first_singular_vertices"] = check.singularVertices;
  return text(json);
}

std::string describe(const ReadReport& report) {
  std::ostringstream out;
  out << "format: " << (report.binary ? "binary " : "")
      << scenario_keys::wordFor(scenario_keys::kMeshFormats, report.format) << ", " << report.fileVertices
      << " vertices, " << report.fileFaces << " faces in the file\n";
  const auto line = [&out](std::size_t count, const char* what) {
    if (count > 0) {
      out << "reading: " << count << ' ' << what << '\n';
    }
  };
  line(report.triangulated, "polygons divided into triangles");
  line(report.welded, "vertices merged into an equal one");
  line(report.droppedDegenerate, "faces with a repeated vertex dropped");
  line(report.droppedDuplicate, "repeated faces dropped");
  line(report.isolated, "vertices that no face uses, kept");
  return out.str();
}

}  // namespace graftsman
