#include "core/synthesis/motion/hand_holds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/library/build/motion_library_builder.hpp"
#include "core/motion/body/body.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/synthesis/motion/body_shape.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::hand_holds_test {
namespace {

constexpr int user_hand = joints::left_hand, partner_hand = joints::right_hand;
constexpr std::size_t left_with_right = 1;

/// The user's left hand holds the partner's right hand, if the recording holds them.
class Drawn : public testing::Test {
 protected:
  Drawn() : partner_(test::standing_pose()), body_(body_of(partner_)) {
    for (int joint = partner_hand - 2; joint <= partner_hand; ++joint)
      arm_m_ += body_.bone_lengths[static_cast<std::size_t>(joint - 1)];
    moment_.pair.setZero();
    pairs_[left_with_right].recorded = true;
  }

  Vec3 shoulder() const { return partner_.row(partner_hand - 3); }
  /// The pull of a hand so much beyond the stretched arm's easy reach, in this direction.
  Vec3 drawn(double excess_m, const Vec3& towards = Vec3::UnitX()) const {
    Pose user = Pose::Zero();
    user.row(user_hand) = (shoulder() + (0.95 * arm_m_ + excess_m) * towards).transpose();
    return HandHolds(pairs_, {}, {}).drawn(partner_, moment_, user, RootFrame{}, body_);
  }

  Pose partner_;
  Body body_;
  RecordedMoment moment_;
  HandHolds::Pairs pairs_;
  double arm_m_ = 0;
};

TEST_F(Drawn, AHandWithinEasyReachDrawsNobody) {
  EXPECT_EQ(drawn(-0.01), Vec3::Zero());
  EXPECT_EQ(drawn(-0.3), Vec3::Zero());
}

TEST_F(Drawn, AHandBeyondEasyReachDrawsByWhatIsMissing) {
  EXPECT_LT((drawn(0.1) - Vec3(0.1, 0, 0)).norm(), 1e-12);
  EXPECT_LT((drawn(0.2, -Vec3::UnitZ()) - Vec3(0, 0, -0.2)).norm(), 1e-12);
}

TEST_F(Drawn, NobodyIsLifted) {
  const Vec3 slanting = Vec3(0.6, 0.8, 0);
  EXPECT_LT((drawn(0.1, slanting) - Vec3(0.06, 0, 0)).norm(), 1e-12);
}

TEST_F(Drawn, AHandThatIsTooFarAwayDrawsNobodyAndNothingJumps) {
  EXPECT_EQ(drawn(0.4), Vec3::Zero());
  EXPECT_EQ(drawn(3), Vec3::Zero());
  Vec3 before = drawn(0);
  for (double excess_m = 0.001; excess_m < 0.5; excess_m += 0.001) {
    const Vec3 now = drawn(excess_m);
    EXPECT_LT((now - before).norm(), 0.006) << excess_m;
    before = now;
  }
}

TEST_F(Drawn, OnlyHandsThatTheRecordingHoldsDraw) {
  pairs_[left_with_right].recorded = false;
  EXPECT_EQ(drawn(0.1), Vec3::Zero());
}

TEST_F(Drawn, TheRecordedOffsetBetweenTheHandsIsAimedAt) {
  moment_.pair.row(partner_hand + joint_count) = Eigen::RowVector3d(0.05, 0, 0);
  EXPECT_LT((drawn(0.1) - Vec3(0.15, 0, 0)).norm(), 1e-12);
}

/// The partner's right arm, a third of the way into a hold.
class Reached : public Drawn {
 protected:
  Reached() {
    pairs_[left_with_right].ramp = 0.4;
    moment_.partner = {};
  }

