#include "widgets/scene/values/picture_projection.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace abrazo::widgets {

PictureProjection::PictureProjection(const OrbitCamera& camera, double width_px, double height_px)
    : eye_(camera.position()),
      forward_((camera.focus() - eye_).normalized()),
      right_(camera.right()),
      up_(camera.up()),
      width_px_(width_px),
      middle_y_px_(height_px * (1 + camera.lowered) / 2),
      focal_px_(height_px / (2 * std::tan(camera.view_angle_rad / 2))),
      nearest_m_(camera.nearest_shown_m()),
      is_parallel_(camera.is_parallel),
      plane_(camera.plane) {
  if (is_parallel_) focal_px_ /= camera.distance_m;
}

std::optional<PicturePoint> PictureProjection::project(const Vec3& world) const {
  const Vec3 offset = world - eye_;
  const double depth = offset.dot(forward_);
  if (depth <= nearest_m_ || (plane_ && plane_->leaves_out(world))) return std::nullopt;
  const double scale = pixels_per_metre(depth);
  return PicturePoint{width_px_ / 2 + scale * offset.dot(right_), middle_y_px_ - scale * offset.dot(up_),
                      depth};
}

PictureProjection::Ray PictureProjection::ray(double x, double y) const {
  const Vec3 aside = ((x - width_px_ / 2) * right_ - (y - middle_y_px_) * up_) / focal_px_;
  if (is_parallel_) return {eye_ + aside, forward_};
  return {eye_, (forward_ + aside).normalized()};
}

}  // namespace abrazo::widgets
