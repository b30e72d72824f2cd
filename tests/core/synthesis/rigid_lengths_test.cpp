#include "core/synthesis/edit/rigid_lengths.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <stdexcept>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::rigid_lengths_test {
namespace {

constexpr std::array girdle = {joints::Thorax, joints::LowerNeck, joints::LeftClavicle,
                               joints::RightClavicle};

double& length_between(RigidDistances& lengths, int a, int b) {
  for (RigidDistance& rigid : lengths)
    if ((rigid.a == a && rigid.b == b) || (rigid.a == b && rigid.b == a)) return rigid.length_m;
  throw std::out_of_range("no such distance");
}

/// Cayley-Menger: 288 times the squared volume [m^6]; negative when no four points have these distances.
double squared_volume(RigidDistances lengths, int first_vertex) {
  Eigen::Matrix<double, 5, 5> m = Eigen::Matrix<double, 5, 5>::Ones();
  m.diagonal().setZero();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j) {
      const double apart = length_between(lengths, first_vertex + girdle[static_cast<std::size_t>(i)],
                                          first_vertex + girdle[static_cast<std::size_t>(j)]);
      m(i + 1, j + 1) = m(j + 1, i + 1) = apart * apart;
    }
  return m.determinant();
}

/// Two people, the shoulders brought forward by `forward_m`: a girdle in space, not in a plane.
PairPose pair_with_shoulders(double forward_m) {
  PairPose pair = test::facing_pair(0.7);
  for (const int first : {0, joint_count})
    for (const int shoulder : {joints::LeftClavicle, joints::RightClavicle})
      pair(first + shoulder, 2) += first == 0 ? forward_m : -forward_m;
  return pair;
}

TEST(RigidLengths, OfAPoseStayAsTheyAre) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.03);
  for (int i = 0; i < 100; ++i) {
    PairPose pair = pair_with_shoulders(0.06);
    pair = pair.unaryExpr([&](double x) { return x + noise(random); });
    RigidDistances lengths = rigid_distances(pair);
    const RigidDistances before = lengths;
    make_lengths_fit(pair, lengths);
    for (std::size_t n = 0; n < lengths.size(); ++n) EXPECT_EQ(lengths[n].length_m, before[n].length_m);
  }
}

TEST(RigidLengths, ThatNoShouldersHaveAreMadePossible) {
  const PairPose pair = pair_with_shoulders(0.06);
  RigidDistances lengths = rigid_distances(pair);
  for (const int first : {0, joint_count}) {  // as when a narrow chest is asked of wide shoulders
    length_between(lengths, first + joints::LowerNeck, first + joints::LeftClavicle) *= 0.8;
    length_between(lengths, first + joints::LeftClavicle, first + joints::RightClavicle) *= 1.1;
    ASSERT_LT(squared_volume(lengths, first), 0);
  }
  const RigidDistances before = lengths;
  make_lengths_fit(pair, lengths);
  for (const int first : {0, joint_count}) EXPECT_GT(squared_volume(lengths, first), 0);
  for (std::size_t n = 0; n < lengths.size(); ++n) {
    const bool is_bone = n % (lengths.size() / 2) < bone_count;
    if (is_bone) {
      EXPECT_EQ(lengths[n].length_m, before[n].length_m) << n;
    }
  }
}

TEST(RigidLengths, AreMovedByNoMoreThanItTakes) {
  const PairPose pair = pair_with_shoulders(0.06);
  const RigidDistances possible = rigid_distances(pair);
  RigidDistances wanted = possible;
  length_between(wanted, joints::LowerNeck, joints::LeftClavicle) *= 0.8;
  length_between(wanted, joints::LeftClavicle, joints::RightClavicle) *= 1.1;
  RigidDistances fitting = wanted;
  make_lengths_fit(pair, fitting);
  // Squared distances move in proportion, from what was asked for towards the pose: all by the same share.
  double share = -1;
  for (std::size_t n = 0; n < wanted.size(); ++n) {
    const auto squared = [n](const RigidDistances& of) { return of[n].length_m * of[n].length_m; };
    if (std::abs(squared(possible) - squared(wanted)) < 1e-9) continue;
    const double of_this = (squared(fitting) - squared(wanted)) / (squared(possible) - squared(wanted));
    if (share < 0) share = of_this;
    EXPECT_NEAR(of_this, share, 1e-6);
  }
  EXPECT_GT(share, 0);
  EXPECT_LT(share, 1);
  const double volume = squared_volume(fitting, 0);
  EXPECT_GT(volume, 0);
  EXPECT_LT(volume, squared_volume(possible, 0)) << "nearer to a plane than the pose: not the pose's angles";
}

TEST(RigidLengths, OfAPelvisWiderThanItsBonesAreMadePossible) {
  const PairPose pair = test::facing_pair(0.7);
  RigidDistances lengths = rigid_distances(pair);
  double& hips = length_between(lengths, joints::LeftHipJoint, joints::RightHipJoint);
  const double bones = length_between(lengths, joints::Root, joints::LeftHipJoint) +
                       length_between(lengths, joints::Root, joints::RightHipJoint);
  hips = 1.2 * bones;
  make_lengths_fit(pair, lengths);
  EXPECT_LE(hips, bones);
  EXPECT_GT(hips, 0.5 * bones);
}

TEST(RigidLengths, OfBonesThatHaveNoLengthStayAsTheyAre) {
  PairPose pair = test::facing_pair(0.7);
  pair.row(joints::LeftHipJoint) = pair.row(joints::Root);
  pair.row(joints::LowerNeck) = pair.row(joints::Thorax);
  RigidDistances lengths = rigid_distances(pair);
  for (RigidDistance& rigid : lengths) rigid.length_m *= 1.1;
  const RigidDistances before = lengths;
  make_lengths_fit(pair, lengths);
  for (std::size_t n = 0; n < lengths.size(); ++n) EXPECT_EQ(lengths[n].length_m, before[n].length_m);
}

}  // namespace
}  // namespace abrazo::rigid_lengths_test
