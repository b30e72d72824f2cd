#include "core/library/takes/tier.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/base/text.hpp"
#include "core/base/utf8.hpp"

namespace abrazo {

Tier& TiersInOrder::named(const std::string& name) {
  const auto [place, is_new] = places_.emplace(name, tiers_.size());
  if (is_new) tiers_.push_back({name, {}, {}, kind_of_name(name)});
  return tiers_[place->second];
}

std::vector<Tier> TiersInOrder::taken() {
  for (Tier& tier : tiers_) std::ranges::stable_sort(tier.intervals, {}, &TierInterval::start_s);
  places_.clear();
  return std::exchange(tiers_, {});
}

std::vector<std::string> values_of(std::span<const TierInterval> intervals) {
  std::vector<std::string> values;
  for (const TierInterval& interval : intervals)
    if (std::find(values.begin(), values.end(), interval.value) == values.end())
      values.push_back(interval.value);
  return values;
}

std::vector<VocabularyEntry> vocabulary_of(std::span<const TierInterval> intervals) {
  std::vector<VocabularyEntry> vocabulary;
  for (std::string& value : values_of(intervals)) vocabulary.push_back({std::move(value)});
  return vocabulary;
}

std::vector<VocabularyEntry> with_values_of(std::vector<VocabularyEntry> vocabulary, const Tier& other) {
  const auto has = [&vocabulary](const auto& is) {
    return std::any_of(vocabulary.begin(), vocabulary.end(), is);
  };
  std::vector<VocabularyEntry> more = other.vocabulary;
  for (const VocabularyEntry& each : vocabulary_of(other.intervals)) more.push_back(each);
  for (VocabularyEntry& entry : more) {
    if (entry.value.empty() ||
        has([&entry](const VocabularyEntry& known) { return known.value == entry.value; }))
      continue;
    if (has([&entry](const VocabularyEntry& known) { return known.key == entry.key; })) entry.key = 0;
    vocabulary.push_back(std::move(entry));
  }
  return vocabulary;
}

TierKind kind_of_name(std::string_view name) {
  const std::string lower = lower_case(trimmed(name));
  for (const char* role : {"role", "roles", "who leads"})
    if (lower == role) return TierKind::Role;
  for (const char* move : {"move", "moves", "label", "labels", "figure", "figures"})
    if (lower == move) return TierKind::Move;
  return TierKind::Note;
}

namespace {

/// Files in other encodings are read by readers that use the encoding stated in the file.
bool is_utf8(const Tier& tier) {
  bool good = !first_broken_byte(tier.name);
  for (const TierInterval& each : tier.intervals)
    good = good && !first_broken_byte(each.value) && !first_broken_byte(each.detail) &&
           !first_broken_byte(each.confidence);
  for (const VocabularyEntry& each : tier.vocabulary)
    good = good && !first_broken_byte(each.value) && !first_broken_byte(each.description);
  return good;
}

}  // namespace

Status check_tiers(std::span<const Tier> tiers, std::string_view where) {
  std::set<std::string_view> names;
  for (const Tier& tier : tiers) {
    if (trimmed(tier.name).empty()) return Error{"a tier has no name; give it one", std::string(where)};
    const std::string place = fmt::format("{}: tier {}", where, in_quotes(tier.name));
    if (!names.insert(tier.name).second) return Error{"there are two of this name; rename one", place};
    if (!is_utf8(tier))
      return Error{
          "holds text that is not UTF-8; save the file as UTF-8, or correct the encoding that it names",
          place};
    const TierInterval* before = nullptr;
    for (const TierInterval& interval : tier.intervals) {
      const std::string spoken =
          fmt::format("{} at {:.3f}-{:.3f} s", in_quotes(interval.value), interval.start_s, interval.end_s);
      if (!std::isfinite(interval.start_s) || !std::isfinite(interval.end_s))
        return Error{spoken + " needs finite times", place};
      if (interval.end_s <= interval.start_s)
        return Error{spoken + " does not end after its start; give it some length", place};
      if (before && interval.start_s < before->end_s)
        return Error{fmt::format("{} overlaps {} at {:.3f}-{:.3f} s; move one, or put it into another tier",
                                 spoken, in_quotes(before->value), before->start_s, before->end_s),
                     place};
      before = &interval;
    }
  }
  return Done{};
}

}  // namespace abrazo
