#include "core/stream/net/arrival_clock.hpp"

#include <gtest/gtest.h>

namespace abrazo::arrival_clock_test {
namespace {

constexpr double tolerance_s = 1e-6;  // of a double that counts seconds since 1970
constexpr double wall_s = 1.8e9;      // when the session's clock says 0

TEST(ArrivalClock, TakesAwayTheTimeThatAPacketWaited) {
  ArrivalClock clock;
  EXPECT_NEAR(clock.arrived_s(wall_s + 1.000, wall_s + 1.004, 1.004), 1.000, tolerance_s);
  EXPECT_NEAR(clock.arrived_s(wall_s + 1.010, wall_s + 1.011, 1.011), 1.010, tolerance_s);
}

TEST(ArrivalClock, APacketIsNeverFromTheFuture) {
  ArrivalClock clock;
  EXPECT_EQ(clock.arrived_s(wall_s + 2, wall_s + 1, 1), 1);
}

TEST(ArrivalClock, WhenTheTimeOfDayIsSetThePacketsThatWaitedCameJustNowAndLaterOnesAreExactAgain) {
  for (const double step_s : {5.0, -5.0, 3600.0, -86400.0, 0.5, -0.5}) {
    ArrivalClock clock;
    EXPECT_NEAR(clock.arrived_s(wall_s + 1.000, wall_s + 1.001, 1.001), 1.000, tolerance_s);
    // Two came before it was set at 1.015, and are read after that.
    EXPECT_EQ(clock.arrived_s(wall_s + 1.010, wall_s + 1.020 + step_s, 1.020), 1.020) << step_s;
    EXPECT_EQ(clock.arrived_s(wall_s + 1.012, wall_s + 1.021 + step_s, 1.021), 1.021) << step_s;
    EXPECT_NEAR(clock.arrived_s(wall_s + 1.030 + step_s, wall_s + 1.034 + step_s, 1.034), 1.030, tolerance_s)
        << step_s;
  }
}

TEST(ArrivalClock, AProgramThatWasStoppedLearnsHowLongItsPacketsWaited) {
  ArrivalClock clock;
  (void)clock.arrived_s(wall_s + 1, wall_s + 1, 1);
  EXPECT_NEAR(clock.arrived_s(wall_s + 2, wall_s + 61, 61), 2, tolerance_s);
  EXPECT_NEAR(clock.arrived_s(wall_s + 60, wall_s + 61, 61), 60, tolerance_s);
}

TEST(ArrivalClock, AWallClockThatFollowsATimeServerIsNotTakenForOneThatWasSet) {
  ArrivalClock clock;
  const double rate = 1 + 5e-4;  // the most that Linux slews
  for (double now_s = 1; now_s < 3600; now_s += 60)
    EXPECT_NEAR(clock.arrived_s(wall_s + rate * now_s - 0.005, wall_s + rate * now_s, now_s), now_s - 0.005,
                1e-5);
}

TEST(ArrivalClock, TheFirstPacketMayHaveWaitedSomeSecondsAndNoMore) {
  EXPECT_NEAR(ArrivalClock().arrived_s(wall_s, wall_s + 9, 9), 0, tolerance_s);
  EXPECT_EQ(ArrivalClock().arrived_s(0, wall_s, 9), 9) << "a stamp that was never set";
}

}  // namespace
}  // namespace abrazo::arrival_clock_test
