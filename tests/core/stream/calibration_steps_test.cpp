// A calibration in the T-pose, step by step on a clock of the test's own.
#include <gtest/gtest.h>

#include "core/stream/receive/calibration_steps.hpp"

namespace abrazo::calibration_steps_test {
namespace {

using Stage = CalibrationSteps::Stage;

/// Arms of 0.25 m + 0.25 m + 0.15 m at shoulders 0.35 m apart; legs and spine that put the head at about 1.6
/// m.
Body person(double scale = 1) {
  Body body;
  const auto set = [&body, scale](int joint, double length_m) {
    body.bone_lengths[static_cast<std::size_t>(joint - 1)] = scale * length_m;
  };
  for (const int joint : {joints::left_elbow, joints::right_elbow}) set(joint, 0.25);
  for (const int joint : {joints::left_wrist, joints::right_wrist}) set(joint, 0.25);
  for (const int joint : {joints::left_hand, joints::right_hand}) set(joint, 0.15);
  for (const int joint : {joints::left_knee, joints::right_knee}) set(joint, 0.42);
  for (const int joint : {joints::left_ankle, joints::right_ankle}) set(joint, 0.42);
  for (const int joint : {joints::LowerBack, joints::UpperBack, joints::Thorax}) set(joint, 0.14);
  for (const int joint : {joints::LowerNeck, joints::UpperNeck, joints::Head}) set(joint, 0.08);
  body.pseudo_lengths = {scale * 0.2, scale * 0.35, scale * 0.18, scale * 0.18};
  return body;
}

class Calibration : public testing::Test {
 protected:
  /// Till the measuring begins.
  void count_down() {
    steps.start(10);
    EXPECT_FALSE(steps.advance(12.9, {true, {}}));
    EXPECT_TRUE(steps.advance(13, {true, {}})) << "now the stream is to measure";
  }
  CalibrationSteps steps;
};

TEST_F(Calibration, CountsThreeTwoOne) {
  steps.start(10);
  EXPECT_EQ(steps.large(10.01), "3");
  EXPECT_EQ(steps.large(11.01), "2");
  EXPECT_EQ(steps.large(12.99), "1");
}

TEST_F(Calibration, MeasuresForASecondAndTellsHeightAndArmSpan) {
  count_down();
  EXPECT_EQ(steps.large(13.5), "Hold still");
  steps.advance(13.9, {true, person()});
  EXPECT_TRUE(steps.is_under_way()) << "the second is not over";
  steps.advance(14, {true, person()});
  EXPECT_EQ(steps.stage(), Stage::Done);
  EXPECT_NE(steps.words().find("1.65 m from hand to hand: plausible"), std::string::npos) << steps.words();
}

TEST_F(Calibration, OfSomeoneWhoDancesIsDoneButTold) {
  count_down();
  steps.advance(14, {true, person(), {"a joint moved by 0.40 m meanwhile; stand still"}});
  EXPECT_EQ(steps.stage(), Stage::Done);
  EXPECT_TRUE(steps.is_doubtful());
  EXPECT_TRUE(steps.words().starts_with("Calibrated, but look: head at")) << steps.words();
  EXPECT_TRUE(steps.words().ends_with(
      "the T-pose is doubtful: a joint moved by 0.40 m meanwhile; stand still; then calibrate again"))
      << steps.words();
  count_down();
  EXPECT_FALSE(steps.is_doubtful());
  steps.advance(14, {true, person()});
  EXPECT_FALSE(steps.is_doubtful());
}

TEST_F(Calibration, TellsTheFirstDoubtAndTheNumberOfTheOthersInALine) {
  count_down();
  steps.advance(14, {true, person()});
  EXPECT_EQ(steps.brief(), steps.words()) << "there is no doubt";
  count_down();
  steps.advance(14, {true, person(), {"one foot is higher than the other; stand on both"}});
  EXPECT_EQ(steps.brief(), "Calibrated, but doubtful: one foot is higher than the other; stand on both");
  count_down();
  steps.advance(14,
                {true, person(), {"the left arm is bent by 80 degrees; stretch it", "another", "a third"}});
  EXPECT_EQ(steps.brief(),
            "Calibrated, but doubtful: the left arm is bent by 80 degrees; stretch it, and 2 more");
}

TEST_F(Calibration, ThatMeasuresTheSameAsBeforeIsDoneAfterAWhile) {
  steps.start(10);
  steps.advance(13, {true, person()});
  steps.advance(14.1, {true, person()});
  EXPECT_TRUE(steps.is_under_way()) << "these may be the measures from before";
  steps.advance(15.6, {true, person()});
  EXPECT_EQ(steps.stage(), Stage::Done);
}

TEST_F(Calibration, FailsWithAReasonWhenTheUserIsNotTracked) {
  steps.start(10);
  EXPECT_FALSE(steps.advance(13, {false, {}}));
  EXPECT_EQ(steps.stage(), Stage::Failed);
  EXPECT_NE(steps.words().find("not tracked"), std::string::npos);
  count_down();
  steps.advance(13.5, {false, {}});
  EXPECT_EQ(steps.stage(), Stage::Failed);
  EXPECT_NE(steps.words().find("tracking was lost"), std::string::npos);
}

TEST_F(Calibration, FailsWhenNoMeasuresCome) {
  count_down();
  steps.advance(15.4, {true, {}});
  EXPECT_TRUE(steps.is_under_way());
  steps.advance(15.6, {true, {}});
  EXPECT_EQ(steps.stage(), Stage::Failed);
}

TEST_F(Calibration, AGiantOrArmsThatHangAreSaid) {
  EXPECT_TRUE(judge_body(person()).is_plausible);
  EXPECT_FALSE(judge_body(person(100)).is_plausible);
  EXPECT_NE(judge_body(person(100)).words.find("unit"), std::string::npos);
  Body short_arms = person();
  for (const int joint : {joints::left_elbow, joints::left_wrist, joints::right_elbow, joints::right_wrist})
    short_arms.bone_lengths[static_cast<std::size_t>(joint - 1)] = 0.05;
  EXPECT_FALSE(judge_body(short_arms).is_plausible);
  EXPECT_NE(judge_body(short_arms).words.find("arms"), std::string::npos);
}

TEST_F(Calibration, IsCancelled) {
  steps.start(10);
  steps.cancel();
  EXPECT_FALSE(steps.advance(13, {true, {}}));
  EXPECT_EQ(steps.large(13), "");
}

}  // namespace
}  // namespace abrazo::calibration_steps_test
