#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>

#include "widgets/plots/sample_table.hpp"

namespace abrazo::widgets::plot_table_test {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr Series drawn = Series::FootLock;

SampleTable::Row row(std::uint64_t index, double time_s, double value) {
  SampleTable::Row row{time_s, index, {}};
  row.values.fill(none);
  row.values[static_cast<std::size_t>(drawn)] = value;
  return row;
}

/// `count` rows, 100 a second, of value sin.
SampleTable waves(std::uint64_t count) {
  SampleTable table;
  for (std::uint64_t i = 0; i < count; ++i)
    table.append(row(i, static_cast<double>(i) / 100, std::sin(static_cast<double>(i) / 40)));
  return table;
}

double largest(const std::vector<SampleTable::Point>& line) {
  double found = -1e300;
  for (const auto& point : line) found = std::max(found, point.value);
  return found;
}

TEST(SampleTable, DrawsEveryValueWhereTheyAreFewAndOneBeyondEachEnd) {
  const auto line = waves(100).line(drawn, 0.205, 0.255, 300);
  ASSERT_EQ(line.size(), 7U);
  EXPECT_DOUBLE_EQ(line.front().time_s, 0.20);
  EXPECT_DOUBLE_EQ(line.back().time_s, 0.26);
}

TEST(SampleTable, KeepsTheLeastAndTheLargestOfEachColumn) {
  SampleTable table;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const double value = i == 437 ? 9 : i == 441 ? -5 : 1;
    table.append(row(i, static_cast<double>(i) / 100, value));
  }
  const auto line = table.line(drawn, 0, 10, 100);
  EXPECT_LE(line.size(), 204U);
  const auto spike = std::ranges::find(line, SampleTable::Point{4.37, 9});
  ASSERT_NE(spike, line.end());
  EXPECT_NE(std::ranges::find(spike, line.end(), SampleTable::Point{4.41, -5}), line.end());
  for (std::size_t p = 1; p < line.size(); ++p) EXPECT_LE(line[p - 1].time_s, line[p].time_s);
}

