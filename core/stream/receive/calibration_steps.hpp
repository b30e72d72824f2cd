#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/body/body.hpp"

namespace abrazo {

/// A calibration in the T-pose step by step: counts down, measures while the user holds still, judges the
/// result. Independent of window and stream; gets the time and the measurements.
class CalibrationSteps {
 public:
  static constexpr double countdown_s = 3, hold_s = 1;
  static constexpr double patience_s = 1.5;  ///< wait for the measurements after holding still

  enum class Stage { Idle, Countdown, Hold, Done, Failed };
  struct Seen {
    bool is_tracked = false;
    std::optional<Body> measured;          ///< of the user, from the stream
    std::vector<std::string> doubts = {};  ///< deviations from a T-pose while it was measured
  };

  void start(double now_s);
  void cancel() { stage_ = Stage::Idle; }
  /// @return whether to begin measuring now
  bool advance(double now_s, const Seen& seen);

  Stage stage() const { return stage_; }
  bool is_under_way() const { return stage_ == Stage::Countdown || stage_ == Stage::Hold; }
  /// Large text: "3", "Hold still"; empty when idle.
  std::string large(double now_s) const;
  /// Instruction or result.
  const std::string& words() const { return words_; }
  /// The same in a line: of the doubts the first, and how many there are.
  const std::string& brief() const { return brief_; }
  /// Done, but the measurements are implausible or the pose was no T-pose.
  bool is_doubtful() const { return is_doubtful_; }

 private:
  void finish(Stage stage, std::string words);
  void finish_with(const Body& body, const std::vector<std::string>& doubts);

  Stage stage_ = Stage::Idle;
  double since_s_ = 0;
  std::optional<Body> before_;  ///< body before this calibration
  std::string words_, brief_;
  bool is_doubtful_ = false;
};

/// The measurements of a body as text, and whether they are plausible for a person: head at 1.0 to 2.2 m, arm
/// span from hand to hand in the T-pose 0.75 to 1.25 times that.
struct BodyVerdict {
  bool is_plausible = false;
  std::string words;
};
BodyVerdict judge_body(const Body& body);

/// Distance from hand to hand with arms stretched sideways [m].
double arm_span(const Body& body);

}  // namespace abrazo
