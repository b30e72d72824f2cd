#include "widgets/timeline/timeline_tracks.hpp"

#include <gtest/gtest.h>

namespace abrazo::widgets {
namespace {

TimelineTracks ten_frames() {
  TimelineTracks tracks;
  for (int i = 0; i < 10; ++i) tracks.append(0.1 * i, i < 4 ? 2 : 5, i < 6 ? "turn" : "open hold", 0.01 * i);
  return tracks;
}

TEST(TimelineTracks, JoinsFramesOfOneTakeIntoOneInterval) {
  const TimelineTracks tracks = ten_frames();
  ASSERT_EQ(tracks.sources().size(), 2u);
  EXPECT_EQ(tracks.sources()[0].key, 2);
  EXPECT_EQ(tracks.sources()[1].key, 5);
}

TEST(TimelineTracks, AnIntervalLastsUntilTheNextBegins) {
  const TimelineTracks tracks = ten_frames();
  EXPECT_DOUBLE_EQ(tracks.sources()[0].to_s, tracks.sources()[1].from_s);
  EXPECT_NEAR(tracks.moves()[0].to_s, 0.6, 1e-12);
}

TEST(TimelineTracks, AGapWithoutFramesEndsAnInterval) {
  TimelineTracks tracks = ten_frames();
  tracks.append(5.0, 5, "open hold", 0);
  ASSERT_EQ(tracks.sources().size(), 3u);
  EXPECT_NEAR(tracks.sources()[1].to_s, 0.9, 1e-12);
  EXPECT_DOUBLE_EQ(tracks.sources()[2].from_s, 5.0);
}

TEST(TimelineTracks, ForgetsWhatWasEvicted) {
  TimelineTracks tracks = ten_frames();
  tracks.drop_before(0.5);
  ASSERT_EQ(tracks.sources().size(), 1u);
  EXPECT_DOUBLE_EQ(tracks.sources()[0].from_s, 0.5);
  EXPECT_EQ(tracks.costs().size(), 5u);
}

TEST(TimelineTracks, ScalesTheCostCurveByWhatIsInView) {
  EXPECT_NEAR(ten_frames().usual_cost(0.15, 0.55), 0.05, 1e-12);
  EXPECT_EQ(ten_frames().usual_cost(7, 8), 0);
}

TEST(TimelineTracks, ATakeIsCalledByItsNumberWhereItHasOne) {
  EXPECT_EQ(short_take_name("salsa_06"), "06");
  EXPECT_EQ(short_take_name("warm-up"), "warm-up");
  EXPECT_EQ(short_take_name("12"), "12");
}

}  // namespace
}  // namespace abrazo::widgets
