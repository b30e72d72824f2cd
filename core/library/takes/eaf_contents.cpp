#include "core/library/takes/eaf_contents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <unordered_map>

#include "core/base/text.hpp"
#include "core/library/takes/eaf_times.hpp"

namespace abrazo {

namespace {

using Annotation = EafContents::Annotation;
using TierElement = EafContents::TierElement;

void warn(std::vector<std::string>& warnings, int count, const char* one, const char* many) {
  if (count > 0) warnings.push_back(fmt::format("{} {}", count, count == 1 ? one : many));
}

// ---- vocabularies ----

const EafContents::Vocabulary* vocabulary_of_tier(const EafContents& contents, const TierElement& tier) {
  const auto type = contents.types.find(tier.type);
  if (type == contents.types.end() || type->second.vocabulary.empty()) return nullptr;
  const auto vocabulary = contents.vocabularies.find(type->second.vocabulary);
  return vocabulary == contents.vocabularies.end() ? nullptr : &vocabulary->second;
}

constexpr std::size_t most_languages = 100;  ///< that are compared

/// The language of the tier's annotations: its own if stated, else the one with most of their values, else
/// the first.
std::string language_of(const EafContents::Vocabulary& vocabulary, const TierElement& tier) {
  std::map<std::string, std::set<std::string_view>> values;
  std::vector<std::string> languages;
  for (const EafContents::Entry& entry : vocabulary.entries)
    for (const EafContents::Word& word : entry.words) {
      if (values.find(word.language) == values.end()) languages.push_back(word.language);
      if (languages.size() > most_languages) return languages.front();
      values[word.language].insert(word.value);
    }
  if (languages.empty()) return {};
  if (values.find(tier.language) != values.end()) return tier.language;
  std::vector<std::ptrdiff_t> hits;
  for (const std::string& language : languages)
    hits.push_back(std::count_if(
        tier.annotations.begin(), tier.annotations.end(),
        [&](const Annotation& one) { return values[language].find(one.value) != values[language].end(); }));
  return languages[static_cast<std::size_t>(std::max_element(hits.begin(), hits.end()) - hits.begin())];
}

std::vector<VocabularyEntry> words_of(const EafContents::Vocabulary& vocabulary, const std::string& language,
                                      int& missing) {
  std::vector<VocabularyEntry> words;
  std::set<std::string_view> seen;
  for (const EafContents::Entry& entry : vocabulary.entries) {
    const auto word = std::find_if(entry.words.begin(), entry.words.end(),
                                   [&](const EafContents::Word& one) { return one.language == language; });
    if (word == entry.words.end() || trimmed(word->value).empty() || !seen.insert(word->value).second)
      ++missing;
    else
      words.push_back({word->value, word->description});
  }
  return words;
}

// ---- child tiers of ours ----

bool is_remark(const TierElement& tier, const char* type) {
  return tier.type.starts_with(type) && !tier.parent.empty() &&
         std::none_of(tier.annotations.begin(), tier.annotations.end(),
                      [](const Annotation& one) { return one.alignable; });
}

bool is_remark(const TierElement& tier) {
  return is_remark(tier, eaf_detail_type) || is_remark(tier, eaf_confidence_type);
}

/// Values of child tiers, by annotation id.
using Remarks = std::unordered_map<std::string_view, std::string_view>;

Remarks remarks_of(const EafContents& contents, const char* type) {
  Remarks remarks;
  for (const TierElement& tier : contents.tiers)
    if (is_remark(tier, type))
      for (const Annotation& one : tier.annotations) remarks.emplace(one.parent, one.value);
  return remarks;
}

/// Kinds, colours and keys from the property.
void add_facts(const std::string& facts_json, std::vector<Tier>& tiers, std::vector<std::string>& warnings) {
  if (facts_json.empty()) return;
  std::vector<std::string> ignored;
  const auto facts = parse_tiers_json(facts_json, eaf_facts_property, ignored);
  if (!facts) {
    warnings.push_back("kinds, colours and keys of tiers were left out: the property " +
                       std::string(eaf_facts_property) + " cannot be read");
    return;
  }
  for (Tier& tier : tiers) {
    const auto fact =
        std::find_if(facts->begin(), facts->end(), [&](const Tier& one) { return one.name == tier.name; });
    if (fact == facts->end()) continue;
    tier.kind = fact->kind;
    std::map<std::string_view, const VocabularyEntry*> known;
    for (const VocabularyEntry& entry : fact->vocabulary) known.emplace(entry.value, &entry);
    for (VocabularyEntry& entry : tier.vocabulary)
      if (const auto found = known.find(entry.value); found != known.end())
        entry.rgb = found->second->rgb, entry.key = found->second->key;
  }
}

/// Builds the tiers and counts omissions.
class TierBuilder {
 public:
  TierBuilder(const EafContents& contents, std::string_view where) : contents_(contents), where_(where) {}
  Result<std::vector<Tier>> tiers();
  void add_warnings(std::vector<std::string>& warnings) const;

