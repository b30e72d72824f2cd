#pragma once

#include <vector>

#include "core/choreography/couple_path.hpp"
#include "core/choreography/dancer_body.hpp"
#include "core/choreography/footwork.hpp"
#include "core/choreography/posture.hpp"
#include "core/choreography/salsa_phrase.hpp"

namespace abrazo {

enum class DanceRole { Leader, Follower };

/// Motion of one dancer's feet and trunk over a dance, by beat. Beat 0 is count 1 of the first phrase. The
/// leader steps with the left on 1, right on 2, left on 3, holds 4, and right, left, right on 5, 6, 7; the
/// follower mirrors it. The feet are set under the dancer's spot on the couple's path (in a basic step in
/// front of it and behind it), a standing foot turns on its ball with the dancer, and the trunk follows the
/// weight.
class DancerScore {
 public:
  /// @param amplitude  of steps and hips
  DancerScore(DanceRole role, const DancerBody& body, const std::vector<SalsaPhrase>& phrases,
              const CouplePath& path, double amplitude);

  /// Posture of a foot; the heel may lift the ankle further, but a standing foot never moves otherwise.
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
    LeftHeel,
    RightHeel,
    ChannelCount
  };
  using Controls = Eigen::Array<double, ChannelCount, 1>;

  void write_steps(const std::vector<SalsaPhrase>& phrases, const CouplePath& path);
  void write_pivot(Side side, double until, const CouplePath& path);
  void write_trunk(const std::vector<SalsaPhrase>& phrases, const CouplePath& path);
  Controls controls(const SalsaPhrase& phrase, double beat, const CouplePath& path) const;
  Vec3 placement(const Spot& spot, Side side, double forward) const;
  Spot spot(double beat, const CouplePath& path) const;
  Footwork& feet(Side side) { return side == Side::Left ? left_ : right_; }

  DanceRole role_;
  DancerBody body_;
  double amplitude_;
  Footwork left_, right_;
  SmoothTrack<Controls> trunk_;
};

}  // namespace abrazo