  Vec3 arm() const { return Vec3(partner_.row(partner_hand - 1)) - shoulder(); }
  /// The partner when the target asks for the wrist there, from the shoulder.
  Pose pose_for(const Vec3& wrist) {
    HandHolds::UserHands user_hands;
    user_hands[0].at = shoulder() + wrist + Vec3(partner_.row(partner_hand) - partner_.row(partner_hand - 1));
    HandHolds holds(pairs_, arms_, user_hands);
    const RootFrame user_root, place = root_frame(partner_);
    Pose pose = partner_;
    holds.place_arms(
        pose, {*library_, playhead_, moment_, false, partner_, user_root, partner_, body_, place}, 1.0 / 60);
    arms_ = holds.arms();
    return pose;
  }
  Vec3 hand_for(const Vec3& wrist) { return pose_for(wrist).row(partner_hand); }
  /// The longest step of the hand on a way of the target in steps of 1 mm [m].
  double longest_step(const Vec3& from, const Vec3& to) {
    const int steps = static_cast<int>((to - from).norm() * 1000);
    double longest = 0;
    Vec3 last = hand_for(from);
    for (int i = 1; i <= steps; ++i) {
      const Vec3 hand = hand_for(from + (to - from) * i / steps);
      longest = std::max(longest, (hand - last).norm());
      last = hand;
    }
    return longest;
  }

  std::shared_ptr<const MotionLibrary> library_ = test::small_library();
  SourcePlayhead playhead_{0, 0, 1};
  HandHolds::Arms arms_;
};

TEST_F(Reached, AHandOppositeTheFreeArmDoesNotSwingFromOneSideToTheOther) {
  const Vec3 across = arm().unitOrthogonal();
  EXPECT_LT(longest_step(-0.8 * arm() - 0.05 * across, -0.8 * arm() + 0.05 * across), 0.002);
}

TEST_F(Reached, AHandThatPassesTheShoulderDoesNotSwing) {
  const Vec3 across = arm().unitOrthogonal();
  EXPECT_LT(longest_step(-0.2 * across + 0.01 * arm(), 0.2 * across + 0.01 * arm()), 0.005);
}

TEST_F(Reached, TheElbowTurnsToItsSideWithinABoundedSpeed) {
  const Vec3 wrist = arm();
  hand_for(wrist);
  const HandHolds::Arm free = arms_[1];
  ASSERT_TRUE(free.reaches);
  arms_[1].side = turned(free.side, 2.5 * free.along);
  hand_for(wrist);
  const double turned_rad = 2.5 - std::acos(std::clamp(arms_[1].side.dot(free.side), -1.0, 1.0));
  const double share = 0.4 * 0.4 * 0.4 * (10 - 15 * 0.4 + 6 * 0.4 * 0.4);  // of a ramp of 0.4
  EXPECT_NEAR(turned_rad, 8.0 / 60 / share, 1e-3) << "8 rad/s, faster while the hold is weak";
}

TEST_F(Reached, NextToTheStretchedArmTheElbowMovesNoFasterThanTwiceTheTarget) {
  pairs_[left_with_right].ramp = 1;
  const auto elbow_at = [&](double share) -> Vec3 { return pose_for(share * arm()).row(partner_hand - 2); };
  const double bones_m = body_.bone_lengths[static_cast<std::size_t>(partner_hand - 3)] +
                         body_.bone_lengths[static_cast<std::size_t>(partner_hand - 2)];
  const double step = 0.001 / arm().norm(), stretched = bones_m / arm().norm();
  Vec3 last = elbow_at(0.85 * stretched);
  for (double share = 0.85 * stretched + step; share < 1.2 * stretched; share += step) {
    const Vec3 elbow = elbow_at(share);
    EXPECT_LT((elbow - last).norm(), 0.002) << share / stretched << " of the stretched arm";
    last = elbow;
  }
}

TEST_F(Reached, WhatIsListedAreTheHoldsOfThisFrame) {
  std::vector<HandHold> holds(3);
  HandHolds(pairs_, {}, {}).list(partner_, partner_, RootFrame{}, holds);
  ASSERT_EQ(holds.size(), 1u);
  EXPECT_TRUE(holds.front().active_left);
  EXPECT_FALSE(holds.front().passive_left);
}

TEST_F(Reached, AHandInFrontTurnsAboutTheShoulderAndKeepsItsDistance) {
  const Vec3 there = turned(arm(), 0.8 * arm().unitOrthogonal());
  const Vec3 to_hand = partner_.row(partner_hand) - partner_.row(partner_hand - 1);
  EXPECT_NEAR((hand_for(there) - to_hand - shoulder()).norm(), arm().norm(), 1e-9);
}

/// The hands are 0.6 m apart, hold one another from frame 60 on, are 15 cm apart from 120 and 20 cm from 150
/// on.
class RecordedHold : public testing::Test {
 protected:
  RecordedHold() {
    PairedTake take = test::swinging_take("hold", 180, 5, 0.62);
    for (std::size_t frame = 0; frame < 180; ++frame) {
      const double apart_m = frame < 60 ? 0.6 : frame < 120 ? 0.02 : frame < 150 ? 0.15 : 0.2;
      take.b.poses[frame].row(partner_hand) =
          take.a.poses[frame].row(user_hand) + Eigen::RowVector3d(0, apart_m, 0);
    }
    poses_ = take;
    std::vector<PairedTake> takes;
    takes.push_back(std::move(take));
    library_ =
        std::make_shared<const MotionLibrary>(std::move(*build_library("hold", std::move(takes), {}, {})));
  }
  void show(HandHolds& holds, int frame, bool source_changed = false) const {
    const SourcePlayhead playhead{library_->find_pair("hold", frame, false), 0, 1};
    const RecordedMoment moment = recorded_moment(*library_, playhead);
    const Pose &user = poses_.a.poses[static_cast<std::size_t>(frame)],
               &partner = poses_.b.poses[static_cast<std::size_t>(frame)];
    const RootFrame user_root = root_frame(user), place = root_frame(partner);
    holds.update({*library_, playhead, moment, source_changed, user, user_root, partner, body_, place},
                 1.0 / 60);
  }
  static bool is_held(const HandHolds& holds) { return holds.pairs()[left_with_right].recorded; }

