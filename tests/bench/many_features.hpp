#pragma once

#include <vector>

#include "core/library/store/normalization.hpp"
#include "tests/bench/bench_data.hpp"

namespace abrazo::bench {

/// Features of as many poses as wanted: those of the library in random order without what is held out, then,
/// of a generated library, those of dances by other couples; of a recorded one (something is held out) the
/// same on other bodies. Kept in the file that ABRAZO_BENCH_FEATURES names, if any, for the next run.
std::vector<Features> many_features(const BenchData& data, std::size_t count);

/// Features of the user's poses on the library's body: of a take that is not searched.
std::vector<Features> user_features(const BenchData& data, int count);

}  // namespace abrazo::bench
