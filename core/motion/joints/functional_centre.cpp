#include "core/motion/joints/functional_centre.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include "core/base/statistics.hpp"

namespace abrazo {

namespace {

constexpr double degree_rad = std::numbers::pi / 180;
constexpr double least_range_rad = 40 * degree_rad, least_range_across_rad = 20 * degree_rad;
constexpr double error_of_regression_m = 0.007;
constexpr double distinct_direction_rad = 5 * degree_rad;  ///< nearer directions tell the same
constexpr int corrections = 20;

/// The sums of all markers that the centre follows from.
struct SphereSums {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();  ///< covariances of the places
  Vec3 skew = Vec3::Zero();                          ///< covariances of place and squared length
  std::vector<Vec3> means;
};

SphereSums sums_of(const std::vector<Positions>& trajectories) {
  SphereSums sums;
  for (const Positions& places : trajectories) {
    const Vec3 mean = places.colwise().mean().transpose();
    const Positions about = places.rowwise() - mean.transpose();
    const auto count = static_cast<double>(places.rows());
    sums.spread += about.transpose() * about / count;
    // Lengths from the mean: a far origin would cost all digits.
    sums.skew += about.transpose() * about.rowwise().squaredNorm() / count +
                 2 * (about.transpose() * about / count) * mean;
    sums.means.push_back(mean);
  }
  return sums;
}

/// Variance of the noise along each axis, from how far the distances from the centre vary.
double noise_variance(const std::vector<Positions>& trajectories, const Vec3& centre) {
  double sum = 0;
  for (const Positions& places : trajectories) {
    const Eigen::VectorXd squared = (places.rowwise() - centre.transpose()).rowwise().squaredNorm();
    const double mean = squared.mean();
    sum += (squared.array() - mean).square().mean() / (4 * mean);
  }
  return sum / static_cast<double>(trajectories.size());
}

/// Directions of the first marker from the centre, as angles about their mean along the widest direction and
/// across it.
Eigen::Matrix<double, Eigen::Dynamic, 2> angles_of(const Positions& places, const Vec3& centre) {
  const Positions directions = (places.rowwise() - centre.transpose()).rowwise().normalized();
  const Vec3 middle = directions.colwise().mean().transpose().normalized();
  const Vec3 one = middle.unitOrthogonal(), other = middle.cross(one);
  Eigen::Matrix<double, Eigen::Dynamic, 2> angles(places.rows(), 2);
  for (Eigen::Index f = 0; f < places.rows(); ++f) {
    const Vec3 direction = directions.row(f).transpose();
    Eigen::Vector2d across(direction.dot(one), direction.dot(other));
    const double sine = across.norm(), angle = std::atan2(sine, direction.dot(middle));
    if (sine > 0) across *= angle / sine;
    angles.row(f) = across.transpose();
  }
  const Eigen::Matrix<double, Eigen::Dynamic, 2> about = angles.rowwise() - angles.colwise().mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> widest(about.transpose() * about);
  return about * widest.eigenvectors().rowwise().reverse();
}

std::array<double, 2> ranges_of(const Eigen::Matrix<double, Eigen::Dynamic, 2>& angles) {
  std::array<double, 2> ranges{};
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const std::vector<double> values(angles.col(axis).begin(), angles.col(axis).end());
    ranges[static_cast<std::size_t>(axis)] = quantile(values, 0.95) - quantile(values, 0.05);
  }
  return ranges;
}

std::size_t distinct_directions(const Eigen::Matrix<double, Eigen::Dynamic, 2>& angles) {
  std::set<std::pair<long, long>> cells;
  for (Eigen::Index f = 0; f < angles.rows(); ++f)
    cells.emplace(std::lround(angles(f, 0) / distinct_direction_rad),
                  std::lround(angles(f, 1) / distinct_direction_rad));
  return cells.size();
}

}  // namespace

std::optional<FunctionalCentre> functional_centre(const std::vector<Positions>& trajectories) {
  if (trajectories.empty() || trajectories.front().rows() < 10) return std::nullopt;
  const SphereSums sums = sums_of(trajectories);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(sums.spread);
  constexpr double least_share = 1e-6;
  const double thinnest = spread.eigenvalues()[0];
  if (!(thinnest > least_share * spread.eigenvalues()[2])) return std::nullopt;
  const Eigen::Matrix3d inverse = (2 * sums.spread).inverse();
  FunctionalCentre found;
  found.centre = inverse * sums.skew;
  double variance = 0;
  for (int i = 0; i < corrections; ++i) {
    variance = noise_variance(trajectories, found.centre);
    Vec3 bias = Vec3::Zero();
    for (const Vec3& mean : sums.means) bias += mean - found.centre;
    found.centre = inverse * (sums.skew - 2 * variance * bias);
  }
  if (!found.centre.allFinite() || !std::isfinite(variance)) return std::nullopt;
  const auto angles = angles_of(trajectories.front(), found.centre);
  found.range = ranges_of(angles);
  found.noise_m = std::sqrt(variance);
  double radius_sq = 0;
  for (const Vec3& mean : sums.means) radius_sq += (mean - found.centre).squaredNorm();
  const auto markers = static_cast<double>(trajectories.size());
  // Of markers at distance r, with noise s in n distinct directions: r s / sqrt(n least eigenvalue), of which
  // the noise itself is a part.
  const double told = thinnest - markers * variance;
  found.expected_error_m = told > 0 ? std::sqrt(radius_sq / markers * variance /
                                                (static_cast<double>(distinct_directions(angles)) * told))
                                    : std::numeric_limits<double>::infinity();
  return found;
}

bool is_better_than_regression(const FunctionalCentre& found) {
  return found.range[0] >= least_range_rad && found.range[1] >= least_range_across_rad &&
         found.expected_error_m < error_of_regression_m;
}

}  // namespace abrazo
