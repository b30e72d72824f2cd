#include "core/synthesis/transition.hpp"

#include <gtest/gtest.h>

#include "tests/support/bodies.hpp"

namespace abrazo::transition_test {
namespace {

std::array<double, joint_count> same_for_all(double hurry = 1) {
  std::array<double, joint_count> all{};
  all.fill(hurry);
  return all;
}

TEST(Transition, TheReferenceDoesNotJump) {
  const Pose old_source = test::standing_pose();
  const Pose new_source = test::moved(old_source, 0.5, Vec3(0.3, 0, 0));
  Transition transition;
  transition.jump(old_source, Pose::Zero(), new_source, Pose::Zero());
  EXPECT_LT((new_source + transition.offset() - old_source).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Transition, HalfIsLeftAfterTheHalfLife) {
  Transition transition;
  transition.jump(Pose::Ones(), Pose::Zero(), Pose::Zero(), Pose::Zero());
  transition.fade(0.1, 0.1, same_for_all());
  EXPECT_NEAR(transition.offset()(0, 0), 0.5, 1e-12);
}

TEST(Transition, ManySmallFadesEqualOneLongOne) {
  Transition fine;
  Transition coarse;
  for (Transition* t : {&fine, &coarse})
    t->jump(Pose::Ones(), Pose::Constant(2.0), Pose::Zero(), Pose::Zero());
  for (int step = 0; step < 10; ++step) fine.fade(0.01, 0.08, same_for_all());
  coarse.fade(0.1, 0.08, same_for_all());
  EXPECT_LT((fine.offset() - coarse.offset()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Transition, AHurriedJointArrivesSooner) {
  Transition transition;
  transition.jump(Pose::Ones(), Pose::Zero(), Pose::Zero(), Pose::Zero());
  auto hurry = same_for_all();
  hurry[20] = 4;
  transition.fade(0.05, 0.1, hurry);
  EXPECT_LT(transition.offset()(20, 0), 0.5 * transition.offset()(19, 0));
}

TEST(Transition, AHalfLifeOfZeroForgetsAtOnce) {
  Transition transition;
  transition.jump(Pose::Ones(), Pose::Zero(), Pose::Zero(), Pose::Zero());
  transition.fade(0.01, 0, same_for_all());
  EXPECT_TRUE(transition.offset().isZero());
}

}  // namespace
}  // namespace abrazo::transition_test
