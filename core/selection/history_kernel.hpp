#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "core/selection/motion_history.hpp"

namespace abrazo {

/// Similarity of two stretches of motion, 1 for identical ones. Four parts of the last two seconds (the
/// present pose, the quarter second before, up to one second, up to two) are each described on their
/// principal axes and divided by their usual distance, so that a part counts by how unusual it is, not by its
/// size in metres. The kernel is the mean of four Gaussian kernels, over the first part, the first two, and
/// so on: motions that agreed recently are somewhat similar, and more similar the longer they agreed.
class HistoryKernel {
 public:
  /// A moment of a motion [s before now].
  static constexpr std::array<double, 13> lags_s = {0,   0.067, 0.133, 0.2, 0.267, 0.4, 0.6,
                                                    0.8, 1.0,   1.25,  1.5, 1.75,  2.0};
  static constexpr std::size_t raw_size = lags_s.size() * MotionHistory::coordinates;
  using Raw = std::array<float, raw_size>;
  using Rows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  static void sample(const MotionHistory& history, Raw& raw);

  /// Computes axes and usual distances. @param motions one row per motion, raw_size columns
  explicit HistoryKernel(const Rows& motions);

  static constexpr int part_count = 4;

  /// Dimension of a description.
  int size() const { return size_; }
  void describe(const Raw& raw, std::span<float> description) const;
  /// One row per motion.
  Rows describe(const Rows& motions) const;

  /// The kernel of two descriptions.
  float operator()(std::span<const float> a, std::span<const float> b) const;

  /// Descriptions to compare with, one per row. Each part has its own array, because they are read one after
  /// the other, mostly from outside the caches.
  struct Compared {
    std::array<Rows, part_count> parts;
    Eigen::Matrix<float, Eigen::Dynamic, part_count> squares;
    Eigen::Index size() const { return squares.rows(); }
  };
  Compared to_compare(const Rows& descriptions) const;
  /// Evaluates the kernel of one description with each of the first `kernel.size()` descriptions.
  /// @param work the same size as `kernel`
  void compare(const Compared& with, std::span<const float> description, std::span<float> kernel,
               std::span<float> work) const;

 private:
  struct Part {
    Eigen::Index first = 0, count = 0;  ///< coordinates of the raw motion
    Eigen::VectorXf mean;
    Rows axes;            ///< one row per axis, divided by the part's usual distance
    Eigen::Index at = 0;  ///< offset in a description
  };
  std::vector<Part> parts_;
  int size_ = 0;
};

}  // namespace abrazo
