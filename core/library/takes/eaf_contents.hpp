#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/takes/tier.hpp"

namespace abrazo {

/// An ELAN document as it stands, before times and references are followed (EAF 3.0 schema, December 2016).
struct EafContents {
  struct TimeSlot {
    std::string id;
    std::optional<double> time_s;  ///< nothing = between its neighbours in the tier
  };
  struct Annotation {
    std::string id, value;
    std::string entry;        ///< CVE_REF
    bool alignable = true;    ///< has time slots; otherwise it refers to another annotation
    std::string first, last;  ///< time slots
    std::string parent, previous;
  };
  struct TierElement {
    std::string id, type, parent;
    std::string language;  ///< LANG_REF
    std::vector<Annotation> annotations;
  };
  struct Type {
    std::string constraint;  ///< stereotype; empty = none
    std::string vocabulary;
  };
  struct Word {
    std::string language, value, description;
  };
  struct Entry {
    std::string id;
    std::vector<Word> words;  ///< one of each language
  };
  struct Vocabulary {
    bool is_elsewhere = false;  ///< in another file, which is not read
    std::vector<Entry> entries;
  };
  std::string format;
  std::vector<TimeSlot> slots;  ///< in order of time
  std::vector<TierElement> tiers;
  std::map<std::string, Type> types;
  std::map<std::string, Vocabulary> vocabularies;
  std::string tier_facts;  ///< of the property that write_eaf leaves: see tier_facts_json
  int external_references = 0;
  int reference_links = 0;
  int media_with_offset = 0;
};

/// What write_eaf calls the property and the types of its child tiers.
constexpr const char* eaf_facts_property = "abrazo.tiers";
constexpr const char* eaf_detail_type = "detail of annotation";
constexpr const char* eaf_confidence_type = "confidence of annotation";

/// Tiers with times: slots without a value lie evenly between their neighbours of the tier, symbolic children
/// share the time of their parents. Child tiers of the two types above become detail and confidence.
/// @param warnings  what was interpolated and left out, with how often
/// @return an Error that names tier and annotation for references that lead nowhere or in a circle, times
/// that cannot be known, intervals that run backwards or overlap
Result<std::vector<Tier>> tiers_of(const EafContents& contents, std::string_view where,
                                   std::vector<std::string>& warnings);

}  // namespace abrazo
