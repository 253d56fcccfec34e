#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/terminal.h"
#include "core/base/write_file.h"
#include "core/fusion/update.h"
#include "core/fusion/verify.h"
#include "core/io/report.h"
#include "core/io/result_file.h"
#include "core/io/scenario.h"
#include "core/project/evaluate.h"
#include "core/project/project_file.h"

using namespace graftsman;

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// The error with the file at the front of its message, where it is not there already.
Error naming(const std::string& file, Error error) {
  if (!error.message.starts_with(file)) {
    error.message = file + ": " + error.message;
  }
  return error;
}

// Whether the name ends in it, in any case.
bool endsIn(const std::filesystem::path& path, std::string_view wanted) {
  std::string ending = path.extension().string();
  for (char& c : ending) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return ending == wanted;
}

// The fusion that a project shows, as if a scenario had said it; what it is made of is computed.
Result<LoadedScenario> fusionOf(const LoadedProject& loaded) {
  if (!loaded.fusionIntact) {
    return fail(loaded.damage.front());
  }
  const FusionList& fusions = loaded.project.document.fusions;
  const FusionId shown = loaded.project.shown;
  for (const Side side : {Side::Part, Side::Base}) {
    if (!find(fusions, shown)->of(side)) {
      return fail({ErrorCode::MeshEmpty,
                   std::string("the project has no ") + name(side) + " yet. Load one in the workbench.",
                   side});
    }
  }
  if (!find(fusions, shown)->closed) {
    return fail(ErrorCode::LoopTooShort, "the project's loop is not closed yet. Close it in the workbench.");
  }
  Evaluated known;
  Upstream upstream = evaluateUpstream(fusions, shown, known, terminalProgress("Fusing"));
  if (upstream.error) {
    return fail(std::move(*upstream.error));
  }
  const Fusion resolved = resolve(*find(fusions, shown), upstream.assets);
  LoadedScenario fusion;
  fusion.scenario.part = resolved.part->source;
  fusion.scenario.base = resolved.base->source;
  fusion.scenario.inputs = resolved.inputs;
  fusion.partReport = resolved.part->report;
  fusion.baseReport = resolved.base->report;
  return fusion;
}

Result<LoadedScenario> read(const std::filesystem::path& input) {
  const Progress progress = terminalProgress("Reading");
  if (!endsIn(input, ".graft")) {
    return readScenario(input, progress);
  }
  const Result<LoadedProject> loaded = readProject(input, progress, Wanted::Results);
  if (!loaded) {
    return fail(loaded.error());
  }
  Result<LoadedScenario> fusion = fusionOf(*loaded);
  if (fusion) {
    fusion->scenario.name = input.stem().string();
  }
  return fusion;
}

Result<void> writeReport(const std::string& path, const std::string& text) {
  if (path == "-") {
    std::fwrite(text.data(), 1, text.size(), stdout);
    return {};
  }
  return writeFile(path, text);
}

// A slip of the hand must not cost a model: nothing that was read, and nothing twice, is written.
Result<void> checkTargets(const FuseOptions& options, const Scenario& scenario) {
  const auto same = [](const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code ignored;
    return std::filesystem::weakly_canonical(a, ignored) == std::filesystem::weakly_canonical(b, ignored) ||
           std::filesystem::equivalent(a, b, ignored);
  };
  std::vector<std::string> targets = {options.output};
  if (options.report && *options.report != "-") {
    targets.push_back(*options.report);
  }
  for (const std::string& target : targets) {
    for (const std::filesystem::path& source :
         {std::filesystem::path(options.input), scenario.part, scenario.base}) {
      if (same(target, source)) {
        return fail(
            ErrorCode::FileUnwritable,
            target + ": is one of the files that the fusion is made of. Give the output another name.");
      }
    }
  }
  if (targets.size() == 2 && same(targets[0], targets[1])) {
    return fail(ErrorCode::FileUnwritable,
                targets[0] + ": is both the mesh and the report. Give one another name.");
  }
  return {};
}

Result<void> run(const FuseOptions& options) {
  for (const auto& [name, what] : {std::pair(options.input, "input"), std::pair(options.output, "output"),
                                   std::pair(options.report.value_or("-"), "report")}) {
    if (name.empty()) {
      return fail(ErrorCode::FileUnreadable, std::string("The ") + what + "'s file name is empty; give one.");
    }
  }
  if (!isResultName(options.output)) {
    return fail(ErrorCode::FormatUnknown,
                options.output +
                    ": unknown format. Give the output a name that ends in .obj, .ply, .stl, .off or .glb.");
  }
  const Clock::time_point start = Clock::now();
  Result<LoadedScenario> loaded = read(options.input);
  if (!loaded) {
    return fail(naming(options.input, std::move(loaded.error())));
  }
  if (Result<void> separate = checkTargets(options, loaded->scenario); !separate) {
    return separate;
  }
  FusionInputs inputs = loaded->scenario.inputs;
  if (options.curve) {
    Result<FCF> curve = parseFCF(*options.curve);
    if (!curve) {
      return fail(naming("--fcf", std::move(curve.error())));
    }
    inputs.fcf = std::move(*curve);
  }
  const double readMilliseconds = millisecondsSince(start);

  const FusionResults results = update(inputs, {}, terminalProgress("Fusing"));
  if (results.error) {
    return fail(naming(options.input, *results.error));
  }
  const Clock::time_point writeStart = Clock::now();
  if (Result<void> written = writeResult(options.output, results, terminalProgress("Writing")); !written) {
    return written;
  }
  const double writeMilliseconds = millisecondsSince(writeStart);
  const double totalMilliseconds = millisecondsSince(start);
  if (!options.report) {
    return {};
  }
  const ReportContext context = {.name = loaded->scenario.name,
                                 .input = options.input,
                                 .output = options.output,
                                 .version = GRAFTSMAN_VERSION,
                                 .partReport = loaded->partReport,
                                 .baseReport = loaded->baseReport,
                                 .readMilliseconds = readMilliseconds,
                                 .writeMilliseconds = writeMilliseconds,
                                 .totalMilliseconds = totalMilliseconds};
  const Verification verification = verify(results);
  if (Result<void> written = writeReport(*options.report, formatReport(results, verification, context));
      !written) {
    return written;
  }
  if (!verification.holds()) {
    return fail(ErrorCode::Unexpected, options.output + ": written, but not as it must be: " +
                                           verification.broken() + ". Please report this with the scenario.");
  }
  return {};
}

}  // namespace

int fuse(const FuseOptions& options) {
  const Result<void> done = run(options);
  if (!done) {
    return reportError(done.error());
  }
  clearProgress();
  return 0;
}
