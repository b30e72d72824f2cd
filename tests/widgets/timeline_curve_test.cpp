#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "widgets/timeline/sample_curve.hpp"

namespace abrazo::widgets::timeline_curve_test {
namespace {

double figure(int i) {
  return std::sin(0.37 * i) + 0.001 * (i % 97);
}

SampleCurve curve(int samples) {
  SampleCurve made;
  for (int i = 0; i < samples; ++i) made.append(0.01 * i, figure(i));
  return made;
}

/// The same by looking at every sample.
SampleCurve::Extent extent_by_hand(int first, int last) {
  SampleCurve::Extent extent{1e9F, -1e9F};
  for (int i = first; i < last; ++i) {
    extent.least = std::min(extent.least, static_cast<float>(figure(i)));
    extent.most = std::max(extent.most, static_cast<float>(figure(i)));
  }
  return extent;
}

TEST(SampleCurve, ColumnsKnowTheSmallestAndLargestOfTheirSamples) {
  const auto columns = curve(5000).columns(-0.005, 49.995, 7);  // between samples
  ASSERT_EQ(columns.size(), 7u);
  for (int column = 0; column < 7; ++column) {
    const auto first = static_cast<int>(std::ceil(column * 5000 / 7.0));
    const auto last = static_cast<int>(std::ceil((column + 1) * 5000 / 7.0));
    const auto expected = extent_by_hand(first, last);
    EXPECT_EQ(columns[static_cast<std::size_t>(column)].least, expected.least) << column;
    EXPECT_EQ(columns[static_cast<std::size_t>(column)].most, expected.most) << column;
  }
}

TEST(SampleCurve, KeepsThatAfterTheOldestWereGivenUp) {
  SampleCurve dropped = curve(3000);
  dropped.drop_before(4.995);
  EXPECT_EQ(dropped.size(), 2500u);
  for (int i = 3000; i < 3300; ++i) dropped.append(0.01 * i, figure(i));
  const auto column = dropped.columns(0, 40, 1).front();
  const auto expected = extent_by_hand(500, 3300);
  EXPECT_EQ(column.least, expected.least);
  EXPECT_EQ(column.most, expected.most);
}

TEST(SampleCurve, CanBeGivenUpWhollyAndFilledAgain) {
  SampleCurve again = curve(200);
  again.drop_before(100);
  EXPECT_EQ(again.size(), 0u);
  again.append(101, 5);
  EXPECT_EQ(again.columns(100, 102, 1).front().most, 5);
  EXPECT_EQ(again.columns(100, 102, 1).front().least, 5);
}

TEST(SampleCurve, AColumnWithoutSamplesIsEmpty) {
  SampleCurve two;
  two.append(0.5, 1);
  two.append(2.5, 3);
  two.append(2.6, std::nan(""));
  const auto columns = two.columns(0, 3, 3);
  EXPECT_LE(columns[0].least, columns[0].most);
  EXPECT_GT(columns[1].least, columns[1].most);
  EXPECT_EQ(columns[2].most, 3);
  EXPECT_EQ(two.size(), 2u);
}

TEST(SampleCurve, EmptyColumnsAreBridgedOnAStraightLineAndGapsStay) {
  const SampleCurve::Extent none{1, -1};
  std::vector<SampleCurve::Extent> columns = {none, {0, 2}, none, none,   {4, 4},
                                              none, none,   none, {5, 5}, none};
  bridge_columns(columns, [](std::size_t first, std::size_t end) { return first <= 6 && 6 < end; });
  EXPECT_EQ(columns[2].least, 2);
  EXPECT_EQ(columns[3].most, 3);
  EXPECT_TRUE(is_empty(columns[5]));
  EXPECT_TRUE(is_empty(columns[7]));
  EXPECT_TRUE(is_empty(columns[0])) << "nothing is known beyond the ends";
  EXPECT_TRUE(is_empty(columns[9]));
}

TEST(SampleCurve, ReachesAsHighAsItsColumnsUnlessOneTowers) {
  SampleCurve even;
  for (int i = 0; i < 100; ++i) even.append(i, 1 + 0.01 * i);
  EXPECT_NEAR(usual_upper(even.columns(0, 100, 100)), 1.99, 1e-6);
  even.append(100, 500);
  EXPECT_LT(usual_upper(even.columns(0, 101, 101)), 3);
  EXPECT_EQ(usual_upper(even.columns(200, 300, 10)), 0);
}

}  // namespace
}  // namespace abrazo::widgets::timeline_curve_test
