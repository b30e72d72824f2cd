#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "core/annotation/label_edits.hpp"

namespace abrazo::test {

/// Annotations of ten seconds at 10 frames a second: a tier "move" with `one` at 1-2, `two` at 3-5 and `one`
/// at 6-7, whose keys are 1 and 2, an empty tier "role" with the keys a and b, and an empty tier "note".
/// Moves are active, nothing is selected, the cursor is at 4 s.
struct LabelTiers {
  LabelTiers() {
    move = *annotations.add_tier("move", TierKind::Move, {{"one", "", {}, '1'}, {"two", "", {}, '2'}});
    role = *annotations.add_tier("role", TierKind::Role, {{"a", "", {}, 'a'}, {"b", "", {}, 'b'}});
    note = *annotations.add_tier("note", TierKind::Note, {});
    place = {move, 0, Conflict::Replace, {0, 10}, 10, 4};
    first = draw(1, 2, "one");
    second = draw(3, 5, "two");
    third = draw(6, 7, "one");
  }

  int draw(double from_s, double to_s, const char* value) {
    const auto id = annotations.draw(move, from_s, to_s, value, Conflict::Refuse, place.range);
    return id ? *id : 0;
  }

  Annotations annotations;
  EditPlace place;
  int move = 0, role = 0, note = 0;      ///< tiers
  int first = 0, second = 0, third = 0;  ///< labels of "move"
};

/// "3-5 two" of every label of a tier.
inline std::vector<std::string> label_texts(const Annotations& annotations, int tier) {
  std::vector<std::string> texts;
  for (const Annotation& each : annotations.tier(tier)->annotations) {
    char span[80];
    std::snprintf(span, sizeof span, "%g-%g ", each.start_s, each.end_s);
    texts.push_back(span + each.value);
  }
  return texts;
}

/// The labels of a tier after an edit; its Error where it was not done.
inline std::vector<std::string> after(const Result<LabelEdit>& edit, int tier) {
  if (!edit) return {edit.error().text()};
  return label_texts(edit->next, tier);
}

}  // namespace abrazo::test
