// graftsman-cli: fuses meshes and examines them without a display.

#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/cli/commands.h"
#include "core/base/large_array.h"
#include "core/base/parallel.h"

namespace {

constexpr int kWrongUsage = 2;

constexpr const char* kExamples = R"(Examples:
  graftsman-cli fuse nose.json -o nose.obj --report nose-report.json
  graftsman-cli fuse nose.json -o nose.ply --fcf paste
  graftsman-cli fuse nose.json -o nose.stl --fcf "0,0;0.3,0.1;0.7,0.9;1,1" --threads 1
  graftsman-cli fuse nose.graft -o nose.obj
  graftsman-cli check head.obj
  graftsman-cli sweep nose-sweep.json -o results --dry-run
  graftsman-cli sweep nose-sweep.json -o results --picture
  graftsman-cli sweep nose-sweep.json -o results --only 3/8    # the third of eight shares
  graftsman-cli sweep --merge results                          # when all eight are there
  graftsman-cli frames nose.json -o frames --turntable 72
  graftsman-cli frames nose.json -o frames --morph 48 --size 640x480

Exit codes: 0 done; 1 an error of the input, told in one line on stderr; 2 wrong usage.)";

int usageError(const CLI::ParseError& error) {
  std::fprintf(stderr, "graftsman-cli: %s (see graftsman-cli --help)\n", error.what());
  return kWrongUsage;
}

void addThreads(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "Threads to use (default: all); the result never depends on it")
      ->check(CLI::Range(1, 1024));
}

// A check of CLI11: says what the text should be unless `parse` makes something of it.
template <class Parse>
CLI::Validator readableBy(Parse parse, const std::string& expected) {
  return {[=](std::string& text) {
            return parse(text) ? std::string() : "must be " + expected + ", not " + text;
          },
          ""};
}

void addSweepOptions(CLI::App& command, SweepOptions& options, std::string& mergeFolder, int& threads) {
  CLI::Option& input = *command.add_option("SWEEP", options.input, "Sweep (.json)");
  CLI::Option& output =
      *command.add_option("-o,--output", options.folder, "Folder for the results; made if it is not there");
  CLI::Option& only = *command
                           .add_option("--only", options.only,
                                       "Run the K-th of N shares: \"K/N\"; --merge joins their tables")
                           ->check(readableBy(parseShare, "\"K/N\" with whole numbers, K from 1 to N"));
  CLI::Option& dryRun =
      *command.add_flag("--dry-run", options.dryRun, "Say how many results there would be, and their names");
  command.add_option("--mesh", options.mesh, "Format of the meshes: obj, ply, stl, off, glb or none")
      ->check(CLI::IsMember({"obj", "ply", "stl", "off", "glb", "none"}));
  command.add_flag("--picture", options.picture, "Draw a picture of each result");
  addThreads(command, threads);
  CLI::Option& merge =
      *command.add_option("--merge", mergeFolder, "Join the tables of all shares in this folder");
  merge.excludes(&input)->excludes(&output)->excludes(&only)->excludes(&dryRun);
  command.callback([&] {
    if (merge.count() == 0 && input.count() == 0) {
      throw CLI::RequiredError("SWEEP or --merge");
    }
    if (merge.count() == 0 && output.count() == 0 && !options.dryRun) {
      throw CLI::RequiredError("--output");
    }
  });
}

void addFramesOptions(CLI::App& command, FramesOptions& options, int& threads) {
  constexpr int kMostFrames = 100'000;
  command.add_option("INPUT", options.input, "Scenario (.json) or project (.graft)")->required();
  command.add_option("-o,--output", options.folder, "Folder for the frames; made if it is not there")
      ->required();
  CLI::Option& turntable =
      *command
           .add_option("--turntable", options.turntable, "Frames of one turn of the camera round the result")
           ->check(CLI::Range(1, kMostFrames));
  CLI::Option& morph =
      *command.add_option("--morph", options.morph, "Frames of the way from the base's shape to the part's")
           ->check(CLI::Range(2, kMostFrames));
  morph.excludes(&turntable);
  command.add_option("--size", options.size, "Width and height in pixels (default: 1280x720)")
      ->check(readableBy(parseSize, "\"WxH\", each from 1 to 8192"));
  command
      .add_option("--view", options.view, "tile or whole (default: whole for a turntable, tile for a morph)")
      ->check(CLI::IsMember({"tile", "whole"}));
  command.add_option("--up", options.up, "y or z: which way is up (default: guessed)")
      ->check(CLI::IsMember({"y", "z"}));
  addThreads(command, threads);
  command.callback([&] {
    if (turntable.count() + morph.count() == 0) {
      throw CLI::RequiredError("--turntable or --morph");
    }
  });
}

}  // namespace

int main(int argc, char** argv) {
  graftsman::keepFreedMemory();
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
  addThreads(fuseCommand, threads);

  CheckOptions checkOptions;
  CLI::App& checkCommand = *app.add_subcommand("check", "Say exactly what a mesh file is like");
  checkCommand.add_option("MESH", checkOptions.mesh, "Mesh (.obj, .ply, .stl, .off)")->required();
  checkCommand.add_flag("--json", checkOptions.json, "As JSON");

  SweepOptions sweepOptions;
  std::string mergeFolder;
  CLI::App& sweepCommand = *app.add_subcommand(
      "sweep", "Fuse every combination of a sweep's values; write meshes, pictures and a table of measures");
  addSweepOptions(sweepCommand, sweepOptions, mergeFolder, threads);

  FramesOptions framesOptions;
  CLI::App& framesCommand = *app.add_subcommand(
      "frames", "Draw the result from all round, or on its way from base to part, as PNG files");
  addFramesOptions(framesCommand, framesOptions, threads);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return usageError(error);
  }
  graftsman::setThreadCount(threads);
  if (fuseCommand.parsed()) {
    return fuse(fuseOptions);
  }
  if (checkCommand.parsed()) {
    return check(checkOptions);
  }
  if (framesCommand.parsed()) {
    return frames(framesOptions);
  }
  return mergeFolder.empty() ? sweep(sweepOptions) : mergeSweep(mergeFolder);
}
