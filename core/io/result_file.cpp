#include "core/io/result_file.h"

#include <cctype>
#include <string>
#include <system_error>
#include <vector>

#include "core/io/glb_writer.h"
#include "core/io/mesh_file.h"
#include "core/io/printable.h"

namespace graftsman {
namespace {

bool isGlb(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return ending == ".glb";
}

}  // namespace

bool isResultName(const std::filesystem::path& path) {
  return isGlb(path) || formatOf(path);
}

Result<void> writeResult(const std::filesystem::path& path, const FusionResults& results,
                         const Progress& progress) {
  if (!isGlb(path)) {
    return writeMesh(path, results.fused->points, results.fused->faces(), {}, progress);
  }
  std::vector<Point> part = results.join->points;
  const std::vector<Index>& target = results.join->tileVertices;
  for (std::size_t i = 0; i < target.size(); ++i) {
    part[static_cast<std::size_t>(target[i])] = results.combined->part[i];
  }
  return writeGlb(path, {results.join->points, part, results.fused->faces()});
}

Result<void> makeFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder, error)) {
    return fail(ErrorCode::FileUnwritable,
                printable(folder.string(), 400) + ": is no folder and cannot be made one" +
                    (error ? ": " + error.message() : std::string()) + ". Choose another.");
  }
  return {};
}

}  // namespace graftsman
