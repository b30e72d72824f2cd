#include "core/metrics/partner_error.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace abrazo {

namespace {

/// Displacements from frame to frame, each less the mean of all.
std::vector<Pose> varying_velocities(std::span<const Pose> poses) {
  std::vector<Pose> velocities;
  if (poses.size() < 2) return velocities;
  const Pose mean = (poses.back() - poses.front()) / static_cast<double>(poses.size() - 1);
  velocities.reserve(poses.size() - 1);
  for (std::size_t frame = 1; frame < poses.size(); ++frame)
    velocities.emplace_back(poses[frame] - poses[frame - 1] - mean);
  return velocities;
}

/// Correlation of `leader` with `follower` as it is `shift` frames later.
double correlation_at(const std::vector<Pose>& leader, const std::vector<Pose>& follower, int shift) {
  double both = 0, first_sq = 0, second_sq = 0;
  const int count = static_cast<int>(leader.size());
  for (int frame = std::max(0, -shift); frame < count - std::max(0, shift); ++frame) {
    const Pose& one = leader[static_cast<std::size_t>(frame)];
    const Pose& other = follower[static_cast<std::size_t>(frame + shift)];
    both += one.cwiseProduct(other).sum();
    first_sq += one.squaredNorm();
    second_sq += other.squaredNorm();
  }
  constexpr double still_m_sq = 1e-18;  // rounding of a motion that does not vary
  return first_sq > still_m_sq && second_sq > still_m_sq ? both / std::sqrt(first_sq * second_sq) : 0;
}

}  // namespace

double mean_joint_distance(const Pose& a, const Pose& b) {
  return (a - b).rowwise().norm().mean();
}

Lag measure_lag(std::span<const Pose> leader, std::span<const Pose> follower, double fps, double longest_s) {
  if (leader.size() != follower.size())
    throw std::invalid_argument("measure_lag: the motions differ in length");
  if (!(fps > 0)) throw std::invalid_argument("measure_lag: the frame rate must be positive");
  if (longest_s < 0) throw std::invalid_argument("measure_lag: the longest shift cannot be negative");
  const std::vector<Pose> first = varying_velocities(leader), second = varying_velocities(follower);
  const int longest =
      std::min(static_cast<int>(std::floor(longest_s * fps + 1e-9)), static_cast<int>(first.size() / 2));
  std::vector<double> correlations;
  for (int shift = -longest; shift <= longest; ++shift)
    correlations.push_back(correlation_at(first, second, shift));
  const auto best = std::max_element(correlations.begin(), correlations.end());
  Lag lag{static_cast<double>(best - correlations.begin() - longest) / fps, *best};
  if (*best == 0) return {};
  if (best == correlations.begin() || best + 1 == correlations.end()) return lag;
  const double before = *(best - 1), after = *(best + 1);
  const double curvature = before - 2 * *best + after;
  if (curvature >= 0) return lag;
  const double offset = 0.5 * (before - after) / curvature;
  lag.shift_s += offset / fps;
  lag.correlation = std::min(1.0, *best - 0.25 * (before - after) * offset);
  return lag;
}

}  // namespace abrazo
