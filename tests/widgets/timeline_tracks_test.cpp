#include "widgets/timeline/timeline_tracks.hpp"

#include <gtest/gtest.h>

namespace abrazo::widgets::timeline_tracks_test {
namespace {

TimelineTracks ten_frames() {
  TimelineTracks tracks;
  for (int i = 0; i < 10; ++i)
    tracks.append({.time_s = 0.1 * i,
                   .pair = 100 + i,
                   .take = i < 4 ? 2 : 5,
                   .label = i < 6 ? "turn" : "open hold",
                   .source_changed = i == 4 || i == 8,
                   .leader = i < 7 ? Leader::User : Leader::Partner,
                   .cost = 0.01 * i,
                   .energy = 0.1});
  return tracks;
}

TEST(TimelineTracks, JoinsFramesOfOneTakeIntoOneIntervalUntilTheSourceJumps) {
  const TimelineTracks tracks = ten_frames();
  ASSERT_EQ(tracks.sources().size(), 3u);
  EXPECT_EQ(tracks.sources()[0].key, 2);
  EXPECT_EQ(tracks.sources()[1].key, 5);
  EXPECT_EQ(tracks.sources()[2].key, 5);
  EXPECT_NEAR(tracks.sources()[2].from_s, 0.8, 1e-12);
}

TEST(TimelineTracks, AnIntervalLastsUntilTheNextBegins) {
  const TimelineTracks tracks = ten_frames();
  EXPECT_DOUBLE_EQ(tracks.sources()[0].to_s, tracks.sources()[1].from_s);
  EXPECT_NEAR(tracks.moves()[0].to_s, 0.6, 1e-12);
}

TEST(TimelineTracks, KnowsWhoLeads) {
  const TimelineTracks tracks = ten_frames();
  ASSERT_EQ(tracks.leaders().size(), 2u);
  EXPECT_EQ(tracks.leaders()[1].key, static_cast<int>(Leader::Partner));
  EXPECT_NEAR(tracks.leaders()[1].from_s, 0.7, 1e-12);
}

TEST(TimelineTracks, AGapWithoutFramesEndsAnInterval) {
  TimelineTracks tracks = ten_frames();
  tracks.append({.time_s = 5, .pair = 1, .take = 5, .label = "open hold"});
  ASSERT_EQ(tracks.sources().size(), 4u);
  EXPECT_NEAR(tracks.sources()[2].to_s, 0.9, 1e-12);
  EXPECT_DOUBLE_EQ(tracks.sources()[3].from_s, 5.0);
  EXPECT_EQ(tracks.pair_at(3), -1);
  EXPECT_EQ(interval_at(tracks.sources(), 3), nullptr);
}

TEST(TimelineTracks, ForgetsWhatWasEvicted) {
  TimelineTracks tracks = ten_frames();
  tracks.drop_before(0.45);
  ASSERT_EQ(tracks.sources().size(), 2u);
  EXPECT_DOUBLE_EQ(tracks.sources()[0].from_s, 0.45);
  EXPECT_EQ(tracks.costs().size(), 5u);
  EXPECT_EQ(tracks.pair_at(0.4), -1);
}

TEST(TimelineTracks, KnowsThePairOfAnyTime) {
  const TimelineTracks tracks = ten_frames();
  EXPECT_EQ(tracks.pair_at(0.35), 103);
  EXPECT_EQ(tracks.pair_at(0.9), 109);
  EXPECT_EQ(tracks.pair_at(-1), -1);
}

TEST(TimelineTracks, OfHoursItKeepsTheLanesWholeAndTheCurvesWithTheirExtremes) {
  constexpr int frames = 60'000, spike = 9'876;
  TimelineTracks tracks;
  for (int i = 0; i < frames; ++i) {
    tracks.append({.time_s = 0.01 * i,
                   .pair = i,
                   .take = i / 1000,
                   .label = "turn",
                   .source_changed = false,
                   .leader = Leader::User,
                   .cost = i == spike ? 5.0 : 1 + 0.001 * (i % 7),
                   .energy = 0.1});
    tracks.thin_older(10'000, 4'000);
  }
  EXPECT_EQ(tracks.sources().size(), 60u);
  EXPECT_LE(tracks.costs().size(), 10'000u + 4'000u + 8'192u);
  const auto columns = tracks.costs().columns(0, 600, 6);
  EXPECT_EQ(columns[0].most, 5.0F);
  for (const auto& column : columns) EXPECT_EQ(column.least, 1.0F);
  EXPECT_EQ(tracks.pair_at(0.01 * (frames - 10'000) + 1e-6), frames - 10'000) << "the newest stay";
  EXPECT_NEAR(tracks.pair_at(100.004), 10'000, 64) << "of older ones one nearby";
  tracks.drop_before(300);
  EXPECT_EQ(tracks.pair_at(200), -1);
  EXPECT_NEAR(tracks.pair_at(400.004), 40'000, 64);
  EXPECT_EQ(tracks.costs().columns(0, 600, 1)[0].most, 1.006F);
}

TEST(TimelineTracks, AnotherLibraryChangesNumbersAndLabelsAndNotTheIntervals) {
  TimelineTracks tracks = ten_frames();
  tracks.renumber({-1, -1, 3, -1, -1, 6}, [](int pair, bool user_is_active) {
    return PairFacts{pair + 1000, pair < 103 ? "turn" : "spin",
                     user_is_active ? Leader::Partner : Leader::User};
  });
  ASSERT_EQ(tracks.sources().size(), 3U);
  EXPECT_EQ(tracks.sources()[0].key, 3);
  EXPECT_EQ(tracks.sources()[2].key, 6);
  EXPECT_NEAR(tracks.sources()[2].from_s, 0.8, 1e-12) << "a jump within a take stays one";
  EXPECT_EQ(tracks.pair_at(0.35), 1103);
  ASSERT_EQ(tracks.moves().size(), 2U);
  EXPECT_EQ(tracks.label(tracks.moves()[1].key), "spin");
  EXPECT_NEAR(tracks.moves()[1].from_s, 0.3, 1e-12);
  EXPECT_NEAR(tracks.moves()[1].to_s, 0.9, 1e-12);
  ASSERT_EQ(tracks.leaders().size(), 1U);
  EXPECT_EQ(tracks.leaders()[0].key, static_cast<int>(Leader::Partner));
  EXPECT_EQ(tracks.costs().size(), 10U);
}

TEST(TimelineTracks, AnotherLibraryLeavesNoGapsWherePairsAreThinned) {
  TimelineTracks tracks;
  for (int i = 0; i < 60'000; ++i) {
    tracks.append({.time_s = 0.1 * i, .pair = i, .take = 0, .label = "turn"});
    tracks.thin_older(10'000, 4'000);
  }
  tracks.renumber({0}, [](int pair, bool) { return PairFacts{pair, "turn", Leader::User}; });
  EXPECT_EQ(tracks.moves().size(), 1U);
  EXPECT_EQ(tracks.sources().size(), 1U);
}

TEST(TimelineTracks, FindsTheEdgesOfMoves) {
  const TimelineTracks tracks = ten_frames();
  EXPECT_NEAR(*tracks.edge_after(0), 0.6, 1e-12);
  EXPECT_FALSE(tracks.edge_after(0.6));
  EXPECT_NEAR(*tracks.edge_before(0.7), 0.6, 1e-12);
  EXPECT_NEAR(*tracks.edge_before(0.6), 0, 1e-12);
  EXPECT_FALSE(tracks.edge_before(0));
}

TEST(TimelineTracks, DrawsOfTooShortIntervalsOneForEachPixel) {
  TimelineTracks::Lane lane;
  for (int i = 0; i < 100000; ++i) lane.push_back({0.01 * i, 0.01 * (i + 1), i});
  const auto shown = drawn(lane, 100, 900, 1);
  EXPECT_LE(shown.size(), 802u);
  EXPECT_GE(shown.size(), 400u);
  EXPECT_EQ(drawn(lane, 100, 100.05, 1e-4).size(), 6u) << "nothing is left out where there is room";
}

TEST(TimelineTracks, DrawsOnlyWhatIsInView) {
  const TimelineTracks tracks = ten_frames();
  EXPECT_EQ(drawn(tracks.moves(), 0.1, 0.3, 0.001).size(), 1u);
  EXPECT_EQ(drawn(tracks.moves(), 0.1, 0.8, 0.001).size(), 2u);
  EXPECT_TRUE(drawn(tracks.moves(), 2, 3, 0.001).empty());
}

TEST(TimelineTracks, ATakeIsCalledByItsNumberWhereItHasOne) {
  EXPECT_EQ(short_take_name("salsa_06"), "06");
  EXPECT_EQ(short_take_name("warm-up"), "warm-up");
  EXPECT_EQ(short_take_name("12"), "12");
}

TEST(TimelineTracks, RowsThatWereLeftOutEndNoInterval) {
  TimelineTracks tracks;
  for (int i = 0; i < 5; ++i) {
    TrackRow row;
    row.time_s = 2 * i;
    row.pair = 7;
    row.take = 1;
    row.left_out_s = i > 0 ? 2 : 0;
    tracks.append(row);
  }
  ASSERT_EQ(tracks.sources().size(), 1U);
  EXPECT_EQ(tracks.sources()[0].to_s, 8);
  EXPECT_EQ(tracks.pair_at(3.5), 7);
  EXPECT_DOUBLE_EQ(tracks.longest_gap_s(), 3);
}

TEST(TimelineTracks, EndAtAGapOfARecordingWhoseRowsAreThinned) {
  TimelineTracks tracks;
  for (const double time_s : {0.0, 0.1, 0.2, 5.2, 5.3, 5.4}) {
    TrackRow row;
    row.time_s = time_s;
    row.take = 1;
    row.left_out_s = 0.1;
    tracks.append(row);
  }
  for (const TimelineTracks::Lane* lane : {&tracks.sources(), &tracks.moves(), &tracks.leaders()}) {
    ASSERT_EQ(lane->size(), 2U);
    EXPECT_EQ(lane->front().to_s, 0.2);
    EXPECT_EQ(lane->back().from_s, 5.2);
  }
}

/// The cost had a line over the gap, which the lanes showed.
TEST(TimelineTracks, TheCurvesEndWhereTheLanesDo) {
  TimelineTracks tracks;
  for (const double time_s : {0.0, 2.0, 4.0, 9.0, 11.0, 20.0}) {
    TrackRow row;
    row.time_s = time_s;
    row.take = time_s == 20 ? -1 : 1;
    row.left_out_s = time_s > 0 ? 2 : 0;
    row.is_by_intent = time_s > 9;
    tracks.append(row);
  }
  EXPECT_FALSE(tracks.has_gap_of_curves(0.5, 3.5)) << "rows were left out";
  EXPECT_TRUE(tracks.has_gap_of_curves(3.5, 9.5));
  EXPECT_TRUE(tracks.has_gap_of_curves(5, 6));
  EXPECT_FALSE(tracks.has_gap_of_curves(9.5, 10.5)) << "another method";
  EXPECT_TRUE(tracks.has_gap_of_curves(10, 20)) << "nothing was selected";
}

TEST(TimelineTracks, KnowWhichMethodACostIsOf) {
  TimelineTracks tracks;
  for (int i = 0; i < 6; ++i) {
    TrackRow row;
    row.time_s = 0.1 * i;
    row.take = 0;
    row.is_by_intent = i >= 3;
    tracks.append(row);
  }
  EXPECT_FALSE(tracks.is_by_intent_at(0.2));
  EXPECT_TRUE(tracks.is_by_intent_at(0.35));
  EXPECT_TRUE(tracks.is_by_intent_at(0.5)) << "also at the newest";
  EXPECT_FALSE(TimelineTracks().is_by_intent_at(0));
}

TEST(TimelineTracks, KeepTheRoleThatTheUserWasGiven) {
  TimelineTracks tracks;
  for (int i = 0; i < 6; ++i) {
    TrackRow row;
    row.time_s = 0.1 * i;
    row.user_is_active = i < 3;
    tracks.append(row);
  }
  ASSERT_EQ(tracks.user_roles().size(), 2U);
  EXPECT_EQ(tracks.user_roles()[0].key, 1);
  EXPECT_NEAR(tracks.user_roles()[0].to_s, 0.3, 1e-12);
  EXPECT_EQ(tracks.user_roles()[1].key, 0);
}

}  // namespace
}  // namespace abrazo::widgets::timeline_tracks_test
