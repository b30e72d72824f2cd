#include "core/selection/motion_history.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "tests/support/bodies.hpp"

namespace abrazo::motion_history_test {
namespace {

using Sample = MotionHistory::Sample;

/// Coordinates are kept as float: of two metres that is some 1e-7, a few of which add up.
constexpr double rounding_m = 2e-6;

/// Every joint goes its own way at its own steady speed, so that between two poses the motion is the line
/// between them, whenever the poses came.
class SteadyMotion {
 public:
  explicit SteadyMotion(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> speed(-0.4, 0.4);
    for (int joint = 0; joint < joint_count; ++joint)
      for (int axis = 0; axis < 3; ++axis) velocity_(joint, axis) = speed(random);
  }
  Pose at(double time_s) const { return test::standing_pose() + time_s * velocity_; }

 private:
  Pose velocity_;
};

RootFrame root_of(const Pose& pose, double heading_rad) {
  return {Vec3(pose.row(0)), heading_rad};
}

Sample sample_of(const MotionHistory& history, double lag_s) {
  Sample xyz;
  history.sample(lag_s, xyz);
  return xyz;
}

double largest_difference(const Sample& sample, const Pose& expected) {
  double largest = 0;
  for (int joint = 0; joint < joint_count; ++joint)
    for (int axis = 0; axis < 3; ++axis)
      largest =
          std::max(largest, std::abs(static_cast<double>(sample[static_cast<std::size_t>(3 * joint + axis)]) -
                                     expected(joint, axis)));
  return largest;
}

/// Gives the history the motion from 0 to `until_s` and asks, after each pose of the last 0.1 s, for moments.
void expect_every_moment_is_right(const std::string& what, double until_s,
                                  const std::function<double()>& next_interval_s) {
  const SteadyMotion motion(3);
  MotionHistory history;
  double now_s = 0;
  double elapsed_s = 0;
  while (now_s < until_s) {
    const Pose pose = motion.at(now_s);
    const RootFrame root = root_of(pose, 0.7 + now_s);
    history.add(pose, root, elapsed_s);
    const bool is_asked = now_s > until_s - 0.1;
    for (const double lag_s : {0.0, 0.001, 0.01, 0.067, 0.133, 0.4, 1.0, 1.75, 1.9, 1.95, 1.98, 2.0}) {
      if (!is_asked) break;
      ASSERT_LT(largest_difference(sample_of(history, lag_s), to_normalized(motion.at(now_s - lag_s), root)),
                rounding_m)
          << what << ", " << lag_s << " s before " << now_s;
    }
    elapsed_s = next_interval_s();
    now_s += elapsed_s;
  }
}

TEST(MotionHistory, APoseOfAnyMomentIsSeenFromTheNewestRootAndHeading) {
  expect_every_moment_is_right("60 Hz", 3, [] { return 1.0 / 60; });
}

TEST(MotionHistory, HoldsTwoSecondsAtEveryRate) {
  for (const double rate_hz :
       {240.0, 144.0, 125.0, 120.0, 100.0, 95.0, 90.0, 50.0, 32.0, 30.0, 25.0, 15.0, 5.0})
    expect_every_moment_is_right(std::to_string(rate_hz) + " Hz", 6, [=] { return 1 / rate_hz; });
}

TEST(MotionHistory, TellsTheTimeOfPosesThatComeIrregularly) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> jitter(1.0 / 240, 0.05);
  expect_every_moment_is_right("irregular", 8, [&] { return jitter(random); });
  expect_every_moment_is_right("240 Hz with gaps", 8, [&] { return random() % 20 == 0 ? 0.28 : 1.0 / 240; });
}

TEST(MotionHistory, BeforeItBeganTheFirstPoseHeld) {
  const SteadyMotion motion(4);
  MotionHistory history;
  for (int frame = 0; frame <= 30; ++frame) {
    const Pose pose = motion.at(frame / 60.0);
    const RootFrame root = root_of(pose, -0.3);
    history.add(pose, root, 1.0 / 60);
    for (const double lag_s : {frame / 60.0, frame / 60.0 + 0.01, 1.0, 2.0})
      ASSERT_LT(largest_difference(sample_of(history, lag_s), to_normalized(motion.at(0), root)), rounding_m)
          << lag_s << " s before frame " << frame;
  }
}

TEST(MotionHistory, IsTheSameWhereverInTheWorldAndWhicheverWayTheUserMoves) {
  const SteadyMotion motion(6);
  for (const auto& [yaw_rad, offset] : std::vector<std::pair<double, Vec3>>{
           {2.5, Vec3::Zero()}, {0, Vec3(1000, 0, -1000)}, {-1.2, Vec3(-1000, 0, 700)}}) {
    MotionHistory here, there;
    for (int frame = 0; frame < 150; ++frame) {
      const Pose pose = motion.at(frame / 60.0);
      const Pose moved = test::moved(pose, yaw_rad, offset);
      here.add(pose, root_of(pose, 0.4), 1.0 / 60);
      there.add(moved, root_of(moved, 0.4 + yaw_rad), 1.0 / 60);
    }
    for (const double lag_s : {0.0, 0.3, 1.0, 2.0}) {
      const Sample a = sample_of(here, lag_s), b = sample_of(there, lag_s);
      for (std::size_t c = 0; c < a.size(); ++c)
        ASSERT_NEAR(a[c], b[c], 2 * rounding_m) << "turned by " << yaw_rad << ", " << lag_s << " s before";
    }
  }
}

TEST(MotionHistory, NeverHoldsMoreThanItsRoom) {
  const SteadyMotion motion(7);
  MotionHistory history;
  EXPECT_TRUE(history.is_empty());
  for (int frame = 0; frame < 5000; ++frame) {
    const Pose pose = motion.at(frame / 240.0);
    history.add(pose, root_of(pose, 0), 1.0 / 240);
    ASSERT_LE(history.size(), MotionHistory::most_samples);
  }
  EXPECT_EQ(history.size(), MotionHistory::most_samples);
}

TEST(MotionHistory, OnceClearedKnowsNothingOfBefore) {
  const SteadyMotion motion(8);
  MotionHistory history, fresh;
  for (int frame = 0; frame < 200; ++frame)
    history.add(motion.at(frame / 60.0), root_of(motion.at(frame / 60.0), 1), 1.0 / 60);
  history.clear();
  EXPECT_TRUE(history.is_empty());
  const Pose pose = test::moved(test::standing_pose(), 1, Vec3(4, 0, 2));
  for (MotionHistory* each : {&history, &fresh}) each->add(pose, root_of(pose, 1), 0.1);
  EXPECT_EQ(sample_of(history, 1), sample_of(fresh, 1));
}

/// One whose ring went round, with a newest pose that is not kept yet.
MotionHistory used_history() {
  const SteadyMotion motion(9);
  MotionHistory history;
  for (int frame = 0; frame < 400; ++frame) {
    const Pose pose = motion.at(frame / 100.0).rowwise() + Eigen::RowVector3d(30, 0, -7);
    history.add(pose, root_of(pose, 0.2), 1.0 / 100);
  }
  return history;
}

std::vector<MotionHistory::Kept> kept_of(const MotionHistory& history) {
  std::vector<MotionHistory::Kept> kept;
  for (std::size_t i = 0; i < history.size(); ++i) kept.push_back(history.kept(i));
  return kept;
}

TEST(MotionHistory, MadeAgainFromItsPartsGoesOnWithTheSameBits) {
  MotionHistory first = used_history();
  ASSERT_GT(first.newest().since_s, 0) << "the newest must not be the last kept to test anything";
  MotionHistory second;
  ASSERT_TRUE(second.restore(first.origin(), first.root(), kept_of(first), first.newest()));
  const SteadyMotion motion(10);
  for (int frame = 0; frame < 300; ++frame) {
    for (const double lag_s : {0.0, 0.02, 0.5, 1.7, 2.0})
      ASSERT_EQ(sample_of(second, lag_s), sample_of(first, lag_s)) << lag_s << " s before frame " << frame;
    const Pose pose = motion.at(frame / 100.0);
    for (MotionHistory* each : {&first, &second}) each->add(pose, root_of(pose, 0.1), 1.0 / 100);
  }
}

TEST(MotionHistory, PartsThatCannotBeAHistoryAreRefusedAndLeaveNone) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinite = std::numeric_limits<float>::infinity();
  const MotionHistory good = used_history();
  struct Parts {
    Vec3 origin;
    RootFrame root;
    std::vector<MotionHistory::Kept> kept;
    MotionHistory::Kept newest;
  };
  const std::vector<std::pair<std::string, std::function<void(Parts&)>>> damages = {
      {"an origin that is no place", [](Parts& p) { p.origin.x() = static_cast<double>(nan); }},
      {"a root that is no place", [](Parts& p) { p.root.position.y() = static_cast<double>(infinite); }},
      {"a heading that is none", [](Parts& p) { p.root.heading_rad = static_cast<double>(nan); }},
      {"a joint nowhere", [](Parts& p) { p.kept[5].positions[17] = nan; }},
      {"a joint at infinity", [](Parts& p) { p.kept.back().positions[0] = -infinite; }},
      {"a newest joint nowhere", [](Parts& p) { p.newest.positions[74] = nan; }},
      {"time that runs backwards", [](Parts& p) { p.kept[3].since_s = -0.1F; }},
      {"a time that is none", [](Parts& p) { p.newest.since_s = nan; }},
      {"too many poses", [](Parts& p) { p.kept.resize(MotionHistory::most_samples + 1, p.kept.front()); }}};
  for (const auto& [what, damage] : damages) {
    Parts parts{good.origin(), good.root(), kept_of(good), good.newest()};
    damage(parts);
    MotionHistory history = good;
    EXPECT_FALSE(history.restore(parts.origin, parts.root, parts.kept, parts.newest)) << what;
    EXPECT_TRUE(history.is_empty()) << what;
  }
}

}  // namespace
}  // namespace abrazo::motion_history_test
