#pragma once

#include <vector>

#include "core/choreography/choreography_options.hpp"
#include "core/choreography/couple_path.hpp"
#include "core/choreography/dancer_body.hpp"
#include "core/choreography/fighter_limbs.hpp"
#include "core/choreography/footwork.hpp"
#include "core/choreography/posture.hpp"
#include "core/choreography/random_source.hpp"
#include "core/choreography/smooth_track.hpp"

namespace abrazo {

/// Offsets of trunk and heels from upright on the spot. Leans and turns are in the space of the spot.
enum TrunkChannel {
  Forward,  ///< of the root [m]
  Leftward,
  Upward,
  PelvisYaw,   ///< positive left [rad]
  PelvisLean,  ///< forward
  PelvisTilt,  ///< to the left
  ChestYaw,
  ChestLean,
  ChestTilt,
  HeadLean,
  LeftHeel,  ///< raised by [m]
  RightHeel,
  TrunkChannelCount
};
using TrunkOffsets = Eigen::Array<double, TrunkChannelCount, 1>;

/// The guard: left foot and shoulder forward, knees bent, rear heel up.
TrunkOffsets guard_stance();

/// Rises from 0 to 1, stays there and falls back; velocity and acceleration are continuous.
struct Pulse {
  double start = 0, full = 0, release = 0, end = 0;  ///< [s], ascending
  double at(double time) const;
};

/// Trunk and heels leave the guard and return.
struct TrunkMove {
  Pulse pulse = {};
  TrunkOffsets offsets;
};

/// A hand leaves the guard for a position in the world and returns.
struct HandMove {
  Pulse pulse = {};
  Vec3 target = Vec3::Zero();
  Vec3 arc = Vec3::Zero();    ///< lateral deviation of the path half-way [m]
  Pulse swept = {};           ///< a parry continues
  Vec3 sweep = Vec3::Zero();  ///< by this [m]
  Vec3 elbow = Vec3::Zero();  ///< its direction, chest space of the left arm
};

/// A foot leaves the floor, is drawn up, may strike, and returns to its position.
struct LegMove {
  Pulse chamber = {};
  Vec3 drawn_up = Vec3::Zero();  ///< ankle from the hip, pelvis space [m]
  Pulse strike = {};             ///< none if all zero
  Vec3 target = Vec3::Zero();    ///< of the ankle, world
  Vec3 arc = Vec3::Zero();
  Pulse swept = {};
  Vec3 sweep = Vec3::Zero();
  Vec3 hinge = Vec3::UnitX();  ///< axis of the knee, pelvis space
  double pointed = 0;          ///< of the foot from square to the shank [rad]
};

/// Root, hips, spine, head and shoulders placed, limbs not yet.
struct PlacedTrunk {
  TrunkPosture posture;
  Pose pose = Pose::Zero();
};

/// One fighter's motion over a take: moves added in order of time, and the pose at any time.
class Fighter {
 public:
  Fighter(const DancerBody& body, const Performance& performance, const Spot& start, double seconds,
          RandomSource& random);

  const DancerBody& body() const { return body_; }
  const Performance& performance() const { return performance_; }

  /// Time at which a foot has finished all moves added so far [s].
  double free_from(Side side) const;
  double free_from() const;
  /// The spot after everything added so far.
  const Spot& final_spot() const { return shuffles_.empty() ? start_ : shuffles_.back().to; }
  Spot spot(double time) const;

  /// One foot after the other to another spot, the one nearer to it first; in several steps if it is far.
  /// @return the time of arrival
  double shuffle(double start, double duration, const Spot& to);
  /// Turns a standing foot on its ball, relative to its direction in the guard.
  void pivot(Side side, double start, double end, double yaw);
  void add(const TrunkMove& move) { trunk_moves_.push_back(move); }
  void add(Side side, const HandMove& move) { hand_moves_[index_of(side)].push_back(move); }
  void add(Side side, const LegMove& move);
  HandMove& last_hand_move(Side side) { return hand_moves_[index_of(side)].back(); }
  /// A leg move added before; its target is set after `settle`.
  LegMove& leg_move(Side side, std::size_t index) { return leg_moves_[index_of(side)][index]; }
  std::size_t leg_move_count(Side side) const { return leg_moves_[index_of(side)].size(); }

  /// Bends the knees where a step or lean would overstretch a leg. Call after all moves of trunk and feet are
  /// added.
  void settle(double seconds);

  Pose pose(double time) const;
  /// The pose without its limbs.
  PlacedTrunk trunk_at(double time) const;
  /// The trunk on a spot with only `offsets`, without limbs.
  PlacedTrunk trunk_on(const Spot& spot, const TrunkOffsets& offsets) const;
  /// Guard position of the hand of a placed trunk.
  Vec3 guard_hand(Side side, const PlacedTrunk& trunk, double heading) const;

 private:
  struct Shuffle {
    double start = 0, end = 0;
    Spot from, to;
  };
  using Idle = Eigen::Array<double, 12, 1>;

  static std::size_t index_of(Side side) { return side == Side::Left ? 0 : 1; }
  Vec3 stance_place(const Spot& spot, Side side) const;
  double stance_yaw(Side side) const;
  void step(double start, double duration, const Spot& to);
  void move_foot(Side side, double start, double end, const Spot& to);
  TrunkOffsets offsets(double time) const;
  TrunkPosture trunk(const Spot& spot, const TrunkOffsets& offsets) const;
  FootPosture foot(Side side, double time, const TrunkOffsets& offsets) const;
  bool airborne(Side side, double time) const;
  double overstretch(double time) const;
  PlacedTrunk trunk_at(double time, const TrunkOffsets& offsets) const;
  void place_leg(Side side, double time, const TrunkOffsets& offsets, PlacedTrunk& placed) const;
  void place_arm(Side side, double time, PlacedTrunk& placed) const;

  DancerBody body_;
  Performance performance_;
  Spot start_;
  double bounce_hz_, bounce_phase_;
  std::array<Footwork, 2> feet_;
  std::array<double, 2> landed_{};
  std::vector<Shuffle> shuffles_;
  std::vector<TrunkMove> trunk_moves_;
  std::array<std::vector<HandMove>, 2> hand_moves_;
  std::array<std::vector<LegMove>, 2> leg_moves_;
  SmoothTrack<Idle> idle_;
  SmoothTrack<double> lowered_{0, 1, {0.0}};
};

}  // namespace abrazo
