#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/takes/tier.hpp"

namespace abrazo {

/// A parsed ELAN document, before times and references are resolved (EAF 3.0 schema, December 2016).
struct EafContents {
  struct TimeSlot {
    std::string id;
    std::optional<double> time_s;  ///< none = between its neighbours in the tier
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
    std::vector<Word> words;  ///< one per language
  };
  struct Vocabulary {
    bool is_elsewhere = false;  ///< defined in another file, which is not read
    std::vector<Entry> entries;
  };
  std::string format;
  std::vector<TimeSlot> slots;  ///< in order of time
  std::vector<TierElement> tiers;
  std::map<std::string, Type> types;
  std::map<std::string, Vocabulary> vocabularies;
  std::string tier_facts;  ///< of the property that write_eaf writes: see tier_facts_json
  int external_references = 0;
  int reference_links = 0;
  int media_with_offset = 0;
};

/// Names of write_eaf for the property and the types of its child tiers.
constexpr const char* eaf_facts_property = "abrazo.tiers";
constexpr const char* eaf_detail_type = "detail of annotation";
constexpr const char* eaf_confidence_type = "confidence of annotation";

/// Tiers with times: slots without a value are interpolated evenly between their neighbours in the tier;
/// symbolic children have the time of their parents. Child tiers of the two types above become detail and
/// confidence.
/// @param warnings counts of interpolated and omitted items
/// @return an Error naming tier and annotation for dangling or circular references, unknown times, and
/// reversed or overlapping intervals
Result<std::vector<Tier>> tiers_of(const EafContents& contents, std::string_view where,
                                   std::vector<std::string>& warnings);

}  // namespace abrazo
