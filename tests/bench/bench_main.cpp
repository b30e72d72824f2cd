#include "tests/bench/bench_main.hpp"

#include <benchmark/benchmark.h>

#include <Eigen/Core>

namespace abrazo::bench {

int run_benchmarks(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::AddCustomContext("compiler", ABRAZO_COMPILER);
  benchmark::AddCustomContext("Eigen in the library", Eigen::SimdInstructionSetsInUse());
  return benchmark::RunSpecifiedBenchmarks() > 0 ? 0 : 1;
}

}  // namespace abrazo::bench
