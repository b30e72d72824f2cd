#include "core/choreography/choreography_options.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace abrazo {
namespace {

/// Also false for NaN.
bool within(double value, double low, double high) {
  return value >= low && value <= high;
}

void require(bool fine, const std::string& what) {
  if (!fine) throw std::invalid_argument("choreography options: " + what);
}

}  // namespace

Performance performance_of_skill(double skill) {
  require(within(skill, 0, 1), "skill must be between 0 and 1");
  const double missing = 1 - skill;
  // A beginner's step is some third smaller; at 175 bpm 0.12 s is a third of a beat.
  return {.amplitude = 1 - 0.35 * missing, .timing_error_s = 0.12 * missing, .wander_m = 0.03 * missing};
}

void check_performer(const PerformerOptions& performer, const char* who) {
  const std::string name(who);
  require(within(performer.height_m, 1.4, 2.2), name + "'s height must be between 1.4 and 2.2 m");
  require(within(performer.arm_scale, 0.8, 1.25), name + "'s arm scale must be between 0.8 and 1.25");
  require(within(performer.leg_scale, 0.85, 1.15), name + "'s leg scale must be between 0.85 and 1.15");
  const Performance& performance = performer.performance;
  require(within(performance.amplitude, 0.5, 1.3), name + "'s amplitude must be between 0.5 and 1.3");
  require(within(performance.timing_error_s, 0, 0.25), name + "'s timing error must be between 0 and 0.25 s");
  require(within(performance.wander_m, 0, 0.1), name + "'s wander must be between 0 and 0.1 m");
}

void check_options(const ChoreographyOptions& options) {
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  require(positive(options.minutes) && positive(options.take_seconds), "durations must be positive");
  require(positive(options.fps) && positive(options.pace), "frame rate and pace must be positive");
  require(options.tempo_bpm == 0 || positive(options.tempo_bpm),
          "the tempo must be positive, or 0 to be drawn");
  check_performer(options.a, "performer a");
  check_performer(options.b, "performer b");
}

}  // namespace abrazo
