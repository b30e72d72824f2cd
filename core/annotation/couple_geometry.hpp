#pragma once

#include <array>
#include <vector>

#include "core/base/positions.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// Both performers of a take from the library, frame by frame, in the take's world.
struct CoupleMotion {
  double fps = 0;           ///< rate of these frames, not of the take
  std::vector<int> frames;  ///< their numbers in the take, ascending
  std::vector<Pose> a, b;   ///< [m], one per frame

  int size() const { return static_cast<int>(frames.size()); }
};

/// A take of the library at about `rate_hz`, or at the library's rate if that is lower.
CoupleMotion couple_motion(const MotionLibrary& library, int take, double rate_hz);

/// Relative placement of the couple. Angles in turns, positive to the left in top view, unwrapped: a full
/// turn to the left adds 1.
struct CoupleGeometry {
  std::vector<double> heading_a, heading_b;  ///< heading from `root_frame`, mean of 3 frames
  std::vector<double> orb;                   ///< direction of the line from a's to b's root

  /// Turn count n: rotation of a performer relative to the line between the two. Between two moments in which
  /// both face one another it changes by a whole number, whatever the path on the floor.
  double n_a(int frame) const { return heading_a[index(frame)] - orb[index(frame)]; }
  double n_b(int frame) const { return heading_b[index(frame)] - orb[index(frame)]; }

 private:
  static std::size_t index(int frame) { return static_cast<std::size_t>(frame); }
};
CoupleGeometry couple_geometry(const CoupleMotion& motion);

/// The four ways of holding hands.
enum class HandPair { LeftRight, RightLeft, LeftLeft, RightRight };  ///< mine, yours
inline constexpr std::array<HandPair, 4> hand_pairs = {HandPair::LeftRight, HandPair::RightLeft,
                                                       HandPair::LeftLeft, HandPair::RightRight};
/// Hands nearer than this count as a hold [m]: an annotator's judgement, wider than the 13 cm of HoldMetric.
inline constexpr double held_hands_m = 0.18;
/// Between the ends of two hands [m].
double hand_distance(const Pose& mine, const Pose& yours, HandPair hands);

/// A hand nearer than this to the other's back counts as supporting it [m].
inline constexpr double hand_on_back_m = 0.24;
/// Distance of a hand end from the nearest of the other's spine joints, if the hand is behind the chest [m];
/// `far_m` if it is in front.
double back_distance(const Vec3& hand, const Pose& other);

/// A value that stands for "too far to matter" [m].
inline constexpr double far_m = 1.0;

}  // namespace abrazo
