#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/takes/eaf_contents.hpp"

namespace abrazo {

struct EafSpan {
  double start_s = 0, end_s = 0;
};

/// Times of the annotations of an ELAN document.
class EafTimes {
 public:
  Status resolve(const EafContents& contents, std::string_view where);
  /// Of an annotation of the document that was resolved.
  EafSpan of(std::string_view annotation) const { return spans_.at(annotation); }
  /// Number of slots with interpolated times.
  int interpolated() const { return interpolated_; }

 private:
  Status resolve_slots(const EafContents& contents);
  Status resolve_slots_of(const EafContents::TierElement& tier);
  Status resolve_references(const EafContents& contents);
  /// Annotations of one tier that refer to the same annotation.
  struct Family {
    const EafContents::TierElement* tier = nullptr;
    std::vector<const EafContents::Annotation*> siblings;
  };
  Status divide(const EafContents& contents, const Family& family, const EafSpan& whole);
  Error in_tier(const EafContents::TierElement& tier, std::string message) const;

  struct Slot {
    std::size_t place = 0;  ///< in the order of time
    double time_s = 0;
    bool known = false;
  };
  std::string where_;
  std::unordered_map<std::string_view, Slot> slots_;
  std::unordered_map<std::string_view, EafSpan> spans_;
  int interpolated_ = 0;
};

}  // namespace abrazo
