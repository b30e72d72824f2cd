#include "core/synthesis/bodies/placed_pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/motion/body/body_choice.hpp"
#include "core/motion/body/girth.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/synthesis/bodies/gliding_body.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::placed_pair_test {
namespace {

BodyChange change_to(const Pose& pose, double arms, double legs) {
  BodyChange change{body_of(pose), body_of(pose)};
  using namespace joints;
  for (const int joint : {left_knee, left_ankle, right_knee, right_ankle})
    change.to.bone_lengths[static_cast<std::size_t>(joint - 1)] *= legs;
  for (const int joint : {left_elbow, left_wrist, right_elbow, right_wrist})
    change.to.bone_lengths[static_cast<std::size_t>(joint - 1)] *= arms;
  return change;
}

TEST(GlidingBody, GlidesWhenTheChoiceChangesAndFollowsTheUsersMeasuresAtOnce) {
  const Body small = body_of(test::standing_pose()), large = scaled_body(small, 1.2);
  const auto after_a_frame = [&](const Body& first, bool of_user, const Body& next, bool next_of_user) {
    GlidingBody body;
    body.follow(first, of_user, 0, true);
    body.follow(next, next_of_user, 0.01, false);
    return body.now().bone_lengths;
  };
  const auto difference = [](const auto& a, const Body& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      largest = std::max(largest, std::abs(a[i] - b.bone_lengths[i]));
    return largest;
  };
  EXPECT_LT(difference(after_a_frame(small, false, large, true), small), 1e-3) << "to the user's body";
  EXPECT_LT(difference(after_a_frame(small, true, large, false), small), 1e-3) << "from the user's body";
  EXPECT_LT(difference(after_a_frame(small, false, large, false), small), 1e-3) << "to another body";
  EXPECT_EQ(after_a_frame(small, true, large, true), large.bone_lengths) << "the user measured anew";
}

TEST(PlacedPair, TheSameBodyAtTheSamePlaceIsTheRecordedPose) {
  const Pose pose = test::moved(test::standing_pose(), 0.4, Vec3(1, 0, 2));
  const BodyChange change{body_of(pose), body_of(pose)};
  EXPECT_LT((rebuilt(pose, change, joint_at(pose, 0)) - pose).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(PlacedPair, AScaledBodyIsTheScaledPose) {
  const Pose pose = test::moved(test::standing_pose(), -1, Vec3(1, 0, 2));
  const BodyChange change{body_of(pose), scaled_body(body_of(pose), 0.85)};
  EXPECT_LT((rebuilt(pose, change, 0.85 * joint_at(pose, 0)) - 0.85 * pose).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_NEAR(change.legs(), 0.85, 1e-12);
  EXPECT_NEAR(girth(change.from, change.to), 0.85, 1e-12);
}

TEST(PlacedPair, BonesHaveTheOtherBodysLengthsAndTheRecordedDirections) {
  const Pose pose = test::standing_pose();
  const BodyChange change = change_to(pose, 1.2, 0.85);
  const Pose other = rebuilt(pose, change, Vec3::Zero());
  EXPECT_LT(largest_length_difference(body_of(other), change.to), 1e-12);
  for (int joint = 1; joint < joint_count; ++joint) {
    const int parent = joint_parents[static_cast<std::size_t>(joint)];
    const Vec3 was = (pose.row(joint) - pose.row(parent)).normalized();
    const Vec3 is = (other.row(joint) - other.row(parent)).normalized();
    EXPECT_LT((was - is).norm(), 1e-12) << joint_names[static_cast<std::size_t>(joint)];
  }
  const auto hips = [](const Pose& p) { return 0.5 * (p(joints::left_hip, 1) + p(joints::right_hip, 1)); };
  EXPECT_NEAR(hips(other), 0.85 * hips(pose), 1e-12);
}

TEST(PlacedPair, ABoneThatTheRecordedBodyLacksGoesOnInTheDirectionBeforeIt) {
  Pose pose = test::standing_pose();
  const BodyChange change{body_of(pose), body_of(pose)};
  pose.row(joints::Head) = pose.row(joints::UpperNeck);
  const Pose other = rebuilt(pose, change, Vec3::Zero());
  EXPECT_LT(largest_length_difference(body_of(other), change.to), 1e-12);
  EXPECT_TRUE(other.allFinite());
}

TEST(PlacedPair, FeetAreBroughtToTheirPlacesAndBonesStay) {
  const Pose pose = test::moved(test::standing_pose(), 0.7, Vec3(0, -0.05, 0));
  const Body body = body_of(pose);
  ToeBases feet = toe_bases(pose);
  feet[0] += Vec3(0.1, 0.05, 0.05);
  const Pose stepped = standing_at(pose, body, feet);
  EXPECT_LT((toe_bases(stepped)[0] - feet[0]).norm(), 1e-6);
  EXPECT_EQ(toe_bases(stepped)[1], feet[1]);
  EXPECT_LT(largest_length_difference(body_of(stepped), body), 1e-6);
}

}  // namespace
}  // namespace abrazo::placed_pair_test
