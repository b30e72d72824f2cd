#pragma once

#include <vector>

#include "core/choreography/dancer_body.hpp"
#include "core/choreography/posture.hpp"
#include "core/choreography/salsa_phrase.hpp"
#include "core/choreography/smooth_track.hpp"

namespace abrazo {

/// A dancer with everything placed except the arms.
struct PlacedDancer {
  const DancerBody& body;
  const Turn& chest;
  Pose& pose;
  Vec3 left_stray = Vec3::Zero(), right_stray = Vec3::Zero();  ///< of the hands from their targets [m]
};

/// Positions of the four hands over a dance. His left and her right hold one another between the two, at the
/// side, or above the head of the turning dancer, or are free. His right and her left hold one another, or
/// lie on her shoulder blade and on his shoulder, or on her waist while she is led in, or are free. Walking
/// in tandem both right hands hold one another. Hands that hold meet wherever both arms can reach.
class CoupleHolds {
 public:
  explicit CoupleHolds(const std::vector<SalsaPhrase>& phrases);

  /// Places all four arms.
  void place_arms(double beat, const PlacedDancer& leader, const PlacedDancer& follower) const;

 private:
  /// Weights of the hand positions: those up to LeftTandem sum to 1, and so do those up to RightTandem.
  enum Channel {
    LeftOpen,
    LeftClosed,
    LeftOverHer,
    LeftOverHim,
    LeftFree,
    LeftTandem,
    RightOpen,
    RightClosed,
    RightFree,
    RightWaist,
    RightTandem,
    Sway,
    Height,
    Spread,
    Grip,
    ChannelCount
  };
  using Controls = Eigen::Array<double, ChannelCount, 1>;

  struct Holds {
    Vec3 ahead;                ///< from the leader to the follower
    Vec3 left, right, tandem;  ///< middle of the hold: his left, his right with her left, both right hands
  };

  static Holds holds_at(double beat, const Controls& now, const PlacedDancer& leader,
                        const PlacedDancer& follower);
  static Controls controls(const SalsaPhrase& phrase, int half_beat);
  static Channel left_hold(const SalsaPhrase& phrase, int half_beat);
  static Channel right_hold(const SalsaPhrase& phrase, int half_beat);

  SmoothTrack<Controls> shares_;
};

}  // namespace abrazo
