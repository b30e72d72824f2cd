#include "core/library/takes/eaf_file.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "core/base/text.hpp"

namespace abrazo {

namespace {

using Milliseconds = std::uint64_t;

struct Slots {
  Milliseconds start = 0, end = 0;
};

/// An interval's place in the tier, from whole milliseconds and from where the one before it ends.
Slots slots_of(const TierInterval& interval, Milliseconds free_from) {
  const auto rounded = [](double time_s) { return static_cast<Milliseconds>(std::llround(time_s * 1000)); };
  Slots slots{std::max(rounded(interval.start_s), free_from), rounded(interval.end_s)};
  slots.end = std::max(slots.end, slots.start + 1);
  return slots;
}

/// XML 1.0, 2.2: of the control characters only these.
bool is_xml_text(std::string_view text) {
  return std::none_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r';
  });
}

bool is_xml_text(const Tier& tier) {
  return is_xml_text(tier.name) &&
         std::all_of(tier.intervals.begin(), tier.intervals.end(),
                     [](const TierInterval& one) {
                       return is_xml_text(one.value) && is_xml_text(one.detail) &&
                              is_xml_text(one.confidence);
                     }) &&
         std::all_of(tier.vocabulary.begin(), tier.vocabulary.end(), [](const VocabularyEntry& entry) {
           return is_xml_text(entry.value) && is_xml_text(entry.description);
         });
}

Status check(std::span<const Tier> tiers) {
  constexpr double latest_s = std::numeric_limits<std::uint32_t>::max() / 1000.0 - 1;
  std::set<std::string> names;
  for (const Tier& tier : tiers) {
    if (!names.insert(tier.name).second) return Error{"two tiers of one name; rename one", tier.name};
    if (!is_xml_text(tier))
      return Error{"has a control character, which XML cannot hold; write it again", in_quotes(tier.name)};
    double free_from_s = 0;
    for (const TierInterval& interval : tier.intervals) {
      // Negated, so that NaN fails too.
      if (!(interval.start_s >= 0 && interval.end_s < latest_s))
        return Error{"an EAF file holds times from 0 to 49 days; found " + std::to_string(interval.start_s) +
                         " to " + std::to_string(interval.end_s) + " s",
                     tier.name};
      if (interval.end_s < interval.start_s || interval.start_s < free_from_s)
        return Error{"the interval '" + interval.value + "' at " + std::to_string(interval.start_s) +
                         " s runs backwards or overlaps the one before it",
                     tier.name};
      free_from_s = interval.end_s;
    }
  }
  return Done{};
}

/// The document as it grows. The order of elements is the schema's, that of time slots ascending: ELAN takes
/// the place in the list for the order in time.
class EafDocument {
 public:
  EafDocument(std::span<const Tier> tiers, const EafFacts& facts);
  void add(const Tier& tier);
  std::string finish();

 private:
  /// An attribute that waits for the name of its slot.
  struct SlotUse {
    Milliseconds time;
    pugi::xml_attribute reference;
  };
  void add_annotation(pugi::xml_node tier, const Tier& facts, const TierInterval& interval,
                      const Slots& slots);
  void add_remarks(const Tier& tier, int first_annotation, const char* word, const char* type,
                   std::string TierInterval::*remark);
  void add_time_slots();
  void add_types();
  void add_type(const std::string& name, const std::string& vocabulary, const char* constraint);
  void add_vocabularies();
  std::string free_name(std::set<std::string>& taken, std::string name);

  pugi::xml_document document_;
  pugi::xml_node root_, times_;
  std::set<std::string> tier_names_, type_names_;
  std::vector<std::pair<const Tier*, std::string>> with_vocabulary_;  ///< with the name of its type
  std::set<const char*> remark_types_;
  std::vector<SlotUse> uses_;
  int annotations_ = 0;
};

constexpr const char* free_text = "free text";  ///< linguistic type of tiers without a vocabulary
constexpr const char* language = "und";         ///< ISO 639-3: words of no known language
constexpr const char* one_to_one = "Symbolic_Association";

/// An attribute that is written for every value.
pugi::xml_attribute set(pugi::xml_node node, const char* name, const std::string& value) {
  pugi::xml_attribute attribute = node.append_attribute(name);
  attribute.set_value(value.c_str());
  return attribute;
}

