// The metrics on captured salsa. The expected figures were measured with other programs on all fifteen takes
// of the same dancers, of which eleven are read here.
#include <gtest/gtest.h>

#include "core/library/build/capsule_calibration.hpp"
#include "core/library/takes/manifest.hpp"
#include "core/metrics/continuity.hpp"
#include "core/metrics/foot_slide.hpp"
#include "core/metrics/penetration.hpp"
#include "core/metrics/zmp.hpp"
#include "tests/support/captured_data.hpp"

namespace abrazo::captured_metrics_test {
namespace {

std::vector<Pose> every_nth(const std::vector<Pose>& poses, std::size_t n) {
  std::vector<Pose> thinned;
  for (std::size_t frame = 0; frame < poses.size(); frame += n) thinned.push_back(poses[frame]);
  return thinned;
}

class CapturedMetrics : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const auto data = test::captured_data();
    if (!data) return;
    for (const char* number : {"01", "02", "03", "05", "06", "07", "09", "10", "12", "13", "14"}) {
      Manifest::Take take;
      take.name = number;
      take.fps = 60;
      take.metres_per_unit = metres_per_asf_unit;
      take.a = {*data / "cmu_salsa" / ("60_" + take.name + ".amc"), *data / "cmu_salsa" / "60.asf"};
      take.b = {*data / "cmu_salsa" / ("61_" + take.name + ".amc"), *data / "cmu_salsa" / "61.asf"};
      std::vector<std::string> warnings;
      takes.push_back(std::move(*load_take(take, warnings)));
    }
  }
  static void TearDownTestSuite() { takes.clear(); }
  void SetUp() override {
    if (takes.empty()) GTEST_SKIP() << "captured motions not found; set ABRAZO_DATA to try this";
  }

  static inline std::vector<PairedTake> takes;
};

TEST_F(CapturedMetrics, ZmpErrorOfTheDancersIsThatOfTheReference) {
  struct Case {
    std::size_t stride;
    double smoothing_s, contact_height_m, expected_m;
  };
  for (const Case& c : {Case{1, 4.0 / 60, 0.10, 0.0451}, Case{2, 4.0 / 60, 0.10, 0.0418},
                        Case{4, 4.0 / 60, 0.10, 0.0374}, Case{2, 0, 0.10, 0.080}, Case{1, 0, 0.10, 0.136},
                        Case{2, 4.0 / 60, 0.07, 0.056}, Case{2, 4.0 / 60, 0.15, 0.040}}) {
    ZmpSettings settings;
    settings.smoothing_s = c.smoothing_s;
    settings.contact_height_m = c.contact_height_m;
    const double fps = 60.0 / static_cast<double>(c.stride);
    ZmpError both;
    for (const PairedTake& take : takes)
      for (const Clip* clip : {&take.a, &take.b})
        both.append(measure_zmp(every_nth(clip->poses, c.stride), fps, settings));
    EXPECT_NEAR(both.mean_m() / c.expected_m, 1, 0.06) << fps << " Hz, contact below " << c.contact_height_m;
    if (c.smoothing_s > 0 && c.contact_height_m == 0.10) {
      EXPECT_LT(both.skipped(), 0.02 * static_cast<double>(both.error_m.size()));
    }
  }
}

TEST_F(CapturedMetrics, DancersFeetBrushTheFloor) {
  for (const bool leader : {true, false}) {
    FootSlideMetric metric;
    for (const PairedTake& take : takes) {
      const std::vector<Pose>& poses = (leader ? take.a : take.b).poses;
      const ToeRest rest = toe_rest(poses);
      for (std::size_t frame = 1; frame < poses.size(); ++frame)
        metric.add(poses[frame - 1], poses[frame], 1.0 / 60, rest);
    }
    EXPECT_NEAR(metric.figures().mean_m_s, 0.15, 0.025) << (leader ? "leader" : "follower");
  }
}

TEST_F(CapturedMetrics, FollowerMovesAsFarAStepAsInTheReference) {
  ContinuityMetric metric;
  for (const PairedTake& take : takes) {
    metric.interrupt();
    for (const Pose& pose : every_nth(take.b.poses, 4)) metric.add(pose, false);
  }
  const ContinuityMetric::Figures figures = metric.figures();
  EXPECT_NEAR(figures.displacement_mean_m, 0.047, 0.002);
  EXPECT_NEAR(figures.displacement_p95_m, 0.091, 0.002);
  EXPECT_NEAR(figures.displacement_max_m, 0.121, 0.001);
}

TEST_F(CapturedMetrics, CalibratedCapsulesRarelyPenetrateInTheRecording) {
  const std::vector<Body> bodies = {body_of(takes.front().a.poses), body_of(takes.front().b.poses)};
  const std::vector<TakeBodies> of_takes(takes.size(), TakeBodies{0, 1});
  const std::vector<CapsuleRadii> radii = calibrate_capsules(takes, of_takes, bodies);
  PenetrationMetric metric;
  for (const PairedTake& take : takes)
    for (std::size_t frame = 0; frame < take.a.poses.size(); frame += 4) {
      PairPose pair;
      pair << take.a.poses[frame], take.b.poses[frame];
      metric.add(pair, pair, radii[0], radii[1]);
    }
  const PenetrationMetric::Figures figures = metric.figures();
  EXPECT_LT(figures.deep_share, 0.12) << "26 % with generic radii";
  EXPECT_LT(figures.max_m, 0.134) << "13.4 cm with generic radii";
  EXPECT_EQ(figures.excess_max_m, 0) << "a recording has no more than itself";
}

}  // namespace
}  // namespace abrazo::captured_metrics_test
