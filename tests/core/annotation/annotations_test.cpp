#include "core/annotation/annotations.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace abrazo::annotations_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr Annotations::Range ten_seconds{0, 10};

/// "0-1 a" of every annotation of the tier.
std::vector<std::string> texts(const Annotations& annotations, int tier) {
  std::vector<std::string> found;
  for (const Annotation& one : annotations.tier(tier)->annotations) {
    char text[80];
    std::snprintf(text, sizeof text, "%g-%g ", one.start_s, one.end_s);
    found.push_back(text + one.value);
  }
  return found;
}

/// A tier "move" with a at 1-2, b at 3-5, c at 6-7, and the way to them.
struct Moves {
  Moves() {
    tier = *annotations.add_tier("move", TierKind::Move, {});
    a = draw(1, 2, "a");
    b = draw(3, 5, "b");
    c = draw(6, 7, "c");
  }
  int draw(double from_s, double to_s, const char* value) {
    const auto id = annotations.draw(tier, from_s, to_s, value, Conflict::Refuse, ten_seconds);
    if (!id) ADD_FAILURE() << id.error().text();
    return id ? *id : 0;
  }
  std::vector<std::string> now() const { return texts(annotations, tier); }

  Annotations annotations;
  int tier = 0, a = 0, b = 0, c = 0;
};

template <typename T>
std::string refusal(const Result<T>& result) {
  return result ? "done" : result.error().text();
}

TEST(Annotations, AreInOrderOfTimeHoweverTheyWereDrawn) {
  Moves moves;
  moves.draw(2.5, 3, "d");
  EXPECT_THAT(moves.now(), ElementsAre("1-2 a", "2.5-3 d", "3-5 b", "6-7 c"));
}

TEST(Annotations, DrawnFromRightToLeftAreTheSame) {
  Moves moves;
  moves.draw(9, 8, "d");
  EXPECT_THAT(moves.now(), ElementsAre("1-2 a", "3-5 b", "6-7 c", "8-9 d"));
}

TEST(Annotations, AreHeldAtTheEndsOfTheRange) {
  Moves moves;
  ASSERT_TRUE(moves.annotations.draw(moves.tier, 9, 14, "d", Conflict::Refuse, ten_seconds));
  EXPECT_EQ(moves.now().back(), "9-10 d");
  EXPECT_THAT(refusal(moves.annotations.draw(moves.tier, 11, 14, "e", Conflict::Replace, ten_seconds)),
              HasSubstr("nothing of 11.000-14.000 s is within 0.000-10.000 s"));
  EXPECT_THAT(
      refusal(moves.annotations.draw(moves.tier, std::nan(""), 1, "e", Conflict::Replace, ten_seconds)),
      HasSubstr("finite"));
}

TEST(Annotations, ReplaceCutsWhatReachesInAndRemovesWhatIsCovered) {
  Moves moves;
  ASSERT_TRUE(moves.annotations.draw(moves.tier, 1.5, 6.5, "d", Conflict::Replace, ten_seconds));
  EXPECT_THAT(moves.now(), ElementsAre("1-1.5 a", "1.5-6.5 d", "6.5-7 c"));
  EXPECT_EQ(moves.annotations.find(moves.b), nullptr);
}

TEST(Annotations, ReplaceWithinALongOneLeavesBothItsParts) {
  Moves moves;
  ASSERT_TRUE(moves.annotations.say(moves.b, {.value = "b", .detail = "detail", .confidence = "low"}));
  ASSERT_TRUE(moves.annotations.draw(moves.tier, 3.5, 4, "d", Conflict::Replace, ten_seconds));
  EXPECT_THAT(moves.now(), ElementsAre("1-2 a", "3-3.5 b", "3.5-4 d", "4-5 b", "6-7 c"));
  const Annotation& later = moves.annotations.tier(moves.tier)->annotations[3];
  EXPECT_NE(later.id, moves.b);
  EXPECT_EQ(later.detail, "detail");
  EXPECT_EQ(later.confidence, "low");
}

