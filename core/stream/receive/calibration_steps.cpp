#include "core/stream/receive/calibration_steps.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace abrazo {
namespace {

constexpr double lowest_m = 1.0, highest_m = 2.2;         // of the head joint
constexpr double least_span = 0.75, largest_span = 1.25;  // of that height

}  // namespace

double arm_span(const Body& body) {
  double span = body.pseudo_lengths[1];  // from shoulder to shoulder
  for (const int joint : {joints::left_elbow, joints::left_wrist, joints::left_hand, joints::right_elbow,
                          joints::right_wrist, joints::right_hand})
    span += body.bone_lengths[static_cast<std::size_t>(joint - 1)];
  return span;
}

BodyVerdict judge_body(const Body& body) {
  const double height = body.height(), span = arm_span(body);
  const std::string measures = fmt::format("head at {:.2f} m, {:.2f} m from hand to hand", height, span);
  if (!(height >= lowest_m && height <= highest_m))
    return {
        false,
        measures + ": not the height of a person; check the sender's unit and floor, then calibrate again"};
  if (!(span >= least_span * height && span <= largest_span * height))
    return {false,
            measures + ": the arms do not fit the height; stretch both out to the sides and calibrate again"};
  return {true, measures + ": plausible"};
}

void CalibrationSteps::start(double now_s) {
  stage_ = Stage::Countdown;
  since_s_ = now_s;
  is_doubtful_ = false;
  words_ = "Stand in the T-pose: straight, arms out to the sides, palms down, looking ahead";
}

void CalibrationSteps::finish(Stage stage, std::string words) {
  stage_ = stage;
  words_ = std::move(words);
  brief_ = words_;
}

void CalibrationSteps::finish_with(const Body& body, const std::vector<std::string>& doubts) {
  const BodyVerdict verdict = judge_body(body);
  is_doubtful_ = !verdict.is_plausible || !doubts.empty();
  std::string words = (is_doubtful_ ? "Calibrated, but look: " : "Calibrated: ") + verdict.words;
  if (!doubts.empty())
    words += fmt::format("; the T-pose is doubtful: {}; then calibrate again", fmt::join(doubts, "; "));
  finish(Stage::Done, std::move(words));
  if (!is_doubtful_) return;
  const std::size_t more = doubts.size() - (verdict.is_plausible ? 1 : 0);
  brief_ = "Calibrated, but doubtful: " + (verdict.is_plausible ? doubts.front() : verdict.words) +
           (more > 0 ? fmt::format(", and {} more", more) : "");
}

bool CalibrationSteps::advance(double now_s, const Seen& seen) {
  const double elapsed_s = now_s - since_s_;
  if (stage_ == Stage::Countdown && elapsed_s >= countdown_s) {
    if (!seen.is_tracked) {
      finish(
          Stage::Failed,
          "Not calibrated: the user is not tracked now. Step to where the capture sees you, then try again");
      return false;
    }
    stage_ = Stage::Hold;
    since_s_ = now_s;
    before_ = seen.measured;
    words_ = "Hold still";
    return true;
  }
  if (stage_ != Stage::Hold) return false;
  if (!seen.is_tracked) {
    finish(Stage::Failed, "Not calibrated: tracking was lost while measuring. Try again");
    return false;
  }
  if (elapsed_s < hold_s) return false;
  const bool is_new = seen.measured && (!before_ || seen.measured->bone_lengths != before_->bone_lengths);
  // The same person measured twice may come out the same: then the last of the wait decides.
  if (is_new || (seen.measured && elapsed_s >= hold_s + patience_s)) {
    finish_with(*seen.measured, seen.doubts);
  } else if (elapsed_s >= hold_s + patience_s) {
    finish(Stage::Failed,
           "Not calibrated: too few whole poses came in within a second. See the diagnosis below, then try "
           "again");
  }
  return false;
}

std::string CalibrationSteps::large(double now_s) const {
  if (stage_ == Stage::Hold) return "Hold still";
  if (stage_ != Stage::Countdown) return {};
  return std::to_string(std::max(1, static_cast<int>(std::ceil(countdown_s - (now_s - since_s_)))));
}

}  // namespace abrazo
