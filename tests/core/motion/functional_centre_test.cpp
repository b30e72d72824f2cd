// Hip joint centres from the motion of the thigh, on bodies whose centres are known.
#include "core/motion/joints/functional_centre.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "core/motion/files/import_clip.hpp"
#include "tests/core/motion/marker_body.hpp"
#include "tests/core/motion/motion_fixtures.hpp"

namespace abrazo::functional_centre_test {
namespace {

using test::has_warning;
using test::the_warning;
using ::testing::HasSubstr;

constexpr double degree = std::numbers::pi / 180;
const Vec3 hip(0.09, -0.08, -0.05);

/// Flexion and abduction of a thigh that swings to and fro in many directions (a star), in turn.
Eigen::Matrix3d swing(int frame, int frames, double flexion_rad, double abduction_rad) {
  const double t = 2 * std::numbers::pi * frame / frames;
  return (Eigen::AngleAxisd(flexion_rad / 2 * std::sin(7 * t), Vec3::UnitX()) *
          Eigen::AngleAxisd(abduction_rad / 2 * std::sin(5 * t + 0.4), Vec3::UnitZ()))
      .toRotationMatrix();
}

/// Two markers on a thigh that turns about `hip`, with noise in each coordinate.
std::vector<Positions> thigh(int frames, double flexion_rad, double abduction_rad, double noise_m) {
  const std::vector<Vec3> markers = {{0.06, -0.41, 0.01}, {0.09, -0.20, 0.02}};
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 1);
  std::vector<Positions> trajectories(2, Positions(frames, 3));
  for (int f = 0; f < frames; ++f)
    for (std::size_t m = 0; m < 2; ++m)
      trajectories[m].row(f) = (hip + swing(f, frames, flexion_rad, abduction_rad) * markers[m] +
                                noise_m * Vec3(noise(random), noise(random), noise(random)))
                                   .transpose();
  return trajectories;
}

TEST(FunctionalCentre, IsExactWithoutNoise) {
  const auto found = functional_centre(thigh(200, 60 * degree, 40 * degree, 0));
  ASSERT_TRUE(found);
  EXPECT_LT((found->centre - hip).norm(), 1e-9);
  EXPECT_LT(found->noise_m, 1e-6);
  // Of a sine, the 5th to 95th percentile is 0.988 of its range.
  EXPECT_NEAR(found->range[0], 60 * degree, 4 * degree);
  EXPECT_NEAR(found->range[1], 40 * degree, 6 * degree);
}

TEST(FunctionalCentre, IsWithinSomeMillimetresWithNoiseAndWithoutBias) {
  for (const double noise_m : {0.001, 0.003, 0.006}) {
    const auto found = functional_centre(thigh(1500, 70 * degree, 45 * degree, noise_m));
    ASSERT_TRUE(found);
    EXPECT_LT((found->centre - hip).norm(), noise_m) << noise_m;
    EXPECT_NEAR(found->noise_m, noise_m, 0.05 * noise_m);
    EXPECT_TRUE(is_better_than_regression(*found)) << noise_m;
  }
}

TEST(FunctionalCentre, IsNotTrustedWhereTheMotionTellsLittle) {
  const auto trusts = [](double flexion_deg, double abduction_deg, double noise_m) {
    const auto found = functional_centre(thigh(600, flexion_deg * degree, abduction_deg * degree, noise_m));
    return found && is_better_than_regression(*found);
  };
  EXPECT_TRUE(trusts(60, 40, 0.002));
  EXPECT_FALSE(trusts(45, 12, 0.0002)) << "walking";
  EXPECT_FALSE(trusts(30, 30, 0.0002));
  EXPECT_FALSE(trusts(60, 40, 0.02)) << "the skin slides";
  EXPECT_FALSE(functional_centre(thigh(600, 60 * degree, 0, 0))) << "one plane tells no centre";
  EXPECT_FALSE(functional_centre(thigh(600, 0, 0, 0)));
  EXPECT_FALSE(functional_centre(thigh(5, 60 * degree, 40 * degree, 0)));
  EXPECT_FALSE(functional_centre({}));
}

/// The marked body, whose legs swing about hips that are `off` from where the regression has them (mirrored
/// on the right), while the body turns and walks.
test::MarkedBody swinging_body(int frames, double flexion_deg, double abduction_deg, const Vec3& off,
                               double noise_m) {
  test::MarkedBody body = test::marked_body(frames, 0.2);
  const NamedMotion still = test::marked_body(1, 0.2).markers;
  const Pose standing = test::marked_body(1, 0.2).poses.front();
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 1);
  for (int f = 0; f < frames; ++f) {
    const auto index = static_cast<std::size_t>(f);
    const Eigen::Affine3d world = Eigen::Translation3d(0.01 * f, 0, 0.3 * std::sin(0.05 * f)) *
                                  Eigen::AngleAxisd(0.03 * f, Vec3::UnitY());
    for (const int side : {1, -1}) {
      const int joint = side > 0 ? joints::left_hip : joints::right_hip;
      const Vec3 centre = standing.row(joint).transpose() + Vec3(side * off.x(), off.y(), off.z());
      const Eigen::Matrix3d turn =
          swing(f + (side > 0 ? 0 : frames / 3), frames, flexion_deg * degree, abduction_deg * degree);
      body.poses[index].row(joint) = (world * centre).transpose();
      for (const char* part : {"KNE", "THI", "ANK", "TIB", "TOE", "HEE"}) {
        const std::string name = (side > 0 ? "L" : "R") + std::string(part);
        const auto row = std::ranges::find(still.points, name) - still.points.begin();
        const Vec3 place = still.frames[0].row(row).transpose();
        body.markers.frames[index].row(row) = (world * (centre + turn * (place - centre))).transpose();
      }
    }
    for (Eigen::Index i = 0; i < body.markers.frames[index].size(); ++i)
      body.markers.frames[index].data()[i] += noise_m * noise(random);
  }
  return body;
}

