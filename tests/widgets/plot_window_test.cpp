#include "widgets/plots/plot_window.hpp"

#include <gtest/gtest.h>

#include "widgets/plots/pane_arrangement.hpp"

namespace abrazo::widgets::plot_window_test {
namespace {

Playback live(double last_s) {
  Playback playback;
  playback.extend(0, last_s);
  playback.follow();
  return playback;
}

TEST(PlotWindow, GoesAlongWithTheLiveEnd) {
  PlotWindow window;
  window.show(live(5));
  EXPECT_DOUBLE_EQ(window.from_s(), 0) << "while all fits";
  window.show(live(50));
  EXPECT_DOUBLE_EQ(window.to_s(), 50);
  EXPECT_TRUE(window.follows());
}

TEST(PlotWindow, ZoomsWhileLiveAndKeepsTheLiveEnd) {
  PlotWindow window;
  window.show(live(50));
  window.zoom(0.5, 42);
  EXPECT_DOUBLE_EQ(window.span_s(), 10);
  EXPECT_DOUBLE_EQ(window.to_s(), 50);
  window.show(live(51));
  EXPECT_DOUBLE_EQ(window.to_s(), 51);
}

TEST(PlotWindow, StaysWhereItWasPannedWhileLiveUntilItIsAttached) {
  PlotWindow window;
  window.show(live(50));
  window.pan(-12);
  EXPECT_TRUE(window.detached());
  window.show(live(60));
  EXPECT_DOUBLE_EQ(window.to_s(), 38);
  window.zoom(0.5, 30);
  EXPECT_DOUBLE_EQ(window.to_s(), 34) << "30 stays where it is";
  window.attach();
  EXPECT_DOUBLE_EQ(window.to_s(), 60);
}

TEST(PlotWindow, PanningBackToTheLiveEndFollowsAgain) {
  PlotWindow window;
  window.show(live(50));
  window.pan(-5);
  window.pan(9);
  EXPECT_TRUE(window.follows());
  EXPECT_DOUBLE_EQ(window.to_s(), 50);
}

TEST(PlotWindow, ASeekBringsTheCursorBackIntoView) {
  PlotWindow window;
  Playback playback = live(100);
  window.show(playback);
  playback.seek(90);
  window.show(playback);
  EXPECT_DOUBLE_EQ(window.to_s(), 100) << "a cursor in view moves nothing";
  window.pan(-60);
  window.show(playback);
  EXPECT_DOUBLE_EQ(window.to_s(), 40) << "nor does a parked one that was left by hand";
  playback.seek(70);
  window.show(playback);
  EXPECT_DOUBLE_EQ(window.to_s(), 70);
}

TEST(PlotWindow, KeepsSomeOfWhatThereIsInView) {
  PlotWindow window;
  window.show(live(100));
  window.pan(-1000);
  EXPECT_DOUBLE_EQ(window.to_s(), 2);
  window.pan(1000);
  EXPECT_DOUBLE_EQ(window.to_s(), 100);
}

TEST(PlotWindow, ZoomStopsAtAQuarterSecondAndAnHour) {
  PlotWindow window;
  window.show(live(10'000));
  window.zoom(1e-9, 0);
  EXPECT_DOUBLE_EQ(window.span_s(), 0.25);
  window.zoom(1e9, 0);
  EXPECT_DOUBLE_EQ(window.span_s(), 3600);
}

TEST(PaneArrangement, IsEnergiesResidualsAndCostAtFirst) {
  const PaneArrangement panes = default_arrangement();
  ASSERT_EQ(panes.size(), 3U);
  EXPECT_EQ(title_of(panes[0]), "Energy [m²]");
  EXPECT_EQ(title_of(panes[1]), "Residuals [mm]");
  EXPECT_EQ(title_of(panes[2]), "Cost [m²]");
}

TEST(PaneArrangement, EveryGroupCanBeAPaneOfOneUnit) {
  for (const std::string_view group : series_groups()) {
    const PaneSeries pane = series_of_group(group);
    for (const Series series : pane) EXPECT_TRUE(can_join(pane, series)) << info_of(series).key;
    EXPECT_FALSE(usual_series(group).empty()) << group;
  }
}

TEST(PaneArrangement, RefusesASecondUnitAndSaysWhatToDo) {
  const PaneSeries energies = usual_series("Energy");
  EXPECT_TRUE(can_join(energies, Series::PoseCost));
  EXPECT_EQ(why_not(energies, Series::PoseCost), "");
  EXPECT_EQ(why_not(energies, Series::SolveTime), "'solve' is in ms, this pane in m²; add a pane for it");
}

TEST(PaneArrangement, IsRememberedInOrder) {
  const PaneArrangement panes = {{Series::SolveTime, Series::TotalTime}, {Series::HoldChange}};
  EXPECT_EQ(text_of(panes), "time.solve,time.total;metric.hold_change");
  EXPECT_EQ(arrangement_of(text_of(panes)), panes);
}

TEST(PaneArrangement, LeavesOutWhatItDoesNotKnow) {
  const PaneArrangement expected = {{Series::SolveTime}};
  EXPECT_EQ(arrangement_of("time.solve,time.of_day,cost.pose,time.solve;;nothing"), expected);
  EXPECT_EQ(arrangement_of(""), default_arrangement());
  EXPECT_EQ(arrangement_of("a;b,c"), default_arrangement());
}

TEST(PaneGrid, StandsInARowAndInRowsWhereThereIsHeight) {
  EXPECT_EQ(plan_panes(3, 930, 150).columns, 3);
  EXPECT_EQ(plan_panes(6, 930, 150).columns, 6);
  EXPECT_EQ(plan_panes(6, 930, 300).columns, 3);
  EXPECT_EQ(plan_panes(6, 930, 300).rows, 2);
}

TEST(PaneGrid, CollapsesWhereItIsLowAndScrollsToWhatHasNoRoom) {
  EXPECT_TRUE(plan_panes(3, 930, 60).collapsed);
  EXPECT_FALSE(plan_panes(3, 930, 110).collapsed);
  const PaneGrid grid = plan_panes(8, 660, 110);
  EXPECT_EQ(grid.columns, 2) << "those that are in view are readable";
  EXPECT_EQ(grid.rows, 1);
  EXPECT_EQ(grid.all_rows, 4);
}

}  // namespace
}  // namespace abrazo::widgets::plot_window_test
