#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <utility>

#include "core/mesh/capsules.hpp"
#include "tests/support/bodies.hpp"
#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/common/value_range.hpp"
#include "widgets/scene/actors/capsule_surface.hpp"
#include "widgets/scene/values/mesh_scalar.hpp"
#include "widgets/scene/values/orbit_camera.hpp"
#include "widgets/scene/values/pair_camera.hpp"
#include "widgets/scene/values/smoothing_budget.hpp"
#include "widgets/settings/slider_scale.hpp"

namespace abrazo::widgets::scene_arithmetic_test {
namespace {

TEST(OrbitCamera, TurnsAboutItsTargetAtTheSameDistance) {
  OrbitCamera camera;
  camera.orbit(120, -300);
  EXPECT_NEAR((camera.position() - camera.target).norm(), camera.distance_m, 1e-12);
  EXPECT_NEAR(camera.right().dot(camera.up()), 0, 1e-12);
  EXPECT_GT(camera.up().y(), 0);
}

TEST(OrbitCamera, PanKeepsThePointUnderThePointer) {
  OrbitCamera camera;
  const double height = 600, metres = 2 * camera.distance_m * std::tan(camera.view_angle_rad / 2);
  const Vec3 right = camera.right(), before = camera.target;
  camera.pan(height, 0, height);  // as far as the view is high
  EXPECT_NEAR((camera.target - before).dot(right), -metres, 1e-9);
}

/// Where a joint is in the picture: (0, 0) the middle, 1 the upper and right edge.
std::pair<double, double> place_in_picture(const OrbitCamera& camera, const Vec3& joint, double aspect) {
  const Vec3 offset = joint - camera.position();
  const double depth = offset.dot((camera.target - camera.position()).normalized());
  const double half = depth * std::tan(camera.view_angle_rad / 2);
  return {offset.dot(camera.right()) / (half * aspect), offset.dot(camera.up()) / half};
}

TEST(OrbitCamera, TheDistanceThatFitsKeepsEveryJointInThePictureAlsoInANarrowOne) {
  for (const double aspect : {0.5, 1.0, 2.5}) {
    OrbitCamera camera;
    const PairPose pair = test::facing_pair(0.8);
    camera.distance_m = camera.distance_for(pair, {aspect, 0.8});
    for (int joint = 0; joint < pair.rows(); ++joint) {
      const auto [x, y] = place_in_picture(camera, pair.row(joint).transpose(), aspect);
      EXPECT_LT(std::abs(x), 0.84);
      EXPECT_LT(std::abs(y), 0.80);
    }
  }
}

/// As `facing_pair`, walked and turned about the vertical.
PairPose moved_pair(double x, double angle_rad) {
  PairPose pair = test::facing_pair(0.8);
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  for (int joint = 0; joint < pair.rows(); ++joint) {
    const double px = pair(joint, 0), pz = pair(joint, 2);
    pair(joint, 0) = c * px + s * pz + x;
    pair(joint, 2) = c * pz - s * px;
  }
  return pair;
}

/// Between the line through the two roots and the direction of view [rad], 0 to pi/2.
double angle_beside(const OrbitCamera& camera, const PairPose& pair) {
  Vec3 line = (pair.row(joint_count) - pair.row(0)).transpose();
  line.y() = 0;
  return std::acos(std::min(1.0, std::abs(line.normalized().dot(camera.right().cross(Vec3(0, 1, 0))))));
}

TEST(PairCamera, BeginsBesideThePairWhicheverWayItStands) {
  for (const double angle : {0.0, 1.0, 2.5, -2.0}) {
    OrbitCamera camera;
    PairCamera().start(camera, moved_pair(3, angle), {});
    EXPECT_GT(angle_beside(camera, moved_pair(3, angle)), 1.2) << angle;
    EXPECT_NEAR(camera.target.x(), 3, 0.5);
  }
}

TEST(PairCamera, StaysWhereItIsWhileThePairOnlySways) {
  OrbitCamera camera;
  PairCamera follower;
  follower.start(camera, moved_pair(0, 0), {});
  const Vec3 before = camera.position();
  for (int i = 0; i < 60; ++i) follower.follow(camera, moved_pair(0.15, 0.2), {}, 1.0 / 60);
  EXPECT_LT((camera.position() - before).norm(), 1e-9);
}

TEST(PairCamera, GoesAlongCalmlyWhenThePairWalksAndTurns) {
  OrbitCamera camera;
  PairCamera follower;
  follower.start(camera, moved_pair(0, 0), {});
  Vec3 before = camera.position();
  for (int i = 0; i < 600; ++i) {
    const PairPose pair = moved_pair(i / 300.0, i / 300.0);
    follower.follow(camera, pair, {}, 1.0 / 60);
    EXPECT_LT((camera.position() - before).norm() * 60, 4.0) << "metres a second";
    before = camera.position();
  }
  EXPECT_NEAR(camera.target.x(), 2, 0.7);
  EXPECT_GT(angle_beside(camera, moved_pair(2, 2)), 0.55) << "it lags, and stays beside";
}

/// Whether every joint is in the picture.
bool is_whole(const OrbitCamera& camera, const PairPose& pair, const PictureShape& picture) {
  const double slope = std::tan(camera.view_angle_rad / 2);
  const Vec3 ahead = (camera.focus() - camera.position()).normalized();
  for (int joint = 0; joint < pair.rows(); ++joint) {
    const Vec3 from_camera = pair.row(joint).transpose() - camera.position();
    const double far = from_camera.dot(ahead);
    if (std::abs(from_camera.dot(camera.right())) > far * slope * picture.aspect ||
        std::abs(from_camera.dot(camera.up())) > far * slope)
      return false;
  }
  return true;
}

TEST(PairCamera, KeepsADancerWhoCrossesFastInANarrowPicture) {
  for (const double aspect : {0.7, 1.0, 1.8}) {
    const PictureShape picture{aspect};
    OrbitCamera camera;
    PairCamera follower;
    follower.start(camera, moved_pair(0, 0), picture);
    // One crosses in front of the other within a second, and both walk on to one side.
    for (int i = 0; i < 120; ++i) {
      PairPose pair = moved_pair(0, 0);
      const double gone_m = 2 * std::min(i / 60.0, 1.0);
      for (int joint = 0; joint < joint_count; ++joint) pair(joint, 2) += 1.5 * gone_m;
      follower.follow(camera, pair, picture, 1.0 / 60);
      ASSERT_TRUE(is_whole(camera, pair, picture)) << "aspect " << aspect << ", frame " << i;
    }
  }
}

TEST(PairCamera, LeavesTheDirectionAlonePastATurnByHand) {
  OrbitCamera camera;
  PairCamera follower;
  follower.start(camera, moved_pair(0, 0), {});
  follower.turned_by_hand();
  camera.azimuth_rad += 1.4;
  const double chosen = camera.azimuth_rad;
  for (int i = 0; i < 300; ++i) follower.follow(camera, moved_pair(0, 1), {}, 1.0 / 60);
  EXPECT_DOUBLE_EQ(camera.azimuth_rad, chosen);
}

TEST(RobustUpper, ReachesTheLargestOfOrdinaryValues) {
  std::vector<double> values;
  for (int i = 0; i <= 100; ++i) values.push_back(0.01 * i);
  EXPECT_DOUBLE_EQ(robust_upper(values), 1);
  EXPECT_DOUBLE_EQ(robust_upper({}), 0);
}

TEST(RobustUpper, DoesNotFollowASpikeOrWhatIsNotANumber) {
  std::vector<double> values(600, 0.02);
  values[17] = 30;
  values[18] = std::numeric_limits<double>::quiet_NaN();
  values[19] = std::numeric_limits<double>::infinity();
  EXPECT_LT(robust_upper(values), 0.03);
}

TEST(RobustUpper, ShowsASpikeWhereEverythingElseIsZero) {
  std::vector<double> values(600, 0.0);
  values[17] = 3;
  EXPECT_DOUBLE_EQ(robust_upper(values), 3);
}

TEST(CapsuleSurface, LiesOneRadiusFromItsBone) {
  std::array<double, bone_count> radii{};
  radii[1] = 0.08;
  const CapsuleSurface surface(radii);
  const Pose pose = test::standing_pose();
  std::vector<float> points(static_cast<std::size_t>(3 * surface.point_count()));
  surface.place(pose, 1, 0.01, points);
  const Vec3 a = pose.row(bone(1).first), b = pose.row(bone(1).second);
  for (std::size_t p = 0; p < points.size(); p += 3) {
    const Vec3 point(points[p], points[p + 1], points[p + 2]);
    EXPECT_NEAR(closest_points(a, b, point, point).distance, 0.09, 1e-6);
  }
}

TEST(CapsuleSurface, HasRadiiInProportionToItsGirth) {
  CapsuleRadii radii{};
  radii[1] = 0.08;
  const CapsuleSurface surface(radii);
  const Pose pose = test::standing_pose();
  std::vector<float> points(static_cast<std::size_t>(3 * surface.point_count()));
  surface.place(pose, 1.5, 0.01, points);
  const Vec3 a = pose.row(bone(1).first), b = pose.row(bone(1).second);
  for (std::size_t p = 0; p < points.size(); p += 3) {
    const Vec3 point(points[p], points[p + 1], points[p + 2]);
    EXPECT_NEAR(closest_points(a, b, point, point).distance, 1.5 * 0.08 + 0.01, 1e-6)
        << "a silhouette is not thicker";
  }
}

TEST(CapsuleSurface, FacesOutwards) {
  const CapsuleSurface surface(generic_capsule_radii());
  const Pose pose = test::standing_pose();
  std::vector<float> points(static_cast<std::size_t>(3 * surface.point_count())), normals(points.size());
  surface.place(pose, 1, 0, points);
  surface.place_normals(pose, normals);
  const auto at = [](const std::vector<float>& list, std::int64_t i) {
    const auto base = static_cast<std::size_t>(3 * i);
    return Vec3(list[base], list[base + 1], list[base + 2]);
  };
  for (const auto& [i, j, k] : surface.triangles()) {
    const Vec3 u = at(points, j) - at(points, i), v = at(points, k) - at(points, i);
    const Vec3 facing(u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(),
                      u.x() * v.y() - u.y() * v.x());
    ASSERT_GE(facing.dot(at(normals, i)), -1e-12);
  }
}

TEST(MeshScalar, LengthChangeIsTheResultLessTheSelectedPair) {
  const auto frame = test::synthetic_frame(0, 0);
  const auto values = edge_scalars(*frame, MeshScalar::LengthChange);
  const MeshEdge& edge = frame->result.edges.back();
  const auto length = [&edge](const PairPose& pose) {
    return (pose.row(edge[0]) - pose.row(edge[1])).norm();
  };
  EXPECT_NEAR(values.back(), 1000 * (length(frame->result.result) - length(frame->result.selected_pair)),
              1e-9);
}

TEST(MeshScalar, MapsBeginAndEndWithTheirColours) {
  EXPECT_EQ(sequential_colour(0), (std::array<unsigned char, 3>{68, 1, 84}));
  EXPECT_EQ(sequential_colour(1), (std::array<unsigned char, 3>{253, 231, 37}));
  EXPECT_EQ(sequential_colour(7), sequential_colour(1));
  EXPECT_EQ(sequential_colour(0, ColourMap::Cividis), (Colour{0, 34, 78}));
  EXPECT_EQ(sequential_colour(1, ColourMap::Cividis), (Colour{254, 232, 56}));
}

/// The dark end of viridis was not seen on the dark scene, nor its bright end on the light one.
TEST(MeshScalar, EveryColourOfAMapDiffersFromTheBackgroundInBrightness) {
  for (const Theme theme : {Theme::Dark, Theme::Light})
    for (const ColourMap map : {ColourMap::Viridis, ColourMap::Cividis})
      for (int stop = 0; stop <= 20; ++stop) {
        const Palette& p = palette_of(theme);
        const auto [r, g, b] = sequential_colour(stop / 20.0, map, part_on(p.dark));
        for (const QColor& ground : {p.scene_top, p.scene_bottom})
          EXPECT_GT(contrast(QColor(r, g, b), ground), 2) << stop << (p.dark ? " dark" : " light");
      }
}

/// Red was not seen on the coral body, and blue not on the blue one.
TEST(MeshScalar, TheEndsOfTheDivergingMapHaveTheHueOfNoBody) {
  for (const Theme theme : {Theme::Dark, Theme::Light})
    for (const double end : {0.0, 1.0}) {
      const Palette& p = palette_of(theme);
      const auto [r, g, b] = diverging_colour(end);
      for (const QColor& body : {p.active, p.passive}) {
        const int apart = std::abs(QColor(r, g, b).hslHue() - body.hslHue());
        EXPECT_GT(std::min(apart, 360 - apart), 60) << end << ' ' << body.name().toStdString();
      }
    }
}

TEST(ColourScale, GivesWhatIsNoNumberAColourOfItsOwn) {
  for (const bool is_signed : {false, true})
    for (const ColourMap map : {ColourMap::Viridis, ColourMap::Cividis})
      EXPECT_EQ((ColourScale{10, is_signed, map, false}.colour(std::nan(""))), no_value_colour);
}

TEST(ColourScale, IsLinearOrTwoDecadesLongOrSigned) {
  const ColourScale linear{10}, logarithmic{10, false, ColourMap::Viridis, true}, both_ways{10, true};
  EXPECT_DOUBLE_EQ(linear.share(5), 0.5);
  EXPECT_DOUBLE_EQ(linear.share(-3), 0);
  EXPECT_DOUBLE_EQ(linear.share(70), 1);
  EXPECT_DOUBLE_EQ(logarithmic.share(10), 1);
  EXPECT_DOUBLE_EQ(logarithmic.share(1), 0.5);
  EXPECT_NEAR(logarithmic.share(0.1), 0, 1e-12);
  EXPECT_DOUBLE_EQ(logarithmic.share(0), 0);
  EXPECT_DOUBLE_EQ(both_ways.share(0), 0.5);
  EXPECT_DOUBLE_EQ(both_ways.share(-10), 0);
  ColourScale narrow{10};
  narrow.lower = 8;
  EXPECT_DOUBLE_EQ(narrow.share(9), 0.5);
  EXPECT_DOUBLE_EQ(narrow.share(3), 0) << "below the lower end";
  EXPECT_DOUBLE_EQ(ColourScale{}.share(3), 0) << "without a range everything is at the low end";
}

TEST(EdgeScalars, HaveNoNumberWhereTheFrameHasNone) {
  FrameSnapshot frame = *test::synthetic_frame(0, 0);
  frame.result.edge_residuals_m.resize(3);
  const std::vector<double> values = edge_scalars(frame, MeshScalar::Residual);
  EXPECT_FALSE(std::isnan(values[2]));
  EXPECT_TRUE(std::isnan(values[3]));
  EXPECT_TRUE(std::isfinite(typical_upper(frame.result.edges, values)));
}

TEST(SteadyRange, GrowsAtOnceAndShrinksAfterAWhile) {
  SteadyRange range;
  range.show(18, 0);
  EXPECT_DOUBLE_EQ(range.upper(), 20);
  range.show(70, 0.1);
  EXPECT_DOUBLE_EQ(range.upper(), 75);
  for (double time = 0.2; time < 1.5; time += 0.1) range.show(10, time);
  EXPECT_DOUBLE_EQ(range.upper(), 75);
  for (double time = 1.5; time < 4; time += 0.1) range.show(10, time);
  EXPECT_DOUBLE_EQ(range.upper(), 10);
}

TEST(SteadyRange, StaysWhenLocked) {
  SteadyRange range;
  range.show(18, 0);
  range.set_locked(true);
  range.show(500, 1);
  EXPECT_DOUBLE_EQ(range.upper(), 20);
}

TEST(SmoothingBudget, GivesUpSmoothEdgesOnlyWhileMovingOnASlowRenderer) {
  SmoothingBudget budget;
  EXPECT_FALSE(budget.wants_smoothing(true)) << "a first picture tells how quick the renderer is";
  EXPECT_TRUE(budget.wants_smoothing(false));
  budget.took(false, 5);
  EXPECT_TRUE(budget.wants_smoothing(true));
  for (int i = 0; i < 20; ++i) budget.took(true, 8);
  EXPECT_TRUE(budget.wants_smoothing(true));
  budget.took(true, 60);
  EXPECT_FALSE(budget.wants_smoothing(true));
  EXPECT_TRUE(budget.wants_smoothing(false));
  for (int i = 0; i < 1000; ++i) budget.took(false, 5);
  EXPECT_TRUE(budget.wants_smoothing(true)) << "a machine that was busy once is tried again";
}

TEST(SmoothingBudget, IsNotTriedAgainWherePicturesAreSlowWithoutIt) {
  SmoothingBudget budget;
  budget.took(true, 30);
  for (int i = 0; i < 10'000; ++i) budget.took(false, SmoothingBudget::affordable_ms + 1);
  EXPECT_FALSE(budget.wants_smoothing(true));
}

TEST(SliderScale, TakesValuesToPlacesAndBack) {
  const SliderScale plain{0, 2, false, false}, logarithmic{0.001, 10, true, false}, whole{1, 200, true, true};
  for (const double value : {0.0, 0.5, 2.0}) EXPECT_NEAR(plain.value(plain.place(value)), value, 1e-9);
  for (const double value : {0.001, 0.2, 10.0})
    EXPECT_NEAR(logarithmic.value(logarithmic.place(value)), value, 1e-9);
  for (const double value : {1.0, 10.0, 137.0}) EXPECT_DOUBLE_EQ(whole.value(whole.place(value)), value);
}

TEST(SliderScale, ALogarithmicScaleThatBeginsAtZeroReachesZero) {
  const SliderScale scale{0, 5, true, false};
  EXPECT_DOUBLE_EQ(scale.value(0), 0);
  EXPECT_DOUBLE_EQ(scale.value(1), 5);
  EXPECT_NEAR(scale.value(scale.place(0.2)), 0.2, 1e-9);
  EXPECT_DOUBLE_EQ(scale.place(0), 0);
}

TEST(Palette, TextCanBeReadOnEverySurface) {
  for (const Theme theme : {Theme::Dark, Theme::Light}) {
    const Palette& p = palette_of(theme);
    for (const QColor& surface : {p.window, p.panel, p.raised}) {
      EXPECT_GE(contrast(p.text, surface), 4.5);
      EXPECT_GE(contrast(p.secondary, surface), 4.5) << surface.name().toStdString();
    }
    EXPECT_GE(contrast(p.warning, p.panel), 4.5);
  }
}

TEST(Palette, KnowsAMoveHoweverItIsWritten) {
  const Palette& p = palette_of(Theme::Dark);
  EXPECT_EQ(label_colour(p, "open_hold"), QColor("#5aa9e6"));
  EXPECT_EQ(label_colour(p, "Cross body lead"), QColor("#e1a23b"));
  EXPECT_EQ(label_colour(p, "basic"), QColor("#59616e"));
  EXPECT_NE(label_colour(p, "unheard of"), label_colour(p, "basic"));
  EXPECT_NE(label_colour(p, "unheard of"), label_colour(p, "jab"));
  EXPECT_EQ(label_colour(p, "Low kick"), label_colour(p, "low_kick"));
}

}  // namespace
}  // namespace abrazo::widgets::scene_arithmetic_test