TEST(Annotations, PushMovesNeighboursOnWithTheirLengths) {
  Moves moves;
  ASSERT_TRUE(moves.annotations.draw(moves.tier, 2.5, 4, "d", Conflict::Push, ten_seconds));
  EXPECT_THAT(moves.now(), ElementsAre("1-2 a", "2.5-4 d", "4-6 b", "6-7 c"));
}

TEST(Annotations, PushGoesOnThroughAllThatAreHit) {
  Moves moves;
  ASSERT_TRUE(moves.annotations.draw(moves.tier, 1.5, 4, "d", Conflict::Push, ten_seconds));
  // b's middle, 4 s, is later than d's, 2.75 s; a's is earlier.
  EXPECT_THAT(moves.now(), ElementsAre("0.5-1.5 a", "1.5-4 d", "4-6 b", "6-7 c"));
  ASSERT_TRUE(moves.annotations.place(moves.b, 4, 8, Conflict::Push, ten_seconds));
  EXPECT_THAT(moves.now(), ElementsAre("0.5-1.5 a", "1.5-4 d", "4-8 b", "8-9 c"));
}

TEST(Annotations, PushWithoutRoomIsRefusedAndChangesNothing) {
  Moves moves;
  const Annotations before = moves.annotations;
  EXPECT_THAT(
      refusal(moves.annotations.place(moves.b, 3, 9.5, Conflict::Push, ten_seconds)),
      HasSubstr("move: no room to push on: 'c' (9.500-10.500 s) would end up 0.500 s beyond the end"));
  EXPECT_THAT(refusal(moves.annotations.draw(moves.tier, 0.5, 3, "d", Conflict::Push, ten_seconds)),
              HasSubstr("beyond the start"));
  EXPECT_EQ(moves.annotations, before);
}

TEST(Annotations, ALongerOnePushesItsNeighboursToTheSideWhereTheyAre) {
  Moves moves;
  // Far over c, whose middle would be in the earlier half by then.
  ASSERT_TRUE(moves.annotations.place(moves.b, 3, 9, Conflict::Push, ten_seconds));
  EXPECT_THAT(moves.now(), ElementsAre("1-2 a", "3-9 b", "9-10 c"));
}

TEST(Annotations, RefuseNamesWhatIsInTheWay) {
  Moves moves;
  const Annotations before = moves.annotations;
  EXPECT_THAT(refusal(moves.annotations.draw(moves.tier, 1.5, 4, "d", Conflict::Refuse, ten_seconds)),
              HasSubstr("move: 'a' (1.000-2.000 s), 'b' (3.000-5.000 s) are in the way"));
  EXPECT_THAT(refusal(moves.annotations.place(moves.a, 1, 3.5, Conflict::Refuse, ten_seconds)),
              HasSubstr("'b' (3.000-5.000 s) is in the way"));
  EXPECT_EQ(moves.annotations, before);
}

TEST(Annotations, AnEdgeThatMeetsANeighbourButForRoundingIsInNobodysWay) {
  Moves moves;
  moves.draw(2 - 1e-9, 3 + 1e-9, "d");
  EXPECT_EQ(moves.annotations.tier(moves.tier)->annotations[1].start_s, 2);
  EXPECT_EQ(moves.annotations.tier(moves.tier)->annotations[1].end_s, 3);
}

TEST(Annotations, OneThatIsMovedKeepsItsLengthAtTheEnds) {
  Moves moves;
  ASSERT_TRUE(moves.annotations.place(moves.c, 9.5, 10.5, Conflict::Refuse, ten_seconds));
  EXPECT_THAT(moves.now(), ElementsAre("1-2 a", "3-5 b", "9-10 c"));
  ASSERT_TRUE(moves.annotations.place(moves.c, -3, -2, Conflict::Refuse, ten_seconds));
  EXPECT_THAT(moves.now(), ElementsAre("0-1 c", "1-2 a", "3-5 b"));
}

TEST(Annotations, OneThatIsResizedIsCutAtTheEnds) {
  Moves moves;
  ASSERT_TRUE(moves.annotations.place(moves.c, 6, 14, Conflict::Refuse, ten_seconds));
  EXPECT_EQ(moves.now().back(), "6-10 c");
}

