#pragma once

#include <array>
#include <span>

#include "core/library/store/normalization.hpp"

namespace abrazo {

/// What a user did in the last two seconds, as one value without a pointer: some 30 poses a second, and the
/// newest as it is. Positions are kept as float relative to where the history began, so that what is read
/// does not depend on where in the world the user moves.
class MotionHistory {
 public:
  static constexpr double length_s = 2;
  static constexpr double between_s = 1.0 / 30;
  static constexpr std::size_t coordinates = std::size_t{joint_count} * 3;
  /// One more than fill the length when poses come a little early: the oldest that is asked for lies between
  /// two.
  static constexpr std::size_t most_samples = 65;
  using Sample = std::array<float, coordinates>;  ///< x, y, z of the 25 joints

  struct Kept {
    float since_s = 0;  ///< since the sample before
    Sample positions{};
  };

  bool is_empty() const { return count_ == 0; }
  void clear();
  /// @param root       of the pose
  /// @param elapsed_s  since the pose before; of the first it does not matter
  void add(const Pose& world, const RootFrame& root, double elapsed_s);

  /// The pose so long before the newest, relative to the newest's root and heading [m]; between two samples
  /// on the line between them, before the first the first.
  void sample(double lag_s, std::span<float, coordinates> xyz) const;

  // What a history consists of, to be kept elsewhere and made again.
  const Vec3& origin() const { return origin_; }  ///< horizontal
  const RootFrame& root() const { return root_; }
  /// Newest last; the newest pose of all is in `newest`.
  std::size_t size() const { return count_; }
  const Kept& kept(std::size_t i) const { return ring_[(first_ + i) % most_samples]; }
  const Kept& newest() const { return newest_; }
  /// @param kept  as `kept` gave them
  /// @return whether that can be a history: finite, in time, not too many
  bool restore(const Vec3& origin, const RootFrame& root, std::span<const Kept> kept, const Kept& newest);

 private:
  Vec3 origin_ = Vec3::Zero();
  RootFrame root_;  ///< of the newest
  std::array<Kept, most_samples> ring_{};
  std::size_t first_ = 0, count_ = 0;
  Kept newest_;  ///< `since_s` counts from the last of the ring; 0 when it is that
};

}  // namespace abrazo
