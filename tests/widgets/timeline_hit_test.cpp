#include "widgets/timeline/timeline_hit.hpp"

#include <gtest/gtest.h>

namespace abrazo::widgets::timeline_hit_test {
namespace {

using Part = TimelineHit::Part;

/// 20 pixels a second from x = 100; in at 20 s, out at 30 s; a marker at 15 s, one at 25 s.
struct Place {
  TimelineAxis axis{100, 700, 10, 35};
  TimelineLanes lanes;
  Markers markers;
  std::optional<Playback::Range> range = Playback::Range{20, 30};
  Place() {
    lanes.set_height(lanes.whole_px());
    markers.add(15, "dip");
    markers.add(25);
  }
  TimelineHit at(double time_s, double y, double off_px = 0) const {
    return hit(axis.x(time_s) + off_px, y, axis, lanes, range, markers, true);
  }
  double middle_of(TimelineLane lane) const { return lanes.top_of(lane) + info_of(lane).height_px / 2; }
};

TEST(TimelineHit, TellsTheHandlesOfTheRangeFromWhatIsBetween) {
  const Place place;
  EXPECT_EQ(place.at(20, 10, -3).part, Part::In);
  EXPECT_EQ(place.at(30, 10, 4).part, Part::Out);
  EXPECT_EQ(place.at(22, 10).part, Part::Range);
  EXPECT_EQ(place.at(32, 10).part, Part::Time);
  EXPECT_EQ(place.at(20, place.middle_of(TimelineLane::Source)).part, Part::Time) << "only on the ruler";
}

TEST(TimelineHit, OfANarrowRangeBothHandlesCanBeTaken) {
  Place place;
  place.range = Playback::Range{20, 20.2};
  EXPECT_EQ(place.at(20, 10, -2).part, Part::In);
  EXPECT_EQ(place.at(20.2, 10, 2).part, Part::Out);
}

TEST(TimelineHit, FindsAMarkerOnTheRulerAndByItsFlag) {
  const Place place;
  const int dip = place.markers.all()[0].id;
  EXPECT_EQ(place.at(15, 10, 3), (TimelineHit{Part::Marker, dip}));
  EXPECT_EQ(place.at(15, place.middle_of(TimelineLane::Markers), 11), (TimelineHit{Part::Marker, dip}));
  EXPECT_EQ(place.at(15, place.middle_of(TimelineLane::Moves)).part, Part::Time);
  EXPECT_EQ(place.at(16, 10).part, Part::Time);
}

TEST(TimelineHit, KnowsTheNamesAtTheLeftAndTheOverviewBelow) {
  const Place place;
  EXPECT_EQ(place.at(9, 40).part, Part::Names);
  EXPECT_EQ(place.at(12, place.lanes.bottom_px() + 5).part, Part::Overview);
}

TEST(TimelineLanes, StandOneBelowTheOtherWithoutTheHiddenOnes) {
  TimelineLanes lanes;
  lanes.set_height(400);
  EXPECT_EQ(lanes.top_of(TimelineLane::Moves), 26 + 27);
  lanes.set_shown(TimelineLane::Source, false);
  EXPECT_EQ(lanes.top_of(TimelineLane::Moves), 26);
  TimelineLane found{};
  ASSERT_TRUE(lanes.lane_at(30, found));
  EXPECT_EQ(found, TimelineLane::Moves);
  EXPECT_FALSE(lanes.lane_at(10, found)) << "the ruler";
}

TEST(TimelineLanes, ScrollOnlyWhereTheyDoNotFit) {
  TimelineLanes lanes;
  lanes.set_height(lanes.whole_px());
  lanes.scroll_to(50);
  EXPECT_EQ(lanes.scroll_px(), 0);
  lanes.set_height(lanes.whole_px() - 30);
  lanes.scroll_to(500);
  EXPECT_EQ(lanes.scroll_px(), 54) << "two lanes are above, so that the last one is whole";
  lanes.set_height(lanes.whole_px());
  EXPECT_EQ(lanes.scroll_px(), 0) << "and come back where there is room again";
}

TEST(TimelineLanes, NoLaneIsCutAtTheTopWhereverTheyAreScrolledTo) {
  TimelineLanes lanes;
  lanes.set_tiers({{1, "role"}, {2, "move"}});
  lanes.set_height(lanes.whole_px() - 100);
  for (double px = 0; px <= lanes.most_scroll_px(); px += 5) {
    lanes.scroll_to(px);
    bool begins_at_the_top = lanes.top_of_tier(1) == lanes.top_px() || lanes.top_of_tier(2) == lanes.top_px();
    for (int lane = 0; lane < timeline_lane_count; ++lane) {
      const auto each = static_cast<TimelineLane>(lane);
      begins_at_the_top |= lanes.is_shown(each) && lanes.top_of(each) == lanes.top_px();
    }
    EXPECT_TRUE(begins_at_the_top) << px;
  }
  EXPECT_LE(lanes.top_of_tier(2) + TimelineLanes::tier_px, lanes.bottom_px()) << "the last one is whole";
}

TEST(TimelineLanes, SmallStepsOfAWheelAddUpToALane) {
  TimelineLanes lanes;
  lanes.set_height(lanes.whole_px() - 60);
  for (int step = 0; step < 5; ++step) lanes.scroll_to(lanes.asked_scroll_px() + 4);
  EXPECT_EQ(lanes.scroll_px(), 27);
}

TEST(TimelineLanes, ATierThatIsRevealedIsWholeAndTheTopLaneToo) {
  TimelineLanes lanes;
  lanes.set_tiers({{1, "role"}, {2, "move"}, {3, "note"}});
  lanes.set_height(lanes.whole_px() - 71);
  lanes.reveal(2);
  EXPECT_LE(lanes.top_of_tier(2) + TimelineLanes::tier_px, lanes.bottom_px());
  EXPECT_EQ(lanes.scroll_px(), 54);
}

/// In a window that was made lower the lanes began with Source again, and nobody saw what was annotated.
TEST(TimelineLanes, ATierThatIsRevealedStaysInViewInEveryHeight) {
  TimelineLanes lanes;
  lanes.set_tiers({{1, "role"}, {2, "move"}, {3, "note"}});
  const auto is_whole = [&lanes] {
    return lanes.top_of_tier(2) >= lanes.top_px() &&
           lanes.top_of_tier(2) + TimelineLanes::tier_px <= lanes.bottom_px();
  };
  lanes.set_height(lanes.whole_px());
  lanes.reveal(2);
  const double least = lanes.top_px() + 54 + TimelineLanes::overview_px;
  for (const double height_px : {lanes.whole_px() - 100, least, lanes.whole_px(), least}) {
    lanes.set_height(height_px);
    EXPECT_TRUE(is_whole()) << height_px;
  }
  lanes.scroll_to(0);
  lanes.set_height(least + 10);
  EXPECT_EQ(lanes.scroll_px(), 0) << "until a person scrolls";
}

/// Of the session: an annotated take has little else to show.
TEST(TimelineLanes, AnEmptyTierDoesNotScrollTheLanesOfTheSessionAway) {
  TimelineLanes lanes;
  lanes.set_tiers({{1, "role", true}, {2, "move", true}});
  lanes.set_height(lanes.top_px() + 54 + TimelineLanes::overview_px);
  lanes.reveal(2);
  EXPECT_EQ(lanes.scroll_px(), 0);
  lanes.set_tiers({{1, "role", true}, {2, "move", false}});
  EXPECT_LE(lanes.top_of_tier(2) + TimelineLanes::tier_px, lanes.bottom_px()) << "with its first label";
  lanes.set_tiers({{1, "role", true}, {2, "move", true}});
  lanes.set_of_take(true);
  EXPECT_LE(lanes.top_of_tier(2) + TimelineLanes::tier_px, lanes.bottom_px()) << "of a take";
  lanes.set_of_take(false);
  EXPECT_EQ(lanes.scroll_px(), 0);
}

TEST(TimelineLanes, AfterATierThatWasRevealedTheyAreWhereAPersonScrolledThem) {
  TimelineLanes lanes;
  lanes.set_tiers({{1, "role"}, {2, "move"}});
  lanes.set_height(lanes.top_px() + 54 + TimelineLanes::overview_px);
  lanes.scroll_to(27);
  lanes.reveal(2);
  ASSERT_GT(lanes.scroll_px(), 27);
  lanes.set_tiers({});
  EXPECT_EQ(lanes.scroll_px(), 27);
}

TEST(TimelineLanes, AComputedLaneIsRevealed) {
  TimelineLanes lanes;
  lanes.set_height(lanes.top_px() + 54 + TimelineLanes::overview_px);
  lanes.reveal(TimelineLane::Takes);
  EXPECT_GE(lanes.top_of(TimelineLane::Takes), lanes.top_px());
  EXPECT_LE(lanes.top_of(TimelineLane::Takes) + info_of(TimelineLane::Takes).height_px, lanes.bottom_px());
  lanes.set_shown(TimelineLane::Takes, false);
  lanes.scroll_to(0);
  lanes.reveal(TimelineLane::Takes);
  EXPECT_EQ(lanes.scroll_px(), 0) << "not when it is hidden";
}

TEST(TimelineLanes, AreRememberedByName) {
  TimelineLanes lanes;
  lanes.set_shown(TimelineLane::Energy, true);
  lanes.set_shown(TimelineLane::Role, false);
  TimelineLanes again;
  again.set_text(lanes.text() + " Weather");
  EXPECT_EQ(again.text(), lanes.text());
  EXPECT_TRUE(again.is_shown(TimelineLane::Energy));
}

}  // namespace
}  // namespace abrazo::widgets::timeline_hit_test
