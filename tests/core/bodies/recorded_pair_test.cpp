#include "core/bodies/recorded_pair.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/libraries.hpp"

namespace abrazo::recorded_pair_test {
namespace {

PairedTake take_with(std::vector<RoleInterval> roles) {
  PairedTake take = test::swinging_take("swing", 40, 1);
  take.roles = std::move(roles);
  return take;
}

TEST(RecordedPair, WhoIsActiveMostOfTheTimeComesFirst) {
  const PairedTake take =
      take_with({{0, 10, ActivePerformer::A}, {10, 35, ActivePerformer::B}, {35, 40, ActivePerformer::A}});
  EXPECT_EQ(recorded_pair_of(take).active.poses, take.b.poses);
  EXPECT_EQ(recorded_pair_of(take).passive.poses, take.a.poses);
  EXPECT_EQ(recorded_pair_of(take_with({})).active.poses, take.a.poses);
}

TEST(RecordedPair, APartHasTheFramesBetween) {
  const RecordedPair pair = recorded_pair_of(take_with({}));
  const auto part = cut(pair, 5, 9);
  ASSERT_TRUE(part);
  ASSERT_EQ(part->active.poses.size(), 4u);
  EXPECT_EQ(part->active.poses.front(), pair.active.poses[5]);
  EXPECT_EQ(part->passive.poses.back(), pair.passive.poses[8]);
  EXPECT_EQ(cut(pair, 30, {})->active.poses.size(), 10u);
}

TEST(RecordedPair, FramesThatThereAreNotAreRefusedWithThoseThatThereAre) {
  const RecordedPair pair = recorded_pair_of(take_with({}));
  const std::vector<std::pair<long long, std::optional<long long>>> wrong = {
      {-1, {}}, {5, 5}, {9, 3}, {40, {}}, {0, 41}};
  for (const auto& [from, to] : wrong) {
    const auto part = cut(pair, from, to);
    ASSERT_FALSE(part);
    EXPECT_THAT(part.error().text(), ::testing::HasSubstr("take swing: frames"));
    EXPECT_THAT(part.error().text(), ::testing::HasSubstr("it has frames 0 to 40"));
    EXPECT_EQ(part.error().hint, Hint::ChooseFrames);
  }
}

}  // namespace
}  // namespace abrazo::recorded_pair_test
