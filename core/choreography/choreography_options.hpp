#pragma once

#include <cstdint>

namespace abrazo {

/// How a performer carries out what is choreographed. The defaults are an expert's.
struct Performance {
  double amplitude = 1;       ///< of steps, hips, arms and blows; 0.5 .. 1.3
  double timing_error_s = 0;  ///< standard deviation of how early or late a move is begun [s]; 0 .. 0.25
  double wander_m =
      0;  ///< slow, random drift of trunk and hands from where they should be, rms [m]; 0 .. 0.1
};

/// From a first lesson (0) to an expert (1): smaller, late and early, unsteady.
/// @throws std::invalid_argument when the skill is not between 0 and 1
Performance performance_of_skill(double skill);

/// Build of a performer and how well he or she performs.
struct PerformerOptions {
  double height_m = 1.75;  ///< 1.4 .. 2.2
  double arm_scale = 1;    ///< length of the arms against that of a usual body of this height; 0.8 .. 1.25
  double leg_scale = 1;    ///< likewise, the height staying (trunk and neck give way); 0.85 .. 1.15
  Performance performance = {};
};

/// Paired takes to be generated. Same options, same takes.
struct ChoreographyOptions {
  std::uint64_t seed = 1;
  double minutes = 1;  ///< in all
  double fps = 60;
  double tempo_bpm = 0;  ///< salsa: beats, 8 to a count of eight; 0 draws one of 160 .. 190 for every take
  double pace = 1;       ///< fight: speed of blows and footwork against the usual
  double take_seconds = 20;  ///< the minutes are divided into takes of about this length
  PerformerOptions a{.height_m = 1.80, .performance = {}};  ///< leader; the fighter who attacks first
  PerformerOptions b{.height_m = 1.66, .performance = {}};
};

/// @param who  named in the message
/// @throws std::invalid_argument when a value is outside the range given with it
void check_performer(const PerformerOptions& performer, const char* who);

/// Both performers, and that durations, frame rate, pace and tempo are positive.
/// @throws std::invalid_argument saying which is not
void check_options(const ChoreographyOptions& options);

}  // namespace abrazo