  PairedTake poses_;
  std::shared_ptr<const MotionLibrary> library_;
  Body body_ = body_of(test::standing_pose());
};

TEST_F(RecordedHold, TheHandStartsFourTenthsOfASecondBeforeTheHold) {
  HandHolds holds;
  for (int frame = 20; frame < 60; ++frame) {
    show(holds, frame);
    EXPECT_EQ(is_held(holds), frame >= 60 - 24) << frame;
  }
  EXPECT_GT(holds.pairs()[left_with_right].ramp, 0.9) << "it is there in time";
}

TEST_F(RecordedHold, AHoldLastsUntilTheHandsAreEighteenCentimetresApart) {
  HandHolds holds;
  for (int frame = 50; frame < 180; ++frame) {
    show(holds, frame);
    EXPECT_EQ(is_held(holds), frame < 150) << frame;
  }
}

TEST_F(RecordedHold, ThatEndsOnTheWaySlowsTheHandDownGradually) {
  constexpr double most_m_s2 = 40;
  for (int frames = 4; frames < 20; ++frames) {
    HandHolds holds;
    for (int frame = 36; frame < 36 + frames; ++frame) show(holds, frame);
    for (int n = 0; n < 40 && holds.pairs()[left_with_right].ramp > 0; ++n) {
      const HandHolds::Pair before = holds.pairs()[left_with_right];
      show(holds, n, n == 0);  // of another source, which does not hold
      const HandHolds::Pair& now = holds.pairs()[left_with_right];
      if (now.ramp <= 0) break;
      const auto at = static_cast<std::size_t>(n);
      const Vec3 target = holds.user_hands()[0].at + root_frame(poses_.a.poses[at]).rotation() * now.offset;
      const double way_m = (target - Vec3(poses_.b.poses[at].row(partner_hand))).norm();
      const double slope = 30 * before.ramp * before.ramp * (1 - before.ramp) * (1 - before.ramp);
      EXPECT_LE(std::abs(now.ramp_pace - before.ramp_pace) * 60 * slope * way_m, 1.0001 * most_m_s2)
          << frames << " frames up, " << n << " down";
    }
    EXPECT_EQ(holds.pairs()[left_with_right].ramp, 0) << "it is released all the same";
  }
}

TEST_F(RecordedHold, ItBeginsAtThirteenCentimetresAndWithAnotherSourceAnew) {
  HandHolds at_fifteen;
  show(at_fifteen, 120);
  EXPECT_FALSE(is_held(at_fifteen));
  for (const bool source_changed : {false, true}) {
    HandHolds holds;
    for (int frame = 60; frame < 120; ++frame) show(holds, frame);
    show(holds, 120, source_changed);
    EXPECT_EQ(is_held(holds), !source_changed);
  }
}

}  // namespace
}  // namespace abrazo::hand_holds_test
