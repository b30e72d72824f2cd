#include "app/workbench/start/answer_times.hpp"

#include <gtest/gtest.h>

namespace abrazo::app::answer_times_test {
namespace {

TEST(AnswerTimes, AreZeroBeforeTheFirst) {
  const AnswerTimes times;
  EXPECT_EQ(times.count(), 0);
  EXPECT_EQ(times.longest_ms(), 0);
  EXPECT_EQ(times.within_ms(0.99), 0);
}

TEST(AnswerTimes, ShareIsTheNextWholeMillisecond) {
  AnswerTimes times;
  for (int ms = 0; ms < 100; ++ms) times.add(ms + 0.5);
  EXPECT_EQ(times.within_ms(0.50), 50);
  EXPECT_EQ(times.within_ms(0.99), 99);
  EXPECT_EQ(times.within_ms(1.00), 99.5) << "never more than the longest";
}

TEST(AnswerTimes, OneLongWaitIsTheLongestAndLeavesTheShareAlone) {
  AnswerTimes times;
  for (int i = 0; i < 999; ++i) times.add(2.25);
  times.add(5000);
  EXPECT_EQ(times.longest_ms(), 5000);
  EXPECT_EQ(times.within_ms(0.99), 3);
}

TEST(AnswerTimes, CountWaitsOfASecondAndMoreTogether) {
  AnswerTimes times;
  times.add(1500);
  times.add(2500);
  EXPECT_EQ(times.within_ms(0.5), 2500);
}

}  // namespace
}  // namespace abrazo::app::answer_times_test
