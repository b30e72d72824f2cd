#pragma once

#include <optional>

#include "core/base/positions.hpp"

namespace abrazo {

/// Root position and heading of a body; removed by normalisation.
struct RootFrame {
  Vec3 position = Vec3::Zero();  ///< root joint, world [m]
  double heading_rad = 0;        ///< about Y; 0 = facing +Z, positive to the body's left

  /// Rotation RM^root of the paper: normalised = R^T (world - position).
  Eigen::Matrix3d rotation() const;
};

/// Root and heading of a pose. Heading = perpendicular to the blend of the horizontal hip axis (0.6) and
/// shoulder axis (0.4), each as a unit vector. A hip axis shorter than 5 cm in top view is unreliable (lying,
/// bending sideways): then `previous_heading_rad` is kept, or the shoulders decide if there is none.
RootFrame root_frame(const Pose& pose, std::optional<double> previous_heading_rad = std::nullopt);

/// Eq. 1-2: a body relative to the active root, rotated by the inverse of its heading.
Pose to_normalized(const Pose& world, const RootFrame& active_root);

/// Inverse of to_normalized: Eq. 5-6 with the translation that the paper omits.
Pose to_world(const Pose& normalized, const RootFrame& active_root);

/// 15-D feature: positions of `feature_joints` in a normalised pose [m] (paper 3.2.2).
using Features = Eigen::Matrix<double, 15, 1>;
Features pose_features(const Pose& normalized_active);

}  // namespace abrazo
