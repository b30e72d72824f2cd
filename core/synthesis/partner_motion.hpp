#pragma once

#include <cstdint>
#include <optional>

#include "core/selection/source_playhead.hpp"
#include "core/synthesis/adaptation.hpp"
#include "core/synthesis/foot_plants.hpp"
#include "core/synthesis/hand_holds.hpp"
#include "core/synthesis/partner_place.hpp"
#include "core/synthesis/settings.hpp"
#include "core/synthesis/transition.hpp"

namespace abrazo {

/// What moves the partner from frame to frame with the playback `continuous`, as one value.
struct PartnerMotion {
  SourcePlayhead playhead;
  std::uint8_t moved_by = 0;  ///< the settings that it began with, see moving_settings
  PartnerPlace place;
  double since_change_s = 0;  ///< of the source
  Transition transition;
  Adaptation adaptation;
  FootPlants plants;
  HandHolds holds;
};

/// Those settings as bits at whose change the partner goes on from what is shown.
std::uint8_t moving_settings(const Settings& settings);

/// The partner as it was last shown, when no recorded motion leads on from there: after a loss of tracking, a
/// change of role, library or body. World [m].
struct ShownPartner {
  Pose pose;
  Pose before;          ///< `before_s` earlier
  double before_s = 0;  ///< 0: it stood still
};

/// What the next frame of the partner's motion follows from.
struct MotionStep {
  const MotionLibrary& library;
  const Settings& settings;
  const Pose& user;  ///< on the library's body, world [m]
  RootFrame user_root;
  double elapsed_s = 0;
  int chosen = -1;       ///< the pair that was selected
  bool changes = false;  ///< it does not go on with the source, but is another one
  bool stands = false;   ///< the source time is held
  /// Where the user wants the partner, seen from the user's root, in place of where the source has it.
  std::optional<RootFrame> partner_place = std::nullopt;
  double lead_s = 0;  ///< by which the user is ahead of the source, see FrameIntent [source s]
  std::optional<ShownPartner> shown;  ///< when there is no source yet, but a partner
};

/// What the recording did between two moments, seen from the partner's own heading.
struct RecordedPath {
  Vec3 own = Vec3::Zero();
  double turn = 0;
};

/// Moves the partner on by a frame: source time, place, what is left of changes; then, adapted to the user,
/// planted feet and held hands.
class PartnerMover {
 public:
  /// @param motion  goes on by this frame
  PartnerMover(PartnerMotion& motion, const MotionStep& step);

  /// The user and the moved partner with the usual passive body's bones. They may be in one another's way:
  /// what the mesh parts. World [m].
  PairPose move();
  /// @param edited  the partner of that edit
  /// @return what the partner should look like: bones are right but for what it was adapted by
  Pose adapt(const Pose& edited);

 private:
  double leg_scale() const;
  BodyShape shape_in(const RecordedMoment& moment) const;
  RecordedPath path_between(const RecordedMoment& from, const RecordedMoment& to) const;
  RecordedMoment moment_at(const SourcePlayhead& playhead) const;
  RootFrame away(const RootFrame& wanted);
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
  Vec3 goes_ = Vec3::Zero();  ///< what is left of the way to the wanted place, horizontal [m]
  RootFrame root_;            ///< of the moved partner
  Pose moved_ = Pose::Zero();
  bool changed_ = false;
  bool is_placed_ = true;
};

/// Mean over the joints of how the user differs from the recorded leader where the user is, weighted towards
/// joints near the partner; horizontal, world [m].
Vec3 shift_of_user(const RecordedMoment& moment, const Pose& user, const RootFrame& user_root);

}  // namespace abrazo
