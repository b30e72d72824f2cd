#include "core/library/tier.hpp"

#include <algorithm>

#include "core/base/json_text.hpp"

namespace abrazo {

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

std::string tiers_json(std::span<const Tier> tiers) {
  JsonText json;
  json.begin_object().key("tiers").begin_array();
  for (const Tier& tier : tiers) {
    json.begin_object().key("name").value(tier.name);
    json.key("vocabulary").begin_array();
    for (const VocabularyEntry& entry : tier.vocabulary) json.value(entry.value);
    json.end_array().key("intervals").begin_array();
    for (const TierInterval& interval : tier.intervals) {
      json.begin_object().key("start_s").value(interval.start_s).key("end_s").value(interval.end_s);
      json.key("value").value(interval.value).end_object();
    }
    json.end_array().end_object();
  }
  json.end_array().end_object();
  return json.take() + "\n";
}

}  // namespace abrazo
