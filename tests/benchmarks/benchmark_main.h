#pragma once

#include <benchmark/benchmark.h>

#include "core/base/large_array.h"

/// The main() of a benchmark. As in the programs, freed memory is kept: for the peers' use as for ours.
#define GRAFTSMAN_BENCHMARK_MAIN()                            \
  int main(int argc, char** argv) {                           \
    graftsman::keepFreedMemory();                             \
    benchmark::Initialize(&argc, argv);                       \
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) { \
      return 1;                                               \
    }                                                         \
    benchmark::RunSpecifiedBenchmarks();                      \
    benchmark::Shutdown();                                    \
    return 0;                                                 \
  }                                                           \
  int main(int, char**)
