#pragma once

#include <string_view>
#include <vector>

#include "core/base/positions.hpp"
#include "core/choreography/random_source.hpp"

namespace abrazo {

/// A figure of one 8-count.
enum class SalsaMove { OpenHold, ClosedHold, Turn, CrossBodyLead };

/// "open_hold", ... as in label files.
std::string_view label_of(SalsaMove move);

inline constexpr int beats_per_phrase = 8;

/// One 8-count and how it is danced this time.
struct SalsaPhrase {
  SalsaMove move = SalsaMove::OpenHold;
  double step = 0.27;          ///< length of the forward and back steps [m]
  double distance = 0.85;      ///< between the pelvises [m]
  double offset = 0;           ///< follower beside the leader's centre line, towards his right [m]
  double couple_turn = 0;      ///< the couple's turn over the phrase, positive left [rad]
  Vec3 travel = Vec3::Zero();  ///< of the couple's centre over the phrase [m]
  double hips = 1;             ///< amplitude of the hip motion
  double hand_sway = 0.06;     ///< how far the held hands are drawn to and fro [m]
  double hand_height = 0;      ///< of the held hands above their usual height [m]
  double hand_spread = 0;      ///< of the held hands further to the side than usual [m]
  double grip = 0.045;         ///< between the hand ends of a hold [m]
};

/// Share of the couple's turn that is made by a beat of the phrase (-0.5 .. 7.5).
double couple_progress(SalsaMove move, double beat);

/// Phrases in random order. Every move comes twice in eight, and the couple stays within some 1.5 m of the
/// origin.
std::vector<SalsaPhrase> draw_phrases(int count, RandomSource& random);

}  // namespace abrazo
