#include "core/metrics/movement.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/statistics.hpp"
#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::movement_test {
namespace {

constexpr ToeRest rest = {0.04, 0.04};

Pose at(double x_m) {
  return test::moved(test::standing_pose(), 0, {x_m, 0, 0});
}

MovementMetric moved_by(double fps, int steps, const auto& place_m) {
  MovementMetric metric(rest);
  for (int i = 0; i <= steps; ++i) metric.add(at(place_m(i / fps)), 3 + i / fps);
  return metric;
}

TEST(Quantile, LiesBetweenTwoValuesByItsDistanceFromThem) {
  EXPECT_EQ(quantile({3, 1, 2}, 0.5), 2);
  EXPECT_EQ(quantile({4, 1, 2, 3}, 0.5), 2.5);
  EXPECT_NEAR(quantile({0, 10}, 0.99), 9.9, 1e-12);
  EXPECT_EQ(quantile({5, 7}, 1), 7);
  EXPECT_EQ(quantile({5}, 0.3), 5);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
  EXPECT_NEAR(root_mean_square({3, 4}), std::sqrt(12.5), 1e-12);
  EXPECT_TRUE(std::isnan(root_mean_square({})));
}

TEST(Movement, OfSomebodyWhoGlidesIsTheirSpeedAtAnyRate) {
  for (const double fps : {15.0, 60.0, 120.0}) {
    const auto f = moved_by(fps, 100, [](double t) { return 1.5 * t; }).figures();
    EXPECT_NEAR(f.speed_p50_m_s, 1.5, 1e-9) << fps;
    EXPECT_NEAR(f.speed_p99_m_s, 1.5, 1e-9) << fps;
    EXPECT_NEAR(f.speed_rms_m_s, 1.5, 1e-9) << fps;
    EXPECT_NEAR(f.acceleration_rms_m_s2, 0, 1e-6) << fps;
    EXPECT_NEAR(f.largest_step_m, 1.5 / fps, 1e-9) << fps;
    EXPECT_NEAR(f.slide.mean_m_s, 1.5, 1e-9) << fps;
  }
}

TEST(Movement, AccelerationIsThatOfSomebodyWhoFalls) {
  for (const double fps : {15.0, 60.0}) {
    const auto f = moved_by(fps, 60, [](double t) { return 0.5 * 9.81 * t * t; }).figures();
    EXPECT_NEAR(f.acceleration_p50_m_s2, 9.81, 1e-8) << fps;
    EXPECT_NEAR(f.acceleration_p99_m_s2, 9.81, 1e-8) << fps;
    EXPECT_NEAR(f.acceleration_rms_m_s2, 9.81, 1e-8) << fps;
  }
}

TEST(Movement, AccelerationIsTheSameWhenStepsAreUnevenlyApart) {
  MovementMetric metric(rest);
  double t = 0;
  for (int i = 0; i < 60; ++i, t += i % 3 == 0 ? 0.03 : 0.01) metric.add(at(0.5 * 9.81 * t * t), t);
  EXPECT_NEAR(metric.figures().acceleration_rms_m_s2, 9.81, 1e-8);
}

TEST(Movement, OneJointOfTwentyFiveCountsAsOne) {
  MovementMetric metric(rest);
  Pose pose = test::standing_pose();
  metric.add(pose, 0);
  metric.add(pose, 0.1);
  pose(joints::Head, 1) += 0.5;  // 5 m/s, after none: 50 m/s^2
  const auto step = metric.add(pose, 0.2);
  const auto f = metric.figures();
  EXPECT_NEAR(f.speed_p99_m_s, 0.99 * 5.0 / 25, 1e-9);
  EXPECT_NEAR(f.acceleration_rms_m_s2, 50 / 5.0, 1e-9);
  ASSERT_TRUE(step && step->unexplained_m);
  EXPECT_NEAR(*step->unexplained_m, 0.5 / 25, 1e-12);
}

TEST(Movement, AcrossAnInterruptionThereIsNone) {
  MovementMetric metric(rest);
  metric.add(at(0), 0);
  metric.add(at(0.01), 0.1);
  metric.interrupt();
  EXPECT_FALSE(metric.add(at(5), 0.2));
  EXPECT_FALSE(metric.add(at(5.01), 0.3)->acceleration_m_s2);
  metric.add(at(9), 0.3);  // no time passed
  metric.add(at(9.01), 0.4);
  const auto f = metric.figures();
  EXPECT_NEAR(f.largest_step_m, 0.01, 1e-9);
  EXPECT_TRUE(std::isnan(f.acceleration_rms_m_s2)) << "no three poses in a row";
}

TEST(Movement, OfNothingIsNotANumber) {
  const auto f = MovementMetric(rest).figures();
  for (const double value : {f.speed_p50_m_s, f.speed_rms_m_s, f.acceleration_p99_m_s2, f.largest_step_m})
    EXPECT_TRUE(std::isnan(value));
}

}  // namespace
}  // namespace abrazo::movement_test
