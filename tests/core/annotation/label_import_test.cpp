#include "core/annotation/label_import.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "core/base/atomic_file.hpp"
#include "tests/core/annotation/label_tiers.hpp"

namespace abrazo::label_import_test {
namespace {

using test::label_texts;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Way = TierTarget::Way;

class LabelImport : public testing::Test, protected test::LabelTiers {
 protected:
  const Tier moves{"move", {{1, 2, "spin"}, {2, 4, "one"}}, {}, TierKind::Move};
  const Tier figures{"figures", {{1, 2, "spin"}}, {}, TierKind::Move};
  const Tier notes{"seen", {{1, 2, "late"}}, {}, TierKind::Note};
};

TEST_F(LabelImport, ATierGoesIntoTheOneOfItsNameAndKind) {
  const TierPlan plan = plan_tiers({moves}, annotations);
  EXPECT_THAT(plan.targets, ElementsAre(TierTarget{Way::Into, move}));
  EXPECT_TRUE(plan.is_clear);
}

TEST_F(LabelImport, ElseIntoTheOnlyOneOfItsKind) {
  const TierPlan plan = plan_tiers({figures}, annotations);
  EXPECT_THAT(plan.targets, ElementsAre(TierTarget{Way::Into, move}));
  EXPECT_TRUE(plan.is_clear);
}

TEST_F(LabelImport, ElseIntoANewOneAndThatIsAGuess) {
  const Tier steps{"steps", {}, {}, TierKind::Move};
  const TierPlan two = plan_tiers({figures, steps}, annotations);
  EXPECT_THAT(two.targets, ElementsAre(TierTarget{Way::New}, TierTarget{Way::New}));
  EXPECT_FALSE(two.is_clear);
  EXPECT_FALSE(plan_tiers({notes}, annotations).is_clear) << "notes can be about anything";
}

TEST_F(LabelImport, LabelsTakeThePlaceOfThoseThereAndWordsAreAdded) {
  const auto next = with_imported({moves}, {{Way::Into, move}}, annotations, place.range);
  ASSERT_TRUE(next);
  EXPECT_THAT(label_texts(*next, move), ElementsAre("1-2 spin", "2-4 one"));
  ASSERT_TRUE(next->tier(move)->entry("spin"));
  EXPECT_EQ(next->tier(move)->entry("two")->key, '2') << "words that were there stay";
}

TEST_F(LabelImport, AKeyThatAnotherWordHasIsNotTakenOver) {
  Tier keyed = moves;
  keyed.vocabulary = {{"spin", "", {}, '1'}};
  const auto next = with_imported({keyed}, {{Way::Into, move}}, annotations, place.range);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->tier(move)->entry_of_key('1')->value, "one");
  EXPECT_EQ(next->tier(move)->entry("spin")->key, 0);
}

TEST_F(LabelImport, ANewTierHasAFreshNameAndOneThatIsLeftOutIsNotThere) {
  const auto next = with_imported({moves, notes}, {{Way::New}, {Way::LeaveOut}}, annotations, place.range);
  ASSERT_TRUE(next);
  ASSERT_TRUE(next->tier_named("move 2"));
  EXPECT_THAT(label_texts(*next, next->tier_named("move 2")->id), ElementsAre("1-2 spin", "2-4 one"));
  EXPECT_FALSE(next->tier_named("seen"));
}

TEST_F(LabelImport, LabelsBeyondTheSubjectAreRefusedWithTheTier) {
  const Tier late{"move", {{20, 21, "one"}}, {}, TierKind::Move};
  const auto next = with_imported({late}, {{Way::Into, move}}, annotations, place.range);
  ASSERT_FALSE(next);
  EXPECT_THAT(next.error().text(), HasSubstr("move"));
  EXPECT_THAT(next.error().text(), HasSubstr("within"));
}

TEST_F(LabelImport, AFileOfAnotherTakeIsReadAllTheSame) {
  const auto file = std::filesystem::path(testing::TempDir()) / "one_take_labels.csv";
  ASSERT_TRUE(write_whole_file(file, "take,start_frame,end_frame,label\nsalsa_01,0,30,turn\n"));
  const auto read = read_labels_for(file, 60, "salsa_02");
  std::filesystem::remove(file);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->take, "salsa_01");
  EXPECT_THAT(read->warnings, ElementsAre(HasSubstr("has labels of the take salsa_01, none of salsa_02")));
  EXPECT_DOUBLE_EQ(read->tiers.at(0).intervals.at(0).end_s, 0.5);
  EXPECT_FALSE(read_labels_for("not_there.csv", 60, "salsa_02"));
}

}  // namespace
}  // namespace abrazo::label_import_test
