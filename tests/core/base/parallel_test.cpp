#include "core/base/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <string_view>
#include <vector>

namespace abrazo::parallel_test {
namespace {

TEST(ForEachRow, CallsEachRowOnceAndReportsTheEndWhoeverDidTheLast) {
  for (int run = 0; run < 200; ++run) {
    std::vector<std::atomic<int>> calls(5);
    double told = -1;
    const bool whole = for_each_row(
        calls.size(), 2,
        [&](double fraction, std::string_view) {
          EXPECT_GE(fraction, told);
          told = fraction;
          return true;
        },
        "counting", [&](std::size_t row) { ++calls[row]; });
    EXPECT_TRUE(whole);
    EXPECT_EQ(told, 1);
    for (const std::atomic<int>& each : calls) EXPECT_EQ(each, 1);
  }
}

TEST(ForEachRow, CanBeCancelledAtTheEndAtTheLatest) {
  for (int run = 0; run < 200; ++run)
    EXPECT_FALSE(for_each_row(
        1, 1, [](double fraction, std::string_view) { return fraction < 1; }, "counting",
        [](std::size_t) {}));
}

}  // namespace
}  // namespace abrazo::parallel_test
