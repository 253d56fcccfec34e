#include <cstdio>
#include <memory>
#include <string>

#include "app/cli/commands.h"
#include "app/cli/terminal.h"
#include "core/io/printable.h"
#include "core/sweep/sweep_folder.h"

using namespace graftsman;

namespace {

void printNames(const Sweep& sweep, const SweepShare& share) {
  const std::vector<std::size_t> order = runOrder(sweep, share);
  std::printf("%zu result%s\n", order.size(), order.size() == 1 ? "" : "s");
  for (const std::size_t combination : order) {
    std::printf("%zu\t%s\n", combination + 1, sweep.name(combination).c_str());
  }
}

// Runs the share. False: none of its combinations fused.
Result<bool> runShare(const std::shared_ptr<const LoadedSweep>& loaded, const SweepShare& share,
                      const std::string& folderName) {
  Result<SweepFolder> folder = SweepFolder::open(folderName, loaded, {});
  if (!folder) {
    return fail(std::move(folder.error()));
  }
  const std::shared_ptr<const Sweep> sweep(loaded, &loaded->sweep);
  SweepRun run(sweep);
  const std::vector<std::size_t> order = runOrder(*sweep, share);
  std::size_t fused = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::string name = sweep->name(order[i]);
    showStep(i + 1, order.size(), name);
    const SweepResult result = run.run(order[i], {});
    if (result.results.error) {
      reportWarning(name + ": " + result.results.error->message);
    }
    fused += result.measures ? 1 : 0;
    if (Result<void> added = folder->add(result, {}); !added) {
      return fail(std::move(added.error()));
    }
  }
  if (Result<void> written = folder->writeTable(share); !written) {
    return fail(std::move(written.error()));
  }
  return fused > 0 || order.empty();
}

}  // namespace

int sweep(const SweepOptions& options) {
  if (options.input.empty() || (options.folder.empty() && !options.dryRun)) {
    return reportError({ErrorCode::FileUnreadable, std::string("The ") +
                                                       (options.input.empty() ? "sweep" : "output folder") +
                                                       "'s file name is empty; give one."});
  }
  Result<LoadedSweep> read = readSweep(options.input, terminalProgress("Reading"));
  if (!read) {
    return reportError(read.error());
  }
  SweepShare share;
  if (const auto numbers = parseShare(options.only)) {
    share = {numbers->number, numbers->of};
  }
  if (options.dryRun) {
    clearProgress();
    printNames(read->sweep, share);
    return 0;
  }
  if (options.mesh) {
    read->output.mesh = *options.mesh == "none" ? "" : *options.mesh;
  }
  if (options.picture && !read->output.picture) {
    read->output.picture = SweepPicture();
  }
  const Result<bool> done =
      runShare(std::make_shared<const LoadedSweep>(std::move(*read)), share, options.folder);
  if (!done) {
    return reportError(done.error());
  }
  if (!*done) {
    return reportError({ErrorCode::Unexpected, printable(options.input, 400) +
                                                   ": none of the combinations fuses. " + tableName(share) +
                                                   " says why of each."});
  }
  clearProgress();
  return 0;
}

int mergeSweep(const std::string& folder) {
  const Result<MergedTables> merged = mergeTables(folder);
  return merged ? 0 : reportError(merged.error());
}
