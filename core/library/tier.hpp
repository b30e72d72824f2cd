#pragma once

#include <span>
#include <string>
#include <vector>

namespace abrazo {

/// A value over [start_s, end_s).
struct TierInterval {
  double start_s = 0;
  double end_s = 0;
  std::string value;

  bool operator==(const TierInterval&) const = default;
};

/// A named row of intervals beside the frames of a session or take: roles, moves, notes.
struct Tier {
  std::string name;
  std::vector<TierInterval> intervals;  ///< ascending, not overlapping
  std::vector<std::string> vocabulary;  ///< what a value can be; empty = free text

  bool operator==(const Tier&) const = default;
};

/// The values of a tier's intervals, each once, in order of appearance.
std::vector<std::string> values_of(std::span<const TierInterval> intervals);

/// Tiers as one JSON object:
/// {"tiers":[{"name":...,"vocabulary":[...],"intervals":[{"start_s":...,"end_s":..., "value":...}]}]}. Times
/// read back to the same doubles.
std::string tiers_json(std::span<const Tier> tiers);

}  // namespace abrazo
