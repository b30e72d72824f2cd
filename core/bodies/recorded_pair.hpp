#pragma once

#include <optional>
#include <string>

#include "core/base/result.hpp"
#include "core/library/takes/paired_take.hpp"
#include "core/motion/body/clip.hpp"

namespace abrazo {

/// Two performers recorded together, the active one first; as many poses at the same rate.
struct RecordedPair {
  std::string name;
  Clip active, passive;
};

/// The pair of a take as its roles have it: active is who is so in most frames, A if nobody is.
RecordedPair recorded_pair_of(const PairedTake& take);

/// Frames [from, to) of a pair, 0-based; to its end where `to` is not given. The Error gives the frames that
/// there are.
Result<RecordedPair> cut(const RecordedPair& pair, long long from, std::optional<long long> to);

}  // namespace abrazo
