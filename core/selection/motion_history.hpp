#pragma once

#include <array>
#include <span>

#include "core/library/store/normalization.hpp"

namespace abrazo {

/// The user's motion of the last two seconds, as one value without pointers: about 30 poses per second, and
/// the newest pose. Positions are floats relative to the start of the history, so that readings do not depend
/// on the user's place in the world.
class MotionHistory {
 public:
  static constexpr double length_s = 2;
  static constexpr double between_s = 1.0 / 30;
  static constexpr std::size_t coordinates = std::size_t{joint_count} * 3;
  /// One more than fills the length if poses come slightly early: the oldest requested pose lies between two
  /// samples.
  static constexpr std::size_t most_samples = 65;
  using Sample = std::array<float, coordinates>;  ///< x, y, z of the 25 joints

  struct Kept {
    float since_s = 0;  ///< since the previous sample
    Sample positions{};
  };

  bool is_empty() const { return count_ == 0; }
  void clear();
  /// @param root       of the pose
  /// @param elapsed_s since the previous pose; ignored for the first
  void add(const Pose& world, const RootFrame& root, double elapsed_s);

  /// The pose `lag_s` before the newest, relative to the newest's root and heading [m]; linear between
  /// samples, constant before the first.
  void sample(double lag_s, std::span<float, coordinates> xyz) const;

  // State, for serialisation.
  const Vec3& origin() const { return origin_; }  ///< horizontal
  const RootFrame& root() const { return root_; }
  /// Samples, newest last; the newest pose itself is in `newest`.
  std::size_t size() const { return count_; }
  const Kept& kept(std::size_t i) const { return ring_[(first_ + i) % most_samples]; }
  const Kept& newest() const { return newest_; }
  /// @param kept from `kept`
  /// @return whether the values are valid: finite, ascending in time, not too many
  bool restore(const Vec3& origin, const RootFrame& root, std::span<const Kept> kept, const Kept& newest);

 private:
  Vec3 origin_ = Vec3::Zero();
  RootFrame root_;  ///< of the newest
  std::array<Kept, most_samples> ring_{};
  std::size_t first_ = 0, count_ = 0;
  Kept newest_;  ///< `since_s` counts from the last sample of the ring; 0 if it is that sample
};

}  // namespace abrazo