TEST(Annotations, SplitPartsSayTheSame) {
  Moves moves;
  ASSERT_TRUE(moves.annotations.say(moves.b, {.value = "b", .detail = "detail", .confidence = "high"}));
  const auto later = moves.annotations.split(moves.b, 4);
  ASSERT_TRUE(later);
  EXPECT_THAT(moves.now(), ElementsAre("1-2 a", "3-4 b", "4-5 b", "6-7 c"));
  EXPECT_EQ(moves.annotations.find(*later)->detail, "detail");
  EXPECT_THAT(refusal(moves.annotations.split(moves.b, 4)), HasSubstr("4.000 s is not within 'b'"));
  EXPECT_THAT(refusal(moves.annotations.split(moves.b, std::nan(""))), HasSubstr("is not within"));
}

TEST(Annotations, MergedOnesFillWhatWasBetweenThem) {
  Moves moves;
  ASSERT_TRUE(moves.annotations.merge_with_next(moves.a));
  EXPECT_THAT(moves.now(), ElementsAre("1-5 a", "6-7 c"));
  EXPECT_THAT(refusal(moves.annotations.merge_with_next(moves.c)), HasSubstr("is the last of its tier"));
}

TEST(Annotations, ACopyStandsInTheOtherTierAndSaysTheSame) {
  Moves moves;
  const int other = *moves.annotations.add_tier("move of b", TierKind::Move, {});
  ASSERT_TRUE(moves.annotations.say(moves.b, {.value = "b", .detail = "detail", .confidence = "high"}));
  const auto copy = moves.annotations.copy_to(moves.b, other, Conflict::Refuse);
  ASSERT_TRUE(copy);
  EXPECT_THAT(texts(moves.annotations, other), ElementsAre("3-5 b"));
  EXPECT_EQ(moves.annotations.find(*copy)->confidence, "high");
  EXPECT_THAT(refusal(moves.annotations.copy_to(moves.b, moves.tier, Conflict::Replace)),
              HasSubstr("in this tier already"));
  EXPECT_THAT(refusal(moves.annotations.copy_to(moves.b, other, Conflict::Refuse)), HasSubstr("in the way"));
}

TEST(Annotations, HoldTheirStartButNotTheirEnd) {
  const Moves moves;
  const AnnotationTier& tier = *moves.annotations.tier(moves.tier);
  EXPECT_EQ(tier.at(0.5), nullptr);
  EXPECT_EQ(tier.at(1)->value, "a");
  EXPECT_EQ(tier.at(2), nullptr);
  EXPECT_EQ(tier.at(4.9)->value, "b");
  EXPECT_EQ(tier.at(8), nullptr);
}

TEST(Annotations, WhatIsGoneIsNamedInTheRefusal) {
  Moves moves;
  ASSERT_TRUE(moves.annotations.remove(moves.a));
  for (const std::string& text :
       {refusal(moves.annotations.remove(moves.a)), refusal(moves.annotations.split(moves.a, 1.5)),
        refusal(moves.annotations.merge_with_next(moves.a)),
        refusal(moves.annotations.say(moves.a, {.value = ""})),
        refusal(moves.annotations.place(moves.a, 1, 2, Conflict::Push, ten_seconds)),
        refusal(moves.annotations.copy_to(moves.a, moves.tier, Conflict::Push))})
    EXPECT_THAT(text, HasSubstr("there is no annotation " + std::to_string(moves.a)));
  EXPECT_THAT(refusal(moves.annotations.draw(99, 1, 2, "", Conflict::Push, ten_seconds)),
              HasSubstr("there is no tier 99"));
}

TEST(AnnotationTiers, HaveUniqueNames) {
  Annotations annotations;
  const int role = *annotations.add_tier(" role ", TierKind::Role, {});
  const int move = *annotations.add_tier("move", TierKind::Move, {});
  EXPECT_EQ(annotations.tier(role)->name, "role");
  EXPECT_THAT(refusal(annotations.add_tier("role", TierKind::Note, {})), HasSubstr("role: there is a tier"));
  EXPECT_THAT(refusal(annotations.add_tier("  ", TierKind::Note, {})), HasSubstr("needs a name"));
  EXPECT_THAT(refusal(annotations.rename_tier(move, "role")), HasSubstr("give another"));
  EXPECT_TRUE(annotations.rename_tier(move, "move"));
  EXPECT_TRUE(annotations.rename_tier(move, "moves"));
  EXPECT_EQ(annotations.tier_named("moves")->id, move);
  EXPECT_EQ(annotations.first_of(TierKind::Role)->id, role);
  EXPECT_EQ(annotations.first_of(TierKind::Note), nullptr);
}

