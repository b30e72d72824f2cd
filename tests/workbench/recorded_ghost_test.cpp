#include "app/workbench/library/recorded_ghost.hpp"

#include <gtest/gtest.h>

#include "tests/support/libraries.hpp"

namespace abrazo::app::recorded_ghost_test {
namespace {

/// Distance between the same joints of two frames, both bodies.
Positions moves(const PairPose& from, const PairPose& to) {
  return to - from;
}

TEST(RecordedGhost, BeginsWhereTheUserIs) {
  const auto library = test::small_library();
  const RootFrame user{Vec3(3, 0.95, -2), 0.7};
  RecordedGhost ghost;
  ghost.begin(*library, 5, user, false);
  EXPECT_LT((ghost.at(*library, 5) - library->pair_in_world(5, user)).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(RecordedGhost, BeginsWhereAUserWhoFollowsIs) {
  const auto library = test::small_library();
  const RootFrame user{Vec3(3, 0.95, -2), 0.7};
  RecordedGhost ghost;
  ghost.begin(*library, 5, user, true);
  EXPECT_LT((ghost.at(*library, 5) - library->pair_in_world(5, user, true)).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(RecordedGhost, GoesOnAsItWasRecorded) {
  const auto library = test::small_library();
  const auto recorded = [&](int pair) {
    PairPose pose;
    pose.topRows<joint_count>() = to_world(library->pose(pair).topRows<joint_count>(), library->root(pair));
    pose.bottomRows<joint_count>() =
        to_world(library->pose(pair).bottomRows<joint_count>(), library->root(pair));
    return pose;
  };
  const RootFrame user{Vec3(3, 0.95, -2), library->root(5).heading_rad + 0.7};
  RecordedGhost ghost;
  ghost.begin(*library, 5, user, false);
  const Eigen::Matrix3d turn = RootFrame{Vec3::Zero(), 0.7}.rotation();
  const Positions expected = moves(recorded(5), recorded(9)) * turn.transpose();
  EXPECT_LT((moves(ghost.at(*library, 5), ghost.at(*library, 9)) - expected).cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace
}  // namespace abrazo::app::recorded_ghost_test