 private:
  Status add(const TierElement& element, const EafTimes& times);

  const EafContents& contents_;
  std::string where_;
  Remarks details_, confidences_;
  std::vector<Tier> tiers_;
  int empty_ = 0, unknown_types_ = 0, elsewhere_ = 0, missing_words_ = 0, interpolated_ = 0;
};

Status TierBuilder::add(const TierElement& element, const EafTimes& times) {
  Tier tier{element.id, {}, {}, kind_of_name(element.id)};
  if (!element.type.empty() && contents_.types.find(element.type) == contents_.types.end()) ++unknown_types_;
  if (const auto* vocabulary = vocabulary_of_tier(contents_, element)) {
    tier.vocabulary = words_of(*vocabulary, language_of(*vocabulary, element), missing_words_);
    elsewhere_ += vocabulary->is_elsewhere ? 1 : 0;
  }
  const auto remark = [](const Remarks& remarks, const std::string& id) {
    const auto found = remarks.find(id);
    return found == remarks.end() ? std::string() : std::string(found->second);
  };
  for (const Annotation& one : element.annotations) {
    const EafSpan span = times.of(one.id);
    if (span.end_s < span.start_s)
      return Error{
          fmt::format("annotation {} ({}) runs backwards, from {:.3f} to {:.3f} s; correct its time slots",
                      in_quotes(one.id), in_quotes(one.value), span.start_s, span.end_s),
          fmt::format("{}: tier {}", where_, in_quotes(element.id))};
    if (span.end_s == span.start_s) {
      ++empty_;
      continue;
    }
    tier.intervals.push_back({.start_s = span.start_s,
                              .end_s = span.end_s,
                              .value = one.value,
                              .detail = remark(details_, one.id),
                              .confidence = remark(confidences_, one.id)});
  }
  std::stable_sort(tier.intervals.begin(), tier.intervals.end(),
                   [](const TierInterval& a, const TierInterval& b) { return a.start_s < b.start_s; });
  tiers_.push_back(std::move(tier));
  return Done{};
}

Result<std::vector<Tier>> TierBuilder::tiers() {
  EafTimes times;
  if (const Status found = times.resolve(contents_, where_); !found) return found.error();
  interpolated_ = times.interpolated();
  details_ = remarks_of(contents_, eaf_detail_type);
  confidences_ = remarks_of(contents_, eaf_confidence_type);
  for (const TierElement& element : contents_.tiers) {
    if (is_remark(element)) continue;
    if (const Status added = add(element, times); !added) return added.error();
  }
  if (const Status checked = check_tiers(tiers_, where_); !checked) return checked.error();
  return std::move(tiers_);
}

void TierBuilder::add_warnings(std::vector<std::string>& warnings) const {
  const double format = parse_number(contents_.format).value_or(3.0);
  if (format > 3.0)
    warnings.push_back("is of format " + contents_.format +
                       ", newer than 3.0; what is new in it is not read");
  warn(warnings, interpolated_, "time slot without a value was put evenly between its neighbours",
       "time slots without a value were put evenly between their neighbours");
  warn(warnings, empty_, "annotation without length was left out",
       "annotations without length were left out");
  warn(warnings, unknown_types_, "tier has a linguistic type that the file does not have; taken as free text",
       "tiers have a linguistic type that the file does not have; taken as free text");
  warn(warnings, elsewhere_, "tier has its vocabulary in another file, which is not read",
       "tiers have their vocabulary in another file, which is not read");
  warn(warnings, missing_words_, "vocabulary entry without a word in the tier's language was left out",
       "vocabulary entries without a word of their own in the tier's language were left out");
  warn(warnings, contents_.external_references, "reference to something outside the file was left out",
       "references to something outside the file were left out");
  warn(warnings, contents_.reference_links, "link between annotations was left out",
       "links between annotations were left out");
  warn(warnings, contents_.media_with_offset,
       "video or sound file has an offset, which is not used: times are those of the annotations",
       "video or sound files have an offset, which is not used: times are those of the annotations");
}

}  // namespace

Result<std::vector<Tier>> tiers_of(const EafContents& contents, std::string_view where,
                                   std::vector<std::string>& warnings) {
  TierBuilder builder(contents, where);
  auto tiers = builder.tiers();
  if (!tiers) return tiers.error();
  builder.add_warnings(warnings);
  add_facts(contents.tier_facts, *tiers, warnings);
  return tiers;
}

}  // namespace abrazo
