#include "core/selection/source_playhead.hpp"

#include <gtest/gtest.h>

#include "core/library/build/motion_library_builder.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::source_playhead_test {
namespace {

MotionLibrary library_at(double rate_hz) {
  PairedTake take = test::swinging_take("take", static_cast<int>(4 * rate_hz), 5);
  take.fps = rate_hz;
  take.a.fps = take.b.fps = rate_hz;
  std::vector<PairedTake> takes;
  takes.push_back(std::move(take));
  return std::move(*build_library("one", std::move(takes), {}, {}));
}

TEST(SourcePlayhead, TimeRunsAtTheSamePaceAtEveryStepRateAndLibraryRate) {
  for (const double library_hz : {15.0, 60.0, 120.0}) {
    const MotionLibrary library = library_at(library_hz);
    for (const double steps_hz : {15.0, 30.0, 60.0, 120.0, 240.0})
      for (const double rate : {0.7, 1.0, 1.5}) {
        SourcePlayhead playhead{0, 0, rate};
        for (int step = 0; step < static_cast<int>(2 * steps_hz); ++step)
          playhead = moved(library, playhead, playhead.rate / steps_hz);
        EXPECT_NEAR((playhead.pair + playhead.fraction) / library_hz, 2 * rate, 1e-6)
            << library_hz << " " << steps_hz << " " << rate;
      }
  }
}

TEST(SourcePlayhead, StopsWhereTheRecordingEndsOrBegins) {
  const auto library = test::small_library();
  const int last = library->find_pair("first", 179, false);
  EXPECT_EQ(moved(*library, {last - 3, 0.5, 1}, 5), (SourcePlayhead{last, 0, 1}));
  EXPECT_EQ(moved(*library, {3, 0.5, 1}, -5), (SourcePlayhead{0, 0, 1}));
  EXPECT_NEAR(recorded_ahead(*library, {last - 3, 0.5, 1}, 1), 2.5 / 60, 1e-12);
}

TEST(SourcePlayhead, AMomentBetweenTwoPairsLiesBetweenThem) {
  const auto library = test::small_library();
  const RecordedMoment one = recorded_moment(*library, {10, 0, 1}),
                       next = recorded_moment(*library, {11, 0, 1});
  const RecordedMoment middle = recorded_moment(*library, {10, 0.5, 1});
  EXPECT_LT((middle.pair - 0.5 * (one.pair + next.pair)).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_NEAR(middle.partner.heading_rad, 0.5 * (one.partner.heading_rad + next.partner.heading_rad), 1e-3);
}

TEST(SourcePlayhead, PairsOfAnotherTakeAreNotAhead) {
  const auto library = test::small_library();
  const int other = library->find_pair("second", 0, false);
  EXPECT_FALSE(seconds_to(*library, {10, 0, 1}, other));
  EXPECT_NEAR(*seconds_to(*library, {10, 0.5, 1}, 13), 2.5 / 60, 1e-12);
}

}  // namespace
}  // namespace abrazo::source_playhead_test
