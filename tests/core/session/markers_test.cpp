#include "core/session/frames/markers.hpp"

#include <gtest/gtest.h>

#include <set>

namespace abrazo::markers_test {
namespace {

Markers three() {
  Markers markers;
  markers.add(5, "turn");
  markers.add(2);
  markers.add(9, " end ");
  return markers;
}

TEST(Markers, StandInTheOrderOfTimeWhateverTheOrderOfAdding) {
  const Markers markers = three();
  ASSERT_EQ(markers.all().size(), 3u);
  EXPECT_EQ(markers.all()[0].time_s, 2);
  EXPECT_EQ(markers.all()[1].name, "turn");
  EXPECT_EQ(markers.all()[2].name, "end") << "without the blanks around it";
}

TEST(Markers, KeepTheirIdWhenMovedPastOneAnother) {
  Markers markers = three();
  const int id = markers.all()[0].id;
  markers.move(id, 7);
  EXPECT_EQ(markers.all()[1].id, id);
  markers.rename(id, "dip");
  EXPECT_EQ(markers.find(id)->name, "dip");
}

TEST(Markers, AnIdIsNotGivenTwice) {
  Markers markers = three();
  const int last = markers.all().back().id;
  markers.remove(last);
  EXPECT_EQ(markers.find(last), nullptr);
  EXPECT_GT(markers.add(1), last);
}

TEST(Markers, WhatIsNotThereIsNeitherMovedNorRemoved) {
  Markers markers = three();
  markers.move(77, 1);
  markers.rename(77, "x");
  markers.remove(77);
  EXPECT_EQ(markers, three());
}

TEST(Markers, ThePreviousAndTheNextAreNotTheOneHere) {
  const Markers markers = three();
  EXPECT_EQ(markers.before(5)->time_s, 2);
  EXPECT_EQ(markers.after(5)->time_s, 9);
  EXPECT_EQ(markers.before(2), nullptr);
  EXPECT_EQ(markers.after(9), nullptr);
}

TEST(Markers, TheNearestIsFoundWithinReachOnly) {
  const Markers markers = three();
  EXPECT_EQ(markers.near(5.3, 0.5)->name, "turn");
  EXPECT_EQ(markers.near(3.6, 2)->name, "turn");
  EXPECT_EQ(markers.near(3.4, 2)->time_s, 2);
  EXPECT_EQ(markers.near(7, 0.5), nullptr);
}

TEST(Markers, AreCalledByTheirNumberWithoutAName) {
  const Markers markers = three();
  EXPECT_EQ(marker_title(markers.all()[0]), "2");
  EXPECT_EQ(marker_title(markers.all()[1]), "turn");
}

TEST(Markers, ComeBackFromTheirTextAndWhatIsNoneIsLeftOut) {
  Markers markers;
  markers.add(2, "turn");
  markers.add(1);
  EXPECT_EQ(parse_markers(markers_json(markers)), markers);
  const Markers odd = parse_markers(
      R"([{"id":5,"time_s":1},{"id":5,"time_s":2},{"id":-3,"time_s":0.5},{"id":9},3,{"time_s":"late"}])");
  ASSERT_EQ(odd.all().size(), 3U);
  EXPECT_EQ(odd.all()[1].id, 5);
  EXPECT_NE(odd.all()[2].id, 5) << "no id is used twice";
  EXPECT_TRUE(parse_markers("no markers").empty());
}

TEST(Markers, RestoredOnesNeverShareAnIdWithANewOne) {
  // A file that was edited by hand: the next id is too small, one id is used twice and one is invalid.
  Markers markers = Markers::restored({{4, 1, "a"}, {4, 2, "b"}, {0, 3, "c"}}, 2);
  std::set<int> ids{markers.add(4), markers.add(5)};
  for (const Marker& marker : markers.all()) ids.insert(marker.id);
  EXPECT_EQ(markers.all().size(), 5U);
  EXPECT_EQ(ids.size(), 5U);
  EXPECT_EQ(markers.all()[0].id, 4);
}

}  // namespace
}  // namespace abrazo::markers_test
