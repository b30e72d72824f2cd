#include "tests/soak/wait_account.hpp"

#include <gtest/gtest.h>

namespace abrazo::soak::wait_account_test {
namespace {

constexpr pid_t renderer = 7, other = 8;

/// At the start of the gap all counts are 0; a beat was then.
WaitAccount begun() {
  WaitAccount account;
  account.beat({});
  return account;
}

TEST(WaitAccount, WhatTheThreadRanItself) {
  const WaitAccount::Gap gap = begun().beat({1.0, {1.0, 0}, false, {}});
  EXPECT_DOUBLE_EQ(gap.whole_s, 1.0);
  EXPECT_DOUBLE_EQ(gap.own_s(), 1.0);
}

TEST(WaitAccount, ItsOwnWaitForAProcessorIsExcused) {
  EXPECT_DOUBLE_EQ(begun().beat({1.0, {0.4, 0.6}, false, {}}).own_s(), 0.4);
}

TEST(WaitAccount, ASleepIsItsOwnWhoeverStarves) {
  WaitAccount account = begun();
  account.look({0.1, {}, false, {{renderer, 0}}});
  account.look({0.9, {}, false, {{renderer, 0.8}}});
  EXPECT_DOUBLE_EQ(account.beat({1.0, {}, false, {{renderer, 0.9}}}).own_s(), 1.0);
}

TEST(WaitAccount, ASleepThatNobodyLookedAtIsItsOwn) {
  EXPECT_DOUBLE_EQ(begun().beat({1.0, {}, false, {{renderer, 1.0}}}).own_s(), 1.0);
}

TEST(WaitAccount, ASleepInTheDriverIsExcusedAsLongAsAThreadOfItStarved) {
  WaitAccount account = begun();
  account.look({0.1, {}, true, {{renderer, 3.0}, {other, 5.0}}});
  EXPECT_DOUBLE_EQ(account.beat({1.0, {}, false, {{renderer, 3.6}, {other, 5.3}}}).starved_s, 0.6);
}

TEST(WaitAccount, ASleepInTheDriverWhoseThreadsWorkIsItsOwn) {
  WaitAccount account = begun();
  account.look({0.1, {}, true, {{renderer, 3.0}}});
  EXPECT_DOUBLE_EQ(account.beat({1.0, {}, false, {{renderer, 3.0}}}).own_s(), 1.0);
}

TEST(WaitAccount, NoMoreIsExcusedThanWasSleptInTheDriver) {
  WaitAccount account = begun();
  account.look({0.25, {}, true, {{renderer, 0}}});
  account.look({0.5, {}, false, {{renderer, 0.25}}});  // it waits for something else
  EXPECT_DOUBLE_EQ(account.beat({1.0, {}, false, {{renderer, 0.75}}}).starved_s, 0.25);
}

TEST(WaitAccount, WorkInTheDriverIsItsOwn) {
  WaitAccount account = begun();
  account.look({0.5, {0.5, 0}, true, {{renderer, 0}}});
  EXPECT_DOUBLE_EQ(account.beat({1.0, {1.0, 0}, false, {{renderer, 0.9}}}).own_s(), 1.0);
}

TEST(WaitAccount, ABeatEndsWhatWasSeenOfTheDriver) {
  WaitAccount account = begun();
  account.look({0.5, {}, true, {{renderer, 0}}});
  account.beat({1.0, {}, false, {{renderer, 0.5}}});
  EXPECT_DOUBLE_EQ(account.beat({2.0, {}, false, {{renderer, 1.5}}}).own_s(), 1.0);
}

}  // namespace
}  // namespace abrazo::soak::wait_account_test
