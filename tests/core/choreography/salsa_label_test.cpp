// Labels against the geometry they stand for, measured from the poses alone. Turns and directions are counted
// in whole turns, positive to the left.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/choreography/salsa.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo::salsa_label_test {
namespace {

using namespace joints;

Vec3 joint(const Pose& pose, int index) {
  return pose.row(index).transpose();
}
Vec3 level(const Vec3& v) {
  return {v.x(), 0, v.z()};
}

/// The value next to `before` among those that differ from `angle` by whole turns.
double unwrapped(double angle, double before) {
  return before + std::remainder(angle - before, 1.0);
}

/// Where the body faces: 0.6 hips + 0.4 shoulders.
double heading(const Pose& pose, double before) {
  const auto facing = [&](int left, int right, double near) {
    const Vec3 to_left = joint(pose, left) - joint(pose, right);
    return unwrapped(std::atan2(-to_left.z(), to_left.x()) / (2 * std::numbers::pi), near);
  };
  const double hips = facing(left_hip, right_hip, before);
  return 0.6 * hips + 0.4 * facing(left_shoulder, right_shoulder, hips);
}

/// Shares of the frames of a move.
struct Shares {
  double same_heading = 0;
  double hand_on_her_back = 0;
  std::map<std::string, double> holds;  ///< "Lr": his left, her right
};

struct Measured {
  double places = 0, his_turn = 0, her_turn = 0;  ///< over the move; turns relative to the partner
  double rise = 0, fall = 0;                      ///< of her turn
  Shares shares;
};

bool faces_the_same_way(const Pose& a, const Pose& b, double apart) {
  return std::abs(std::remainder(apart, 1.0)) < 70.0 / 360 &&
         level(joint(a, Root) - joint(b, Root)).norm() < 1.2;
}

bool right_hand_on_her_back(const Pose& a, const Pose& b) {
  const Vec3 hand = joint(a, right_hand);
  double nearest = 1e9;
  for (const int back : {LowerBack, UpperBack, Thorax})
    nearest = std::min(nearest, (hand - joint(b, back)).norm());
  const Vec3 forward = (joint(b, left_shoulder) - joint(b, right_shoulder)).cross(Vec3::UnitY());
  return nearest < 0.24 && (hand - joint(b, Thorax)).dot(forward) < 0;
}

void count_holds(const Pose& a, const Pose& b, double one, Shares& shares) {
  for (const auto& [his, h] : {std::pair(left_hand, 'L'), std::pair(right_hand, 'R')})
    for (const auto& [hers, r] : {std::pair(left_hand, 'l'), std::pair(right_hand, 'r')})
      if ((joint(a, his) - joint(b, hers)).norm() < 0.18) shares.holds[{h, r}] += one;
}

Measured measured(const PairedTake& take, const LabelInterval& move) {
  Measured sum;
  double his = 0, hers = 0, line = 0, lowest = 1e9, start_places = 0, start_his = 0, start_hers = 0;
  double highest_after_low = -1e9, her_relative = 0;
  for (int f = move.start; f < move.end; ++f) {
    const Pose &a = take.a.poses[static_cast<std::size_t>(f)], &b = take.b.poses[static_cast<std::size_t>(f)];
    his = heading(a, his), hers = heading(b, hers);
    const Vec3 d = joint(b, Root) - joint(a, Root);
    line = unwrapped(std::atan2(d.x(), d.z()) / (2 * std::numbers::pi), line);
    her_relative = hers - line;
    if (f == move.start) start_places = line, start_his = his - line, start_hers = her_relative;
    lowest = std::min(lowest, her_relative);
    if (her_relative - lowest > sum.rise) sum.rise = her_relative - lowest, highest_after_low = her_relative;
    sum.fall = std::max(sum.fall, highest_after_low - her_relative);
    const double one = 1.0 / (move.end - move.start);
    sum.shares.same_heading += faces_the_same_way(a, b, hers - his) ? one : 0;
    sum.shares.hand_on_her_back += right_hand_on_her_back(a, b) ? one : 0;
    count_holds(a, b, one, sum.shares);
  }
  sum.places = line - start_places;
  sum.his_turn = his - line - start_his;
  sum.her_turn = her_relative - start_hers;
  return sum;
}

/// The label that the geometry earns, tested in the order of the label definitions.
std::string earned_label(const Measured& move) {
  const bool one_turns = std::abs(move.her_turn) >= 0.7 || std::abs(move.his_turn) >= 0.7;
  if (!one_turns && move.rise >= 0.6 && move.fall >= 0.5 && std::abs(move.places) < 0.3) return "in_and_out";
  if (!one_turns && move.shares.same_heading >= 0.5 && std::abs(move.places) < 0.3) return "walk";
  if (one_turns || (move.places <= -0.3 && move.shares.hand_on_her_back < 0.5)) return "turn";
  if (move.places >= 0.3) return "cross_body_lead";
  return move.shares.hand_on_her_back >= 0.5 ? "closed_hold" : "open_hold";
}

void expect_true_details(const Measured& move, const std::string& detail) {
  const auto says = [&](const std::string& words) { return detail.find(words) != std::string::npos; };
  const auto expect_when_said = [&](const char* words, double value, double expected, double margin) {
    EXPECT_TRUE(!says(words) || std::abs(value - expected) < margin) << words << ": " << value;
  };
  expect_when_said("follower right", move.her_turn, -1, 0.2);
  expect_when_said("follower left", move.her_turn, 1, 0.2);
  expect_when_said("leader right", move.his_turn, -1, 0.2);
  expect_when_said("leader left", move.his_turn, 1, 0.2);
  expect_when_said("places exchanged left", move.places, 0.5, 0.15);
  expect_when_said("in place", move.places, 0, 0.3);
  EXPECT_TRUE(!says("RHback") || move.shares.hand_on_her_back > 0.4) << move.shares.hand_on_her_back;
  for (const char* hold : {"Lr", "Rl", "Ll", "Rr"}) {
    const double share = move.shares.holds.contains(hold) ? move.shares.holds.at(hold) : 0;
    EXPECT_TRUE(!says(hold) || share > 0.35) << hold << ": " << share;
  }
}

void expect_true_labels(const ChoreographyOptions& options) {
  std::map<std::string, int> count;
  for (const PairedTake& take : generate_salsa(options))
    for (const LabelInterval& move : take.labels) {
      SCOPED_TRACE(take.name + " frame " + std::to_string(move.start) + " " + move.label + " " + move.detail);
      const Measured geometry = measured(take, move);
      EXPECT_EQ(earned_label(geometry), move.label);
      expect_true_details(geometry, move.detail);
      ++count[move.label];
    }
  EXPECT_EQ(count.size(), 6U);
}

TEST(SalsaLabels, AreEarnedByTheGeometry) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) expect_true_labels({.seed = seed, .minutes = 5});
}

