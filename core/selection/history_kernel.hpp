#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "core/selection/motion_history.hpp"

namespace abrazo {

/// How alike two stretches of motion are, 1 for the same. Four parts of the last two seconds - the pose now,
/// the quarter of a second before, up to a second, up to two - are each described on their principal axes and
/// divided by their usual distance, so that a part counts by how unusual it is and not by its metres. The
/// kernel is the mean of four Gaussian ones, over the first part, the first two, ...: motions that agree
/// of late are alike somewhat, and the more the longer they have agreed.
class HistoryKernel {
 public:
  /// A moment of a motion [s before now].
  static constexpr std::array<double, 13> lags_s = {0,   0.067, 0.133, 0.2, 0.267, 0.4, 0.6,
                                                    0.8, 1.0,   1.25,  1.5, 1.75,  2.0};
  static constexpr std::size_t raw_size = lags_s.size() * MotionHistory::coordinates;
  using Raw = std::array<float, raw_size>;
  using Rows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  static void sample(const MotionHistory& history, Raw& raw);

  /// Axes and usual distances of these motions. @param motions  a row per motion, raw_size columns
  explicit HistoryKernel(const Rows& motions);

  static constexpr int part_count = 4;

  /// Numbers of a description.
  int size() const { return size_; }
  void describe(const Raw& raw, std::span<float> description) const;
  /// A row per motion.
  Rows describe(const Rows& motions) const;

  /// Of two descriptions.
  float operator()(std::span<const float> a, std::span<const float> b) const;

  /// Descriptions that others are compared with, a row each.
  struct Compared {
    Rows rows;
    Eigen::Matrix<float, Eigen::Dynamic, part_count, Eigen::RowMajor> squares;  ///< of each part
  };
  Compared to_compare(Rows descriptions) const;
  /// The kernel of one description with each of the first `kernel.size()`.
  /// @param work  as many numbers
  void compare(const Compared& with, std::span<const float> description, std::span<float> kernel,
               std::span<float> work) const;

 private:
  struct Part {
    Eigen::Index first = 0, count = 0;  ///< coordinates of the raw motion
    Eigen::VectorXf mean;
    Rows axes;            ///< a row per axis, divided by the part's usual distance
    Eigen::Index at = 0;  ///< in a description
  };
  std::vector<Part> parts_;
  int size_ = 0;
};

}  // namespace abrazo