TEST(AnnotationTiers, ChangePlaces) {
  Annotations annotations;
  const int a = *annotations.add_tier("a", TierKind::Note, {}),
            b = *annotations.add_tier("b", TierKind::Note, {}),
            c = *annotations.add_tier("c", TierKind::Note, {});
  const auto order = [&] {
    std::vector<int> ids;
    for (const AnnotationTier& tier : annotations.tiers()) ids.push_back(tier.id);
    return ids;
  };
  ASSERT_TRUE(annotations.move_tier(a, 2));
  EXPECT_THAT(order(), ElementsAre(b, c, a));
  ASSERT_TRUE(annotations.move_tier(a, 0));
  EXPECT_THAT(order(), ElementsAre(a, b, c));
  EXPECT_THAT(refusal(annotations.move_tier(a, 3)), HasSubstr("places 0 to 2"));
}

TEST(AnnotationTiers, AVocabularySaysEachThingOnceByOneKey) {
  Annotations annotations;
  const int tier = *annotations.add_tier("move", TierKind::Move, {{"basic", "", 0x112233, '1'}});
  EXPECT_EQ(annotations.tier(tier)->entry("basic")->rgb, 0x112233u);
  EXPECT_EQ(annotations.tier(tier)->entry_of_key('1')->value, "basic");
  EXPECT_EQ(annotations.tier(tier)->entry_of_key(0), nullptr);
  EXPECT_THAT(refusal(annotations.set_vocabulary(tier, {{"a"}, {"a"}})), HasSubstr("'a' is already a value"));
  EXPECT_THAT(refusal(annotations.set_vocabulary(tier, {{" "}})), HasSubstr("is empty"));
  EXPECT_THAT(refusal(annotations.set_vocabulary(tier, {{"a", "", {}, '1'}, {"b", "", {}, '1'}})),
              HasSubstr("the key 1 is already that of 'a'"));
  EXPECT_TRUE(annotations.tier(tier)->entry("basic"));
}

TEST(AnnotationTiers, GoWithTheirSuggestions) {
  Moves moves;
  moves.annotations.suggest(std::vector<int>{moves.tier}, {{0, moves.tier, 8, 9, "d", 0.5, ""}});
  ASSERT_TRUE(moves.annotations.remove_tier(moves.tier));
  EXPECT_TRUE(moves.annotations.empty());
  EXPECT_THAT(moves.annotations.suggestions(), IsEmpty());
}

TEST(Suggestions, StandBesideTheAnnotationsUntilAccepted) {
  Moves moves;
  const Annotations without = moves.annotations;
  moves.annotations.suggest(std::vector<int>{moves.tier}, {{0, moves.tier, 8, 9, "d", 0.5, "why"},
                                                           {0, moves.tier, 4, 5.5, "e", 0.7, "why"}});
  EXPECT_EQ(moves.annotations.tiers(), without.tiers());
  EXPECT_EQ(tiers_of(moves.annotations), tiers_of(without));
  const int e = moves.annotations.suggestions().front().id, d = moves.annotations.suggestions().back().id;
  EXPECT_EQ(moves.annotations.find_suggestion(e)->value, "e");
  const auto accepted = moves.annotations.accept(d, Conflict::Refuse, ten_seconds);
  ASSERT_TRUE(accepted);
  EXPECT_EQ(moves.annotations.find(*accepted)->value, "d");
  EXPECT_EQ(moves.annotations.find_suggestion(d), nullptr);
  ASSERT_TRUE(moves.annotations.reject(e));
  EXPECT_THAT(moves.annotations.suggestions(), IsEmpty());
  EXPECT_THAT(moves.now(), ElementsAre("1-2 a", "3-5 b", "6-7 c", "8-9 d"));
}