/// EAF cannot express kinds, colours and keys; without a stated kind it is derived from the name.
bool has_more_than_eaf_has(const Tier& tier) {
  return tier.kind != TierKind::Note || kind_of_name(tier.name) != TierKind::Note ||
         std::any_of(tier.vocabulary.begin(), tier.vocabulary.end(),
                     [](const VocabularyEntry& entry) { return entry.rgb || entry.key != 0; });
}

EafDocument::EafDocument(std::span<const Tier> tiers, const EafFacts& facts)
    : type_names_{free_text, eaf_detail_type, eaf_confidence_type} {
  for (const Tier& tier : tiers) tier_names_.insert(tier.name);
  pugi::xml_node declaration = document_.append_child(pugi::node_declaration);
  set(declaration, "version", "1.0");
  set(declaration, "encoding", "UTF-8");
  root_ = document_.append_child("ANNOTATION_DOCUMENT");
  set(root_, "AUTHOR", facts.author);
  set(root_, "DATE", facts.date);
  set(root_, "FORMAT", "3.0");
  set(root_, "VERSION", "3.0");
  set(root_, "xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance");
  set(root_, "xsi:noNamespaceSchemaLocation", "http://www.mpi.nl/tools/elan/EAFv3.0.xsd");
  pugi::xml_node header = root_.append_child("HEADER");
  set(header, "TIME_UNITS", "milliseconds");
  if (std::any_of(tiers.begin(), tiers.end(), has_more_than_eaf_has)) {
    pugi::xml_node property = header.append_child("PROPERTY");
    set(property, "NAME", eaf_facts_property);
    property.text().set(tier_facts_json(tiers).c_str());
  }
  times_ = root_.append_child("TIME_ORDER");
}

void EafDocument::add_annotation(pugi::xml_node tier, const Tier& facts, const TierInterval& interval,
                                 const Slots& slots) {
  pugi::xml_node annotation = tier.append_child("ANNOTATION").append_child("ALIGNABLE_ANNOTATION");
  set(annotation, "ANNOTATION_ID", "a" + std::to_string(++annotations_));
  const auto word = std::find_if(facts.vocabulary.begin(), facts.vocabulary.end(),
                                 [&](const VocabularyEntry& entry) { return entry.value == interval.value; });
  if (word != facts.vocabulary.end())
    set(annotation, "CVE_REF", "v" + std::to_string(word - facts.vocabulary.begin()));
  uses_.push_back({slots.start, set(annotation, "TIME_SLOT_REF1", "")});
  uses_.push_back({slots.end, set(annotation, "TIME_SLOT_REF2", "")});
  annotation.append_child("ANNOTATION_VALUE").text().set(interval.value.c_str());
}

std::string EafDocument::free_name(std::set<std::string>& taken, std::string name) {
  const std::string wanted = name;
  for (int i = 2; !taken.insert(name).second; ++i) name = wanted + " " + std::to_string(i);
  return name;
}

/// A child tier with detail or confidence, one to one.
void EafDocument::add_remarks(const Tier& tier, int first_annotation, const char* word, const char* type,
                              std::string TierInterval::*remark) {
  pugi::xml_node node;
  for (std::size_t i = 0; i < tier.intervals.size(); ++i) {
    const std::string& text = tier.intervals[i].*remark;
    if (text.empty()) continue;
    if (!node) {
      node = root_.append_child("TIER");
      set(node, "LINGUISTIC_TYPE_REF", type);
      set(node, "PARENT_REF", tier.name);
      set(node, "TIER_ID", free_name(tier_names_, tier.name + " " + word));
      remark_types_.insert(type);
    }
    pugi::xml_node annotation = node.append_child("ANNOTATION").append_child("REF_ANNOTATION");
    set(annotation, "ANNOTATION_ID", "a" + std::to_string(++annotations_));
    set(annotation, "ANNOTATION_REF", "a" + std::to_string(first_annotation + static_cast<int>(i)));
    annotation.append_child("ANNOTATION_VALUE").text().set(text.c_str());
  }
}

