#include <cstdio>

#include "core/annotation/label_keys.hpp"

#include <gmock/gmock.h>

#include "tests/core/annotation/label_tiers.hpp"

namespace abrazo::label_keys_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

LabelKeys::Moment at(double cursor_s) {
  LabelKeys::Moment now;
  now.cursor_s = cursor_s;
  return now;
}

/// "3-5 two"
std::vector<std::string> texts(const std::vector<LabelKeys::Said>& said) {
  std::vector<std::string> found;
  for (const LabelKeys::Said& each : said) {
    char span[80];
    std::snprintf(span, sizeof span, "%g-%g ", each.span.first_s, each.span.last_s);
    found.push_back(span + each.value);
  }
  return found;
}

class LabelKeysTest : public testing::Test, protected test::LabelTiers {
 protected:
  std::vector<std::string> press(char key, double at_s) {
    if (!keys.hold(key)) return {};
    return texts(keys.press(key, *tier_of_key(annotations, move, key), at(at_s)));
  }
  std::vector<std::string> release(char key, double at_s) {
    keys.let_go(key, at(at_s));
    return texts(keys.settle());
  }
  std::vector<std::string> follow(const LabelKeys::Moment& now) { return texts(keys.follow(now)); }

  LabelKeys keys;
};

TEST_F(LabelKeysTest, AKeyIsOfTheActiveTierElseADigitOfTheOnlyOne) {
  EXPECT_EQ(tier_of_key(annotations, move, '2')->id, move);
  EXPECT_EQ(tier_of_key(annotations, role, '2')->id, move);
  EXPECT_EQ(tier_of_key(annotations, role, 'a')->id, role);
  EXPECT_EQ(tier_of_key(annotations, move, 'a'), nullptr) << "a letter of another tier";
  EXPECT_EQ(tier_of_key(annotations, move, '9'), nullptr);
  ASSERT_TRUE(annotations.set_vocabulary(note, {{"seen", "", {}, '2'}}));
  EXPECT_EQ(tier_of_key(annotations, role, '2'), nullptr) << "two tiers have it";
}

TEST_F(LabelKeysTest, AHeldKeySaysItsValueFromPressToRelease) {
  EXPECT_THAT(press('1', 2), IsEmpty());
  EXPECT_TRUE(keys.is_running('1'));
  EXPECT_EQ(keys.running().at('1').from_s, 2);
  EXPECT_THAT(follow(at(2.5)), IsEmpty());
  EXPECT_THAT(release('1', 3), ElementsAre("2-3 one"));
  EXPECT_FALSE(keys.is_running('1'));
  EXPECT_THAT(release('1', 4), IsEmpty());
}

TEST_F(LabelKeysTest, WhatWasSaidBeginsAndEndsOnFrames) {
  LabelKeys::Moment now = at(2.04);
  now.fps = 10;
  keys.hold('1');
  keys.press('1', *annotations.tier(move), now);
  now.cursor_s = 3.07;
  EXPECT_THAT(texts(keys.let_all_go(now)), ElementsAre("2-3.1 one"));
  keys.hold('1');
  keys.press('1', *annotations.tier(move), now);
  EXPECT_THAT(texts(keys.let_all_go(now)), IsEmpty()) << "shorter than half a frame";
}

/// A busy machine reported the releases and presses of the repetition as those of a person.
TEST_F(LabelKeysTest, AKeyThatRepeatsIsHeldUntilNoPressFollowsItsRelease) {
  press('1', 2);
  for (const double at_s : {2.4, 2.45, 2.5}) {
    keys.let_go('1', at(at_s));
    EXPECT_THAT(press('1', at_s + 0.01), IsEmpty());
  }
  EXPECT_EQ(keys.running().at('1').from_s, 2);
  EXPECT_THAT(texts(keys.settle()), IsEmpty()) << "it is held";
  keys.let_go('1', at(3));
  EXPECT_THAT(follow(at(3.03)), IsEmpty());
  EXPECT_THAT(texts(keys.settle()), ElementsAre("2-3 one")) << "to where it was released";
}

TEST_F(LabelKeysTest, AReleaseKeepsItsTimeWhateverEndsTheLabel) {
  press('1', 2);
  keys.let_go('1', at(3));
  EXPECT_THAT(press('2', 3.02), ElementsAre("2-3 one"));
  keys.let_go('2', at(4));
  LabelKeys::Moment parked = at(4.02);
  parked.is_parked = true;
  EXPECT_THAT(follow(parked), ElementsAre("3.02-4 two"));
  EXPECT_THAT(texts(keys.settle()), IsEmpty());
}

