#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "core/base/json_text.hpp"
#include "core/base/limits.hpp"
#include "core/library/takes/refusal.hpp"
#include "core/library/takes/tier_kind.hpp"

namespace abrazo {

namespace {

using nlohmann::json;

void put_entry(JsonText& text, const VocabularyEntry& entry) {
  if (entry.description.empty() && !entry.rgb && entry.key == 0) {
    text.value(entry.value);
    return;
  }
  text.begin_object().key("value").value(entry.value);
  if (!entry.description.empty()) text.key("description").value(entry.description);
  if (entry.rgb) text.key("colour").value(fmt::format("#{:06x}", *entry.rgb & 0xFFFFFFu));
  if (entry.key != 0) text.key("key").value(std::string(1, entry.key));
  text.end_object();
}

void put_interval(JsonText& text, const TierInterval& interval) {
  text.begin_object().key("start_s").value(interval.start_s).key("end_s").value(interval.end_s);
  text.key("value").value(interval.value);
  if (!interval.detail.empty()) text.key("detail").value(interval.detail);
  if (!interval.confidence.empty()) text.key("confidence").value(interval.confidence);
  text.end_object();
}

std::string json_of(std::span<const Tier> tiers, bool with_intervals) {
  JsonText text;
  text.begin_object().key("tiers").begin_array();
  for (const Tier& tier : tiers) {
    text.begin_object().key("name").value(tier.name).key("kind").value(text_of(tier.kind));
    text.key("vocabulary").begin_array();
    for (const VocabularyEntry& entry : tier.vocabulary) put_entry(text, entry);
    text.end_array();
    if (with_intervals) {
      text.key("intervals").begin_array();
      for (const TierInterval& interval : tier.intervals) put_interval(text, interval);
      text.end_array();
    }
    text.end_object();
  }
  text.end_array().end_object();
  return text.take();
}

// ---- reading ----

/// A JSON value with its position.
struct TierNode {
  const json& value;
  std::string place;
  std::vector<std::string>& warnings;

  [[noreturn]] void refuse(const std::string& message) const { throw Refusal{{message, place}}; }
  TierNode at(const char* key) const { return {value.at(key), place + "." + key, warnings}; }
  TierNode at(std::size_t i) const { return {value.at(i), fmt::format("{}[{}]", place, i), warnings}; }
  bool has(const char* key) const { return value.contains(key) && !value.at(key).is_null(); }

