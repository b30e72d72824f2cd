#include "core/motion/body/joint_set.hpp"

#include <gtest/gtest.h>

namespace abrazo::joint_set_test {
namespace {

TEST(JointSet, NamesTheTwentyFiveJointsInTheAgreedOrder) {
  EXPECT_EQ(joint_names.size(), 25u);
  EXPECT_EQ(joint_index("root"), 0);
  EXPECT_EQ(joint_index("head"), 16);
  EXPECT_EQ(joint_index("rhand"), 24);
  EXPECT_EQ(joint_index("lradius"), std::nullopt);
}

TEST(JointSet, PutsEveryParentBeforeItsChildren) {
  EXPECT_EQ(joint_parents[0], -1);
  for (std::size_t j = 1; j < joint_count; ++j) {
    EXPECT_GE(joint_parents[j], 0);
    EXPECT_LT(joint_parents[j], static_cast<int>(j));
  }
}

TEST(JointSet, MirrorsEachJointOntoOneOfTheSameKind) {
  for (int j = 0; j < joint_count; ++j) {
    EXPECT_EQ(mirrored_joint(mirrored_joint(j)), j);
    EXPECT_EQ(joint_parents[static_cast<std::size_t>(mirrored_joint(j))],
              j == 0 ? -1 : mirrored_joint(joint_parents[static_cast<std::size_t>(j)]));
  }
  EXPECT_EQ(mirrored_joint(joints::left_hand), joints::right_hand);
  EXPECT_EQ(mirrored_joint(joints::LowerBack), joints::LowerBack);
  EXPECT_EQ(mirrored_joint(joints::Root), joints::Root);
}

}  // namespace
}  // namespace abrazo::joint_set_test
