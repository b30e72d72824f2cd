#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/base/positions.hpp"

namespace abrazo {

/// Poses of a partner as points in a space in which squared distance is mean joint distance [m]: mean joint
/// distance is of negative type, so its root is a distance of a Hilbert space, and landmark
/// multidimensional scaling (de Silva and Tenenbaum 2004) finds the relevant axes. The mean of points then
/// represents a distribution of poses, and |point - mean|^2 is the expected mean joint distance up to a
/// constant: the regression estimates exactly the quantity to minimise.
class PartnerEmbedding {
 public:
  static constexpr int most_landmarks = 512;
  static constexpr int most_axes = 32;
  using Rows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// @param landmarks representative poses; at least one, at most `most_landmarks`
  explicit PartnerEmbedding(const std::vector<Pose>& landmarks);

  int size() const { return static_cast<int>(axes_.cols()); }
  /// Size of the work space of `embed`.
  int room() const { return static_cast<int>(landmarks_.cols()); }
  /// @param point  `size` numbers
  /// @param work   `room` numbers
  void embed(const Pose& partner, std::span<float> point, std::span<float> work) const;

 private:
  void distances_to(const Pose& partner, std::span<float> distances) const;

  /// One row per joint and axis: that coordinate of all landmarks.
  Rows landmarks_;
  Eigen::VectorXf usual_;  ///< mean distance of each landmark to all
  Rows axes_;              ///< landmark x axis
};

}  // namespace abrazo