TEST(SalsaLabels, AreEarnedAtEveryTempo) {
  for (const double tempo : {160.0, 190.0}) expect_true_labels({.minutes = 2, .tempo_bpm = tempo});
}

TEST(SalsaLabels, AreEarnedByDancersOfOtherBuilds) {
  expect_true_labels({.minutes = 2, .a = {.height_m = 1.92, .arm_scale = 0.95}, .b = {.height_m = 1.58}});
  expect_true_labels({.minutes = 2, .a = {.height_m = 1.70}, .b = {.height_m = 1.78, .leg_scale = 1.1}});
}

TEST(SalsaLabels, AreEarnedByABeginnerWhoLeads) {
  expect_true_labels({.minutes = 3, .a = {.height_m = 1.80, .performance = performance_of_skill(0.5)}});
}

TEST(SalsaLabels, AreAboutEquallyFrequent) {
  std::map<std::string, int> count;
  int all = 0;
  for (const PairedTake& take : generate_salsa({.minutes = 20}))
    for (const LabelInterval& move : take.labels) ++count[move.label], ++all;
  // Drawn from a bag of twelve for every take of seven or eight: nearly, not exactly equal.
  for (const auto& [label, times] : count)
    EXPECT_NEAR(static_cast<double>(times) / all, 1.0 / 6, 0.03) << label;
}

}  // namespace
}  // namespace abrazo::salsa_label_test