TEST(SampleTable, AnHourIsDrawnFromItsBlocksWithoutLosingASpike) {
  SampleTable table = waves(360'000);
  table.append(row(360'000, 3600.00, 1));
  SampleTable spiked;
  for (const auto& one : table.rows()) {
    SampleTable::Row copy = one;
    if (copy.index == 123'457) copy.values[static_cast<std::size_t>(drawn)] = 42;
    spiked.append(copy);
  }
  const auto line = spiked.line(drawn, 0, 3600, 800);
  EXPECT_LE(line.size(), 2U * 802);
  EXPECT_EQ(largest(line), 42);
  const auto spike = std::ranges::find(line, 42.0, &SampleTable::Point::value);
  EXPECT_DOUBLE_EQ(spike->time_s, 1234.57);
}

TEST(SampleTable, TheRasterStaysWhereItIsAsTheWindowMoves) {
  const SampleTable table = waves(20'000);
  const auto before = table.line(drawn, 0, 100, 200), after = table.line(drawn, 10.3, 110.3, 200);
  // What both show, away from their ends, is the same.
  for (const auto& point : before)
    if (point.time_s > 12 && point.time_s < 98) {
      EXPECT_NE(std::ranges::find(after, point), after.end()) << point.time_s;
    }
}

TEST(SampleTable, DroppedRowsAreNotDrawnAnyMore) {
  SampleTable table = waves(10'000);
  table.drop_before(33.333);
  EXPECT_EQ(table.rows().front().index, 3334U);
  for (std::uint64_t i = 10'000; i < 20'000; ++i) table.append(row(i, static_cast<double>(i) / 100, 7));
  table.drop_before(33.333);
  const auto line = table.line(drawn, 0, 200, 20);
  EXPECT_GE(line.front().time_s, 33.333);
  EXPECT_EQ(largest(line), 7);
  table.drop_before(150);
  for (const auto& point : table.line(drawn, 0, 200, 10)) EXPECT_EQ(point.value, 7);
}

TEST(SampleTable, GapsBreakTheLine) {
  SampleTable table;
  for (std::uint64_t i = 0; i < 400; ++i)
    table.append(row(i, static_cast<double>(i) / 100, i >= 100 && i < 300 ? none : 1));
  for (const int columns : {400, 40, 1}) {
    const auto line = table.line(drawn, 0, 4, columns);
    const bool broken = std::ranges::any_of(line, [](const auto& p) { return std::isnan(p.value); });
    EXPECT_EQ(broken, columns > 1) << columns;
  }
}

TEST(SampleTable, TheLineIsBrokenWhereTheRecordingHasAGapHoweverFarAway) {
  SampleTable table;
  for (std::uint64_t i = 0; i < 40'000; ++i) {
    const bool after_gap = i == 20'000;
    table.append(row(i, static_cast<double>(i) / 100 + (i < 20'000 ? 0 : 50), 1), after_gap);
    if (i % 100 == 0) table.thin_older(5'000, 4'000);
  }
  const auto breaks = [&table](double from_s, double to_s, int columns) {
    return std::ranges::count_if(table.line(drawn, from_s, to_s, columns),
                                 [](const auto& point) { return std::isnan(point.value); });
  };
  EXPECT_EQ(breaks(0, 450, 400), 1);
  EXPECT_EQ(breaks(190, 260, 4000), 1);
  EXPECT_EQ(breaks(210, 230, 400), 1) << "from one end of the gap to the other";
  EXPECT_EQ(breaks(260, 450, 400), 0);
  EXPECT_EQ(breaks(0, 450, 4), 0) << "it has no place in a picture of four columns";
  table.drop_before(300);
  EXPECT_EQ(breaks(0, 450, 400), 0);
}

TEST(SampleTable, OfOlderRowsFewRemainAndNoSpikeIsLost) {
  constexpr std::uint64_t rows = 60'000, spike = 12'345, dip = 20'011;
  SampleTable table;
  for (std::uint64_t i = 0; i < rows; ++i) {
    const double value = i == spike ? 9 : i == dip ? -9 : std::sin(static_cast<double>(i) / 40);
    table.append(row(i, static_cast<double>(i) / 100, value));
    if (i % 100 == 0) table.thin_older(10'000, 4'000);
  }
  table.thin_older(10'000, 4'000);
  EXPECT_LE(table.rows().size(), 10'000U + 4'000U + 8'192U);
  EXPECT_GT(table.thinned(), 1'000U);
  for (std::size_t r = 1; r < table.rows().size(); ++r)
    ASSERT_LT(table.rows()[r - 1].index, table.rows()[r].index);
  for (std::uint64_t i = rows - 10'000; i < rows; ++i)
    ASSERT_EQ(table.at(static_cast<double>(i) / 100)->index, i) << "the newest stay";
  const auto line = table.line(drawn, 0, 600, 50);
  EXPECT_EQ(largest(line), 9);
  EXPECT_EQ(std::ranges::min(line, {}, &SampleTable::Point::value).value, -9);
  const auto at = std::ranges::max(line, {}, &SampleTable::Point::value).time_s;
  EXPECT_NEAR(at, spike / 100.0, 0.64) << "as far apart as rows are then";
  table.drop_before(400);
  EXPECT_GE(table.rows().front().time_s, 400) << "the oldest go first";
  EXPECT_LT(table.rows().front().time_s, 400.64) << "and no more of them";
  EXPECT_LT(largest(table.line(drawn, 400, 600, 50)), 1.001);
}

TEST(SampleTable, AnHourAgoIsAsEvenAsTenMinutesAgo) {
  SampleTable table;
  for (std::uint64_t i = 0; i < 400'000; ++i) {
    table.append(row(i, static_cast<double>(i) / 100, 0));
    table.thin_older(10'000, 4'000);
  }
  std::uint64_t longest = 0, shortest = 1'000'000;
  for (std::size_t r = 1; r < table.thinned(); ++r) {
    const std::uint64_t step = table.rows()[r].index - table.rows()[r - 1].index;
    longest = std::max(longest, step);
    shortest = std::min(shortest, step);
  }
  EXPECT_EQ(longest, shortest);
}

TEST(SampleTable, SaysWhichRowIsShownAtATime) {
  const SampleTable table = waves(10);
  EXPECT_EQ(table.at(-1), nullptr);
  EXPECT_EQ(table.at(0.045)->index, 4U);
  EXPECT_EQ(table.at(100)->index, 9U);
}

TEST(PlotCsv, HasUnitsInItsHeaderAndNumbersThatReadBackToTheSameBits) {
  SampleTable table;
  const double awkward = 0.1 + 0.2, time = 1.0 / 3;
  table.append(row(4, 0.1, 1));
  table.append(row(5, time, awkward));
  table.append(row(6, 0.9, 1));
  std::istringstream lines(plot_csv(table, 0.2, 0.5));
  std::string header, line, more;
  std::getline(lines, header);
  EXPECT_TRUE(header.starts_with("time [s],frame,energy.deformation [m^2],")) << header;
  EXPECT_NE(header.find("residual.foot_lock [mm]"), std::string::npos);
  std::getline(lines, line);
  EXPECT_FALSE(std::getline(lines, more)) << "only what is in the window";
  std::vector<std::string> fields;
  std::istringstream cells(line);
  for (std::string cell; std::getline(cells, cell, ',');) fields.push_back(cell);
  const auto number = [](const std::string& text) {
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
  };
  EXPECT_EQ(number(fields[0]), time);
  EXPECT_EQ(fields[1], "5");
  EXPECT_EQ(number(fields[2 + static_cast<std::size_t>(drawn)]), awkward);
  EXPECT_EQ(fields[2], "") << "a value that the frame has not";
}

}  // namespace
}  // namespace abrazo::widgets::plot_table_test
