#include "core/bodies/pair_retargeting.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "core/bodies/retargeted_frame.hpp"
#include "core/choreography/salsa.hpp"
#include "core/metrics/bone_lengths.hpp"
#include "core/metrics/holds.hpp"
#include "core/metrics/posture.hpp"
#include "core/motion/body/body_choice.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo::pair_retargeting_test {
namespace {

using ::testing::HasSubstr;

/// Three seconds of a generated dance, with holds and steps.
const RecordedPair& dance() {
  static const RecordedPair pair = [] {
    ChoreographyOptions options;
    options.minutes = 0.2;
    return *cut(recorded_pair_of(generate_salsa(options).front()), 120, 300);
  }();
  return pair;
}

PairBodies scaled(double active, double passive) {
  const Body a = body_of(dance().active.poses), p = body_of(dance().passive.poses);
  return {{a, scaled_body(a, active)}, {p, scaled_body(p, passive)}};
}

const RetargetedPair& made(double active, double passive) {
  static std::map<std::pair<double, double>, RetargetedPair> all;
  const auto [at, is_new] = all.try_emplace({active, passive});
  if (is_new) at->second = *retarget_pair(dance(), scaled(active, passive));
  return at->second;
}

PairPose recorded_at(std::size_t frame) {
  PairPose pair;
  pair << dance().active.poses[frame], dance().passive.poses[frame];
  return pair;
}

TEST(PairRetargeting, BodiesThatDoNotChangeGiveTheRecordingToTheBit) {
  const RetargetedPair& pair = made(1, 1);
  EXPECT_EQ(pair.active().poses, dance().active.poses);
  EXPECT_EQ(pair.passive().poses, dance().passive.poses);
  for (const RetargetedFrame& frame : pair.frames) EXPECT_EQ(frame.shortfall(), "");
}

TEST(PairRetargeting, BodiesThatHardlyChangeGiveNearlyTheRecording) {
  const RetargetedPair& pair = made(1 + 1e-7, 1 + 1e-7);
  for (std::size_t f = 0; f < pair.frames.size(); ++f)
    ASSERT_LT((pair.frames[f].pose - recorded_at(f)).cwiseAbs().maxCoeff(), 1e-4) << f;
}

TEST(PairRetargeting, BonesHaveTheLengthsOfTheNewBodies) {
  for (const auto& [active, passive] : {std::pair{0.85, 1.0}, std::pair{1.15, 1.15}, std::pair{1.3, 0.85}}) {
    const RetargetedPair& pair = made(active, passive);
    EXPECT_LT(measure_bone_lengths(pair.active().poses, pair.bodies.active.to).max, 1e-3);
    EXPECT_LT(measure_bone_lengths(pair.passive().poses, pair.bodies.passive.to).max, 1e-3);
  }
}

TEST(PairRetargeting, HoldsKeepTheirDistanceWhateverTheSize) {
  for (const auto& [active, passive] : {std::pair{0.85, 1.0}, std::pair{1.15, 1.0}, std::pair{0.85, 0.85}}) {
    HoldMetric holds;
    for (std::size_t f = 0; f < dance().active.poses.size(); ++f)
      holds.add(made(active, passive).frames[f].pose, recorded_at(f));
    ASSERT_GT(holds.figures().holds, 100);
    EXPECT_LT(holds.figures().change_mean_m, 0.01) << active << " " << passive;
  }
}

/// Means over the frames of one body.
PostureChange mean_posture(const RetargetedPair& pair, bool active) {
  const BodyChange& change = active ? pair.bodies.active : pair.bodies.passive;
  PostureChange sum{0, 0, 0};
  const auto frames = static_cast<double>(pair.frames.size());
  for (std::size_t f = 0; f < pair.frames.size(); ++f) {
    const int first = active ? 0 : joint_count;
    const PostureChange now = posture_change(pair.frames[f].pose.middleRows<joint_count>(first),
                                             recorded_at(f).middleRows<joint_count>(first), change.legs());
    sum.pelvis += now.pelvis / frames;
    sum.knee_deg += std::abs(now.knee_deg) / frames;
    sum.trunk_deg += std::abs(now.trunk_deg) / frames;
  }
  return sum;
}

TEST(PairRetargeting, EachBodyKeepsItsPostureWhateverTheSizeOfTheOther) {
  for (const auto& [active, passive] : {std::pair{0.85, 0.85}, std::pair{1.0, 1.15}, std::pair{0.85, 1.0},
                                        std::pair{0.85, 1.15}, std::pair{1.15, 0.85}})
    for (const bool of_active : {true, false}) {
      const PostureChange change = mean_posture(made(active, passive), of_active);
      EXPECT_NEAR(change.pelvis, 1, 0.03) << active << ' ' << passive << ' ' << of_active;
      EXPECT_LT(change.knee_deg, 5) << active << ' ' << passive << ' ' << of_active;
      EXPECT_LT(change.trunk_deg, 3) << active << ' ' << passive << ' ' << of_active;
    }
}

TEST(PairRetargeting, BodiesOfOneSizeHaveTheRecordedAngles) {
  for (const double size : {0.85, 1.15})
    for (const bool of_active : {true, false}) {
      const PostureChange change = mean_posture(made(size, size), of_active);
      EXPECT_NEAR(change.pelvis, 1, 0.005);
      EXPECT_LT(change.knee_deg, 1);
      EXPECT_LT(change.trunk_deg, 0.5);
    }
}

TEST(PairRetargeting, FeetThatStandInTheRecordingStand) {
  const RetargetedPair& pair = made(1.15, 1.0);
  int stands = 0;
  for (std::size_t f = 1; f < pair.frames.size(); ++f)
    for (std::size_t foot = 0; foot < 4; ++foot) {
      if (!pair.frames[f].stands[foot] || !pair.frames[f - 1].stands[foot]) continue;
      const int joint =
          (foot % 2 == 0 ? joints::left_toe_base : joints::right_toe_base) + (foot < 2 ? 0 : joint_count);
      const double legs = foot < 2 ? 1.15 : 1.0;
      const Vec3 is = pair.frames[f].pose.row(joint) - pair.frames[f - 1].pose.row(joint);
      const Vec3 was = recorded_at(f).row(joint) - recorded_at(f - 1).row(joint);
      ASSERT_LT((is - legs * was).norm(), 1e-4) << "frame " << f << ", foot " << foot;
      ++stands;
    }
  EXPECT_GT(stands, 100);
}

TEST(PairRetargeting, NoFootSinksIntoTheFloor) {
  for (const RetargetedFrame& frame : made(1.3, 0.85).frames)
    for (const int joint : {joints::left_toe_base, joints::right_toe_base})
      for (const int first : {0, joint_count}) ASSERT_GT(frame.pose(joint + first, 1), -1e-3);
}

TEST(PairRetargeting, AChildWithAGiantEndsInTheNearestPoseAndSaysSo) {
  const RetargetedPair& pair = made(3, 0.3);
  int nearest = 0, out_of_reach = 0;
  for (std::size_t f = 0; f < pair.frames.size(); ++f) {
    const RetargetedFrame& frame = pair.frames[f];
    ASSERT_TRUE(frame.pose.allFinite());
    ASSERT_LT(frame.bone_error, 1e-3);
    if (!frame.is_nearest_only()) continue;
    ++nearest;
    EXPECT_THAT(frame.shortfall(), HasSubstr("nearest pose"));
    EXPECT_THAT(frame_result_of(pair, f).status_text(), HasSubstr("relaxed: nearest pose"));
    if (frame.hold_change_m <= RetargetedFrame::reachable_m) continue;
    ++out_of_reach;
    EXPECT_NEAR(std::abs(hands_apart(frame.pose, frame.changed_hold) -
                         hands_apart(recorded_at(f), frame.changed_hold)),
                frame.hold_change_m, 1e-12);
    EXPECT_THAT(frame.shortfall(), HasSubstr(frame.changed_hold.passive == joints::left_hand
                                                 ? "the passive body's left hand are out of reach by"
                                                 : "the passive body's right hand are out of reach by"));
  }
  EXPECT_GT(nearest, 0);
  EXPECT_GT(out_of_reach, 0);
}

TEST(PairRetargeting, ATraceFrameHasRecordingMeshAndStandingFeet) {
  const RetargetedPair& pair = made(0.85, 1.0);
  const FrameResult frame = frame_result_of(pair, 90);
  EXPECT_EQ(frame.selected_pair, recorded_at(90));
  EXPECT_EQ(frame.result, pair.frames[90].pose);
  EXPECT_EQ(frame.edges, tetrahedralize(recorded_at(90)).edges);
  EXPECT_EQ(frame.edge_weights.size(), frame.edges.size());
  const auto& stands = pair.frames[90].stands;
  EXPECT_EQ(frame.foot_locks.size(),
            static_cast<std::size_t>(std::count(stands.begin(), stands.end(), true)));
  EXPECT_EQ(frame.status, StepStatus::Ok);
}

TEST(PairRetargeting, EndsWhenItIsAskedTo) {
  const auto pair = retarget_pair(dance(), scaled(0.85, 1), [](double, std::string_view) { return false; });
  ASSERT_FALSE(pair);
  EXPECT_EQ(pair.error().message, "cancelled");
}

TEST(PairRetargeting, APairNeedsAsManyPosesOfBoth) {
  RecordedPair pair = dance();
  pair.passive.poses.pop_back();
  EXPECT_THROW((void)retarget_pair(pair, scaled(1, 1)), std::invalid_argument);
  EXPECT_THROW((void)retarget_pair({}, scaled(1, 1)), std::invalid_argument);
}

}  // namespace
}  // namespace abrazo::pair_retargeting_test
