#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/io/csv.h"
#include "core/sweep/sweep_file.h"
#include "core/sweep/sweep_run.h"

namespace graftsman {

/// The table of a sweep: a row for each result, by the combination's number. Columns:
///   sweep                  the sweep's fingerprint
///   number, name           of the combination, from 1 on
///   part, embedding, shift, adjustment, rigid, scale, line_field, exact_fit, epsilon, max_iterations,
///   deform_exponent, curve, fcf, monotone
///                          every parameter, as a scenario has it; fcf as "s,f;s,f;…"; part, adjustment and
///                          curve are names, empty where the sweep has no list of them
///   seam_angle_mean, seam_angle_greatest (radians), area, volume, distance_greatest, distance_mean,
///   quality_worst, quality_5th_percentile, quality_mean, vertices, faces
///                          the measures; empty where there are none
///   mesh, picture          the files' names; empty where none was written
///   error                  why it does not fuse; empty if it does
/// Numbers have the fewest digits that read back as the same double.
class SweepTable {
 public:
  [[nodiscard]] static const csv::Row& header();

  explicit SweepTable(const LoadedSweep& sweep) : sweep_(sweep) {}

  void add(const SweepResult& result, const std::string& meshFile, const std::string& pictureFile);
  /// Its text, sorted by number.
  [[nodiscard]] std::string text() const;

 private:
  const LoadedSweep& sweep_;
  std::map<std::size_t, csv::Row> rows_;
};

/// "table.csv", or "table-K-of-N.csv" for one of several shares.
[[nodiscard]] std::string tableName(const SweepShare& share);

/// What mergeTables() found.
struct MergedTables {
  std::size_t shares = 0;
  std::size_t rows = 0;
};

/// Joins the tables of all shares in the folder into its table.csv, the same bytes as if the sweep had been
/// run as a whole. Errors: FileUnreadable (no table of a share; one missing: it is named), FileMalformed (no
/// table of a sweep; shares of different N, of different sweeps, or with the same number twice: they are
/// named), FileUnwritable.
[[nodiscard]] Result<MergedTables> mergeTables(const std::filesystem::path& folder);

}  // namespace graftsman
