#include <algorithm>
#include <cstdint>
#include <limits>
#include <pugixml.hpp>

#include "core/base/text.hpp"
#include "core/library/takes/eaf_file.hpp"
#include "core/library/takes/refusal.hpp"

namespace abrazo {

namespace {

constexpr std::size_t most_tiers = 1000;

/// The whole text of an element: comments and CDATA sections cut it into pieces.
std::string text_of(pugi::xml_node element) {
  std::string text;
  for (const pugi::xml_node piece : element.children())
    if (piece.type() == pugi::node_pcdata || piece.type() == pugi::node_cdata) text += piece.value();
  return text;
}

class EafReader {
 public:
  EafReader(pugi::xml_node root, std::string_view where) : root_(root), where_(where) {}
  EafContents contents();

 private:
  [[noreturn]] void refuse(const std::string& message) const { throw Refusal{{message, where_}}; }
  std::string required(pugi::xml_node node, const char* name) const;
  double seconds_per_unit(pugi::xml_node header) const;
  void read_header(pugi::xml_node header);
  void read_slot(pugi::xml_node node);
  void read_tier(pugi::xml_node node);
  EafContents::Annotation annotation(pugi::xml_node node);
  void read_vocabulary(pugi::xml_node node);

  pugi::xml_node root_;
  std::string where_;
  EafContents contents_;
  double seconds_per_unit_ = 1e-3;
};

std::string EafReader::required(pugi::xml_node node, const char* name) const {
  const pugi::xml_attribute attribute = node.attribute(name);
  if (!attribute || *attribute.value() == 0)
    refuse(std::string("a ") + node.name() + " has no " + name + "; add it");
  return attribute.value();
}

double EafReader::seconds_per_unit(pugi::xml_node header) const {
  const std::string units = header.attribute("TIME_UNITS").as_string("milliseconds");
  if (units == "milliseconds") return 1e-3;
  if (units == "PAL-frames") return 1 / 25.0;
  if (units == "NTSC-frames") return 1001 / 30000.0;
  refuse("has times in " + in_quotes(units) + "; known are milliseconds, PAL-frames and NTSC-frames");
}

void EafReader::read_header(pugi::xml_node header) {
  seconds_per_unit_ = seconds_per_unit(header);
  for (const pugi::xml_node media : header.children("MEDIA_DESCRIPTOR"))
    if (media.attribute("TIME_ORIGIN").as_llong() != 0) ++contents_.media_with_offset;
  for (const pugi::xml_node property : header.children("PROPERTY"))
    if (std::string_view(property.attribute("NAME").value()) == eaf_facts_property)
      contents_.tier_facts = text_of(property);
}

void EafReader::read_slot(pugi::xml_node node) {
  EafContents::TimeSlot slot{required(node, "TIME_SLOT_ID"), {}};
  if (const pugi::xml_attribute value = node.attribute("TIME_VALUE")) {
    const auto time = parse_integer(value.value());
    if (!time || *time < 0 || *time > std::numeric_limits<std::uint32_t>::max())
      refuse("time slot " + in_quotes(slot.id) + " is at " + in_quotes(value.value()) +
             "; expected a whole number from 0 to 4294967295");
    slot.time_s = static_cast<double>(*time) * seconds_per_unit_;
    // A whole number of milliseconds is its nearest double, not a product's.
    if (seconds_per_unit_ == 1e-3) slot.time_s = static_cast<double>(*time) / 1000;
  }
  contents_.slots.push_back(std::move(slot));
}

EafContents::Annotation EafReader::annotation(pugi::xml_node node) {
  EafContents::Annotation one;
  one.id = required(node, "ANNOTATION_ID");
  one.value = text_of(node.child("ANNOTATION_VALUE"));
  one.entry = node.attribute("CVE_REF").value();
  one.alignable = std::string_view(node.name()) == "ALIGNABLE_ANNOTATION";
  if (one.alignable) {
    one.first = required(node, "TIME_SLOT_REF1");
    one.last = required(node, "TIME_SLOT_REF2");
  } else {
    one.parent = required(node, "ANNOTATION_REF");
    one.previous = node.attribute("PREVIOUS_ANNOTATION").value();
  }
  if (node.attribute("EXT_REF")) ++contents_.external_references;
  return one;
}

void EafReader::read_tier(pugi::xml_node node) {
  EafContents::TierElement tier;
  tier.id = required(node, "TIER_ID");
  tier.type = node.attribute("LINGUISTIC_TYPE_REF").value();
  tier.parent = node.attribute("PARENT_REF").value();
  tier.language = node.attribute("LANG_REF").value();
  for (const pugi::xml_node holder : node.children("ANNOTATION"))
    for (const pugi::xml_node child : holder.children())
      if (child.type() == pugi::node_element) tier.annotations.push_back(annotation(child));
  contents_.tiers.push_back(std::move(tier));
}

/// Entries of formats before 2.8 have one word without a language.
void EafReader::read_vocabulary(pugi::xml_node node) {
  EafContents::Vocabulary vocabulary;
  vocabulary.is_elsewhere = node.attribute("EXT_REF");
  for (const pugi::xml_node entry : node.children("CV_ENTRY"))
    vocabulary.entries.push_back(
        {entry.attribute("CVE_ID").value(), {{"", text_of(entry), entry.attribute("DESCRIPTION").value()}}});
  for (const pugi::xml_node entry : node.children("CV_ENTRY_ML")) {
    EafContents::Entry words{entry.attribute("CVE_ID").value(), {}};
    for (const pugi::xml_node word : entry.children("CVE_VALUE"))
      words.words.push_back(
          {word.attribute("LANG_REF").value(), text_of(word), word.attribute("DESCRIPTION").value()});
    vocabulary.entries.push_back(std::move(words));
  }
  contents_.vocabularies[required(node, "CV_ID")] = std::move(vocabulary);
}

EafContents EafReader::contents() {
  contents_.format = root_.attribute("FORMAT").as_string("3.0");
  read_header(root_.child("HEADER"));
  for (const pugi::xml_node slot : root_.child("TIME_ORDER").children("TIME_SLOT")) read_slot(slot);
  for (const pugi::xml_node tier : root_.children("TIER")) {
    if (contents_.tiers.size() == most_tiers) refuse("has more than 1000 tiers; leave some out");
    read_tier(tier);
  }
  for (const pugi::xml_node type : root_.children("LINGUISTIC_TYPE"))
    contents_.types[required(type, "LINGUISTIC_TYPE_ID")] = {
        type.attribute("CONSTRAINTS").value(), type.attribute("CONTROLLED_VOCABULARY_REF").value()};
  for (const pugi::xml_node vocabulary : root_.children("CONTROLLED_VOCABULARY")) read_vocabulary(vocabulary);
  for (const pugi::xml_node set : root_.children("REF_LINK_SET"))
    contents_.reference_links += static_cast<int>(std::distance(set.begin(), set.end()));
  return std::move(contents_);
}

std::string place_of_byte(std::string_view where, std::string_view text, std::ptrdiff_t byte) {
  const auto end = text.begin() + std::min(byte, static_cast<std::ptrdiff_t>(text.size()));
  return std::string(where) + ":" + std::to_string(1 + std::count(text.begin(), end, '\n'));
}

}  // namespace

Result<EafContents> parse_eaf(std::string_view text, std::string_view where) {
  pugi::xml_document document;
  const auto outcome = document.load_buffer(
      text.data(), text.size(), pugi::parse_default | pugi::parse_doctype | pugi::parse_ws_pcdata_single);
  if (!outcome)
    return Error{
        std::string("is not XML from here on (") + outcome.description() + "); save it again in ELAN",
        place_of_byte(where, text, outcome.offset)};
  for (const pugi::xml_node child : document.children())
    if (child.type() == pugi::node_doctype)
      return Error{"has a DOCTYPE, whose entities are not expanded; remove it", std::string(where)};
  const pugi::xml_node root = document.document_element();
  if (std::string_view(root.name()) != "ANNOTATION_DOCUMENT")
    return Error{"is XML, but begins with " + in_quotes(root.name()) +
                     "; an ELAN file begins with ANNOTATION_DOCUMENT",
                 std::string(where)};
  try {
    return EafReader(root, where).contents();
  } catch (const Refusal& refusal) {
    return refusal.error;
  }
}

}  // namespace abrazo