/// Root mean square distance of both hips from the true ones [m].
double hip_error(const test::MarkedBody& body, const ImportedClip& clip) {
  double sum = 0;
  for (std::size_t f = 0; f < body.poses.size(); ++f)
    for (const int joint : {joints::left_hip, joints::right_hip})
      sum += (clip.clip.poses[f].row(joint) - body.poses[f].row(joint)).squaredNorm();
  return std::sqrt(sum / (2.0 * static_cast<double>(body.poses.size())));
}

TEST(FunctionalHips, AreFoundWhereTheyAreAndNotWhereTheRegressionHasThem) {
  const Vec3 off(0.008, -0.006, 0.010);  // 14 mm
  const test::MarkedBody body = swinging_body(1200, 70, 45, off, 0.001);
  const auto clip = import_clip(body.markers, {});
  ASSERT_TRUE(clip) << clip.error().text();
  EXPECT_LT(hip_error(body, *clip), 0.003);
  const std::string said = the_warning(clip->report.warnings, "functional-joints").detail;
  EXPECT_THAT(said,
              HasSubstr("2 of the 2 hip joints were found from the motion of the markers on the thigh"));
  EXPECT_THAT(said, testing::ContainsRegex("lhipjoint \\(thigh over [67][0-9] by [34][0-9] degrees, expected "
                                           "error [0-9.]+ mm, 1[345] mm from the regression\\)"));
  EXPECT_FALSE(clip->report.asks()) << "this is no question";
}

TEST(FunctionalHips, AreThoseOfTheRegressionWhereTheLegsHardlySwing) {
  const test::MarkedBody body = swinging_body(600, 40, 10, Vec3::Zero(), 0.001);
  const auto clip = import_clip(body.markers, {});
  ASSERT_TRUE(clip) << clip.error().text();
  EXPECT_FALSE(has_warning(clip->report.warnings, "functional-joints"));
  EXPECT_LT(hip_error(body, *clip), 0.003);
}

TEST(FunctionalHips, AreThoseOfTheRegressionWhereMarkersAreNotWhatTheyAreCalled) {
  const test::MarkedBody body = swinging_body(1200, 70, 45, Vec3(0.03, -0.05, 0.02), 0.001);
  const auto clip = import_clip(body.markers, {});
  ASSERT_TRUE(clip) << clip.error().text();
  EXPECT_FALSE(has_warning(clip->report.warnings, "functional-joints"));
}

}  // namespace
}  // namespace abrazo::functional_centre_test
