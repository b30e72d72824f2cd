#include <gtest/gtest.h>

#include <algorithm>

#include "core/library/store/motion_library.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::role_exchange_test {
namespace {

TEST(RoleExchange, TheUsersBodyIsTheRecordedPassiveOne) {
  const auto library = test::small_library();
  const MotionLibrary exchanged = with_roles_exchanged(*library);
  EXPECT_EQ(exchanged.usual_active_body().name, library->usual_passive_body().name);
  EXPECT_EQ(exchanged.usual_passive_body().name, library->usual_active_body().name);
  EXPECT_EQ(exchanged.active_body(3).name, library->passive_body(3).name);
}

TEST(RoleExchange, PosesStayWhereTheyWereInTheTakesWorld) {
  const auto library = test::small_library();
  const MotionLibrary exchanged = with_roles_exchanged(*library);
  for (int pair = 0; pair < library->pair_count(); pair += 37) {
    const Pose before = to_world(library->pose(pair).bottomRows<joint_count>(), library->root(pair));
    const Pose after = to_world(exchanged.pose(pair).topRows<joint_count>(), exchanged.root(pair));
    EXPECT_LT((before - after).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((pose_features(exchanged.pose(pair).topRows<joint_count>()) - exchanged.features(pair)).norm(),
              1e-12);
  }
}

TEST(RoleExchange, MeshesConnectTheSameJoints) {
  const auto library = test::small_library();
  const MotionLibrary exchanged = with_roles_exchanged(*library);
  for (const int pair : {0, 100}) {
    ASSERT_EQ(exchanged.edges(pair).size(), library->edges(pair).size());
    for (const MeshEdge& edge : library->edges(pair)) {
      MeshEdge other = {static_cast<std::uint8_t>((edge[0] + joint_count) % pair_vertex_count),
                        static_cast<std::uint8_t>((edge[1] + joint_count) % pair_vertex_count)};
      if (other[0] > other[1]) std::swap(other[0], other[1]);
      EXPECT_NE(std::find(exchanged.edges(pair).begin(), exchanged.edges(pair).end(), other),
                exchanged.edges(pair).end());
    }
  }
}

TEST(RoleExchange, TwiceIsTheLibraryItself) {
  const auto library = test::small_library();
  const MotionLibrary twice = with_roles_exchanged(with_roles_exchanged(*library));
  for (int pair = 0; pair < library->pair_count(); pair += 53) {
    EXPECT_LT((twice.pose(pair) - library->pose(pair)).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_TRUE(std::equal(twice.edges(pair).begin(), twice.edges(pair).end(), library->edges(pair).begin(),
                           library->edges(pair).end()));
  }
}

}  // namespace
}  // namespace abrazo::role_exchange_test
