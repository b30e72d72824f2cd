#pragma once

#include <array>
#include <vector>

#include "core/mesh/capsules.hpp"
#include "core/selection/source_playhead.hpp"
#include "core/synthesis/frames/frame_result.hpp"
#include "core/synthesis/motion/steady_hand.hpp"

namespace abrazo {

/// Hands that hold one another. A hold begins where hand ends of the recording come within `hold_distance_m`
/// and ends where they are `hold_ends_m` apart; the partner's hand starts to move shortly before. The hold is
/// released when the user's hand is out of reach or at the partner's shoulder.
class HandHolds {
 public:
  struct Pair {
    bool recorded = false;  ///< between the two distances: held
    bool out_of_reach = false;
    double ramp = 0;             ///< 0 = not held, 1 = held
    double ramp_pace = 0;        ///< continuous if a hold is released during its ramp [1/s]
    Vec3 offset = Vec3::Zero();  ///< partner's hand from the user's, from the user's heading [m]
    Vec3 lag = Vec3::Zero();     ///< remainder of a previous source in `offset`
    Vec3 lag_speed = Vec3::Zero();
    /// Target of the hand relative to the partner's place, and its speed: a released hand comes to rest
    /// beside the body instead of following the user's hand.
    Vec3 asked = Vec3::Zero();
    Vec3 asked_speed = Vec3::Zero();
  };
  /// User's left with partner's left, left with right, right with left, right with right.
  using Pairs = std::array<Pair, 4>;
  /// Direction of an arm that reaches for a hand, and the side of its elbow, relative to the partner's
  /// heading.
  struct Arm {
    bool reaches = false;
    Vec3 along = Vec3::Zero();
    Vec3 side = Vec3::Zero();
  };
  using Arms = std::array<Arm, 2>;  ///< left, right

  using UserHands = std::array<SteadyHand, 2>;  ///< left, right

  HandHolds() = default;
  HandHolds(const Pairs& pairs, const Arms& arms, const UserHands& user_hands)
      : pairs_(pairs), arms_(arms), user_hands_(user_hands) {}

  void reset() { *this = HandHolds(); }
  /// Input for the holds of one frame. World [m].
  struct Surroundings {
    const MotionLibrary& library;
    const SourcePlayhead& playhead;
    const RecordedMoment& moment;
    bool source_changed = false;
    const Pose& user;  ///< whose hands are held
    const RootFrame& user_root;
    const Pose& partner;  ///< without holds
    const Body& body;     ///< of the partner
    const RootFrame& place;
  };
  void update(const Surroundings& now, double elapsed_s);

  /// Brings the partner's arms to the held hands: direction and reach about the shoulder are blended in as
  /// the hold ramps up.
  void place_arms(Pose& partner, const Surroundings& now, double elapsed_s);

  /// How far the hands that are to be held lie beyond the partner's easy reach: the largest excess, from the
  /// shoulder towards the hand, horizontal [m]. A dancer whose hand is drawn away goes along with it. A hand
  /// that is too far away draws nobody.
  /// @param partner where it would be shown now, world [m]
  /// @param moment  of the recording, whose offset between the hands is aimed at
  Vec3 drawn(const Pose& partner, const RecordedMoment& moment, const Pose& user, const RootFrame& user_root,
             const Body& body) const;

  /// Lists the holds with strength above 0; a ramping hold demands little more than the arm's reach.
  /// @param partner after place_arms
  void list(const Pose& partner, const Pose& user, const RootFrame& user_root,
            std::vector<HandHold>& holds) const;

  const Pairs& pairs() const { return pairs_; }
  const Arms& arms() const { return arms_; }
  const UserHands& user_hands() const { return user_hands_; }

 private:
  /// Whether these hands hold one another in the recording now or soon.
  static bool look_at_recording(Pair& pair, const MotionLibrary& library, const SourcePlayhead& playhead,
                                const RecordedMoment& moment, bool source_changed, int user_hand,
                                int partner_hand);
  static bool is_out_of_reach(const Pair& pair, const Vec3& shoulder_to_hand, const Vec3& wrist_to_hand,
                              double arm_m);
  static void follow(Pair& pair, const Vec3& offset, bool begins, double elapsed_s);
  static void reach_for(Pose& pose, const Body& body, const RootFrame& place, int hand, const Vec3& target,
                        double share, Arm& arm, double elapsed_s);

  Pairs pairs_;
  Arms arms_;
  UserHands user_hands_;
};

}  // namespace abrazo
