#include "core/library/build/capsule_calibration.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "core/mesh/capsules.hpp"

namespace abrazo {

namespace {

constexpr double generic_height_m = 1.75;
constexpr double allowed_depth_m = 0.01;
constexpr double exceeding_fraction = 0.01;  ///< of the frames may be deeper
constexpr double smallest_share = 0.4;       ///< of the start that a radius keeps
constexpr std::size_t frames_per_couple = 3000;

using Couple = std::pair<std::uint32_t, std::uint32_t>;

/// r[body_a][i] + r[body_b][j] must not be larger than `largest_sum`.
struct Limit {
  std::uint32_t body_a, body_b;
  std::size_t i, j;
  double largest_sum;
};

SegmentApproach approach(const Pose& a, int i, const Pose& b, int j) {
  const auto at = [](const Pose& pose, int joint) { return Vec3(pose.row(joint).transpose()); };
  return closest_points(at(a, bone(i).first), at(a, bone(i).second), at(b, bone(j).first),
                        at(b, bone(j).second));
}

bool is_calibrated(int i, int j) {
  const auto& radii = generic_capsule_radii();
  if (radii[static_cast<std::size_t>(i)] == 0 || radii[static_cast<std::size_t>(j)] == 0) return false;
  return !(is_hand_or_forearm(i) && is_hand_or_forearm(j));
}

/// Every n-th frame of a couple's takes, as (take, frame).
std::vector<std::pair<const PairedTake*, std::size_t>> sampled_frames(
    const std::vector<const PairedTake*>& takes) {
  std::size_t total = 0;
  for (const PairedTake* take : takes) total += take->a.poses.size();
  const std::size_t stride = std::max<std::size_t>(1, total / frames_per_couple);
  std::vector<std::pair<const PairedTake*, std::size_t>> frames;
  for (const PairedTake* take : takes)
    for (std::size_t frame = 0; frame < take->a.poses.size(); frame += stride)
      frames.emplace_back(take, frame);
  return frames;
}

/// Depth grows with the radii and nothing else, so its 99th percentile is r_i + r_j less the 1st percentile
/// of the distance: so the condition for a couple is one limit on the sum of two radii per pair of bones.
void add_limits(const Couple& couple, const std::vector<const PairedTake*>& takes,
                std::vector<Limit>& limits) {
  const auto frames = sampled_frames(takes);
  std::vector<double> distances(frames.size());
  const auto nth = static_cast<std::ptrdiff_t>(exceeding_fraction * static_cast<double>(frames.size()));
  for (int i = 0; i < bone_count; ++i) {
    for (int j = 0; j < bone_count; ++j) {
      if (!is_calibrated(i, j)) continue;
      std::transform(frames.begin(), frames.end(), distances.begin(), [&](const auto& at) {
        return approach(at.first->a.poses[at.second], i, at.first->b.poses[at.second], j).distance;
      });
      std::nth_element(distances.begin(), distances.begin() + nth, distances.end());
      const double near = distances[static_cast<std::size_t>(nth)];
      limits.push_back({couple.first, couple.second, static_cast<std::size_t>(i), static_cast<std::size_t>(j),
                        near + allowed_depth_m});
    }
  }
}

/// Brings r1 + r2 down to `largest_sum` by one factor; what one cannot give, the other does.
void shrink(double& r1, double smallest1, double& r2, double smallest2, double largest_sum) {
  const double factor = largest_sum / (r1 + r2);
  const double shrunk1 = std::max(smallest1, r1 * factor);
  const double shrunk2 = std::max(smallest2, std::min(r2 * factor, largest_sum - shrunk1));
  r1 = std::max(smallest1, std::min(shrunk1, largest_sum - shrunk2));
  r2 = shrunk2;
}

}  // namespace

std::vector<CapsuleRadii> calibrate_capsules(std::span<const PairedTake> takes,
                                             std::span<const TakeBodies> take_bodies,
                                             std::span<const Body> bodies) {
  std::vector<CapsuleRadii> radii(bodies.size(), generic_capsule_radii());
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (double& radius : radii[b]) radius *= bodies[b].height() / generic_height_m;
  const std::vector<CapsuleRadii> start = radii;

  std::map<Couple, std::vector<const PairedTake*>> couples;
  for (std::size_t t = 0; t < takes.size(); ++t)
    couples[{take_bodies[t].a, take_bodies[t].b}].push_back(&takes[t]);
  std::vector<Limit> limits;
  for (const auto& [couple, of_couple] : couples) add_limits(couple, of_couple, limits);

  const auto excess = [&](const Limit& limit) {
    return radii[limit.body_a][limit.i] + radii[limit.body_b][limit.j] - limit.largest_sum;
  };
  // Radii only shrink: a limit that was met stays met, so going once through by depth is enough.
  std::stable_sort(limits.begin(), limits.end(),
                   [&](const Limit& x, const Limit& y) { return excess(x) > excess(y); });
  for (const Limit& limit : limits) {
    if (excess(limit) <= 0) continue;
    shrink(radii[limit.body_a][limit.i], smallest_share * start[limit.body_a][limit.i],
           radii[limit.body_b][limit.j], smallest_share * start[limit.body_b][limit.j], limit.largest_sum);
  }
  return radii;
}

}  // namespace abrazo
