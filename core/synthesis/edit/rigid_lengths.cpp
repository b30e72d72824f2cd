#include "core/synthesis/edit/rigid_lengths.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

constexpr double shortest_bone_m = 1e-6;
/// Share of the shape's depth(). Points in one plane move out of it without a change of their distances, to
/// first order: linear rows then take many steps to make the distances right.
constexpr double kept_depth = 0.25;
constexpr double rounding = 1e-12;  ///< a pose whose girdle is flat fits too
constexpr int halvings = 20;

/// Bones that begin at one joint and whose other ends keep their distances: index of the bone's row each.
using Spokes = std::span<const int>;
constexpr std::array pelvis = {joints::LeftHipJoint - 1, joints::RightHipJoint - 1};
constexpr std::array girdle = {joints::LowerNeck - 1, joints::LeftClavicle - 1, joints::RightClavicle - 1};

/// Cosines between the spokes; 1 on the diagonal, also of a row that is not used.
using Cosines = Eigen::Matrix3d;

/// 0 = the spokes lie in a plane (two: in a line); negative: no directions have these cosines.
double depth(const Cosines& cosines) {
  return Eigen::SelfAdjointEigenSolver<Cosines>(cosines, Eigen::EigenvaluesOnly).eigenvalues()(0);
}

/// The pseudo-bone between the ends of two bones; -1 = none.
int pseudo_bone_between(int bone_a, int bone_b) {
  for (std::size_t p = 0; p < pseudo_bones.size(); ++p) {
    const auto [a, b] = pseudo_bones[p];
    if ((a == bone_a + 1 && b == bone_b + 1) || (a == bone_b + 1 && b == bone_a + 1))
      return bone_count + static_cast<int>(p);
  }
  return -1;
}

void make_spokes_fit(Spokes spokes, const PairPose& shape, std::span<RigidDistance> lengths) {
  const auto length = [&](int n) -> double& { return lengths[static_cast<std::size_t>(n)].length_m; };
  Cosines recorded = Cosines::Identity();
  Cosines wanted = Cosines::Identity();
  for (std::size_t i = 0; i < spokes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const RigidDistance& one = lengths[static_cast<std::size_t>(spokes[i])];
      const RigidDistance& other = lengths[static_cast<std::size_t>(spokes[j])];
      const Eigen::RowVector3d along_one = shape.row(one.a) - shape.row(one.b);
      const Eigen::RowVector3d along_other = shape.row(other.a) - shape.row(other.b);
      const double norms = along_one.norm() * along_other.norm();
      const double lengths_product = one.length_m * other.length_m;
      if (std::min(norms, lengths_product) < shortest_bone_m * shortest_bone_m) return;
      const double apart = length(pseudo_bone_between(spokes[i], spokes[j]));
      const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
      recorded(row, column) = recorded(column, row) = along_one.dot(along_other) / norms;
      wanted(row, column) = wanted(column, row) =
          (one.length_m * one.length_m + other.length_m * other.length_m - apart * apart) /
          (2 * lengths_product);
    }
  const double goal = kept_depth * std::max(0.0, depth(recorded)) - rounding;
  if (depth(wanted) >= goal) return;
  // The smallest eigenvalue is concave along the path, and large enough at its end.
  double too_little = 0, share = 1;
  for (int n = 0; n < halvings; ++n) {
    const double middle = 0.5 * (too_little + share);
    (depth(wanted + middle * (recorded - wanted)) >= goal ? share : too_little) = middle;
  }
  const Cosines fitting = wanted + share * (recorded - wanted);
  for (std::size_t i = 0; i < spokes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double a = length(spokes[i]), b = length(spokes[j]);
      const double cosine = fitting(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      length(pseudo_bone_between(spokes[i], spokes[j])) =
          std::sqrt(std::max(0.0, a * a + b * b - 2 * a * b * cosine));
    }
}

}  // namespace

void make_lengths_fit(const PairPose& shape, RigidDistances& lengths) {
  constexpr std::size_t per_body = rigid_distance_count / 2;
  for (const std::size_t first : {std::size_t{0}, per_body}) {
    const auto of_body = std::span(lengths).subspan(first, per_body);
    make_spokes_fit(pelvis, shape, of_body);
    make_spokes_fit(girdle, shape, of_body);
  }
}

}  // namespace abrazo
