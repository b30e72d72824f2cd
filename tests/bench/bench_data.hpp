#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/motion/body/clip.hpp"

namespace abrazo::bench {

/// What all benchmarks work on: a library, and a user who is not in what is searched.
struct BenchData {
  std::shared_ptr<const MotionLibrary> library;
  Clip user;                          ///< who leads in the take that is held out
  std::vector<std::string> excluded;  ///< the held-out take where the library has it
};

/// Made or read at the first call. From the environment:
///   ABRAZO_BENCH_LIBRARY  library file; without one `ABRAZO_BENCH_PAIRS` (43 000) generated pairs of salsa
///   ABRAZO_BENCH_HELD_OUT take of that library who gives the user; without one a couple that it does not
///   have
/// Ends the program with a message when the file cannot be read.
const BenchData& bench_data();

/// A whole number from the environment; `otherwise` where it is not set.
int number_from_environment(const char* name, int otherwise);

/// Salsa of couple number `seed`, as many frames of it as wanted at 60 Hz.
std::vector<PairedTake> generated_takes(std::uint64_t seed, int frames);

/// `count` different pairs spread over a library.
std::vector<PairPose> spread_pairs(const MotionLibrary& library, int count);

}  // namespace abrazo::bench
