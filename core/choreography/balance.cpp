#include "core/choreography/balance.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/positions.hpp"
#include "core/choreography/couple_path.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/motion/body/smooth_window.hpp"

namespace abrazo {
namespace {

constexpr double gravity = 9.81;
constexpr double passing_s = 0.10;          ///< half the time the weight takes from foot to foot
constexpr double standing_speed_m_s = 0.1;  ///< a foot that is slower stands
constexpr double behind_toe_base = 0.025;   ///< where a foot carries: towards the heel of its toe-base [m]

// Shares of the body's mass (de Leva 1996, mean of women and men): head, trunk and arms move with the trunk,
// the legs half with it and half with the feet.
constexpr double head_share = 0.068, trunk_share = 0.430, arms_share = 0.094, legs_share = 0.408;

/// 1 while the foot stands.
std::vector<double> standing(const std::vector<FootPosture>& foot, double fps) {
  std::vector<double> stands;
  for (std::size_t f = 0; f < foot.size(); ++f) {
    const std::size_t before = f > 0 ? f - 1 : 0, after = std::min(f + 1, foot.size() - 1);
    const double time_s = std::max(1.0, static_cast<double>(after - before)) / fps;
    stands.push_back((foot[after].toe_base - foot[before].toe_base).norm() / time_s < standing_speed_m_s);
  }
  return stands;
}

Vec3 carrying_point(const FootPosture& foot) {
  return along_floor(foot.toe_base - behind_toe_base * forward_of(foot.yaw));
}

/// Of the body, the legs drawn from the hips to the feet.
Vec3 centre_of_mass(const DancerBody& body, const TrunkPosture& trunk, const FootPosture& left,
                    const FootPosture& right) {
  Pose pose = Pose::Zero();
  place_trunk(body, trunk, pose);
  const auto at = [&](int joint) -> Vec3 { return pose.row(joint).transpose(); };
  const Vec3 shoulders = 0.5 * (at(joints::left_shoulder) + at(joints::right_shoulder));
  const Vec3 hips = 0.5 * (at(joints::left_hip) + at(joints::right_hip));
  const Vec3 feet = 0.5 * (ankle_position(body, left) + ankle_position(body, right));
  // Thighs weigh three times as much as shanks: the legs' centre is at 36 % from the hips down.
  return head_share * (0.5 * (at(joints::Head) + at(joints::Thorax))) +
         trunk_share * (0.6 * shoulders + 0.4 * hips) + arms_share * (0.7 * shoulders + 0.3 * hips) +
         legs_share * (0.64 * hips + 0.36 * feet);
}

}  // namespace

std::vector<Vec3> weight_path(const FeetTrack& feet, double fps) {
  const int half_width = std::max(1, static_cast<int>(std::lround(passing_s * fps)));
  const std::vector<double> left = hann_mean(standing(feet.left, fps), half_width);
  const std::vector<double> right = hann_mean(standing(feet.right, fps), half_width);
  std::vector<Vec3> path;
  for (std::size_t f = 0; f < feet.left.size(); ++f) {
    // Both in the air does not happen in a walk; it would mean "between them".
    const double on_left = left[f] + 1e-3, on_right = right[f] + 1e-3;
    path.push_back((on_left * carrying_point(feet.left[f]) + on_right * carrying_point(feet.right[f])) /
                   (on_left + on_right));
  }
  return path;
}

std::vector<Vec3> pendulum_path(const std::vector<Vec3>& zero_moment_point, double height_m, double fps) {
  const std::size_t count = zero_moment_point.size();
  std::vector<Vec3> path = zero_moment_point;
  if (count < 3) return path;
  // (1 + 2 a) c_k - a (c_k-1 + c_k+1) = p_k; at rest at both ends. Thomas' algorithm.
  const double a = height_m / gravity * fps * fps;
  std::vector<double> upper(count, 0);
  for (std::size_t k = 1; k + 1 < count; ++k) {
    const double pivot = 1 + 2 * a - a * upper[k - 1];
    upper[k] = a / pivot;
    path[k] = (path[k] + a * path[k - 1]) / pivot;
  }
  for (std::size_t k = count - 2; k > 0; --k) path[k] += upper[k] * path[k + 1];
  return path;
}

void balance_trunks(const DancerBody& body, const FeetTrack& feet, double fps, double share,
                    std::vector<TrunkPosture>& trunks) {
  double height_m = 0;
  std::vector<Vec3> centres;
  for (std::size_t f = 0; f < trunks.size(); ++f) {
    centres.push_back(centre_of_mass(body, trunks[f], feet.left[f], feet.right[f]));
    height_m += centres.back().y() / static_cast<double>(trunks.size());
  }
  const std::vector<Vec3> wanted = pendulum_path(weight_path(feet, fps), height_m, fps);
  // A trunk that moves by d moves the centre by d times the share that moves with it.
  constexpr double moving_share = head_share + trunk_share + arms_share + 0.64 * legs_share;
  for (std::size_t f = 0; f < trunks.size(); ++f)
    trunks[f].root += share * (wanted[f] - along_floor(centres[f])) / moving_share;
}

}  // namespace abrazo
