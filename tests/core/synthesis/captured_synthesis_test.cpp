// The method on captured salsa: what must hold on real motion, whatever the machine.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "core/library/build/motion_library_builder.hpp"
#include "core/library/takes/manifest.hpp"
#include "core/metrics/run_summary.hpp"
#include "core/synthesis/step/clip_synthesis.hpp"
#include "tests/support/captured_data.hpp"
#include "tests/support/settings.hpp"

namespace abrazo::captured_synthesis_test {
namespace {

constexpr double metres_per_unit = (1 / 0.45) * 2.54 / 100;

PairedTake captured_take(const std::filesystem::path& data, const std::string& number,
                         ActivePerformer leader = ActivePerformer::A) {
  Manifest::Take take;
  take.name = "salsa_" + number;
  take.fps = 60;
  take.metres_per_unit = metres_per_unit;
  take.a = {data / "cmu_salsa" / ("60_" + number + ".amc"), data / "cmu_salsa" / "60.asf"};
  take.b = {data / "cmu_salsa" / ("61_" + number + ".amc"), data / "cmu_salsa" / "61.asf"};
  take.roles = {{0, 1 << 30, leader}};
  std::vector<std::string> warnings;
  return std::move(*load_take(take, warnings));
}

std::shared_ptr<const MotionLibrary> captured_library(const std::filesystem::path& data) {
  std::vector<PairedTake> takes;
  for (const char* number : {"02", "03", "05"}) takes.push_back(captured_take(data, number));
  auto library = build_library("cmu-salsa", std::move(takes), {}, {});
  return std::make_shared<const MotionLibrary>(std::move(*library));
}

class CapturedSalsa : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const auto data = test::captured_data();
    if (!data) return;
    library = captured_library(*data);
    user = captured_take(*data, "01").a;
    user.poses.resize(900);  // the approach and the first moves
  }
  static void TearDownTestSuite() { library.reset(); }
  void SetUp() override {
    if (!library) GTEST_SKIP() << "captured motions not found; set ABRAZO_DATA to try this";
  }

  static RunSummary::Figures run(const Settings& settings, const Clip& clip) {
    auto synthesizer = std::move(*PartnerSynthesizer::create(library, settings));
    RunSummary summary(*library);
    const Status done = synthesize_clip(
        *synthesizer, clip,
        [&](const ClipStep& step) -> Status { return summary.add(step.result, step.time_s), Done{}; }, {});
    EXPECT_TRUE(done.ok());
    return summary.figures();
  }

  static inline std::shared_ptr<const MotionLibrary> library;
  static inline Clip user;
};

TEST_F(CapturedSalsa, ConstraintsHoldInBothPresets) {
  for (const auto name : preset_names) {
    const RunSummary::Figures figures = run(*preset(name), user);
    EXPECT_EQ(figures.failed, 0U) << name;
    EXPECT_LT(figures.bone_length_max, 1e-3) << name;
    EXPECT_LT(figures.foot_lock_drift_max_m, 1e-3) << name;
    // A partner that moves on its own is parted by and by, and hands that are held keep bodies nearer.
    EXPECT_LT(figures.excess_penetration_p99_m, name == "paper" ? 0.01 : 0.055) << name;
    EXPECT_LT(static_cast<double>(figures.relaxed), 0.02 * static_cast<double>(figures.frames)) << name;
  }
}

TEST_F(CapturedSalsa, BodiesArePartedToTheRecordedOverlapByFrames) {
  Settings settings = *preset("responsive");
  settings.playback = SourcePlayback::Frames;
  EXPECT_LT(run(settings, user).excess_penetration_p99_m, 0.01);
}

