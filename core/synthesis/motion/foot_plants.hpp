#pragma once

#include <array>

#include "core/selection/source_playhead.hpp"

namespace abrazo {

/// Input for one foot of the partner in one frame. World [m].
struct FootMoment {
  Vec3 free = Vec3::Zero();   ///< toe base if nothing held it
  Vec3 ankle = Vec3::Zero();  ///< ankle if nothing held the foot
  Vec3 hip = Vec3::Zero();
  double leg_length = 0;          ///< hip to ankle of a straight leg
  double rest_height = 0;         ///< of the toe base of a standing foot
  double recorded_height = 0;     ///< of the toe base in the recording, for this body
  Vec3 body_goes = Vec3::Zero();  ///< remaining way of the body to its place, without the recorded motion
  bool lands = false;             ///< the foot stands in the recording
  double lands_in_s = 0;          ///< time until it stands again, while it does not
};

/// Planted feet of the partner. Toe base x and z are held, its height is that of the recording, and the ankle
/// follows, so a planted foot rolls and does not hover. When the recording lifts the foot, it first leaves
/// the floor, then its offset fades until it lands again. A foot that is too far away takes a step, one foot
/// at a time. A foot that the edit could not hold is not planted again before the recorded foot lifts.
class FootPlants {
 public:
  struct Foot {
    bool planted = false;
    bool steps = false;  ///< steps because it was too far away
    bool waits_for_lift = false;
    Vec3 anchor = Vec3::Zero();  ///< horizontal, of a planted one
    Vec3 slip = Vec3::Zero();    ///< remaining speed of its landing, horizontal [m/s]
    Vec3 offset = Vec3::Zero();  ///< at release, horizontal
    Vec3 rate = Vec3::Zero();    ///< speed of the offset at release [m/s]
    double since_s = 0, fades_s = 0;
    Vec3 lead = Vec3::Zero(),
         lead_speed = Vec3::Zero();   ///< lead over the free foot for landing, horizontal
    double lift = 0, lift_speed = 0;  ///< height of the shown toe base above the free one
    Vec3 free = Vec3::Zero();         ///< in the frame before
    Vec3 shown = Vec3::Zero();        ///< in the frame before
    bool is_known = false;            ///< there was a previous frame
  };
  using Feet = std::array<Foot, 2>;  ///< left, right

  FootPlants() = default;
  explicit FootPlants(const Feet& feet) : feet_(feet) {}

  /// Releases both feet at once, as when the free pose is shown.
  void reset() { feet_ = {}; }
  /// @return positions of the shown toe bases, left and right
  std::array<Vec3, 2> update(const std::array<FootMoment, 2>& moments, double elapsed_s);
  /// Reports the toe base position that the leg can reach.
  void settle(int foot, const Vec3& reached);
  /// Releases a foot that could not be held; it is shown at `shown`.
  void let_go(int foot, const Vec3& shown);

  const Feet& feet() const { return feet_; }

 private:
  struct OnItsWay {
    Vec3 at;
    double step_lift = 0;
  };

  static void let_go(Foot& foot, const FootMoment& now, double elapsed_s, double fades_s);
  void stay(Foot& foot, const FootMoment& now, double elapsed_s) const;
  static OnItsWay go(Foot& foot, const FootMoment& now);
  static void land(Foot& foot, const FootMoment& now, const Vec3& at, double elapsed_s);
  static void aim(Foot& foot, const FootMoment& now, double elapsed_s);
  static void raise(Foot& foot, const FootMoment& now, double elapsed_s);
  bool must_step(const Foot& foot, const FootMoment& now) const;

  Feet feet_;
};

/// Whether a foot of the partner stands at this moment of the recording: its toe base low and slow, without
/// gaps and runs of less than four frames of 60 Hz.
bool stands_in_recording(const MotionLibrary& library, const SourcePlayhead& playhead, bool left);
/// Time until the foot stands again, at most `most_s` [s].
double stands_again_in_s(const MotionLibrary& library, const SourcePlayhead& playhead, bool left,
                         double most_s);

/// Brings a leg's toe base to `toe_base`: the foot keeps its orientation, or turns about the toe base if the
/// leg does not reach; the knee follows by two-bone inverse kinematics.
/// @param forward direction of the body in which a straight knee bends
void place_foot(Pose& pose, const Body& body, bool left, const Vec3& toe_base, const Vec3& forward);

}  // namespace abrazo
