#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <set>

#include "core/annotation/annotations.hpp"

namespace abrazo::annotation_property_test {
namespace {

constexpr Annotations::Range range{0, 20};

double a_time() {
  // Quarter seconds, so that edges meet often, and some beyond the range.
  return *rc::gen::inRange(-8, 92) / 4.0;
}

Conflict a_conflict() {
  return *rc::gen::element(Conflict::Replace, Conflict::Push, Conflict::Refuse);
}

int one_of(const Annotations& annotations, int tier) {
  const auto& all = annotations.tier(tier)->annotations;
  return all.empty() ? 0 : all[*rc::gen::inRange<std::size_t>(0, all.size())].id;
}

/// Ascending, not overlapping, within the range, every id once.
void hold_together(const Annotations& annotations) {
  std::set<int> ids;
  for (const AnnotationTier& tier : annotations.tiers()) {
    RC_ASSERT(ids.insert(tier.id).second);
    double free_from_s = range.first_s;
    for (const Annotation& one : tier.annotations) {
      RC_ASSERT(ids.insert(one.id).second);
      RC_ASSERT(one.start_s >= free_from_s - 1e-9);
      RC_ASSERT(one.end_s > one.start_s);
      free_from_s = one.end_s;
    }
    RC_ASSERT(free_from_s <= range.last_s + 1e-6);
  }
  for (const Suggestion& suggestion : annotations.suggestions()) RC_ASSERT(ids.insert(suggestion.id).second);
}

double annotated_s(const Annotations& annotations, int tier) {
  double sum_s = 0;
  for (const Annotation& one : annotations.tier(tier)->annotations) sum_s += one.duration_s();
  return sum_s;
}

/// A tier with what a few drawings left in it.
struct Drawn {
  Drawn() {
    tier = *annotations.add_tier("move", TierKind::Move, {});
    for (int i = *rc::gen::inRange(0, 12); i > 0; --i)
      (void)annotations.draw(tier, a_time(), a_time(), std::string(1, static_cast<char>('a' + i)),
                             a_conflict(), range);
  }
  Annotations annotations;
  int tier = 0;
};

/// One edit of any kind. @return whether it was done
bool edit(Annotations& annotations, int tier) {
  const int id = one_of(annotations, tier);
  switch (*rc::gen::inRange(0, 6)) {
    case 0:
      return annotations.draw(tier, a_time(), a_time(), "n", a_conflict(), range).ok();
    case 1:
      return annotations.place(id, a_time(), a_time(), a_conflict(), range).ok();
    case 2:
      return annotations.split(id, a_time()).ok();
    case 3:
      return annotations.merge_with_next(id).ok();
    case 4:
      return annotations.remove(id).ok();
    default: {
      const double start_s = a_time();
      annotations.suggest(std::vector<int>{tier}, {{0, tier, start_s, start_s + 1, "s", 0.5, ""}});
      return annotations.accept(annotations.suggestions().back().id, a_conflict(), range).ok();
    }
  }
}

TEST(AnnotationProperty, EveryEditLeavesTiersThatHoldTogether) {
  EXPECT_TRUE(rc::check("edits", [] {
    Drawn drawn;
    for (int i = 0; i < 8; ++i) {
      edit(drawn.annotations, drawn.tier);
      hold_together(drawn.annotations);
    }
  }));
}

TEST(AnnotationProperty, AnEditThatIsRefusedChangesNothing) {
  EXPECT_TRUE(rc::check("refused edits", [] {
    Drawn drawn;
    const Annotations before = drawn.annotations;
    const int id = one_of(before, drawn.tier);
    const double from_s = a_time(), to_s = a_time();
    const Conflict conflict = a_conflict();
    Annotations drawing = before, placing = before;
    if (!drawing.draw(drawn.tier, from_s, to_s, "n", conflict, range)) RC_ASSERT(drawing == before);
    if (!placing.place(id, from_s, to_s, conflict, range)) RC_ASSERT(placing == before);
  }));
}

TEST(AnnotationProperty, PushKeepsEveryLengthAndTheOrder) {
  EXPECT_TRUE(rc::check("push", [] {
    Drawn drawn;
    const Annotations before = drawn.annotations;
    const double from_s = a_time(), to_s = a_time();
    const auto id = drawn.annotations.draw(drawn.tier, from_s, to_s, "n", Conflict::Push, range);
    RC_PRE(id.ok());
    std::vector<int> order;
    for (const Annotation& one : drawn.annotations.tier(drawn.tier)->annotations)
      if (one.id != *id) {
        order.push_back(one.id);
        RC_ASSERT(std::abs(one.duration_s() - before.find(one.id)->duration_s()) < 1e-9);
      }
    std::vector<int> order_before;
    for (const Annotation& one : before.tier(drawn.tier)->annotations) order_before.push_back(one.id);
    RC_ASSERT(order == order_before);
  }));
}

TEST(AnnotationProperty, ReplaceChangesNothingOutsideTheNewInterval) {
  EXPECT_TRUE(rc::check("replace", [] {
    Drawn drawn;
    const Annotations before = drawn.annotations;
    const double from_s = a_time(), to_s = a_time();
    const auto id = drawn.annotations.draw(drawn.tier, from_s, to_s, "n", Conflict::Replace, range);
    RC_PRE(id.ok());
    const Annotation& placed = *drawn.annotations.find(*id);
    for (int eighth = 0; eighth < 160; ++eighth) {
      const double time_s = eighth / 8.0 + 0.01;
      const Annotation* now = drawn.annotations.tier(drawn.tier)->at(time_s);
      const Annotation* then = before.tier(drawn.tier)->at(time_s);
      if (time_s >= placed.start_s && time_s < placed.end_s)
        RC_ASSERT(now && now->id == *id);
      else
        RC_ASSERT((now ? now->value : "") == (then ? then->value : ""));
    }
  }));
}

TEST(AnnotationProperty, SplittingKeepsTheTimeThatIsAnnotated) {
  EXPECT_TRUE(rc::check("split", [] {
    Drawn drawn;
    const int id = one_of(drawn.annotations, drawn.tier);
    RC_PRE(id != 0);
    const double before_s = annotated_s(drawn.annotations, drawn.tier);
    const Annotations before = drawn.annotations;
    const Annotation& one = *before.find(id);
    const double at_s = one.start_s + one.duration_s() * *rc::gen::inRange(1, 8) / 8.0;
    RC_ASSERT(drawn.annotations.split(id, at_s).ok());
    RC_ASSERT(std::abs(annotated_s(drawn.annotations, drawn.tier) - before_s) < 1e-9);
    RC_ASSERT(drawn.annotations.merge_with_next(id).ok());
    RC_ASSERT(tiers_of(drawn.annotations) == tiers_of(before));
  }));
}

TEST(AnnotationProperty, AcceptedSuggestionsGoWithACopyFromBefore) {
  EXPECT_TRUE(rc::check("accept and undo", [] {
    Drawn drawn;
    const double start_s = a_time();
    drawn.annotations.suggest(std::vector<int>{drawn.tier},
                              {{0, drawn.tier, start_s, start_s + 2, "s", 0.5, ""}});
    const Annotations before = drawn.annotations;
    Annotations edited = before;
    RC_PRE(edited.accept(before.suggestions().front().id, a_conflict(), range).ok());
    RC_ASSERT(!(edited == before));
    edited = before;
    RC_ASSERT(edited.suggestions().size() == 1u);
    RC_ASSERT(tiers_of(edited) == tiers_of(before));
  }));
}

TEST(AnnotationProperty, TheExchangeFormComesBack) {
  EXPECT_TRUE(rc::check("tiers", [] {
    const Drawn drawn;
    const auto back = annotations_of(tiers_of(drawn.annotations));
    RC_ASSERT(back.ok());
    RC_ASSERT(tiers_of(*back) == tiers_of(drawn.annotations));
  }));
}

}  // namespace
}  // namespace abrazo::annotation_property_test
