#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/positions.hpp"
#include "core/choreography/random_source.hpp"

namespace abrazo {

/// The six categories of the paper.
enum class SalsaMove { OpenHold, ClosedHold, Turn, CrossBodyLead, Walk, InAndOut };

/// The figure of one 8-count.
enum class SalsaFigure {
  OpenBasic,
  ClosedBasic,
  FollowerRightTurn,
  FollowerLeftTurn,
  InsideTurn,  ///< her left turn in a cross body lead
  LeaderRightTurn,
  LeaderLeftTurn,
  CrossBodyLead,
  WalkToHisLeft,   ///< side by side, she on his right
  WalkToHisRight,  ///< side by side, she on his left
  WalkInTandem,    ///< she in front
  InAndOut
};

SalsaMove move_of(SalsaFigure figure);

/// "open_hold", ... as in label files.
std::string_view label_of(SalsaMove move);

/// Direction of turns and held hands (`Lr`: his left, her right), as in label files.
std::string_view detail_of(SalsaFigure figure);

inline constexpr int beats_per_phrase = 8;

/// One 8-count with its random variation.
struct SalsaPhrase {
  SalsaFigure figure = SalsaFigure::OpenBasic;
  double step = 0.27;          ///< length of the forward and back steps [m]
  double distance = 0.85;      ///< between the pelvises [m]
  double offset = 0;           ///< follower beside the leader's centre line, towards his right [m]
  double couple_turn = 0;      ///< the couple's turn over the phrase, positive left [rad]
  Vec3 travel = Vec3::Zero();  ///< of the couple's centre over the phrase, besides the walk, as `walked` [m]
  double walk = 0;             ///< how far a walk goes [m]
  double hips = 1;             ///< amplitude of the hip motion
  double his_lean = 0, her_lean = 0;  ///< of the trunk, forward [rad]
  double delay = 0;                   ///< of a turn [beats]
  double hand_sway = 0.06;            ///< how far the held hands are drawn to and fro [m]
  double hand_height = 0;             ///< of the held hands above their usual height [m]
  double hand_spread = 0;             ///< of the held hands further to the side than usual [m]
  double grip = 0.08;                 ///< between the hand ends of a hold [m]
  bool both_hands = true;             ///< his right also holds her left, where the figure allows it
};

/// End of a walk, in the space of the couple at its start: x to the leader's left, z towards the follower.
Vec3 walked(const SalsaPhrase& phrase);

/// Phrases in random order. Every move occurs twice in twelve, and the couple stays within about 3 m of the
/// origin.
std::vector<SalsaPhrase> draw_phrases(int count, RandomSource& random);

}  // namespace abrazo
