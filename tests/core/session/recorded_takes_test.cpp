// How takes are named and counted, and when a recording begins.
#include "core/session/edit/recorded_takes.hpp"

#include <gtest/gtest.h>

#include "core/session/edit/take_name.hpp"
#include "core/session/edit/take_sequence.hpp"

namespace abrazo::recorded_takes_test {
namespace {

using Phase = TakeSequence::Phase;

TEST(TakeName, HasAStemAndPerhapsANumber) {
  EXPECT_EQ(parse_take_name("salsa 003"), (TakeName{"salsa", 3}));
  EXPECT_EQ(parse_take_name("  salsa_12 "), (TakeName{"salsa", 12}));
  EXPECT_EQ(parse_take_name("salsa7"), (TakeName{"salsa", 7}));
  EXPECT_EQ(parse_take_name("salsa"), (TakeName{"salsa", 0}));
  EXPECT_EQ(parse_take_name("7"), (TakeName{"", 7}));
  EXPECT_EQ(parse_take_name("20261121"), (TakeName{"20261121", 0})) << "a date is no number of a take";
}

TEST(TakeName, IsWrittenWithAtLeastThreeDigits) {
  EXPECT_EQ(text_of({"salsa", 3}), "salsa 003");
  EXPECT_EQ(text_of({"salsa", 1234}), "salsa 1234");
  EXPECT_EQ(text_of({"", 7}), "007");
}

TEST(TakeName, CountsUpByItself) {
  EXPECT_EQ(next_take_name("salsa", {}), "salsa 001");
  EXPECT_EQ(next_take_name("salsa", {"salsa 001", "salsa 002"}), "salsa 003");
  EXPECT_EQ(next_take_name("salsa", {"salsa 001", "salsa 007"}), "salsa 008") << "above the highest";
  EXPECT_EQ(next_take_name("tango", {"salsa 001"}), "tango 001");
  EXPECT_EQ(next_take_name("", {}), "take 001");
}

TEST(TakeName, KeepsAWrittenNumberWhileItIsFree) {
  EXPECT_EQ(next_take_name("salsa 010", {"salsa 001"}), "salsa 010");
  EXPECT_EQ(next_take_name("salsa 010", {"salsa 001", "salsa 010"}), "salsa 011");
}

TEST(TakeName, AgainIsTheLastOneWithItsNumberUp) {
  EXPECT_EQ(again_name({"salsa 001", "tango 004"}), "tango 005");
  EXPECT_EQ(again_name({"tango 004", "salsa 002"}), "salsa 003");
  EXPECT_EQ(again_name({"warm-up"}), "warm-up 001");
  EXPECT_EQ(again_name({"003"}), "004");
  EXPECT_EQ(again_name({}), "");
}

TEST(TakeSequence, BeginsAtOnceWithoutACountdown) {
  TakeSequence sequence;
  EXPECT_TRUE(sequence.start("salsa 001", 0, 5));
  EXPECT_EQ(sequence.phase, Phase::Recording);
  EXPECT_DOUBLE_EQ(sequence.elapsed_s(7.5), 2.5);
  EXPECT_TRUE(sequence.stop());
  EXPECT_EQ(sequence.phase, Phase::Idle);
}

TEST(TakeSequence, CountsDownInWholeSecondsAndThenBegins) {
  TakeSequence sequence;
  EXPECT_FALSE(sequence.start("salsa 001", 3, 10));
  EXPECT_EQ(sequence.count(10), 3);
  EXPECT_EQ(sequence.count(10.9), 3);
  EXPECT_EQ(sequence.count(11), 2);
  EXPECT_FALSE(sequence.advance(12.9));
  EXPECT_EQ(sequence.count(12.9), 1);
  EXPECT_TRUE(sequence.advance(13.02));
  EXPECT_FALSE(sequence.advance(13.1)) << "it begins once";
  EXPECT_EQ(sequence.count(13.1), 0);
  EXPECT_NEAR(sequence.elapsed_s(14.02), 1, 1e-9) << "from when it began";
}

TEST(TakeSequence, ACountdownThatIsGivenUpRecordedNothing) {
  TakeSequence sequence;
  sequence.start("salsa 001", 3, 10);
  EXPECT_FALSE(sequence.stop());
  EXPECT_FALSE(sequence.advance(20));
  EXPECT_EQ(sequence.elapsed_s(20), 0);
}

TEST(TakeSequence, CountsDownTenSecondsAtMost) {
  TakeSequence sequence;
  sequence.start("salsa 001", 60, 0);
  EXPECT_EQ(sequence.count(0), 10);
}

TEST(RecordedTakes, AreRenamedToNamesThatNoOtherHas) {
  RecordedTakes takes({{1, "salsa 001", 0, 3, 360, {}}, {2, "salsa 002", 4, 9, 600, {}}});
  EXPECT_EQ(takes.why_not(2, "tango"), "");
  EXPECT_EQ(takes.why_not(2, "salsa 002"), "") << "its own name";
  EXPECT_NE(takes.why_not(2, " salsa 001 "), "");
  EXPECT_NE(takes.why_not(2, "  "), "");
  takes.rename(2, " tango ");
  EXPECT_EQ(takes.find(2)->name, "tango");
  takes.remove(1);
  EXPECT_EQ(takes.names(), std::vector<std::string>{"tango"});
  EXPECT_EQ(takes.find(1), nullptr);
}

}  // namespace
}  // namespace abrazo::recorded_takes_test
