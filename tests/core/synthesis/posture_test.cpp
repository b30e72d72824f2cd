#include "core/synthesis/bodies/posture.hpp"

#include <gtest/gtest.h>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::posture_test {
namespace {

using namespace joints;

struct Posture {
  PairPose rebuilt = test::facing_pair(0.5);
  PostureWeights weights{.legs = 7, .trunk = 3};
  VertexMatrix energy = VertexMatrix::Zero();
  PairPose linear = PairPose::Zero();

  Posture() { add_posture(rebuilt, weights, energy, linear); }
  double at(const PairPose& pose) const {
    return 0.5 * (pose.transpose() * energy * pose).trace() - (linear.transpose() * pose).trace();
  }
  double above_rebuilt(const PairPose& pose) const { return at(pose) - at(rebuilt); }
};

TEST(Posture, ABodyMayStandAnywhere) {
  const Posture posture;
  PairPose moved = posture.rebuilt;
  moved.topRows<joint_count>().rowwise() += Eigen::RowVector3d(0.4, -0.1, 0.2);
  EXPECT_NEAR(posture.above_rebuilt(moved), 0, 1e-9);
  EXPECT_LT((posture.energy * moved - posture.linear).cwiseAbs().maxCoeff(), 1e-9);
}

/// The pelvis alone 10 cm lower changes the vectors to four legs' ends: two ankles from the hips, neck and
/// shoulders from the root.
TEST(Posture, APelvisThatSinksIsHeldByLegsAndTrunk) {
  const Posture posture;
  PairPose sunk = posture.rebuilt;
  for (const int joint : {Root, LeftHipJoint, RightHipJoint}) sunk(joint, 1) -= 0.1;
  EXPECT_NEAR(posture.above_rebuilt(sunk), 0.5 * (2 * 7 + 3 * 3) * 0.01, 1e-9);
}

TEST(Posture, AFootThatRollsIsHeldByItsAnkle) {
  const Posture posture;
  PairPose rolled = posture.rebuilt;
  rolled(joint_count + left_toe_base, 1) -= 0.02;
  EXPECT_NEAR(posture.above_rebuilt(rolled), 0.5 * 7 * 0.0004, 1e-9);
}

TEST(Posture, ArmsAreFree) {
  const Posture posture;
  PairPose reaching = posture.rebuilt;
  for (int joint = left_elbow; joint <= left_hand; ++joint) reaching(joint, 2) += 0.3;
  EXPECT_NEAR(posture.above_rebuilt(reaching), 0, 1e-9);
}

}  // namespace
}  // namespace abrazo::posture_test
