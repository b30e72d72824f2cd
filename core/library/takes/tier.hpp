#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

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

/// Role for "role", "roles", "who leads"; Move for "move", "moves", "label", "labels", "figure", "figures"
/// (in any case); Note for others.
TierKind kind_of_name(std::string_view name);

/// Whether tiers hold together: names are there and each once, text is UTF-8, intervals have finite times,
/// some length, and are ascending without overlap. @return what is not, with the tier's name and the interval
Status check_tiers(std::span<const Tier> tiers, std::string_view where);

/// Tiers as one JSON object:
/// {"tiers":[{"name":...,"kind":"role|move|note","vocabulary":[...],
///            "intervals":[{"start_s":...,"end_s":...,"value":...[,"detail":...][,"confidence":...]}]}]}.
/// A vocabulary's entry is a text, or {"value":...[,"description":...][,"colour":"#rrggbb"][,"key":"1"]}
/// where more is known of it. Times read back to the same doubles.
std::string tiers_json(std::span<const Tier> tiers);

/// Kinds and vocabularies alone, without intervals.
std::string tier_facts_json(std::span<const Tier> tiers);

/// Reads both. Kind, vocabulary and intervals may be missing; intervals need not be ascending.
/// @param warnings  unknown keys, most likely misspelt
Result<std::vector<Tier>> parse_tiers_json(std::string_view text, std::string_view where,
                                           std::vector<std::string>& warnings);

}  // namespace abrazo
