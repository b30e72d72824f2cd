#pragma once

#include <cstdint>
#include <optional>

#include "core/selection/source_playhead.hpp"
#include "core/synthesis/motion/adaptation.hpp"
#include "core/synthesis/motion/foot_plants.hpp"
#include "core/synthesis/motion/hand_holds.hpp"
#include "core/synthesis/motion/partner_place.hpp"
#include "core/synthesis/motion/transition.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

/// State of the partner's motion with the playback `continuous`, as one value.
struct PartnerMotion {
  SourcePlayhead playhead;
  std::uint8_t moved_by = 0;  ///< settings at its start, see moving_settings
  PartnerPlace place;
  double since_change_s = 0;  ///< of the source
  Transition transition;
  Adaptation adaptation;
  FootPlants plants;
  HandHolds holds;
};

/// The settings, as bits, whose change makes the partner continue from the shown pose.
std::uint8_t moving_settings(const Settings& settings);

/// The last shown partner, for frames without a recorded continuation: after a loss of tracking, a change of
/// role, library or body. World [m].
struct ShownPartner {
  Pose pose;
  Pose before;          ///< `before_s` earlier
  double before_s = 0;  ///< 0: at rest
};

/// Input for the next frame of the partner's motion.
struct MotionStep {
  const MotionLibrary& library;
  const Settings& settings;
  const Pose& user;  ///< on the library's body, world [m]
  RootFrame user_root;
  double elapsed_s = 0;
  int chosen = -1;       ///< the selected pair
  bool changes = false;  ///< the chosen pair is another source
  bool stands = false;   ///< the source time is held
  /// Desired place of the partner relative to the user's root, instead of the source's.
  std::optional<RootFrame> partner_place = std::nullopt;
  double lead_s = 0;  ///< by which the user is ahead of the source, see FrameIntent [source s]
  std::optional<ShownPartner> shown;  ///< set if there is a partner but no source yet
};

/// Advances the partner by a frame: source time, place and transitions; then, adapted to the user, planted
/// feet and held hands.
class PartnerMover {
 public:
  /// @param motion advanced by this frame
  PartnerMover(PartnerMotion& motion, const MotionStep& step);

  /// The user and the moved partner with the usual passive body's bones. They may overlap; the mesh edit
  /// separates them. World [m].
  PairPose move();
  /// @param edited the partner after the edit
  /// @return the partner to show; its bone lengths are exact except for the adaptation
  Pose adapt(const Pose& edited);

 private:
  double leg_scale() const;
  BodyShape shape_in(const RecordedMoment& moment) const;
  RecordedStep recorded_step() const;
  RecordedMoment moment_at(const SourcePlayhead& playhead) const;
  RootFrame away(const RootFrame& wanted);
  /// Stands the shown shape at the place.
  void stand();
  void begin();
  void begin_from(const ShownPartner& shown);
  void go_on();
  void follow_clock();
  void change();
  void plant_feet(Pose& pose);
  void hold_hands(Pose& pose);

  PartnerMotion& motion_;
  const MotionStep& step_;
  const Body& body_;
  RecordedMoment moment_;
  double turn_ = 0;           ///< of the recorded heading during this step [rad]
  Vec3 goes_ = Vec3::Zero();  ///< remaining way to the desired place, horizontal [m]
  RootFrame root_;            ///< of the moved partner
  Pose moved_ = Pose::Zero();
  bool changed_ = false;
  bool is_placed_ = true;
};

/// Mean over the joints of the difference between the user and the recorded leader placed at the user,
/// weighted towards joints near the partner; horizontal, world [m].
Vec3 shift_of_user(const RecordedMoment& moment, const Pose& user, const RootFrame& user_root);

}  // namespace abrazo
