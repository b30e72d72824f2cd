#include "core/bodies/foot_steps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace abrazo::foot_steps_test {
namespace {

constexpr double fps = 60;

/// A foot that stands for a second, steps 0.6 m forward within 0.5 s, and stands again.
std::vector<Vec3> one_step() {
  std::vector<Vec3> path;
  for (int f = 0; f < 150; ++f) {
    const double u = std::clamp((f - 60) / 30.0, 0.0, 1.0);
    path.emplace_back(0, 0.02 + 0.1 * std::sin(M_PI * u), 0.6 * u);
  }
  return path;
}

TEST(FootSteps, AFootStandsWhileItIsLowAndSlow) {
  const std::vector<char> standing = standing_frames(one_step(), fps);
  EXPECT_TRUE(standing.front());
  EXPECT_TRUE(standing[58]);
  EXPECT_FALSE(standing[75]);
  EXPECT_TRUE(standing[92]);
  EXPECT_TRUE(standing.back());
}

TEST(FootSteps, GapsAndRunsOfThreeFramesAreNone) {
  std::vector<Vec3> path = one_step();
  for (int f = 30; f < 33; ++f) path[static_cast<std::size_t>(f)].y() = 0.2;   // a glitch while standing
  for (int f = 74; f < 77; ++f) path[static_cast<std::size_t>(f)] = path[73];  // stops in the air
  const std::vector<char> standing = standing_frames(path, fps);
  for (std::size_t f = 28; f < 36; ++f) EXPECT_TRUE(standing[f]) << f;
  for (std::size_t f = 70; f < 80; ++f) EXPECT_FALSE(standing[f]) << f;
}

TEST(FootSteps, AStandingFootIsMovedByTheMeanOfWhatIsWantedThere) {
  const std::vector<char> standing = {0, 1, 1, 1, 0, 0, 0, 1, 1, 0};
  std::vector<Vec3> wanted;
  for (std::size_t f = 0; f < standing.size(); ++f)
    wanted.emplace_back(static_cast<double>(f), 0, -2.0 * static_cast<double>(f));
  const std::vector<Vec3> offsets = stepwise(wanted, standing);
  // Means of frames 1 to 3 and 7 to 8; frames 4 to 6 are a quarter, half and three quarters of the way.
  const double expected[] = {2, 2, 2, 2, 2 + 5.5 * 0.15625, 2 + 5.5 * 0.5, 2 + 5.5 * 0.84375, 7.5, 7.5, 7.5};
  for (std::size_t f = 0; f < offsets.size(); ++f) {
    EXPECT_NEAR(offsets[f].x(), expected[f], 1e-12) << f;
    EXPECT_NEAR(offsets[f].z(), -2 * expected[f], 1e-12) << f;
  }
}

TEST(FootSteps, AFootThatNeverStandsGoesWhereItIsWanted) {
  const std::vector<Vec3> wanted = {Vec3(1, 0, 2), Vec3(3, 0, 4)};
  EXPECT_EQ(stepwise(wanted, std::vector<char>{0, 0}), wanted);
}

}  // namespace
}  // namespace abrazo::foot_steps_test
