#include "core/motion/body/smooth_window.hpp"

#include <gtest/gtest.h>

namespace abrazo::smooth_window_test {
namespace {

TEST(SmoothWindow, HannWeightsOfThreeAreOneTwoOne) {
  const auto mean = hann_mean(std::vector<double>{0, 0, 4, 0, 0}, 1);
  EXPECT_NEAR(mean[1], 1, 1e-12);
  EXPECT_NEAR(mean[2], 2, 1e-12);
  EXPECT_NEAR(mean[3], 1, 1e-12);
  EXPECT_NEAR(mean[0], 0, 1e-12);
}

TEST(SmoothWindow, AConstantStaysToTheEnds) {
  for (const double value : hann_mean(std::vector<double>(7, 3.5), 3)) EXPECT_NEAR(value, 3.5, 1e-12);
}

TEST(SmoothWindow, TheMaximumReachesHalfAWidthToEitherSide) {
  EXPECT_EQ(moving_maximum({0, 0, 0, 5, 0, 0, 1}, 2), (std::vector<double>{0, 5, 5, 5, 5, 5, 1}));
}

}  // namespace
}  // namespace abrazo::smooth_window_test
