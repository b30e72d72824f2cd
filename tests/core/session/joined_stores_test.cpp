// Two stores as one history.
#include <gtest/gtest.h>

#include "core/session/frames/joined_stores.hpp"

namespace abrazo::joined_stores_test {
namespace {

/// Frames [first, last], ten a second.
class Frames : public FrameStore {
 public:
  Frames(std::uint64_t first, std::uint64_t last) {
    for (std::uint64_t i = first; i <= last; ++i) {
      auto frame = std::make_shared<FrameSnapshot>();
      frame->index = i;
      frame->time_s = static_cast<double>(i) / 10;
      frames_.push_back(frame);
    }
  }
  Span span() const override {
    if (frames_.empty()) return {};
    return {frames_.front()->time_s, frames_.back()->time_s, frames_.front()->index, frames_.back()->index,
            frames_.size()};
  }
  FrameSnapshotPtr at(double time_s) const override {
    FrameSnapshotPtr found;
    for (const auto& frame : frames_)
      if (frame->time_s <= time_s) found = frame;
    return found;
  }
  FrameSnapshotPtr frame(std::uint64_t index) const override {
    for (const auto& frame : frames_)
      if (frame->index == index) return frame;
    return nullptr;
  }
  std::vector<FrameSnapshotPtr> range(double from_s, double to_s, std::size_t most) const override {
    std::vector<FrameSnapshotPtr> found;
    for (const auto& frame : frames_)
      if (from_s <= frame->time_s && frame->time_s <= to_s && found.size() < most) found.push_back(frame);
    return found;
  }
  std::vector<FrameSnapshotPtr> between(std::uint64_t first, std::uint64_t last, std::size_t) const override {
    std::vector<FrameSnapshotPtr> found;
    for (const auto& frame : frames_)
      if (first <= frame->index && frame->index <= last) found.push_back(frame);
    return found;
  }
  std::optional<std::uint64_t> state_before(std::uint64_t index) const override {
    if (frames_.empty() || index < frames_.front()->index) return std::nullopt;
    return frames_.front()->index;
  }

 private:
  std::vector<FrameSnapshotPtr> frames_;
};

class Joined : public testing::Test {
 protected:
  /// 2.0 s to 4.0 s, and from 6.0 s to 8.0 s; the earlier one is read on and sees both.
  std::shared_ptr<const FrameStore> joined =
      joined_stores(std::make_shared<Frames>(20, 40), std::make_shared<Frames>(60, 80));
};

TEST_F(Joined, ReachFromTheFirstFrameOfTheOneToTheLastOfTheOther) {
  const FrameStore::Span span = joined->span();
  EXPECT_EQ(span.first_s, 2);
  EXPECT_EQ(span.last_s, 8);
  EXPECT_EQ(span.first_index, 20U);
  EXPECT_EQ(span.last_index, 80U);
  EXPECT_EQ(span.frames, 42U);
}

TEST_F(Joined, GiveTheFrameOfATimeOrIndex) {
  EXPECT_EQ(joined->at(3.05)->index, 30U);
  EXPECT_EQ(joined->at(5)->index, 40U) << "between them the last one before";
  EXPECT_EQ(joined->at(7.55)->index, 75U);
  EXPECT_EQ(joined->at(1), nullptr);
  EXPECT_EQ(joined->frame(33)->index, 33U);
  EXPECT_EQ(joined->frame(66)->index, 66U);
  EXPECT_EQ(joined->frame(50), nullptr);
}

TEST_F(Joined, GiveRangesAcrossBothInOrder) {
  const auto frames = joined->range(3.5, 6.25, 1000);
  ASSERT_EQ(frames.size(), 9U);
  EXPECT_EQ(frames.front()->index, 35U);
  EXPECT_EQ(frames.back()->index, 62U);
  EXPECT_EQ(joined->between(39, 61, 1000).size(), 4U);
  EXPECT_EQ(joined->range(2, 3, 1000).size(), 11U);
  EXPECT_EQ(joined->between(70, 75, 1000).size(), 6U);
}

TEST_F(Joined, GiveNoMoreFramesThanAreWanted) {
  EXPECT_EQ(joined->range(2, 8, 10).size(), 10U);
  EXPECT_EQ(joined->range(2, 8, 1000).size(), 42U);
}

TEST_F(Joined, FindTheStateBeforeAFrame) {
  EXPECT_EQ(joined->state_before(35), 20U);
  EXPECT_EQ(joined->state_before(65), 60U);
}

TEST(JoinedStores, WithNothingAreTheOther) {
  const auto one = std::make_shared<Frames>(1, 3);
  EXPECT_EQ(joined_stores(nullptr, one), one);
  EXPECT_EQ(joined_stores(one, nullptr), one);
  const auto empty = std::make_shared<Frames>(5, 4);
  EXPECT_EQ(joined_stores(one, empty)->span().frames, 3U);
  EXPECT_EQ(joined_stores(one, empty)->at(9)->index, 3U);
  EXPECT_EQ(joined_stores(empty, one)->span().first_index, 1U);
}

}  // namespace
}  // namespace abrazo::joined_stores_test
