#include "core/annotation/couple_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/annotation/motion_channels.hpp"
#include "core/annotation/segment_features.hpp"
#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::couple_geometry_test {
namespace {

constexpr double half_turn = std::numbers::pi;
constexpr double full_turn = 2 * std::numbers::pi;
constexpr int frames = 61;

/// A stands at the origin facing +Z, B one metre before A and facing A; `where` places B by frame.
template <typename Where>
CoupleMotion couple(const Where& where) {
  CoupleMotion motion;
  motion.fps = 30;
  for (int f = 0; f < frames; ++f) {
    motion.frames.push_back(2 * f);
    motion.a.push_back(test::standing_pose());
    const auto [yaw, offset] = where(static_cast<double>(f) / (frames - 1));
    motion.b.push_back(test::moved(test::standing_pose(), yaw, offset));
  }
  return motion;
}

CoupleMotion facing_couple_in_which_b_turns(double turns) {
  return couple([turns](double t) { return std::pair(half_turn + turns * t * full_turn, Vec3(0, 0, 1)); });
}

/// B walks half a circle about A to A's back and always faces A.
CoupleMotion couple_that_changes_places(double turns) {
  return couple([turns](double t) {
    const double line = turns * t * full_turn;
    return std::pair(half_turn + line, Vec3(std::sin(line), 0, std::cos(line)));
  });
}

double change_of_n_b(const CoupleGeometry& geometry) {
  return geometry.n_b(frames - 1) - geometry.n_b(0);
}

TEST(CoupleGeometry, CountsALeftTurnOfBAsPlusOne) {
  const CoupleGeometry geometry = couple_geometry(facing_couple_in_which_b_turns(1));
  EXPECT_NEAR(change_of_n_b(geometry), 1, 1e-6);
  EXPECT_NEAR(geometry.n_a(frames - 1) - geometry.n_a(0), 0, 1e-6);
}

TEST(CoupleGeometry, CountsARightTurnAsMinusOne) {
  EXPECT_NEAR(change_of_n_b(couple_geometry(facing_couple_in_which_b_turns(-1))), -1, 1e-6);
}

TEST(CoupleGeometry, CountsPlacesExchangedToTheLeftAsHalfATurnOfTheLine) {
  const CoupleGeometry geometry = couple_geometry(couple_that_changes_places(0.5));
  EXPECT_NEAR(geometry.orb.back() - geometry.orb.front(), 0.5, 1e-6);
  EXPECT_NEAR(change_of_n_b(geometry), 0, 1e-3) << "who goes on facing the other has not turned";
}

TEST(CoupleGeometry, DoesNotCountWhatTheCoupleTurnsAsAWhole) {
  CoupleMotion motion = facing_couple_in_which_b_turns(0);
  for (int f = 0; f < frames; ++f) {
    const double yaw = full_turn * f / (frames - 1);
    motion.a[static_cast<std::size_t>(f)] =
        test::moved(motion.a[static_cast<std::size_t>(f)], yaw, Vec3::Zero());
    motion.b[static_cast<std::size_t>(f)] =
        test::moved(motion.b[static_cast<std::size_t>(f)], yaw, Vec3::Zero());
  }
  const CoupleGeometry geometry = couple_geometry(motion);
  EXPECT_NEAR(change_of_n_b(geometry), 0, 1e-6);
  EXPECT_NEAR(geometry.n_a(frames - 1) - geometry.n_a(0), 0, 1e-6);
  EXPECT_NEAR(geometry.orb.back() - geometry.orb.front(), 1, 1e-6);
}

TEST(CoupleGeometry, MeasuresBetweenTheHandsThatHold) {
  const Pose a = test::standing_pose();
  Pose b = test::moved(a, half_turn, Vec3(0, 0, 1));
  b.row(joints::right_hand) = a.row(joints::left_hand) + Eigen::RowVector3d(0.1, 0, 0);
  EXPECT_NEAR(hand_distance(a, b, HandPair::LeftRight), 0.1, 1e-12);
  EXPECT_LT(hand_distance(a, b, HandPair::LeftRight), held_hands_m);
  EXPECT_GT(hand_distance(a, b, HandPair::RightLeft), held_hands_m);
}

TEST(CoupleGeometry, SeesAHandOnTheBackOnlyBehindTheChest) {
  const Pose b = test::standing_pose();  // faces +Z: the back is towards -Z
  const Vec3 thorax = b.row(joints::Thorax).transpose();
  EXPECT_NEAR(back_distance(thorax - Vec3(0, 0, 0.1), b), 0.1, 0.02);
  EXPECT_EQ(back_distance(thorax + Vec3(0, 0, 0.1), b), far_m);
}

TEST(TurnCount, KnowsNetTurnRiseAndFall) {
  const std::vector<double> in_and_out = {0, 0.3, 0.6, 0.7, 0.4, 0.1};
  const TurnCount count = turn_count(in_and_out, 0, 6);
  EXPECT_NEAR(count.net, 0.1, 1e-12);
  EXPECT_NEAR(count.rise, 0.7, 1e-12);
  EXPECT_NEAR(count.fall, 0.6, 1e-12);
  EXPECT_NEAR(count.drop, 0.6, 1e-12);
}

TEST(SegmentFeatures, AreTheSameWhereverTheCoupleIs) {
  CoupleMotion motion = facing_couple_in_which_b_turns(1), elsewhere = motion;
  for (std::vector<Pose>* poses : {&elsewhere.a, &elsewhere.b})
    for (Pose& pose : *poses) pose = test::moved(pose, 0.7, Vec3(3, 0, -2));
  const auto described = [](const CoupleMotion& of) {
    const MotionChannels channels = motion_channels(of, couple_geometry(of), false);
    const SegmentFeatures features(channels);
    Eigen::RowVectorXf row(features.count());
    features.describe(5, 50, row.data());
    return row;
  };
  EXPECT_LT((described(motion) - described(elsewhere)).cwiseAbs().maxCoeff(), 1e-4F);
}

TEST(MotionChannels, OfExchangedPerformersAreThoseOfTheOtherOrder) {
  CoupleMotion motion = facing_couple_in_which_b_turns(1), exchanged = motion;
  std::swap(exchanged.a, exchanged.b);
  const MotionChannels b_active = motion_channels(motion, couple_geometry(motion), true);
  const MotionChannels a_active = motion_channels(exchanged, couple_geometry(exchanged), false);
  EXPECT_LT((b_active.values - a_active.values).cwiseAbs().maxCoeff(), 1e-4F);
}

TEST(MotionChannels, SeeWhoMovesFirst) {
  CoupleMotion motion = facing_couple_in_which_b_turns(0);
  for (int f = 0; f < frames; ++f) {  // B does what A did a quarter of a second before
    const auto step = [](double t_s) { return 0.2 * std::exp(-std::pow((t_s - 0.8) / 0.15, 2)); };
    const double t_s = f / motion.fps;
    motion.a[static_cast<std::size_t>(f)].col(0).array() += step(t_s);
    motion.b[static_cast<std::size_t>(f)].col(0).array() += step(t_s - 0.25);
  }
  const auto lead = [&](bool b_is_active) {
    return motion_channels(motion, couple_geometry(motion), b_is_active)
        .values.rightCols(lead_channel_count)
        .mean();
  };
  EXPECT_GT(lead(false), 0.05);
  EXPECT_LT(lead(true), -0.05);
}

}  // namespace
}  // namespace abrazo::couple_geometry_test
