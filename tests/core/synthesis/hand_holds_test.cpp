#include "core/synthesis/motion/hand_holds.hpp"

#include <gtest/gtest.h>

#include "core/motion/body/body.hpp"
#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"

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

}  // namespace
}  // namespace abrazo::hand_holds_test
