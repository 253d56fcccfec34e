#include "core/sweep/sweep_table.h"

#include "core/io/scenario_keys.h"
#include "core/sweep/sweep_words.h"

namespace graftsman {
namespace {

using sweep_words::number;

std::string cell(bool value) {
  return value ? "true" : "false";
}

std::string cell(const FCF& curve) {
  std::string points;
  for (const FCFPoint& point : curve.points()) {
    points += (points.empty() ? "" : ";") + number(point.s) + "," + number(point.f);
  }
  return points;
}

template <class List>
std::string nameIn(const List& list, std::size_t i) {
  return list.empty() ? std::string() : list[i].name;
}

void appendParameters(csv::Row& row, const Sweep& sweep, std::size_t combination) {
  const SweepChoice choice = sweep.choice(combination);
  const FusionInputs inputs = sweep.inputs(combination);
  const AdjustmentSettings& adjustment = inputs.adjustment;
  row.insert(row.end(),
             {nameIn(sweep.parts, choice.part),
              scenario_keys::wordFor(scenario_keys::kEmbeddingMethods, inputs.embedding.method),
              std::to_string(sweep.shifts.empty() ? 0 : sweep.shifts[choice.shift]),
              nameIn(sweep.adjustments, choice.adjustment), cell(adjustment.rigid), cell(adjustment.scale),
              cell(adjustment.lineField), cell(adjustment.exactFit), number(adjustment.epsilon),
              std::to_string(adjustment.maxIterations), number(adjustment.falloff),
              nameIn(sweep.curves, choice.curve), cell(inputs.fcf), cell(inputs.fcf.monotone())});
}

void appendMeasures(csv::Row& row, const std::optional<Measures>& measured) {
  constexpr std::size_t kColumns = 11;
  if (!measured) {
    row.insert(row.end(), kColumns, std::string());
    return;
  }
  const Measures& m = *measured;
  row.insert(row.end(), {number(m.meanSeamAngle), number(m.greatestSeamAngle), number(m.area),
                         m.volume ? number(*m.volume) : "", number(m.greatestDistance),
                         number(m.meanDistance), number(m.worstQuality), number(m.lowQuality),
                         number(m.meanQuality), std::to_string(m.vertices), std::to_string(m.faces)});
}

}  // namespace

const csv::Row& SweepTable::header() {
  static const csv::Row kHeader = {"sweep",
                                   "number",
                                   "name",
                                   "part",
                                   "embedding",
                                   "shift",
                                   "adjustment",
                                   "rigid",
                                   "scale",
                                   "line_field",
                                   "exact_fit",
                                   "epsilon",
                                   "max_iterations",
                                   "deform_exponent",
                                   "curve",
                                   "fcf",
                                   "monotone",
                                   "seam_angle_mean",
                                   "seam_angle_greatest",
                                   "area",
                                   "volume",
                                   "distance_greatest",
                                   "distance_mean",
                                   "quality_worst",
                                   "quality_5th_percentile",
                                   "quality_mean",
                                   "vertices",
                                   "faces",
                                   "mesh",
                                   "picture",
                                   "error"};
  return kHeader;
}

void SweepTable::add(const SweepResult& result, const std::string& meshFile, const std::string& pictureFile) {
  csv::Row row = {sweep_.fingerprint, std::to_string(result.combination + 1),
                  sweep_.sweep.name(result.combination)};
  appendParameters(row, sweep_.sweep, result.combination);
  appendMeasures(row, result.measures);
  row.insert(row.end(), {meshFile, pictureFile, result.results.error ? result.results.error->message : ""});
  rows_[result.combination] = std::move(row);
}

std::string SweepTable::text() const {
  std::string text;
  csv::append(text, header());
  for (const auto& [combination, row] : rows_) {
    csv::append(text, row);
  }
  return text;
}

std::string tableName(const SweepShare& share) {
  return share.of == 1 ? "table.csv"
                       : "table-" + std::to_string(share.number) + "-of-" + std::to_string(share.of) + ".csv";
}

}  // namespace graftsman
