#include "core/choreography/wander.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace abrazo::wander_test {
namespace {

constexpr double minute = 60;

Wander wander(const Performance& performance) {
  RandomSource random(3);
  return {performance, 10 * minute, random};
}

/// Root mean square over ten minutes.
template <typename Value>
double rms(Value value) {
  double squares = 0;
  int count = 0;
  for (double time = 0; time < 10 * minute; time += 0.05, ++count) squares += std::pow(value(time), 2);
  return std::sqrt(squares / count);
}

TEST(Wander, TimingErrorIsTheDeviationAskedFor) {
  const Wander late = wander({.timing_error_s = 0.12});
  // Some 400 independent values: 4 % standard error.
  EXPECT_NEAR(rms([&](double time) { return late.ahead_s(time); }), 0.12, 0.015);
}

TEST(Wander, AnExpertIsInTime) {
  const Wander expert = wander({});
  for (double time = 0; time < minute; time += 0.1) EXPECT_EQ(expert.ahead_s(time), 0);
}

TEST(Wander, TimeNeverRunsBackwards) {
  const Wander late = wander({.timing_error_s = 0.25});
  for (double time = 0; time < 10 * minute; time += 0.01)
    EXPECT_GT(time + 0.01 + late.ahead_s(time + 0.01), time + late.ahead_s(time));
}

TEST(Wander, TrunkAndHandsStrayAsFarAsAskedFor) {
  const Wander unsteady = wander({.wander_m = 0.05});
  EXPECT_NEAR(rms([&](double time) { return unsteady.hand(Side::Left, time).norm(); }), 0.05, 0.008);
  EXPECT_NEAR(rms([&](double time) {
                TrunkPosture trunk;
                unsteady.displace(time, trunk);
                return trunk.root.norm();
              }),
              0.05, 0.012);  // less up and down
}

TEST(Wander, AnExpertStraysByMillimetres) {
  const Wander expert = wander({});
  EXPECT_LT(rms([&](double time) { return expert.hand(Side::Right, time).norm(); }), 0.025);
  EXPECT_LT(rms([&](double time) {
              TrunkPosture trunk;
              expert.displace(time, trunk);
              return trunk.root.norm();
            }),
            0.005);
}

TEST(Wander, TheSameRandomNumbersGiveTheSameWander) {
  const Wander one = wander({.wander_m = 0.02}), two = wander({.wander_m = 0.02});
  EXPECT_EQ(one.hand(Side::Left, 7.3), two.hand(Side::Left, 7.3));
}

}  // namespace
}  // namespace abrazo::wander_test
