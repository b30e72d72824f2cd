#pragma once

#include <optional>
#include <string>

#include "core/motion/body/body.hpp"

namespace abrazo {

/// A calibration in the T-pose step by step: counts down, measures while the user holds still, judges. Knows
/// neither window nor stream; is given the time and what was seen.
class CalibrationSteps {
 public:
  static constexpr double countdown_s = 3, hold_s = 1;
  static constexpr double patience_s = 1.5;  ///< after holding still, for the measures to come

  enum class Stage { Idle, Countdown, Hold, Done, Failed };
  struct Seen {
    bool is_tracked = false;
    std::optional<Body> measured;  ///< of the user, by the stream
  };

  void start(double now_s);
  void cancel() { stage_ = Stage::Idle; }
  /// @return whether the measuring is to begin now
  bool advance(double now_s, const Seen& seen);

  Stage stage() const { return stage_; }
  bool is_under_way() const { return stage_ == Stage::Countdown || stage_ == Stage::Hold; }
  /// Large: "3", "Hold still"; empty while nothing goes on.
  std::string large(double now_s) const;
  /// What to do, or what came of it.
  const std::string& words() const { return words_; }

 private:
  void finish(Stage stage, std::string words);

  Stage stage_ = Stage::Idle;
  double since_s_ = 0;
  std::optional<Body> before_;  ///< as measured before this calibration
  std::string words_;
};

/// The measures of a body in words, and whether they are those of a person: head at 1.0 to 2.2 m, arm span
/// from hand to hand in the T-pose 0.75 to 1.25 of it.
struct BodyVerdict {
  bool is_plausible = false;
  std::string words;
};
BodyVerdict judge_body(const Body& body);

/// From hand to hand with both arms stretched out [m].
double arm_span(const Body& body);

}  // namespace abrazo
