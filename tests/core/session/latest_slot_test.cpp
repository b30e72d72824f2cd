#include "core/session/frames/latest_slot.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace abrazo::latest_slot_test {
namespace {

TEST(LatestSlot, GivesEachValueOnceToAReader) {
  LatestSlot<int> slot;
  std::uint64_t seen = 0;
  EXPECT_EQ(slot.take_if_newer(seen), nullptr);
  slot.publish(std::make_shared<const int>(1));
  slot.publish(std::make_shared<const int>(2));
  EXPECT_EQ(*slot.take_if_newer(seen), 2);
  EXPECT_EQ(slot.take_if_newer(seen), nullptr);
  EXPECT_EQ(*slot.newest(), 2);
}

TEST(LatestSlot, AReaderOnAnotherThreadNeverSeesValuesGoBack) {
  LatestSlot<int> slot;
  std::jthread writer([&] {
    for (int i = 1; i <= 20000; ++i) slot.publish(std::make_shared<const int>(i));
  });
  std::uint64_t seen = 0;
  int last = 0;
  while (last < 20000) {
    const auto value = slot.take_if_newer(seen);
    if (!value) continue;
    ASSERT_GT(*value, last);
    last = *value;
  }
}

}  // namespace
}  // namespace abrazo::latest_slot_test
