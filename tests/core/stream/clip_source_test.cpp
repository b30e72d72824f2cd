#include <stdexcept>

#include "core/stream/receive/clip_source.hpp"

#include <gtest/gtest.h>

#include "tests/support/libraries.hpp"

namespace abrazo::clip_source_test {
namespace {

Clip short_clip(int frames = 60) {
  return test::swinging_take("clip", frames, 1).a;
}

TEST(ClipSource, GivesOneFramePerTickAndNothingBetween) {
  ClipSource source(short_clip());
  const auto first = source.poll(0.0);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->frame, 0);
  EXPECT_TRUE(first->discontinuous) << "nothing comes before the first pose";
  EXPECT_FALSE(source.poll(0.01));
  EXPECT_NEAR(source.next_due_s(), 1.0 / 60, 1e-12);
  const auto second = source.poll(source.next_due_s());
  ASSERT_TRUE(second);
  EXPECT_EQ(second->frame, 1);
  EXPECT_FALSE(second->discontinuous);
}

TEST(ClipSource, ALatePollGivesTheNewestAndCountsWhatWasMissed) {
  ClipSource source(short_clip());
  source.poll(0.0);
  const auto late = source.poll(5.0 / 60);
  ASSERT_TRUE(late);
  EXPECT_EQ(late->frame, 5);
  EXPECT_EQ(late->dropped, 4U);
}

TEST(ClipSource, LoopsAndSaysThatItJumped) {
  ClipSource source(short_clip(30));
  int jumps = 0;
  std::int64_t last_frame = -1;
  for (int tick = 0; tick < 90; ++tick) {
    const auto pose = source.poll(tick / 60.0);
    ASSERT_TRUE(pose) << tick;
    EXPECT_EQ(pose->discontinuous, pose->frame < last_frame || tick == 0) << tick;
    jumps += pose->discontinuous;
    last_frame = pose->frame;
  }
  EXPECT_EQ(jumps, 3);
}

TEST(ClipSource, APausedUserStandsStillButKeepsComing) {
  ClipSource source(short_clip());
  source.poll(0.25);
  source.set_paused(true, 0.25);
  const auto a = source.poll(0.30);
  const auto b = source.poll(0.40);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->frame, 15);
  EXPECT_EQ(b->frame, 15);
  source.set_paused(false, 0.5);
  EXPECT_EQ(source.poll(0.5 + 1.0 / 60)->frame, 16);
}

TEST(ClipSource, HalfSpeedTakesTwiceAsLong) {
  ClipSource source(short_clip());
  source.poll(0);
  source.set_speed(0.5, 0);
  EXPECT_EQ(source.poll(0.5)->frame, 15);
}

TEST(ClipSource, SeekingJumps) {
  ClipSource source(short_clip());
  source.poll(0);
  source.seek(0.5, 0.1);
  const auto pose = source.poll(0.1);
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->frame, 30);
  EXPECT_TRUE(pose->discontinuous);
}

TEST(ClipSource, AThinnedRateKeepsTheSpeed) {
  ClipSource source(short_clip(), 15);
  source.poll(0);
  EXPECT_FALSE(source.poll(1.0 / 60));
  EXPECT_EQ(source.poll(1.0 / 15)->frame, 4);
  source.set_max_rate(30);
  EXPECT_EQ(source.poll(1.0 / 15 + 1.0 / 30)->frame, 6);
}

TEST(ClipSource, AnEmptyClipIsRefused) {
  EXPECT_THROW(ClipSource(Clip{}), std::invalid_argument);
}

}  // namespace
}  // namespace abrazo::clip_source_test