TEST_F(LabelKeysTest, APressWhoseReleaseWasNotReportedIsANewOne) {
  press('1', 2);
  EXPECT_THAT(press('1', 3), ElementsAre("2-3 one"));
  EXPECT_EQ(keys.running().at('1').from_s, 3);
}

TEST_F(LabelKeysTest, ATapThatRepeatsIsOneTap) {
  keys.set_taps(true, at(0));
  press('1', 2);
  keys.let_go('1', at(2.4));
  EXPECT_THAT(press('1', 2.41), IsEmpty());
  EXPECT_TRUE(keys.is_running('1'));
}

TEST_F(LabelKeysTest, ATierSaysOneValueAtATime) {
  press('1', 2);
  EXPECT_THAT(press('2', 3), ElementsAre("2-3 one"));
  EXPECT_THAT(release('1', 4), IsEmpty());
  EXPECT_THAT(release('2', 4), ElementsAre("3-4 two"));
}

TEST_F(LabelKeysTest, TiersAreSaidBesideOneAnother) {
  press('1', 2);
  keys.hold('a');
  keys.press('a', *annotations.tier(role), at(2.5));
  EXPECT_EQ(keys.running().size(), 2u);
  EXPECT_THAT(texts(keys.let_all_go(at(4))), ElementsAre("2-4 one", "2.5-4 a"));
  EXPECT_TRUE(keys.running().empty());
}

TEST_F(LabelKeysTest, PlayedBackwardsItIsTheSameInterval) {
  press('1', 5);
  LabelKeys::Moment back = at(4);
  back.speed = -1;
  EXPECT_THAT(follow(back), IsEmpty());
  EXPECT_THAT(release('1', 3), ElementsAre("3-5 one"));
}

TEST_F(LabelKeysTest, ATapEndsTheLastAndBeginsTheNext) {
  keys.set_taps(true, at(0));
  press('1', 2);
  EXPECT_THAT(release('1', 2.1), IsEmpty());
  EXPECT_THAT(press('2', 3), ElementsAre("2-3 one"));
  EXPECT_THAT(press('2', 4), ElementsAre("3-4 two")) << "the same key again only ends it";
  EXPECT_TRUE(keys.running().empty());
  press('1', 5);
  EXPECT_THAT(texts(keys.set_taps(false, at(6))), ElementsAre("5-6 one"));
}

TEST_F(LabelKeysTest, ACursorThatStandsEndsWhatIsSaid) {
  press('1', 2);
  LabelKeys::Moment parked = at(3);
  parked.is_parked = true;
  EXPECT_THAT(follow(parked), ElementsAre("2-3 one"));
}

TEST_F(LabelKeysTest, ALoopThatStartsOverEndsItAtOut) {
  press('1', 2.2);
  follow(at(2.45));
  LabelKeys::Moment again = at(2.01);
  again.out_s = 2.5;
  EXPECT_THAT(follow(again), ElementsAre("2.2-2.5 one"));
  EXPECT_TRUE(keys.running().empty());
}

TEST_F(LabelKeysTest, AKeyPressedInTheLastFrameOfALoopSaysTheNextRound) {
  press('1', 2.499);
  LabelKeys::Moment again = at(2.01);
  again.fps = 60;
  again.out_s = 2.5;
  EXPECT_THAT(follow(again), IsEmpty()) << "no frame was said yet";
  EXPECT_TRUE(keys.is_running('1'));
  follow(at(2.48));
  again.cursor_s = 2;
  EXPECT_THAT(follow(again), testing::SizeIs(1));
  EXPECT_TRUE(keys.running().empty());
}

TEST_F(LabelKeysTest, InTappingModeItGoesOnWhereTheLoopBegins) {
  keys.set_taps(true, at(0));
  press('1', 2.2);
  follow(at(2.45));
  LabelKeys::Moment again = at(2);
  again.out_s = 2.5;
  EXPECT_THAT(follow(again), ElementsAre("2.2-2.5 one"));
  EXPECT_EQ(keys.running().at('1').from_s, 2);
}

TEST_F(LabelKeysTest, AnotherSubjectHasNothingRunning) {
  press('1', 2);
  keys.forget();
  EXPECT_THAT(release('1', 3), IsEmpty());
}

}  // namespace
}  // namespace abrazo::label_keys_test
