#include "core/library/eaf_file.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <pugixml.hpp>
#include <set>
#include <sstream>

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

Status check(std::span<const Tier> tiers) {
  constexpr double latest_s = std::numeric_limits<std::uint32_t>::max() / 1000.0 - 1;
  std::set<std::string> names;
  for (const Tier& tier : tiers) {
    if (!names.insert(tier.name).second) return Error{"two tiers of one name; rename one", tier.name};
    double free_from_s = 0;
    for (const TierInterval& interval : tier.intervals) {
      // Negated, so that what is not a number fails too.
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
  explicit EafDocument(const EafFacts& facts);
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
  void add_time_slots();
  void add_types();
  void add_vocabularies();

  pugi::xml_document document_;
  pugi::xml_node root_, times_;
  std::vector<Tier> with_vocabulary_;
  std::vector<SlotUse> uses_;
  int annotations_ = 0;
};

constexpr const char* free_text = "free text";  ///< linguistic type of tiers without a vocabulary
constexpr const char* language = "und";         ///< ISO 639-3: words of no known language

/// An attribute that is there whatever the value.
pugi::xml_attribute set(pugi::xml_node node, const char* name, const std::string& value) {
  pugi::xml_attribute attribute = node.append_attribute(name);
  attribute.set_value(value.c_str());
  return attribute;
}

EafDocument::EafDocument(const EafFacts& facts) {
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
  set(root_.append_child("HEADER"), "TIME_UNITS", "milliseconds");
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

void EafDocument::add(const Tier& tier) {
  pugi::xml_node node = root_.append_child("TIER");
  set(node, "LINGUISTIC_TYPE_REF", tier.vocabulary.empty() ? free_text : tier.name);
  set(node, "TIER_ID", tier.name);
  Milliseconds free_from = 0;
  for (const TierInterval& interval : tier.intervals) {
    const Slots slots = slots_of(interval, free_from);
    add_annotation(node, tier, interval, slots);
    free_from = slots.end;
  }
  if (!tier.vocabulary.empty()) with_vocabulary_.push_back(tier);
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

void EafDocument::add_types() {
  const auto add_type = [&](const std::string& name, const std::string& vocabulary) {
    pugi::xml_node type = root_.append_child("LINGUISTIC_TYPE");
    if (!vocabulary.empty()) set(type, "CONTROLLED_VOCABULARY_REF", vocabulary);
    set(type, "GRAPHIC_REFERENCES", "false");
    set(type, "LINGUISTIC_TYPE_ID", name);
    set(type, "TIME_ALIGNABLE", "true");
  };
  add_type(free_text, "");
  for (const Tier& tier : with_vocabulary_) add_type(tier.name, tier.name);
}

void EafDocument::add_vocabularies() {
  if (with_vocabulary_.empty()) return;
  pugi::xml_node und = root_.append_child("LANGUAGE");
  set(und, "LANG_DEF", "http://cdb.iso.org/lg/CDB-00130975-001");
  set(und, "LANG_ID", language);
  set(und, "LANG_LABEL", "undetermined (und)");
  for (const Tier& tier : with_vocabulary_) {
    pugi::xml_node vocabulary = root_.append_child("CONTROLLED_VOCABULARY");
    set(vocabulary, "CV_ID", tier.name);
    for (std::size_t w = 0; w < tier.vocabulary.size(); ++w) {
      pugi::xml_node entry = vocabulary.append_child("CV_ENTRY_ML");
      set(entry, "CVE_ID", "v" + std::to_string(w));
      pugi::xml_node value = entry.append_child("CVE_VALUE");
      set(value, "LANG_REF", language);
      value.text().set(tier.vocabulary[w].value.c_str());
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
  EafDocument document(facts);
  for (const Tier& tier : tiers) document.add(tier);
  return document.finish();
}

}  // namespace abrazo
