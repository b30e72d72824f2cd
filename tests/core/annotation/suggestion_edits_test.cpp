#include "core/annotation/suggestion_edits.hpp"

#include <gmock/gmock.h>

#include "tests/core/annotation/label_tiers.hpp"

namespace abrazo::suggestion_edits_test {
namespace {

using test::after;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Suggestion proposal(double from_s, double to_s, const char* value) {
  Suggestion one;
  one.start_s = from_s;
  one.end_s = to_s;
  one.value = value;
  one.confidence = 0.8;
  return one;
}

class SuggestionEdits : public testing::Test, protected test::LabelTiers {
 protected:
  /// Suggestions of moves, in place of `annotations`. @return their ids
  std::vector<int> suggest(std::vector<Suggestion> moves) {
    const auto edit = with_suggestions(annotations, {std::move(moves), {}}, {"take", true, false});
    EXPECT_TRUE(edit);
    annotations = edit->next;
    std::vector<int> ids;
    for (const Suggestion& each : annotations.suggestions()) ids.push_back(each.id);
    return ids;
  }
};

TEST_F(SuggestionEdits, GoToTheTierOfTheirKind) {
  const SuggestedTiers suggested{{proposal(8, 9, "two")}, {proposal(0, 10, "b")}};
  const auto edit = with_suggestions(annotations, suggested, {"take", true, true});
  ASSERT_TRUE(edit);
  ASSERT_EQ(edit->next.suggestions().size(), 2u);
  EXPECT_EQ(edit->next.suggestions()[0].tier, role);
  EXPECT_EQ(edit->next.suggestions()[1].tier, move);
  EXPECT_EQ(edit->what, "suggest labels");
}

TEST_F(SuggestionEdits, MakeATierWhereThereIsNone) {
  const auto edit = with_suggestions({}, {{}, {proposal(0, 10, "b")}}, {"take", false, true});
  ASSERT_TRUE(edit);
  ASSERT_EQ(edit->next.tiers().size(), 1u) << "none of moves, which were not asked for";
  EXPECT_EQ(edit->next.tiers()[0].name, "role");
}

TEST_F(SuggestionEdits, SayWhyThereAreNone) {
  EXPECT_THAT(with_suggestions(annotations, {}, {"take", true, false}).error().text(),
              HasSubstr("no labels to learn from"));
  EXPECT_THAT(with_suggestions(annotations, {}, {"take", false, true}).error().text(),
              HasSubstr("do not say who is active"));
}

TEST_F(SuggestionEdits, AnAcceptedOneIsALabelAsItIsOrWithAnotherValue) {
  const int id = suggest({proposal(8, 9, "two")}).front();
  const auto accepted = accept_suggestion(annotations, place, id);
  EXPECT_THAT(after(accepted, move), ElementsAre("1-2 one", "3-5 two", "6-7 one", "8-9 two"));
  EXPECT_TRUE(accepted->next.suggestions().empty());
  EXPECT_THAT(after(accept_suggestion_as(annotations, place, id, "one"), move),
              ElementsAre("1-2 one", "3-5 two", "6-7 one", "8-9 one"));
  EXPECT_FALSE(accept_suggestion(annotations, place, 99));
}

TEST_F(SuggestionEdits, ARejectedOneIsGone) {
  const auto ids = suggest({proposal(8, 9, "two"), proposal(9, 10, "one")});
  const auto rejected = reject_suggestion(annotations, ids.front());
  ASSERT_TRUE(rejected);
  EXPECT_EQ(rejected->next.suggestions().size(), 1u);
  EXPECT_FALSE(reject_suggestion(rejected->next, ids.front()));
  EXPECT_TRUE(clear_suggestions(annotations).next.suggestions().empty());
}

TEST_F(SuggestionEdits, OfManyThoseAreAcceptedThatCanBe) {
  const auto ids = suggest({proposal(2, 4, "one"), proposal(8, 9, "two")});
  place.conflict = Conflict::Refuse;
  const AcceptedSuggestions accepted = accept_suggestions(annotations, place, ids);
  EXPECT_THAT(test::label_texts(accepted.edit.next, move),
              ElementsAre("1-2 one", "3-5 two", "6-7 one", "8-9 two"));
  EXPECT_EQ(accepted.refused, 1u);
  EXPECT_THAT(accepted.why, HasSubstr("two"));
  EXPECT_EQ(accepted.edit.what, "accept 1 suggestions");
}

}  // namespace
}  // namespace abrazo::suggestion_edits_test