void EafDocument::add(const Tier& tier) {
  pugi::xml_node node = root_.append_child("TIER");
  const std::string type = tier.vocabulary.empty() ? free_text : free_name(type_names_, tier.name);
  set(node, "LINGUISTIC_TYPE_REF", type);
  set(node, "TIER_ID", tier.name);
  const int first_annotation = annotations_ + 1;
  Milliseconds free_from = 0;
  for (const TierInterval& interval : tier.intervals) {
    const Slots slots = slots_of(interval, free_from);
    add_annotation(node, tier, interval, slots);
    free_from = slots.end;
  }
  if (!tier.vocabulary.empty()) with_vocabulary_.emplace_back(&tier, type);
  add_remarks(tier, first_annotation, "detail", eaf_detail_type, &TierInterval::detail);
  add_remarks(tier, first_annotation, "confidence", eaf_confidence_type, &TierInterval::confidence);
}

void EafDocument::add_time_slots() {
  std::stable_sort(uses_.begin(), uses_.end(),
                   [](const SlotUse& a, const SlotUse& b) { return a.time < b.time; });
  for (std::size_t i = 0; i < uses_.size(); ++i) {
    const std::string id = "ts" + std::to_string(i + 1);
    pugi::xml_node slot = times_.append_child("TIME_SLOT");
    set(slot, "TIME_SLOT_ID", id);
    set(slot, "TIME_VALUE", std::to_string(uses_[i].time));
    uses_[i].reference.set_value(id.c_str());
  }
}

void EafDocument::add_type(const std::string& name, const std::string& vocabulary, const char* constraint) {
  pugi::xml_node type = root_.append_child("LINGUISTIC_TYPE");
  if (constraint) set(type, "CONSTRAINTS", constraint);
  if (!vocabulary.empty()) set(type, "CONTROLLED_VOCABULARY_REF", vocabulary);
  set(type, "GRAPHIC_REFERENCES", "false");
  set(type, "LINGUISTIC_TYPE_ID", name);
  set(type, "TIME_ALIGNABLE", constraint ? "false" : "true");
}

void EafDocument::add_types() {
  add_type(free_text, "", nullptr);
  for (const auto& [tier, type] : with_vocabulary_) add_type(type, tier->name, nullptr);
  for (const char* type : remark_types_) add_type(type, "", one_to_one);
}

void EafDocument::add_vocabularies() {
  if (!with_vocabulary_.empty()) {
    pugi::xml_node und = root_.append_child("LANGUAGE");
    set(und, "LANG_DEF", "http://cdb.iso.org/lg/CDB-00130975-001");
    set(und, "LANG_ID", language);
    set(und, "LANG_LABEL", "undetermined (und)");
  }
  if (!remark_types_.empty()) {
    pugi::xml_node constraint = root_.append_child("CONSTRAINT");
    set(constraint, "DESCRIPTION", "1-1 association with a parent annotation");
    set(constraint, "STEREOTYPE", one_to_one);
  }
  for (const auto& [tier, type] : with_vocabulary_) {
    pugi::xml_node vocabulary = root_.append_child("CONTROLLED_VOCABULARY");
    set(vocabulary, "CV_ID", tier->name);
    for (std::size_t w = 0; w < tier->vocabulary.size(); ++w) {
      const VocabularyEntry& word = tier->vocabulary[w];
      pugi::xml_node entry = vocabulary.append_child("CV_ENTRY_ML");
      set(entry, "CVE_ID", "v" + std::to_string(w));
      pugi::xml_node value = entry.append_child("CVE_VALUE");
      if (!word.description.empty()) set(value, "DESCRIPTION", word.description);
      set(value, "LANG_REF", language);
      value.text().set(word.value.c_str());
    }
  }
}

std::string EafDocument::finish() {
  add_time_slots();
  add_types();
  add_vocabularies();
  std::ostringstream text;
  document_.save(text, "  ", pugi::format_indent, pugi::encoding_utf8);
  return text.str();
}

}  // namespace

Result<std::string> write_eaf(std::span<const Tier> tiers, const EafFacts& facts) {
  if (const Status checked = check(tiers); !checked) return checked.error();
  EafDocument document(tiers, facts);
  for (const Tier& tier : tiers) document.add(tier);
  return document.finish();
}

}  // namespace abrazo
