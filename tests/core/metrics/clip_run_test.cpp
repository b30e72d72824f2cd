#include "core/metrics/clip_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/libraries.hpp"

namespace abrazo::clip_run_test {
namespace {

std::unique_ptr<PartnerSynthesizer> synthesizer() {
  return std::move(*PartnerSynthesizer::create(test::small_library(), *preset("paper")));
}

TEST(ClipRun, KeepsBothBodiesOfEveryStepWithItsTime) {
  const Clip clip = test::swinging_take("user", 61, 9).a;
  std::vector<PairPose> results;
  const auto run = run_clip(*synthesizer(), clip,
                            [&](const ClipStep& step) { results.push_back(step.result.result); }, {});
  ASSERT_TRUE(run) << run.error().text();
  EXPECT_EQ(run->rate_hz(), 15);
  EXPECT_EQ(run->passive.fps, 15);
  ASSERT_EQ(run->active.poses.size(), 16U);
  ASSERT_EQ(run->times_s.size(), 16U);
  EXPECT_NEAR(run->times_s.back(), 1, 1e-12);
  EXPECT_EQ(run->summary.figures().frames, 16U);
  for (std::size_t step = 0; step < results.size(); ++step) {
    EXPECT_EQ(run->active.poses[step], results[step].topRows<joint_count>());
    EXPECT_EQ(run->passive.poses[step], results[step].bottomRows<joint_count>());
  }
}

TEST(ClipRun, IsTheSameWhetherSomebodyLooksOrNot) {
  const Clip clip = test::swinging_take("user", 61, 9).a;
  const auto watched = run_clip(*synthesizer(), clip, [](const ClipStep&) {}, {});
  const auto alone = run_clip(*synthesizer(), clip, {}, {});
  EXPECT_EQ(watched->passive.poses, alone->passive.poses);
}

TEST(ClipRun, StopsWhenAskedTo) {
  const Clip clip = test::swinging_take("user", 61, 9).a;
  const auto run = run_clip(*synthesizer(), clip, {}, [](double, std::string_view) { return false; });
  EXPECT_THAT(run.error().text(), testing::HasSubstr("cancelled"));
}

}  // namespace
}  // namespace abrazo::clip_run_test
