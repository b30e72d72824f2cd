#include "core/evaluation/plots/svg_plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "core/evaluation/plots/html_text.hpp"

namespace abrazo::svg_plot_test {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::Pointwise;

std::vector<double> near(std::vector<double> values) {
  return values;
}

int count_of(const std::string& part, const std::string& text) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(AxisTicks, AreRoundNumbersWithinTheRange) {
  EXPECT_THAT(linear_ticks(0, 50, 5), ElementsAre(0, 10, 20, 30, 40, 50));
  EXPECT_THAT(linear_ticks(0, 100, 5), ElementsAre(0, 20, 40, 60, 80, 100));
  EXPECT_THAT(linear_ticks(0, 12, 3), ElementsAre(0, 5, 10));
  EXPECT_THAT(linear_ticks(0.1, 0.45, 4), Pointwise(DoubleNear(1e-12), near({0.1, 0.2, 0.3, 0.4})));
  EXPECT_THAT(linear_ticks(-3, 3, 6), ElementsAre(-3, -2, -1, 0, 1, 2, 3));
}

TEST(AxisTicks, OfALogarithmicAxisArePowersOfTen) {
  EXPECT_THAT(logarithmic_ticks(5, 200000), ElementsAre(10, 100, 1000, 10000, 100000));
  EXPECT_THAT(logarithmic_ticks(10, 100), ElementsAre(10, 20, 50, 100));
  EXPECT_THROW(logarithmic_ticks(0, 10), std::invalid_argument);
}

TEST(AxisScale, PlacesValuesInProportion) {
  const AxisScale scale({.title = "x", .minimum = 0, .maximum = 50}, 0, 0, 100, 300, 5);
  EXPECT_DOUBLE_EQ(scale.at(0), 100);
  EXPECT_DOUBLE_EQ(scale.at(25), 200);
  EXPECT_DOUBLE_EQ(scale.at(50), 300);
}

TEST(AxisScale, PlacesEqualRatiosEquallyFarApartWhenLogarithmic) {
  const AxisScale scale({.title = "x", .logarithmic = true, .minimum = 1, .maximum = 10000}, 1, 1, 0, 400, 5);
  EXPECT_DOUBLE_EQ(scale.at(1), 0);
  EXPECT_DOUBLE_EQ(scale.at(10), 100);
  EXPECT_DOUBLE_EQ(scale.at(1000), 300);
}

TEST(AxisScale, WidensTheDataToRoundNumbers) {
  const AxisScale scale({.title = "y"}, 66.2, 98.7, 0, 1, 5);
  EXPECT_DOUBLE_EQ(scale.low(), 60);
  EXPECT_DOUBLE_EQ(scale.high(), 100);
}

TEST(AxisScale, HasRoomForValuesThatAreAllEqual) {
  const AxisScale scale({.title = "y"}, 3, 3, 0, 100, 5);
  EXPECT_LT(scale.at(3), scale.at(scale.high()));
}

TEST(NumberText, HasTheDigitsAskedForAndThousandsApart) {
  EXPECT_EQ(number_text(0.04567), "0.0457");
  EXPECT_EQ(number_text(254.6), "255");
  EXPECT_EQ(number_text(1234, 1), "1234");
  EXPECT_EQ(number_text(1234567, 1), "1\u202f234\u202f567");
  EXPECT_EQ(number_text(-2.5, 2), "\u22122.5");
  EXPECT_EQ(number_text(not_known), "\u2013");
  EXPECT_EQ(small_number(0.000004, 0.01), "< 0.01");
  EXPECT_EQ(small_number(0.0123, 0.01), "0.0123");
  EXPECT_EQ(plain_number(60), "60");
  EXPECT_EQ(plain_number(0.5), "0.5");
  EXPECT_EQ(plain_number(20000), "20\u202f000");
  EXPECT_EQ(percent_text(0.12345), "12.3\u00a0%");
  EXPECT_EQ(fixed_text(0.7, 2), "0.70");
}

TEST(LinePlot, HasATooltipForEveryPointAndNamesItsAxesAndSeries) {
  const std::string svg = svg_line_plot({.title = "Recall",
                                         .x = {.title = "k"},
                                         .y = {.title = "share (%)"},
                                         .series = {{.name = "here", .points = {{5, 60.5}, {10, 80}}},
                                                    {.name = "paper", .points = {{5, 92}}}}});
  EXPECT_EQ(count_of("<title>", svg), 3);
  EXPECT_THAT(svg, HasSubstr("<title>here\nk: 5.000\nshare (%): 60.50</title>"));
  for (const char* text : {">Recall<", ">k<", ">share (%)<", ">here<", ">paper<"})
    EXPECT_THAT(svg, HasSubstr(text));
}

TEST(LinePlot, PutsPointsWhereTheirValuesAre) {
  const std::string svg = svg_line_plot({.title = "t",
                                         .x = {.title = "x", .minimum = 0, .maximum = 10},
                                         .y = {.title = "y", .minimum = 0, .maximum = 10},
                                         .series = {{.name = "s", .points = {{0, 0}, {5, 5}, {10, 10}}}}});
  double x[3], y[3];
  const std::size_t at = svg.find("points=\"");
  ASSERT_NE(at, std::string::npos);
  ASSERT_EQ(std::sscanf(svg.c_str() + at, "points=\"%lf,%lf %lf,%lf %lf,%lf", &x[0], &y[0], &x[1], &y[1],
                        &x[2], &y[2]),
            6);
  EXPECT_NEAR(x[1] - x[0], x[2] - x[1], 0.02);
  EXPECT_NEAR(y[0] - y[1], y[1] - y[2], 0.02);
  EXPECT_GT(y[0], y[2]) << "larger values stand higher";
}

TEST(LinePlot, DrawsSomebodyElsesFiguresDashed) {
  LinePlot plot{.title = "t",
                .x = {.title = "x"},
                .y = {.title = "y"},
                .series = {{.name = "s", .points = {{0, 1}, {1, 2}}}}};
  EXPECT_THAT(svg_line_plot(plot), Not(HasSubstr("stroke-dasharray")));
  plot.series[0].reference = true;
  EXPECT_THAT(svg_line_plot(plot), HasSubstr("stroke-dasharray"));
}

TEST(LinePlot, OfNothingIsEmpty) {
  EXPECT_EQ(svg_line_plot({.title = "t", .x = {.title = "x"}, .y = {.title = "y"}}), "");
}

TEST(BarPlot, DrawsABarForEachValueThereIs) {
  const std::string svg = svg_bar_plot({.title = "Rates",
                                        .value = {.title = "%", .minimum = 0, .maximum = 100},
                                        .groups = {"turn", "walk"},
                                        .series = {{.name = "strict", .values = {25, std::nullopt}},
                                                   {.name = "lenient", .values = {50, 75}}}});
  EXPECT_EQ(count_of("<title>", svg), 3);
  EXPECT_THAT(svg, HasSubstr("<title>walk\nlenient: 75.0</title>"));
}

TEST(BarPlot, MakesABarTwiceAsLongForTwiceTheValue) {
  const std::string svg = svg_bar_plot({.title = "t",
                                        .value = {.title = "v"},
                                        .groups = {"a", "b"},
                                        .series = {{.name = "s", .values = {10, 20}}}});
  std::vector<double> widths;
  for (std::size_t at = svg.find(" width=\"", svg.find("<rect")); at != std::string::npos;
       at = svg.find(" width=\"", svg.find("<rect", at)))
    widths.push_back(std::stod(svg.substr(at + 8)));
  ASSERT_EQ(widths.size(), 2U);
  EXPECT_NEAR(widths[1], 2 * widths[0], 0.02);
}

TEST(BarPlot, BreaksALongNameIntoTwoLines) {
  const std::string svg = svg_bar_plot({.title = "t",
                                        .value = {.title = "v"},
                                        .groups = {"a user with legs much longer"},
                                        .series = {{.name = "s", .values = {1}}}});
  EXPECT_THAT(svg, HasSubstr(">a user with legs<"));
  EXPECT_THAT(svg, HasSubstr(">much longer<"));
}

TEST(HeatMap, ShowsEveryCellAndMarksTheOneAskedFor) {
  HeatMap map{.title = "t",
              .column_title = "x",
              .row_title = "y",
              .columns = {"1", "2"},
              .rows = {"a"},
              .cells = {{{.value = 0, .text = "0.10", .tooltip = "first"},
                         {.value = 1, .text = "0.20", .tooltip = ""}}},
              .colours = HeatMap::Colours::Viridis};
  const std::string svg = svg_heat_map(map);
  EXPECT_THAT(svg, HasSubstr(">0.10<"));
  EXPECT_THAT(svg, HasSubstr("<title>first</title>"));
  EXPECT_THAT(svg, HasSubstr("fill:#440154"));
  EXPECT_THAT(svg, HasSubstr("fill:#fde725"));
  EXPECT_THAT(svg, Not(HasSubstr("stroke-width:3")));
  map.marked = {0, 1};
  EXPECT_THAT(svg_heat_map(map), HasSubstr("stroke-width:3"));
}

TEST(Viridis, HasItsKnownEndsAndMiddleAndStaysAtThem) {
  EXPECT_EQ(viridis(0), "#440154");
  EXPECT_EQ(viridis(0.5), "#21918c");
  EXPECT_EQ(viridis(1), "#fde725");
  EXPECT_EQ(viridis(-3), viridis(0));
  EXPECT_EQ(viridis(7), viridis(1));
}

TEST(Plots, EscapeNamesFromOutside) {
  const std::string evil = "<b>\"&'";
  const std::string svg = svg_bar_plot(
      {.title = evil, .value = {.title = evil}, .groups = {evil}, .series = {{.name = evil, .values = {1}}}});
  EXPECT_THAT(svg, Not(HasSubstr("<b>")));
  EXPECT_THAT(svg, HasSubstr("&lt;b&gt;&quot;&amp;&#39;"));
}

}  // namespace
}  // namespace abrazo::svg_plot_test