TEST(Suggestions, OneThatCannotBeAcceptedStays) {
  Moves moves;
  moves.annotations.suggest(std::vector<int>{moves.tier}, {{0, moves.tier, 4, 5.5, "e", 0.7, "why"}});
  const Annotations before = moves.annotations;
  const int e = before.suggestions().front().id;
  EXPECT_THAT(refusal(moves.annotations.accept(e, Conflict::Refuse, ten_seconds)), HasSubstr("in the way"));
  EXPECT_EQ(moves.annotations, before);
}

TEST(Suggestions, NewOnesTakeThePlaceOfThoseOfTheirTiers) {
  Moves moves;
  const int other = *moves.annotations.add_tier("role", TierKind::Role, {});
  moves.annotations.suggest(std::vector<int>{moves.tier, other},
                            {{0, moves.tier, 8, 9, "old", 0.5, ""}, {0, other, 0, 9, "a", 0.5, ""}});
  moves.annotations.suggest(std::vector<int>{moves.tier}, {{0, moves.tier, 7, 9, "new", 0.5, ""}});
  ASSERT_EQ(moves.annotations.suggestions().size(), 2u);
  EXPECT_EQ(moves.annotations.suggestions()[0].value, "a");
  EXPECT_EQ(moves.annotations.suggestions()[1].value, "new");
  EXPECT_THROW(moves.annotations.suggest(std::vector<int>{moves.tier}, {{0, 99, 7, 9, "new", 0.5, ""}}),
               std::invalid_argument);
  EXPECT_THROW(moves.annotations.suggest(std::vector<int>{other}, {{0, other, 9, 9, "a", 0.5, ""}}),
               std::invalid_argument);
}

TEST(AnnotationExchange, TiersComeBackAsTheyWere) {
  const std::vector<Tier> tiers = {{"role", {{0, 1.5, "a"}, {1.5, 4, "b"}}, {{"a"}, {"b"}}, TierKind::Role},
                                   {"move",
                                    {{0.1, 1.0 / 3, "basic", "detail", "low"}},
                                    {{"basic", "the basic", 0x336699, 'b'}},
                                    TierKind::Move},
                                   {"note", {}, {}, TierKind::Note}};
  const auto annotations = annotations_of(tiers);
  ASSERT_TRUE(annotations) << annotations.error().text();
  EXPECT_EQ(tiers_of(*annotations), tiers);
}

TEST(AnnotationExchange, TakesIntervalsInAnyOrderAndAsManyAsAFileHas) {
  std::vector<Tier> tiers = {{"move", {}, {}, TierKind::Move}};
  for (int i = 0; i < 60'000; ++i) tiers[0].intervals.push_back({0.5 * i, 0.5 * i + 0.5, "x", "y", "low"});
  const std::vector<Tier> ascending = tiers;
  std::reverse(tiers[0].intervals.begin(), tiers[0].intervals.end());
  const auto annotations = annotations_of(tiers);
  ASSERT_TRUE(annotations) << annotations.error().text();
  EXPECT_EQ(tiers_of(*annotations), ascending);
  EXPECT_EQ(annotations->next_id(), 60'002);
}

TEST(AnnotationExchange, EdgesThatDifferByRoundingMeet) {
  const auto annotations = annotations_of(std::vector<Tier>{{"m", {{0, 1 + 1e-9, "x"}, {1, 2, "y"}}}});
  ASSERT_TRUE(annotations) << annotations.error().text();
  const auto& both = annotations->tiers()[0].annotations;
  EXPECT_EQ(both[0].end_s, both[1].start_s);
}

TEST(AnnotationExchange, TiersThatDoNotHoldTogetherAreRefused) {
  const auto overlapping = annotations_of(std::vector<Tier>{{"m", {{0, 2, "x"}, {1, 3, "y"}}}});
  EXPECT_THAT(refusal(overlapping), HasSubstr("m: 'y' at 1.000-3.000 s: 'x' (0.000-2.000 s) is in the way"));
  EXPECT_THAT(refusal(annotations_of(std::vector<Tier>{{"m", {{2, 2, "x"}}}})), HasSubstr("'x' at 2.000"));
  EXPECT_THAT(refusal(annotations_of(std::vector<Tier>{{"m", {}}, {"m", {}}})), HasSubstr("of this name"));
}

}  // namespace
}  // namespace abrazo::annotations_test
