#include "widgets/scene/values/pair_camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/motion/body/joint_set.hpp"

namespace abrazo::widgets {
namespace {

constexpr double beside_rad = 1.3;  // from the line between the two; a little less than square shows depth
constexpr double slack_m = 0.25, slack_rad = 0.45;
constexpr double lost_m = 2.5;  // farther is a jump in time, not a step
constexpr double walk_per_s = 2.5, turn_per_s = 0.9, zoom_per_s = 0.8;
constexpr double fastest_turn_rad_per_s = 0.7;
constexpr double too_near = 1.1, too_far = 0.78;  // distance that fits, as a share of the camera's own
constexpr double cut_off = 1.13;                  // from there on feet may be cut off, near the camera first
constexpr double hurries_per_s = 12;              // zooms out, just before that

Vec3 middle_of(const PairPose& pair) {
  Vec3 middle = 0.5 * (pair.row(0) + pair.row(joint_count)).transpose();
  middle.y() = 0;
  return middle;
}

/// The direction beside the pair that is nearest to where the camera is.
double nearest_side(const PairPose& pair, double azimuth_rad) {
  const Vec3 apart = (pair.row(joint_count) - pair.row(0)).transpose();
  const double line = std::atan2(apart.x(), apart.z());
  const double one = std::remainder(line + beside_rad - azimuth_rad, 2 * std::numbers::pi);
  const double other = std::remainder(line - beside_rad - azimuth_rad, 2 * std::numbers::pi);
  return azimuth_rad + (std::abs(one) <= std::abs(other) ? one : other);
}

double share(double per_s, double elapsed_s) {
  return 1 - std::exp(-per_s * elapsed_s);
}

}  // namespace

void PairCamera::show_all(OrbitCamera& camera, const PairPose& pair, const PictureShape& picture) {
  zooms_ = true;
  anchor_ = middle_of(pair);
  camera.target = 0.5 * (pair.colwise().minCoeff() + pair.colwise().maxCoeff()).transpose();
  camera.distance_m = camera.distance_for(pair, picture);
}

void PairCamera::start(OrbitCamera& camera, const PairPose& pair, const PictureShape& picture) {
  turns_ = true;
  camera.azimuth_rad = nearest_side(pair, camera.azimuth_rad);
  show_all(camera, pair, picture);
}

void PairCamera::turn(OrbitCamera& camera, const PairPose& pair, double elapsed_s) const {
  const Vec3 apart = (pair.row(joint_count) - pair.row(0)).transpose();
  if (std::hypot(apart.x(), apart.z()) < 0.15) return;  // on top of one another: no side
  const double off = nearest_side(pair, camera.azimuth_rad) - camera.azimuth_rad;
  const double beyond = std::max(0.0, std::abs(off) - slack_rad);
  const double most = fastest_turn_rad_per_s * elapsed_s;
  camera.azimuth_rad += std::copysign(std::min(beyond * share(turn_per_s, elapsed_s), most), off);
}

void PairCamera::follow(OrbitCamera& camera, const PairPose& pair, const PictureShape& picture,
                        double elapsed_s) {
  const Vec3 ahead = middle_of(pair) - anchor_;
  Vec3 step = Vec3::Zero();
  if (ahead.norm() > lost_m)
    step = ahead;
  else if (ahead.norm() > slack_m)
    step = share(walk_per_s, elapsed_s) * (ahead - slack_m * ahead.normalized());
  anchor_ += step;
  camera.target += step;
  if (turns_) turn(camera, pair, elapsed_s);
  if (!zooms_) return;
  const double fitting = camera.distance_for(pair, picture);
  const double ratio = fitting / camera.distance_m;
  if (ratio <= too_near && ratio >= too_far) return;
  const double urgency = std::clamp((ratio - too_near) / (cut_off - too_near), 0.0, 1.0);
  const double per_s = zoom_per_s + urgency * (hurries_per_s - zoom_per_s);
  camera.distance_m += share(per_s, elapsed_s) * (fitting - camera.distance_m);
  camera.distance_m = std::max(camera.distance_m, fitting / cut_off);
}

}  // namespace abrazo::widgets
