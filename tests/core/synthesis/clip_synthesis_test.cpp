#include "core/synthesis/step/clip_synthesis.hpp"

#include <gtest/gtest.h>

#include "tests/support/libraries.hpp"

namespace abrazo::clip_synthesis_test {
namespace {

std::vector<long long> stepped_frames(const Clip& clip, const Settings& settings) {
  auto synthesizer = PartnerSynthesizer::create(test::small_library(), settings);
  std::vector<long long> frames;
  const Status done =
      synthesize_clip(**synthesizer, clip,
                      [&](const ClipStep& step) -> Status {
                        EXPECT_NEAR(step.time_s, static_cast<double>(step.input_frame) / clip.fps, 1e-12);
                        frames.push_back(step.input_frame);
                        return Done{};
                      },
                      {});
  EXPECT_TRUE(done.ok());
  return frames;
}

TEST(ClipSynthesis, StepsAtFifteenHertzTakeEveryFourthFrameOfSixty) {
  const Clip clip = test::swinging_take("user", 61, 9).a;
  const auto frames = stepped_frames(clip, *preset("paper"));
  ASSERT_EQ(frames.size(), 16U);
  for (std::size_t i = 0; i < frames.size(); ++i) EXPECT_EQ(frames[i], static_cast<long long>(4 * i));
}

TEST(ClipSynthesis, ARateThatDoesNotDivideTheClipsDoesNotDrift) {
  Settings settings = *preset("paper");
  settings.step_rate_hz = 25;
  const Clip clip = test::swinging_take("user", 121, 9).a;
  const auto frames = stepped_frames(clip, settings);
  for (std::size_t i = 0; i < frames.size(); ++i)
    EXPECT_NEAR(static_cast<double>(frames[i]), static_cast<double>(i) * 60 / 25, 0.5 + 1e-9);
}

TEST(ClipSynthesis, TheInputsOwnRateIsTakenUpTo120) {
  Clip clip = test::swinging_take("user", 10, 9).a;
  EXPECT_EQ(clip_step_rate(clip, *preset("responsive")), 60);
  clip.fps = 240;
  EXPECT_EQ(clip_step_rate(clip, *preset("responsive")), 120);
  clip.fps = 10;
  EXPECT_EQ(clip_step_rate(clip, *preset("paper")), 10);
}

TEST(ClipSynthesis, StopsWhenAskedTo) {
  auto synthesizer = PartnerSynthesizer::create(test::small_library(), *preset("responsive"));
  const Clip clip = test::swinging_take("user", 200, 9).a;
  int steps = 0;
  const Status done = synthesize_clip(
      **synthesizer, clip, [&](const ClipStep&) -> Status { return ++steps, Done{}; },
      [](double fraction, std::string_view) { return fraction < 0.3; });
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.error().message, "cancelled");
  EXPECT_LT(steps, 200);
}

TEST(ClipSynthesis, AClipTooSlowToFollowIsRefused) {
  auto synthesizer = PartnerSynthesizer::create(test::small_library(), *preset("paper"));
  Clip clip = test::swinging_take("user", 10, 9).a;
  clip.fps = 2;
  const Status done =
      synthesize_clip(**synthesizer, clip, [](const ClipStep&) -> Status { return Done{}; }, {});
  ASSERT_FALSE(done.ok());
  EXPECT_NE(done.error().text().find("at least 5"), std::string::npos);
}

}  // namespace
}  // namespace abrazo::clip_synthesis_test
