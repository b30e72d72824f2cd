#include "core/annotation/annotations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "core/annotation/annotation_room.hpp"
#include "core/base/text.hpp"

namespace abrazo {

namespace {

template <typename Items>
auto* with_id(Items& items, int id) {
  const auto found =
      std::find_if(items.begin(), items.end(), [id](const auto& item) { return item.id == id; });
  return found == items.end() ? nullptr : &*found;
}

Error no_such(const char* what, int id) {
  return {fmt::format("there is no {} {}; it may have been removed", what, id), ""};
}

void insert(std::vector<Annotation>& annotations, Annotation annotation) {
  const auto at =
      std::upper_bound(annotations.begin(), annotations.end(), annotation.start_s,
                       [](double start_s, const Annotation& other) { return start_s < other.start_s; });
  annotations.insert(at, std::move(annotation));
}

/// The wanted times in ascending order, within the range.
Result<Span> held(double from_s, double to_s, const Annotations::Range& range, std::string_view tier) {
  if (!std::isfinite(from_s) || !std::isfinite(to_s))
    return Error{"an interval needs finite times", std::string(tier)};
  if (to_s < from_s) std::swap(from_s, to_s);
  const Span span{std::max(from_s, range.first_s), std::min(to_s, range.last_s)};
  if (span.end_s - span.start_s <= same_time_s)
    return Error{fmt::format("nothing of {:.3f}-{:.3f} s is within {:.3f}-{:.3f} s; an interval needs some "
                             "length there",
                             from_s, to_s, range.first_s, range.last_s),
                 std::string(tier)};
  return span;
}

/// The same length where it ends at neither side of the range, when it fits there at all.
Span moved_inside(Span span, const Annotations::Range& range) {
  const double length_s = span.end_s - span.start_s;
  if (length_s > range.last_s - range.first_s) return span;
  if (span.start_s < range.first_s) return {range.first_s, range.first_s + length_s};
  if (span.end_s > range.last_s) return {range.last_s - length_s, range.last_s};
  return span;
}

Result<std::string> tier_name(std::string_view name, const std::vector<AnnotationTier>& tiers, int own) {
  name = trimmed(name);
  if (name.empty()) return Error{"a tier needs a name", ""};
  for (const AnnotationTier& tier : tiers)
    if (tier.name == name && tier.id != own)
      return Error{"there is a tier of this name already; give another", std::string(name)};
  return std::string(name);
}

Status check_vocabulary(const std::vector<VocabularyEntry>& vocabulary, std::string_view tier) {
  std::set<std::string_view> values;
  std::map<char, std::string_view> keys;
  for (const VocabularyEntry& entry : vocabulary) {
    if (trimmed(entry.value).empty())
      return Error{"a value of the vocabulary is empty; name it or leave it out", std::string(tier)};
    if (!values.insert(entry.value).second)
      return Error{"'" + entry.value + "' is already a value; choose another word", std::string(tier)};
    if (entry.key == 0) continue;
    if (const auto [owner, is_new] = keys.emplace(entry.key, entry.value); !is_new)
      return Error{fmt::format("the key {} is already that of '{}'; choose another key for '{}'", entry.key,
                               owner->second, entry.value),
                   std::string(tier)};
  }
  return Done{};
}

}  // namespace

// ---- what there is ----

const VocabularyEntry* AnnotationTier::entry(std::string_view value) const {
  const auto found = std::find_if(vocabulary.begin(), vocabulary.end(),
                                  [&](const VocabularyEntry& entry) { return entry.value == value; });
  return found == vocabulary.end() ? nullptr : &*found;
}

const VocabularyEntry* AnnotationTier::entry_of_key(char key) const {
  if (key == 0) return nullptr;
  const auto found = std::find_if(vocabulary.begin(), vocabulary.end(),
                                  [&](const VocabularyEntry& entry) { return entry.key == key; });
  return found == vocabulary.end() ? nullptr : &*found;
}

const Annotation* AnnotationTier::at(double time_s) const {
  const auto after =
      std::upper_bound(annotations.begin(), annotations.end(), time_s,
                       [](double time, const Annotation& annotation) { return time < annotation.start_s; });
  if (after == annotations.begin()) return nullptr;
  const Annotation& candidate = *std::prev(after);
  return time_s < candidate.end_s ? &candidate : nullptr;
}

const AnnotationTier* Annotations::tier(int id) const {
  return with_id(tiers_, id);
}

const AnnotationTier* Annotations::tier_named(std::string_view name) const {
  const auto found = std::find_if(tiers_.begin(), tiers_.end(),
                                  [&](const AnnotationTier& tier) { return tier.name == name; });
  return found == tiers_.end() ? nullptr : &*found;
}

const AnnotationTier* Annotations::first_of(TierKind kind) const {
  const auto found = std::find_if(tiers_.begin(), tiers_.end(),
                                  [&](const AnnotationTier& tier) { return tier.kind == kind; });
  return found == tiers_.end() ? nullptr : &*found;
}

const AnnotationTier* Annotations::tier_of(int annotation) const {
  for (const AnnotationTier& tier : tiers_)
    if (with_id(tier.annotations, annotation)) return &tier;
  return nullptr;
}

const Annotation* Annotations::find(int annotation) const {
  const AnnotationTier* tier = tier_of(annotation);
  return tier ? with_id(tier->annotations, annotation) : nullptr;
}

const Suggestion* Annotations::find_suggestion(int id) const {
  return with_id(suggestions_, id);
}

// ---- tiers ----

Result<int> Annotations::add_tier(std::string_view name, TierKind kind,
                                  std::vector<VocabularyEntry> vocabulary) {
  auto accepted = tier_name(name, tiers_, 0);
  if (!accepted) return accepted.error();
  if (const Status checked = check_vocabulary(vocabulary, *accepted); !checked) return checked.error();
  tiers_.push_back({next_id_++, std::move(*accepted), kind, std::move(vocabulary), {}});
  return tiers_.back().id;
}

Status Annotations::rename_tier(int tier, std::string_view name) {
  AnnotationTier* renamed = with_id(tiers_, tier);
  if (!renamed) return no_such("tier", tier);
  auto accepted = tier_name(name, tiers_, tier);
  if (!accepted) return accepted.error();
  renamed->name = std::move(*accepted);
  return Done{};
}

Status Annotations::set_vocabulary(int tier, std::vector<VocabularyEntry> vocabulary) {
  AnnotationTier* changed = with_id(tiers_, tier);
  if (!changed) return no_such("tier", tier);
  if (const Status checked = check_vocabulary(vocabulary, changed->name); !checked) return checked;
  changed->vocabulary = std::move(vocabulary);
  return Done{};
}

Status Annotations::remove_tier(int tier) {
  if (!with_id(tiers_, tier)) return no_such("tier", tier);
  std::erase_if(tiers_, [&](const AnnotationTier& other) { return other.id == tier; });
  std::erase_if(suggestions_, [&](const Suggestion& suggestion) { return suggestion.tier == tier; });
  return Done{};
}

Status Annotations::move_tier(int tier, int position) {
  AnnotationTier* moved = with_id(tiers_, tier);
  if (!moved) return no_such("tier", tier);
  if (position < 0 || position >= static_cast<int>(tiers_.size()))
    return Error{fmt::format("there is no place {}; {} tiers have places 0 to {}", position, tiers_.size(),
                             tiers_.size() - 1),
                 moved->name};
  const auto from = tiers_.begin() + (moved - tiers_.data()), to = tiers_.begin() + position;
  if (from < to)
    std::rotate(from, from + 1, to + 1);
  else
    std::rotate(to, from, from + 1);
  return Done{};
}

// ---- annotations ----

Result<int> Annotations::draw(int tier, double from_s, double to_s, std::string_view value, Conflict conflict,
                              const Range& range) {
  AnnotationTier* drawn = with_id(tiers_, tier);
  if (!drawn) return no_such("tier", tier);
  const auto wanted = held(from_s, to_s, range, drawn->name);
  if (!wanted) return wanted.error();
  int next_id = next_id_;
  const int id = next_id++;
  const auto span = make_room(drawn->annotations, *wanted, conflict, range, Placing::Anywhere, 0, drawn->name,
                              [&] { return next_id++; });
  if (!span) return span.error();
  next_id_ = next_id;
  insert(drawn->annotations, {{span->start_s, span->end_s, std::string(value)}, id});
  return id;
}

Status Annotations::place(int annotation, double from_s, double to_s, Conflict conflict, const Range& range) {
  const AnnotationTier* of = tier_of(annotation);
  if (!of) return no_such("annotation", annotation);
  AnnotationTier& tier = *with_id(tiers_, of->id);
  Annotation placed = *with_id(tier.annotations, annotation);
  const bool moves = std::abs(to_s - from_s - placed.duration_s()) <= same_time_s;
  const Span asked = moves ? moved_inside({from_s, to_s}, range) : Span{from_s, to_s};
  const auto wanted = held(asked.start_s, asked.end_s, range, tier.name);
  if (!wanted) return wanted.error();
  std::vector<Annotation> others = tier.annotations;
  std::erase_if(others, [&](const Annotation& other) { return other.id == annotation; });
  int next_id = next_id_;
  const auto span = make_room(others, *wanted, conflict, range, moves ? Placing::Anywhere : Placing::Resized,
                              placed.start_s, tier.name, [&] { return next_id++; });
  if (!span) return span.error();
  next_id_ = next_id;
  placed.start_s = span->start_s;
  placed.end_s = span->end_s;
  insert(others, std::move(placed));
  tier.annotations = std::move(others);
  return Done{};
}

Status Annotations::say(int annotation, const TierInterval& said) {
  const AnnotationTier* tier = tier_of(annotation);
  if (!tier) return no_such("annotation", annotation);
  Annotation& label = *with_id(with_id(tiers_, tier->id)->annotations, annotation);
  const double start_s = label.start_s, end_s = label.end_s;
  static_cast<TierInterval&>(label) = said;
  label.start_s = start_s, label.end_s = end_s;
  return Done{};
}

Result<int> Annotations::split(int annotation, double at_s) {
  const AnnotationTier* tier = tier_of(annotation);
  if (!tier) return no_such("annotation", annotation);
  std::vector<Annotation>& annotations = with_id(tiers_, tier->id)->annotations;
  Annotation& earlier = *with_id(annotations, annotation);
  // Negated, so that NaN fails too.
  if (!(at_s > earlier.start_s + same_time_s && at_s < earlier.end_s - same_time_s))
    return Error{fmt::format("{:.3f} s is not within {}; split it where it has some length on both sides",
                             at_s, spoken(earlier)),
                 tier->name};
  Annotation later = earlier;
  later.id = next_id_++;
  later.start_s = earlier.end_s = at_s;
  const int id = later.id;
  insert(annotations, std::move(later));
  return id;
}

Status Annotations::merge_with_next(int annotation) {
  const AnnotationTier* tier = tier_of(annotation);
  if (!tier) return no_such("annotation", annotation);
  std::vector<Annotation>& annotations = with_id(tiers_, tier->id)->annotations;
  Annotation* earlier = with_id(annotations, annotation);
  if (earlier == &annotations.back())
    return Error{spoken(*earlier) + " is the last of its tier; there is nothing to merge it with",
                 tier->name};
  earlier->end_s = (earlier + 1)->end_s;
  annotations.erase(annotations.begin() + (earlier - annotations.data()) + 1);
  return Done{};
}

Status Annotations::remove(int annotation) {
  const AnnotationTier* tier = tier_of(annotation);
  if (!tier) return no_such("annotation", annotation);
  std::erase_if(with_id(tiers_, tier->id)->annotations,
                [&](const Annotation& other) { return other.id == annotation; });
  return Done{};
}

Result<int> Annotations::copy_to(int annotation, int tier, Conflict conflict) {
  const Annotation* found = find(annotation);
  if (!found) return no_such("annotation", annotation);
  const Annotation original = *found;
  if (tier_of(annotation)->id == tier)
    return Error{spoken(original) + " is in this tier already; copy it to another",
                 tier_of(annotation)->name};
  const Range range{std::min(0.0, original.start_s), everywhere.last_s};
  const auto id = draw(tier, original.start_s, original.end_s, original.value, conflict, range);
  if (!id) return id.error();
  if (const Status said = say(*id, original); !said) return said.error();
  return *id;
}

// ---- suggestions ----

void Annotations::suggest(std::span<const int> tiers, std::vector<Suggestion> suggestions) {
  const auto is_meant = [&](int tier) { return std::find(tiers.begin(), tiers.end(), tier) != tiers.end(); };
  for (const Suggestion& suggestion : suggestions)
    if (!with_id(tiers_, suggestion.tier) || !is_meant(suggestion.tier) ||
        !(suggestion.end_s > suggestion.start_s))
      throw std::invalid_argument("a suggestion needs one of the tiers it is made for, and some length");
  std::erase_if(suggestions_, [&](const Suggestion& old) { return is_meant(old.tier); });
  for (Suggestion& suggestion : suggestions) {
    suggestion.id = next_id_++;
    suggestions_.push_back(std::move(suggestion));
  }
  std::stable_sort(suggestions_.begin(), suggestions_.end(),
                   [](const Suggestion& a, const Suggestion& b) { return a.start_s < b.start_s; });
}

Result<int> Annotations::accept(int suggestion, Conflict conflict, const Range& range) {
  const Suggestion* accepted = find_suggestion(suggestion);
  if (!accepted) return no_such("suggestion", suggestion);
  const auto id = draw(accepted->tier, accepted->start_s, accepted->end_s, accepted->value, conflict, range);
  if (id) std::erase_if(suggestions_, [&](const Suggestion& other) { return other.id == suggestion; });
  return id;
}

Status Annotations::reject(int suggestion) {
  if (!find_suggestion(suggestion)) return no_such("suggestion", suggestion);
  std::erase_if(suggestions_, [&](const Suggestion& other) { return other.id == suggestion; });
  return Done{};
}

void Annotations::clear_suggestions() {
  suggestions_.clear();
}

}  // namespace abrazo