  void expect_object(std::initializer_list<std::string_view> known) const {
    if (!value.is_object()) refuse(fmt::format("expected an object {{...}}, found {}", value.type_name()));
    for (const auto& [key, unused] : value.items())
      if (std::find(known.begin(), known.end(), key) == known.end() && warnings.size() < 100)
        warnings.push_back(
            fmt::format("{}: \"{}\" is not read; known here are {}", place, key, fmt::join(known, ", ")));
  }
  TierNode required(const char* key, const char* what) const {
    if (!has(key)) refuse(fmt::format("\"{}\" is missing; add {}", key, what));
    return at(key);
  }
  std::string string() const {
    if (!value.is_string()) refuse(fmt::format("expected a text in quotes, found {}", value.type_name()));
    return value.get<std::string>();
  }
  std::string string_or_nothing(const char* key) const { return has(key) ? at(key).string() : std::string(); }
  double number() const {
    if (!value.is_number()) refuse(fmt::format("expected a number, found {}", value.type_name()));
    return value.get<double>();
  }
  std::size_t size() const {
    if (!value.is_array()) refuse(fmt::format("expected a list [...], found {}", value.type_name()));
    return value.size();
  }
};

std::uint32_t parse_colour(const TierNode& node) {
  const std::string text = node.string();
  const bool is_colour =
      text.size() == 7 && text[0] == '#' &&
      std::all_of(text.begin() + 1, text.end(), [](unsigned char c) { return std::isxdigit(c); });
  if (!is_colour) node.refuse("expected a colour as \"#rrggbb\", found \"" + text + "\"");
  return static_cast<std::uint32_t>(std::stoul(text.substr(1), nullptr, 16));
}

char parse_key(const TierNode& node) {
  const std::string text = node.string();
  if (text.size() != 1 || text[0] <= ' ' || text[0] > '~')
    node.refuse("expected one key as \"1\" or \"b\", found \"" + text + "\"");
  return text[0];
}

VocabularyEntry parse_entry(const TierNode& node) {
  if (node.value.is_string()) return {node.string()};
  node.expect_object({"value", "description", "colour", "key"});
  VocabularyEntry entry{node.required("value", "what can be said").string()};
  entry.description = node.string_or_nothing("description");
  if (node.has("colour")) entry.rgb = parse_colour(node.at("colour"));
  if (node.has("key")) entry.key = parse_key(node.at("key"));
  return entry;
}

TierInterval parse_interval(const TierNode& node) {
  node.expect_object({"start_s", "end_s", "value", "detail", "confidence"});
  return {node.required("start_s", "its start in seconds").number(),
          node.required("end_s", "its end in seconds").number(), node.string_or_nothing("value"),
          node.string_or_nothing("detail"), node.string_or_nothing("confidence")};
}

TierKind parse_kind(const TierNode& node) {
  const std::string text = node.string();
  if (const auto kind = parse_tier_kind(text)) return *kind;
  node.refuse("expected \"role\", \"move\" or \"note\", found \"" + text + "\"");
}

Tier parse_tier(const TierNode& node) {
  node.expect_object({"name", "kind", "vocabulary", "intervals"});
  Tier tier;
  tier.name = node.required("name", "a name that no other tier has").string();
  tier.kind = node.has("kind") ? parse_kind(node.at("kind")) : kind_of_name(tier.name);
  if (node.has("vocabulary")) {
    const TierNode entries = node.at("vocabulary");
    for (std::size_t i = 0, n = entries.size(); i < n; ++i)
      tier.vocabulary.push_back(parse_entry(entries.at(i)));
  }
  if (node.has("intervals")) {
    const TierNode intervals = node.at("intervals");
    for (std::size_t i = 0, n = intervals.size(); i < n; ++i)
      tier.intervals.push_back(parse_interval(intervals.at(i)));
  }
  std::stable_sort(tier.intervals.begin(), tier.intervals.end(),
                   [](const TierInterval& a, const TierInterval& b) { return a.start_s < b.start_s; });
  return tier;
}

}  // namespace

std::string tiers_json(std::span<const Tier> tiers) {
  return json_of(tiers, true) + "\n";
}

std::string tier_facts_json(std::span<const Tier> tiers) {
  return json_of(tiers, false);
}

Result<std::vector<Tier>> parse_tiers_json(std::string_view text, std::string_view where,
                                           std::vector<std::string>& warnings) {
  if (const char* beyond = json_beyond_bounds(text)) return Error{beyond, std::string(where)};
  try {
    const json content = json::parse(text);
    const TierNode root{content, std::string(where) + ": ", warnings};
    if (!content.is_object() || !content.contains("tiers"))
      return Error{"has no \"tiers\"; expected {\"tiers\": [{\"name\": ..., \"intervals\": [...]}]}",
                   std::string(where)};
    root.expect_object({"tiers"});
    const TierNode list{content.at("tiers"), std::string(where) + ": tiers", warnings};
    std::vector<Tier> tiers;
    for (std::size_t i = 0, n = list.size(); i < n; ++i) tiers.push_back(parse_tier(list.at(i)));
    if (const Status checked = check_tiers(tiers, where); !checked) return checked.error();
    return tiers;
  } catch (const json::parse_error& failure) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(failure.byte, text.size()));
    return Error{"is not JSON from here on; look for a missing comma, quote or bracket",
                 fmt::format("{}:{}", where, 1 + std::count(text.begin(), end, '\n'))};
  } catch (const json::exception& failure) {
    return Error{std::string("holds a number or text that cannot be used: ") + failure.what(),
                 std::string(where)};
  } catch (const Refusal& refusal) {
    return refusal.error;
  }
}

}  // namespace abrazo
