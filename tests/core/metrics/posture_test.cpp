#include "core/metrics/posture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::posture_change_test {
namespace {

using namespace joints;

Pose standing() {
  return test::facing_pair(1).topRows<joint_count>();
}

TEST(PostureChange, AScaledPoseHasTheRecordedPosture) {
  for (const double size : {0.7, 1.0, 1.3}) {
    const PostureChange change = posture_change(size * standing(), standing(), size);
    EXPECT_NEAR(change.pelvis, 1, 1e-12);
    EXPECT_NEAR(change.knee_deg, 0, 1e-9);
    EXPECT_NEAR(change.trunk_deg, 0, 1e-9);
  }
}

TEST(PostureChange, IsTheMeanOfBothKnees) {
  Pose straight = standing(), bent = standing();
  for (Pose* pose : {&straight, &bent})
    for (const int hip : {left_hip, right_hip}) {
      pose->row(hip + 1) = pose->row(hip) - Eigen::RowVector3d(0, 0.4, 0);
      pose->row(hip + 2) = pose->row(hip) - Eigen::RowVector3d(0, 0.8, 0);
    }
  const double angle = 30 * std::numbers::pi / 180;
  bent.row(left_ankle) = bent.row(left_knee) - 0.4 * Eigen::RowVector3d(0, std::cos(angle), std::sin(angle));
  EXPECT_NEAR(posture_change(bent, straight, 1).knee_deg, -15, 1e-6);
}

TEST(PostureChange, ATrunkThatLeansAndAPelvisThatSinksAreTold) {
  Pose upright = standing(), leaning = standing();
  upright.row(LowerNeck) = upright.row(Root) + Eigen::RowVector3d(0, 0.5, 0);
  leaning.row(LowerNeck) =
      leaning.row(Root) + Eigen::RowVector3d(0.5 * std::sqrt(0.5), 0.5 * std::sqrt(0.5), 0);
  EXPECT_NEAR(posture_change(leaning, upright, 1).trunk_deg, 45, 1e-9);
  leaning(Root, 1) *= 0.9;
  EXPECT_NEAR(posture_change(leaning, upright, 1).pelvis, 0.9, 1e-12);
}

}  // namespace
}  // namespace abrazo::posture_change_test
