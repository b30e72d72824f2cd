#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo {

/// Meaning of the values of a tier.
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
  std::string confidence = {};  ///< "high", "low", ... of the annotator; empty = unknown

  bool operator==(const TierInterval&) const = default;
};

/// A value that a tier can have.
struct VocabularyEntry {
  std::string value;
  std::string description = {};
  std::optional<std::uint32_t> rgb = {};  ///< 0xRRGGBB; none = from the palette
  char key = 0;                           ///< key for the value: '1' ... '9', 'a' ...; 0 = none

  bool operator==(const VocabularyEntry&) const = default;
};

/// A named row of intervals beside the frames of a session or take: roles, moves, notes.
struct Tier {
  std::string name;
  std::vector<TierInterval> intervals;           ///< ascending, not overlapping
  std::vector<VocabularyEntry> vocabulary = {};  ///< valid values; empty = free text
  TierKind kind = TierKind::Note;

  bool operator==(const Tier&) const = default;
};

/// Collects the tiers of a table, in whose rows intervals of any tier follow one another.
class TiersInOrder {
 public:
  /// The tier of this name, with the kind that the name tells; made behind the others if it is missing.
  Tier& named(const std::string& name);
  /// In order of appearance, each with its intervals by their start.
  std::vector<Tier> taken();

 private:
  std::vector<Tier> tiers_;
  std::map<std::string, std::size_t> places_;
};

/// The values of a tier's intervals, each once, in order of appearance.
std::vector<std::string> values_of(std::span<const TierInterval> intervals);
/// The values as a vocabulary without descriptions, colours and keys.
std::vector<VocabularyEntry> vocabulary_of(std::span<const TierInterval> intervals);
/// The vocabulary, and behind it the values that `other` has or uses besides, without a key that is taken.
std::vector<VocabularyEntry> with_values_of(std::vector<VocabularyEntry> vocabulary, const Tier& other);

/// Role for "role", "roles", "who leads"; Move for "move", "moves", "label", "labels", "figure", "figures"
/// (in any case); Note for others.
TierKind kind_of_name(std::string_view name);

/// Checks tiers: names exist and are unique, text is UTF-8, intervals have finite times, are not empty, and
/// ascend without overlap. The Error names tier and interval.
Status check_tiers(std::span<const Tier> tiers, std::string_view where);

/// Tiers as one JSON object:
/// {"tiers":[{"name":...,"kind":"role|move|note","vocabulary":[...],
///            "intervals":[{"start_s":...,"end_s":...,"value":...[,"detail":...][,"confidence":...]}]}]}.
/// A vocabulary's entry is a text, or {"value":...[,"description":...][,"colour":"#rrggbb"][,"key":"1"]}
/// if it has more than a value. Times read back to the same doubles.
std::string tiers_json(std::span<const Tier> tiers);

/// Kinds and vocabularies alone, without intervals.
std::string tier_facts_json(std::span<const Tier> tiers);

/// Reads both. Kind, vocabulary and intervals may be missing; intervals need not be ascending.
/// @param warnings unknown keys, probably misspelt
Result<std::vector<Tier>> parse_tiers_json(std::string_view text, std::string_view where,
                                           std::vector<std::string>& warnings);

}  // namespace abrazo
