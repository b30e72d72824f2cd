#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace abrazo {

/// What an interval of a tier says.
enum class TierKind : std::uint8_t {
  Role,  ///< who is active (leads, attacks): "a" or "b", the performers of a take
  Move,  ///< which move it is
  Note   ///< anything else
};

/// A value over [start_s, end_s).
struct TierInterval {
  double start_s = 0;
  double end_s = 0;
  std::string value;
  std::string detail = {};      ///< free text
  std::string confidence = {};  ///< "high", "low", ... of the person who said it; empty = not said

  bool operator==(const TierInterval&) const = default;
};

/// One thing that can be said in a tier.
struct VocabularyEntry {
  std::string value;
  std::string description = {};
  std::optional<std::uint32_t> rgb = {};  ///< 0xRRGGBB; nothing = the one the palette has for it
  char key = 0;                           ///< that says it: '1' ... '9', 'a' ...; 0 = none

  bool operator==(const VocabularyEntry&) const = default;
};

/// A named row of intervals beside the frames of a session or take: roles, moves, notes.
struct Tier {
  std::string name;
  std::vector<TierInterval> intervals;           ///< ascending, not overlapping
  std::vector<VocabularyEntry> vocabulary = {};  ///< what a value can be; empty = free text
  TierKind kind = TierKind::Note;

  bool operator==(const Tier&) const = default;
};

/// The values of a tier's intervals, each once, in order of appearance.
std::vector<std::string> values_of(std::span<const TierInterval> intervals);
/// Them as a vocabulary without descriptions, colours and keys.
std::vector<VocabularyEntry> vocabulary_of(std::span<const TierInterval> intervals);

/// Tiers as one JSON object:
/// {"tiers":[{"name":...,"vocabulary":[...],"intervals":[{"start_s":...,"end_s":..., "value":...}]}]}. Times
/// read back to the same doubles.
std::string tiers_json(std::span<const Tier> tiers);

}  // namespace abrazo
