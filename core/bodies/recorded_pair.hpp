#pragma once

#include <optional>
#include <string>

#include "core/base/result.hpp"
#include "core/library/takes/paired_take.hpp"
#include "core/motion/body/clip.hpp"

namespace abrazo {

/// Two performers recorded together, the active one first, with the same number of poses and rate.
struct RecordedPair {
  std::string name;
  Clip active, passive;
};

/// The pair of a take by its roles: the performer who is active in most frames is the active body; A if
/// neither is.
RecordedPair recorded_pair_of(const PairedTake& take);

/// Frames [from, to) of a pair, 0-based; to its end if `to` is not given. The Error gives the existing
/// frames.
Result<RecordedPair> cut(const RecordedPair& pair, long long from, std::optional<long long> to);

}  // namespace abrazo
