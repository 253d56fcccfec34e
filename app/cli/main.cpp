// graftsman-cli: fuses meshes and examines them without a display.

#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/cli/commands.h"
#include "core/base/parallel.h"

namespace {

constexpr int kWrongUsage = 2;

constexpr const char* kExamples = R"(Examples:
  graftsman-cli fuse nose.json -o nose.obj --report nose-report.json
  graftsman-cli fuse nose.json -o nose.ply --fcf paste
  graftsman-cli fuse nose.json -o nose.stl --fcf "0,0;0.3,0.1;0.7,0.9;1,1" --threads 1
  graftsman-cli fuse nose.graft -o nose.obj
  graftsman-cli check head.obj

Exit codes: 0 done; 1 an error of the input, told in one line on stderr; 2 wrong usage.)";

int usageError(const CLI::ParseError& error) {
  std::fprintf(stderr, "graftsman-cli: %s (see graftsman-cli --help)\n", error.what());
  return kWrongUsage;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Graftsman's mesh fusion on the command line: cuts a region out of one mesh, attaches it to another.",
      "graftsman-cli");
  app.set_version_flag("--version", "graftsman-cli " GRAFTSMAN_VERSION);
  app.footer(kExamples);
  app.require_subcommand(1);
  app.set_help_flag("-h,--help", "Print this help and exit");

  FuseOptions fuseOptions;
  int threads = 0;
  CLI::App& fuseCommand =
      *app.add_subcommand("fuse", "Fuse the two meshes of a scenario or a project and write the result");
  fuseCommand.add_option("INPUT", fuseOptions.input, "Scenario (.json) or project (.graft)")->required();
  fuseCommand.add_option("-o,--output", fuseOptions.output, "Mesh to write: .obj, .ply, .stl, .off or .glb")
      ->required();
  fuseCommand.add_option("--report", fuseOptions.report,
                         "Write a report as JSON to this file (- for stdout)");
  fuseCommand.add_option("--fcf", fuseOptions.curve,
                         "Fusion curve: linear, paste, keep-base-slope, half, or points \"s,f;s,f;…\"");
  fuseCommand
      .add_option("--threads", threads, "Threads to use (default: all); the result never depends on it")
      ->check(CLI::Range(1, 1024));

  CheckOptions checkOptions;
  CLI::App& checkCommand = *app.add_subcommand("check", "Say exactly what a mesh file is like");
  checkCommand.add_option("MESH", checkOptions.mesh, "Mesh (.obj, .ply, .stl, .off)")->required();
  checkCommand.add_flag("--json", checkOptions.json, "As JSON");

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return usageError(error);
  }
  graftsman::setThreadCount(threads);
  return fuseCommand.parsed() ? fuse(fuseOptions) : check(checkOptions);
}