/// One take's partner is the other dancer, whose shoulders are wider and turn less: all partners are given
/// one body, and no frame is held for want of a girdle that has its distances.
TEST_F(CapturedSalsa, DancersWhoTakeTurnsAsPartnersFitOneBody) {
  const auto data = *test::captured_data();
  std::vector<PairedTake> takes;
  takes.push_back(captured_take(data, "01"));
  takes.push_back(captured_take(data, "02", ActivePerformer::B));
  takes.push_back(captured_take(data, "05"));
  auto both =
      std::make_shared<const MotionLibrary>(std::move(*build_library("both", std::move(takes), {}, {})));
  auto synthesizer = std::move(*PartnerSynthesizer::create(both, test::responsive_by_pose()));
  const Clip leader = captured_take(data, "03").a;
  std::size_t of_the_other_dancer = 0;
  for (std::size_t frame = 0; frame < leader.poses.size(); ++frame) {
    const FrameResult& result = synthesizer->step(leader.poses[frame], Duration(1 / leader.fps));
    ASSERT_NE(result.status, StepStatus::Failed) << "frame " << frame << ": " << result.message;
    EXPECT_LT(result.residual.bone_length_max, 1e-3) << "frame " << frame;
    const int pair = result.candidates[static_cast<std::size_t>(result.selected)].pair;
    of_the_other_dancer += both->take_of(pair).name == "salsa_02";
  }
  EXPECT_GT(of_the_other_dancer, leader.poses.size() / 10) << "otherwise this tries nothing";
}

TEST_F(CapturedSalsa, TheRecordedPairComesBackWhenTheUserIsTheRecordedLeader) {
  Settings settings = *preset("paper");
  settings.velocity_weight = 0;
  settings.foot_locks = false;
  auto synthesizer = std::move(*PartnerSynthesizer::create(library, settings));
  const PairedTake take = captured_take(*test::captured_data(), "03");
  synthesizer->set_user_body(library->usual_active_body().body);
  double largest = 0;
  for (int frame = 0; frame < static_cast<int>(take.a.poses.size()); frame += 20) {
    synthesizer->pin_pair(library->find_pair("salsa_03", frame, false));
    const auto at = static_cast<std::size_t>(frame);
    const FrameResult& result = synthesizer->step(take.a.poses[at], Duration(1.0 / 15));
    ASSERT_EQ(result.status, StepStatus::Ok);
    largest = std::max({largest, (result.active() - take.a.poses[at]).cwiseAbs().maxCoeff(),
                        (result.passive() - take.b.poses[at]).cwiseAbs().maxCoeff()});
  }
  EXPECT_LT(largest, 1e-6);
}

/// The leader with other proportions: every bone of a limb longer or shorter, joint angles as captured.
Pose with_limbs_scaled(const Pose& pose, double arms, double legs) {
  Pose result = pose;
  for (int joint = 1; joint < joint_count; ++joint) {
    const int parent = joint_parents[static_cast<std::size_t>(joint)];
    const bool arm = joint > joints::left_shoulder && joint != joints::right_shoulder;
    const bool leg = joint < joints::LowerBack && joint != joints::left_hip && joint != joints::right_hip;
    result.row(joint) = result.row(parent) + (arm   ? arms
                                              : leg ? legs
                                                    : 1.0) *
                                                 (pose.row(joint) - pose.row(parent));
  }
  const double lowest = std::min(result(joints::left_toe_base, 1), result(joints::right_toe_base, 1));
  const double was = std::min(pose(joints::left_toe_base, 1), pose(joints::right_toe_base, 1));
  result.col(1).array() += was - lowest;  // still on the floor
  return result;
}

TEST_F(CapturedSalsa, UsersOfOtherSizesAndWithLongArmsKeepHoldingHands) {
  const RunSummary::Figures own = run(*preset("responsive"), user);
  ASSERT_GT(own.holds, 50U);
  const auto expect_holds = [&](const char* who, const std::function<Pose(const Pose&)>& other_body) {
    Clip other = user;
    for (Pose& pose : other.poses) pose = other_body(pose);
    const RunSummary::Figures figures = run(*preset("responsive"), other);
    EXPECT_EQ(figures.failed, 0U) << who;
    EXPECT_GT(figures.holds, own.holds / 2) << who;
    EXPECT_LT(figures.hold_change_mean_m, std::min(0.06, own.hold_change_mean_m + 0.015)) << who;
    EXPECT_LT(figures.bone_length_max, 1e-3) << who;
  };
  expect_holds("85 %", [](const Pose& pose) -> Pose { return 0.85 * pose; });
  expect_holds("115 %", [](const Pose& pose) -> Pose { return 1.15 * pose; });
  expect_holds("arms 20 % longer", [](const Pose& pose) { return with_limbs_scaled(pose, 1.2, 1.0); });
  expect_holds("legs 10 % longer, arms 10 % shorter",
               [](const Pose& pose) { return with_limbs_scaled(pose, 0.9, 1.1); });
}

}  // namespace
}  // namespace abrazo::captured_synthesis_test
