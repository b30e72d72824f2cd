// The method on captured salsa: what must hold on real motion, whatever the machine.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/library/manifest.hpp"
#include "core/library/motion_library_builder.hpp"
#include "core/retarget/body_retargeter.hpp"
#include "core/synthesis/clip_synthesis.hpp"
#include "core/synthesis/run_summary.hpp"
#include "tests/support/captured_data.hpp"

namespace abrazo {
namespace {

constexpr double metres_per_unit = (1 / 0.45) * 2.54 / 100;

PairedTake captured_take(const std::filesystem::path& data, const std::string& number) {
  Manifest::Take take;
  take.name = "salsa_" + number;
  take.fps = 60;
  take.metres_per_unit = metres_per_unit;
  take.a = {data / "cmu_salsa" / ("60_" + number + ".amc"), data / "cmu_salsa" / "60.asf"};
  take.b = {data / "cmu_salsa" / ("61_" + number + ".amc"), data / "cmu_salsa" / "61.asf"};
  take.roles = {{0, 1 << 30, ActivePerformer::A}};
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
    const Status done =
        synthesize_clip(*synthesizer, clip,
                        [&](const ClipStep& step) -> Status { return summary.add(step.result), Done{}; }, {});
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
    EXPECT_LT(figures.excess_penetration_p99_m, 0.01) << name;
    EXPECT_LT(static_cast<double>(figures.relaxed), 0.02 * static_cast<double>(figures.frames)) << name;
  }
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

TEST_F(CapturedSalsa, UsersOfOtherSizesAndWithLongArmsKeepHoldingHands) {
  const RunSummary::Figures own = run(*preset("paper"), user);
  ASSERT_GT(own.holds, 50U);
  Body long_armed = body_of(user.poses);
  for (const int joint : {joints::left_elbow, joints::left_wrist, joints::right_elbow, joints::right_wrist})
    long_armed.bone_lengths[static_cast<std::size_t>(joint - 1)] *= 1.2;
  const BodyRetargeter lengthen(body_of(user.poses), long_armed);
  for (const double scale : {0.85, 1.0, 1.15}) {
    Clip other = user;
    for (Pose& pose : other.poses) pose = scale == 1.0 ? lengthen.apply(pose) : Pose(scale * pose);
    const RunSummary::Figures figures = run(*preset("paper"), other);
    EXPECT_EQ(figures.failed, 0U);
    EXPECT_NEAR(figures.hold_change_mean_m, own.hold_change_mean_m, 0.003) << "scale " << scale;
  }
}

}  // namespace
}  // namespace abrazo
