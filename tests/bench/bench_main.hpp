#pragma once

namespace abrazo::bench {

/// What each of these programs ends with: reads Google Benchmark's options, notes what it was built with,
/// runs.
/// @return for main(): not 0 when there was nothing to run
int run_benchmarks(int argc, char** argv);

}  // namespace abrazo::bench
