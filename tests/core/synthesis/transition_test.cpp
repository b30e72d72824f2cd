#include <cmath>

#include "core/synthesis/motion/transition.hpp"

#include <gtest/gtest.h>

#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::transition_test {
namespace {

constexpr double step_s = 1.0 / 240;

BodyShape shape_of_world(const Pose& pose) {
  const RootFrame root = root_frame(pose);
  return shape_of(to_normalized(pose, root), root.position.y());
}

/// Two people who move differently, so much later than where a change is made.
struct TwoSources {
  PairedTake old = test::swinging_take("old", 200, 3);
  PairedTake other = test::swinging_take("other", 200, 8);
  static Pose at(const PairedTake& take, double time_s) {
    const double frame = 60 * (1 + time_s);
    const auto before = static_cast<std::size_t>(frame);
    const double share = frame - static_cast<double>(before);
    return (1 - share) * take.b.poses[before] + share * take.b.poses[before + 1];
  }
  BodyShape seen(double time_s) const { return shape_of_world(at(old, time_s)); }
  BodyShape source(double time_s) const { return shape_of_world(at(other, time_s)); }
};

double largest_difference(const BodyShape& a, const BodyShape& b) {
  double largest = std::abs(a.root_height - b.root_height);
  for (std::size_t bone = 0; bone < bone_count; ++bone)
    largest = std::max(largest, (a.directions[bone] - b.directions[bone]).norm());
  return largest;
}

TEST(Transition, WhatIsShownGoesOnWithTheSamePoseAndSpeed) {
  const TwoSources two;
  Transition transition;
  transition.begin(two.seen(0), two.source(0), two.seen(-step_s), two.source(-step_s), step_s, 0.25);
  EXPECT_LT(largest_difference(transition.shown(two.source(0)), two.seen(0)), 1e-9);
  transition.advance(step_s);
  EXPECT_LT(largest_difference(transition.shown(two.source(step_s)), two.seen(step_s)), 2e-3);
  EXPECT_GT(largest_difference(two.source(0), two.seen(0)), 0.1) << "there must be something to go over to";
}

TEST(Transition, EndsAtTheSourceWithoutAKink) {
  const TwoSources two;
  Transition transition;
  transition.begin(two.seen(0), two.source(0), two.seen(-step_s), two.source(-step_s), step_s, 0.25);
  transition.advance(transition.duration_s() - step_s);
  EXPECT_LT(largest_difference(transition.shown(two.source(0)), two.source(0)), 1e-4);
  transition.advance(step_s);
  EXPECT_TRUE(transition.is_over());
  EXPECT_EQ(largest_difference(transition.shown(two.source(0)), two.source(0)), 0);
}

TEST(Transition, ALargeChangeTakesLonger) {
  const TwoSources two;
  Transition small, large;
  small.begin(two.source(0.01), two.source(0), two.source(0), two.source(0), 0, 0.24);
  large.begin(two.seen(0), two.source(0), two.seen(0), two.source(0), 0, 0.24);
  EXPECT_LT(small.duration_s(), large.duration_s());
  EXPECT_GE(small.duration_s(), 0.24);
  EXPECT_LE(large.duration_s(), 0.4 + 1e-12);
}

TEST(Transition, OppositeDirectionsStayDirections) {
  EXPECT_NEAR(turn_between(Vec3::UnitX(), -Vec3::UnitX()).norm(), std::acos(-1.0), 1e-12);
  EXPECT_LT((turned(Vec3::UnitX(), turn_between(Vec3::UnitX(), Vec3::UnitZ())) - Vec3::UnitZ()).norm(),
            1e-12);
}

}  // namespace
}  // namespace abrazo::transition_test
