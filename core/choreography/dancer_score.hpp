#pragma once

#include <vector>

#include "core/choreography/couple_path.hpp"
#include "core/choreography/dancer_body.hpp"
#include "core/choreography/footwork.hpp"
#include "core/choreography/posture.hpp"
#include "core/choreography/salsa_phrase.hpp"

namespace abrazo {

enum class DanceRole { Leader, Follower };

/// What one dancer's feet and trunk do over a dance, by beat. Beat 0 is count 1 of the first phrase.
/// The basic step goes forward with the left on 1, in place with the right on 2, closes on 3, holds 4, and
/// back with the right on 5, 6, 7; the follower mirrors it. On a turn she goes round to her right on 5, 6, 7.
class DancerScore {
 public:
  DancerScore(DanceRole role, const DancerBody& body, const std::vector<SalsaPhrase>& phrases,
              const CouplePath& path);

  /// Feet in place; the ankle may be lifted further by the heel, never moved otherwise while it stands.
  FootPosture foot(Side side, double beat) const;

  /// @param gaze_yaw  world direction of the partner's head [rad], any multiple of 2 pi
  TrunkPosture trunk(double beat, double gaze_yaw) const;

 private:
  enum Channel {
    RootX,
    RootY,
    RootZ,
    PelvisYaw,
    PelvisPitch,
    PelvisRoll,
    ChestYaw,
    ChestPitch,
    ChestRoll,
    HeadPitch,
    Gaze,
    LeftHeel,
    RightHeel,
    ChannelCount
  };
  using Controls = Eigen::Array<double, ChannelCount, 1>;

  void write_steps(const std::vector<SalsaPhrase>& phrases, const CouplePath& path);
  void write_turn_steps(double first_beat, const SalsaPhrase& phrase, const CouplePath& path);
  /// Turns the standing foot to the new direction at the end of a cross body lead.
  void write_pivot(double first_beat, Side side, const CouplePath& path);
  void write_trunk(const std::vector<SalsaPhrase>& phrases, const CouplePath& path);
  Controls controls(const SalsaPhrase& phrase, int half_beat, double beat, const CouplePath& path) const;
  Vec3 placement(const Spot& spot, Side side, double forward, double turned) const;
  Spot spot(double beat, const CouplePath& path) const;
  Footwork& feet(Side side) { return side == Side::Left ? left_ : right_; }

  DanceRole role_;
  DancerBody body_;
  double turned_ = 0;  ///< whole turns made before the phrase being written [rad]
  Footwork left_, right_;
  SmoothTrack<Controls> trunk_;
};

}  // namespace abrazo
