#include <cstdio>

#include "app/cli/commands.h"
#include "app/cli/terminal.h"
#include "core/io/mesh_file.h"
#include "core/io/report.h"
#include "core/mesh/mesh_check.h"

using namespace graftsman;

int check(const CheckOptions& options) {
  const Result<MeshFile> file = readMesh(options.mesh, terminalProgress("Reading"));
  if (!file) {
    return reportError(file.error());
  }
  clearProgress();
  const MeshCheck result = checkMesh(*file->mesh);
  const std::string text = options.json ? formatCheck(result, file->report, options.mesh)
                                        : describe(file->report) + describe(result);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return 0;
}
