#pragma once

#include <vector>

#include "core/choreography/dancer_body.hpp"
#include "core/choreography/posture.hpp"
#include "core/choreography/salsa_phrase.hpp"
#include "core/choreography/smooth_track.hpp"

namespace abrazo {

/// A dancer of whom everything but the arms is placed.
struct PlacedDancer {
  const DancerBody& body;
  const Turn& chest;
  Pose& pose;
};

/// Where the four hands are over a dance. The leader's left and the follower's right always hold one another:
/// between the two, at the side, or above her head. His right and her left hold one another, or lie on her
/// shoulder blade and on his shoulder, or are free during a turn.
class CoupleHolds {
 public:
  explicit CoupleHolds(const std::vector<SalsaPhrase>& phrases);

  /// Places all four arms.
  void place_arms(double beat, const PlacedDancer& leader, const PlacedDancer& follower) const;

 private:
  /// Shares of where the hands are; the first three add up to 1, so do the next three.
  enum Channel {
    LeftOpen,
    LeftClosed,
    LeftOver,
    RightOpen,
    RightClosed,
    RightFree,
    Sway,
    Height,
    Spread,
    Grip,
    ChannelCount
  };
  using Controls = Eigen::Array<double, ChannelCount, 1>;

  static Controls controls(const SalsaPhrase& phrase, int half_beat);

  SmoothTrack<Controls> shares_;
};

}  // namespace abrazo
