#pragma once

#include <cstdint>

namespace abrazo {

/// Quality of a performance. The defaults are an expert's.
struct Performance {
  double amplitude = 1;       ///< of steps, hips, arms and blows; 0.5 .. 1.3
  double timing_error_s = 0;  ///< standard deviation of the start time of a move [s]; 0 .. 0.25
  double wander_m = 0;        ///< slow, random drift of trunk and hands from their targets, rms [m]; 0 .. 0.1
};

/// Performance for a skill from beginner (0) to expert (1): beginners have smaller amplitude, timing errors
/// and drift.
/// @throws std::invalid_argument when the skill is not between 0 and 1
Performance performance_of_skill(double skill);

/// Build and skill of a performer.
struct PerformerOptions {
  double height_m = 1.75;  ///< 1.4 .. 2.2
  double arm_scale = 1;    ///< length of the arms relative to a usual body of this height; 0.8 .. 1.25
  double leg_scale = 1;    ///< likewise, at constant height (trunk and neck compensate); 0.85 .. 1.15
  Performance performance = {};
};

/// Paired takes to be generated. Same options, same takes.
struct ChoreographyOptions {
  std::uint64_t seed = 1;
  double minutes = 1;  ///< in all
  double fps = 60;
  double tempo_bpm = 0;  ///< salsa: beats, 8 to a count of eight; 0 draws one of 160 .. 190 for every take
  double pace = 1;       ///< fight: relative speed of blows and footwork
  double take_seconds = 20;  ///< the minutes are divided into takes of about this length
  PerformerOptions a{.height_m = 1.80, .performance = {}};  ///< leader; the fighter who attacks first
  PerformerOptions b{.height_m = 1.66, .performance = {}};
};

/// @param who  named in the message
/// @throws std::invalid_argument when a value is outside the range given with it
void check_performer(const PerformerOptions& performer, const char* who);

/// Checks both performers, and that durations, frame rate, pace and tempo are positive.
/// @throws std::invalid_argument naming the invalid option
void check_options(const ChoreographyOptions& options);

}  // namespace abrazo
