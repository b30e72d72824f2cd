// The cutting plane in the hand: how far a drag moves it, from wherever it is seen, and where a new one
// stands.
#include "widgets/scene/values/cut_handles.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "tests/widgets/plain_camera.hpp"

namespace abrazo::widgets::cut_handles_test {
namespace {

using test::plain_camera;

constexpr double width = 800, height = 600, pi = 3.14159265358979323846, degree = pi / 180;
constexpr double pixel_m = 1.0 / 300;  ///< at the target of the camera

/// A plane through the target.
CutHandles handles_of(double azimuth_rad, double elevation_rad = 0) {
  return {CutPlane{Vec3::Zero(), direction_of(azimuth_rad, elevation_rad)}, plain_camera(), width, height};
}

/// Held by the middle of its shaft's foot, which is the middle of the picture.
double moved_m(const CutHandles& handles, double right_px, double down_px) {
  return handles.moved_m(width / 2, height / 2, width / 2 + right_px, height / 2 + down_px);
}

TEST(CutHandles, FollowThePointerWhereTheNormalIsSeenFromTheSide) {
  for (const double turn : {35, 50, 90, 120, -60}) {
    const CutPlane plane{Vec3::Zero(), direction_of(turn * degree, 0)};
    const double by_m = moved_m(handles_of(turn * degree), 60, 0);
    const Vec3 moved = plane.point + by_m * plane.normal;
    const auto seen = PictureProjection(plain_camera(), width, height).project(moved);
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->x, width / 2 + 60, 1e-6) << turn;
  }
}

TEST(CutHandles, MoveByThePixelsSizeUpAndDownWhereTheNormalFacesTheEye) {
  EXPECT_NEAR(moved_m(handles_of(0), 0, 30), 30 * pixel_m, 1e-9) << "downwards is nearer";
  EXPECT_NEAR(moved_m(handles_of(0), 0, -1), -pixel_m, 1e-9);
  EXPECT_NEAR(moved_m(handles_of(pi), 0, 30), -30 * pixel_m, 1e-9) << "also if it points away";
  EXPECT_NEAR(moved_m(handles_of(0), 50, 0), 0, 1e-9);
}

TEST(CutHandles, OfAnEdgeMoveItTheWayTheEdgeMovesInThePicture) {
  const CutHandles facing = handles_of(0);
  const double lower_y = facing.outline[0]->y, upper_y = facing.outline[2]->y;
  ASSERT_GT(lower_y, upper_y);
  EXPECT_GT(facing.moved_m(width / 2, lower_y, width / 2, lower_y + 10), 0) << "nearer is larger";
  EXPECT_GT(facing.moved_m(width / 2, upper_y, width / 2, upper_y - 10), 0);
}

TEST(CutHandles, CanBeMovedFinelyFromEverySide) {
  for (int turn = 0; turn <= 180; ++turn)
    for (int tilt = -90; tilt <= 90; tilt += 5) {
      const CutHandles handles = handles_of(turn * degree, tilt * degree);
      const double right_m = std::abs(moved_m(handles, 1, 0)), down_m = std::abs(moved_m(handles, 0, 1));
      EXPECT_GT(std::max(right_m, down_m), 0.5 * pixel_m) << turn << " " << tilt;
      EXPECT_LE(std::max(right_m, down_m), 2 * pixel_m * (1 + 1e-9)) << turn << " " << tilt;
    }
}

TEST(CutHandles, DoNotJumpBetweenBothWaysOfDragging) {
  constexpr double step = 0.25;
  for (double turn = 0; turn < 90; turn += step) {
    const double here_m = moved_m(handles_of(turn * degree), 1, 1),
                 next_m = moved_m(handles_of((turn + step) * degree), 1, 1);
    EXPECT_NEAR(here_m, next_m, 0.1 * pixel_m) << turn;
  }
}

TEST(CutHandles, DoNotRunAwayTowardsTheVanishingPointOfTheNormal) {
  const CutHandles nearly_facing = handles_of(15 * degree);
  const double most_m = 2 * 380 * pixel_m;
  for (int right = -380; right <= 380; right += 20)
    EXPECT_LE(std::abs(moved_m(nearly_facing, right, 0)), most_m) << right;
}

/// Angle between the normal of a new plane and the direction to the eye [degrees].
double turned_degrees(double eye_rad, const Vec3& between) {
  return std::abs(std::remainder(new_cut_azimuth(eye_rad, between) - eye_rad, 2 * pi)) / degree;
}

TEST(NewCutPlane, IsTurnedFromTheEyeHoweverTheBodiesStand) {
  for (int eye = -180; eye <= 180; eye += 7)
    for (int line = 0; line < 360; line += 15) {
      const double turned = turned_degrees(eye * degree, direction_of(line * degree, 0));
      EXPECT_GE(turned, 40 - 1e-9) << eye << " " << line;
      EXPECT_LE(turned, 60 + 1e-9) << eye << " " << line;
    }
  EXPECT_GE(turned_degrees(0.3, Vec3::Zero()), 40 - 1e-9) << "bodies at one place have no line";
}

TEST(NewCutPlane, StandsAlongTheLineBetweenTheBodiesIfThatIsSeenAside) {
  const Vec3 between = direction_of(140 * degree, 0);
  const double azimuth = new_cut_azimuth(0, between);
  EXPECT_NEAR(azimuth / degree, 50, 1e-9);
  EXPECT_NEAR(direction_of(azimuth, 0).dot(between), 0, 1e-9);
}

}  // namespace
}  // namespace abrazo::widgets::cut_handles_test
