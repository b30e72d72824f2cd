#include "core/session/frames/frame_range.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/session/export/history_record.hpp"
#include "core/session/frames/frame_history.hpp"

namespace abrazo::frame_range_test {
namespace {

std::shared_ptr<FrameSnapshot> made(std::uint64_t index) {
  auto frame = std::make_shared<FrameSnapshot>();
  frame->index = index;
  frame->time_s = static_cast<double>(index) / 100;
  return frame;
}

/// Frames [0, count), a hundred a second; some cannot be read. Notes how many were asked for at once.
class Stored : public FrameStore {
 public:
  explicit Stored(std::uint64_t count) : count_(count) {}

  Span span() const override { return {0, static_cast<double>(count_ - 1) / 100, 0, count_ - 1, count_}; }
  FrameSnapshotPtr at(double time_s) const override {
    if (time_s < 0) return nullptr;
    return frame(std::min(count_ - 1, static_cast<std::uint64_t>(time_s * 100 + 1e-9)));
  }
  FrameSnapshotPtr frame(std::uint64_t index) const override {
    const bool is_lost = index >= lost_from && index < lost_to;
    return index < count_ && !is_lost ? made(index) : nullptr;
  }
  std::vector<FrameSnapshotPtr> range(double, double, std::size_t) const override {
    ADD_FAILURE() << "a range is not read whole";
    return {};
  }
  std::vector<FrameSnapshotPtr> between(std::uint64_t first, std::uint64_t last, std::size_t) const override {
    most_at_once = std::max(most_at_once, last - first + 1);
    std::vector<FrameSnapshotPtr> found;
    for (std::uint64_t i = first; i <= last; ++i)
      if (FrameSnapshotPtr one = frame(i)) found.push_back(one);
    return found;
  }
  std::optional<std::uint64_t> state_before(std::uint64_t) const override { return std::nullopt; }

  bool is_kept(std::uint64_t, std::uint64_t, std::size_t) const override { return keeps_all; }

  bool keeps_all = false;
  std::uint64_t lost_from = 0, lost_to = 0;
  mutable std::uint64_t most_at_once = 0;

 private:
  std::uint64_t count_;
};

/// 5000 frames on disk, the last thousand also in memory, and a hundred that only memory has.
class Stretch : public testing::Test {
 protected:
  Stretch() {
    history.set_store(store);
    for (std::uint64_t i = 4000; i < 5100; ++i) history.append(made(i));
  }
  static std::vector<std::uint64_t> indices(FrameRange frames) {
    std::vector<std::uint64_t> found;
    while (const FrameSnapshotPtr frame = frames.next()) found.push_back(frame->index);
    return found;
  }
  /// What a view gets that comes back until there is no more.
  std::vector<std::uint64_t> caught_up(std::uint64_t next) const {
    std::vector<std::uint64_t> found;
    while (true) {
      const std::vector<FrameSnapshotPtr> frames = history.next_since(next);
      if (frames.empty()) return found;
      for (const FrameSnapshotPtr& frame : frames) found.push_back(frame->index);
      next = found.back() + 1;
    }
  }
  static std::vector<std::uint64_t> all(std::uint64_t first, std::uint64_t end) {
    std::vector<std::uint64_t> numbers;
    for (std::uint64_t i = first; i < end; ++i) numbers.push_back(i);
    return numbers;
  }

  std::shared_ptr<Stored> store = std::make_shared<Stored>(5000);
  FrameHistory history;
};

/// A view that was hidden has thousands of frames to catch up with, and the window does not wait for the
/// disk.
TEST_F(Stretch, IsCaughtUpWithInParts) {
  store->lost_from = 1200;
  store->lost_to = 1500;
  std::vector<std::uint64_t> expected = all(1000, 1200);
  for (const std::uint64_t index : all(1500, 5100)) expected.push_back(index);
  EXPECT_EQ(caught_up(1000), expected);
  EXPECT_LE(store->most_at_once, FrameHistory::read_at_once);
}

/// Views that show another subject begin anew, and so do the figures after a change of library.
TEST_F(Stretch, IsReadFromItsBeginningInPartsToo) {
  EXPECT_EQ(caught_up(0), all(0, 5100));
  EXPECT_LE(store->most_at_once, FrameHistory::read_at_once);
}

TEST_F(Stretch, ThatTheStoreKeepsInMemoryComesAtOnce) {
  store->keeps_all = true;
  EXPECT_EQ(history.next_since(0).size(), 5100U);
}

TEST_F(Stretch, GivesEveryFrameOnceWhereverItIs) {
  EXPECT_EQ(indices(history.stretch(0, 100)), all(0, 5100));
  EXPECT_EQ(indices(history.stretch(39.5, 40.5)), all(3950, 4051));
  EXPECT_EQ(indices(history.stretch(10, 11)), all(1000, 1101));
  EXPECT_EQ(indices(history.stretch(45, 46)), all(4500, 4601));
}

TEST_F(Stretch, HoldsAPieceOfWhatIsOnDisk) {
  FrameRange frames = history.stretch(0, 100);
  EXPECT_EQ(frames.size(), 5100U);
  EXPECT_EQ(store->most_at_once, 0U) << "nothing is read before it is wanted";
  while (frames.next()) continue;
  EXPECT_EQ(store->most_at_once, FrameRange::piece);
}

TEST_F(Stretch, StartsAgain) {
  FrameRange frames = history.stretch(39, 41);
  for (int i = 0; i < 150; ++i) frames.next();
  frames.rewind();
  EXPECT_EQ(indices(frames), all(3900, 4101));
}

TEST_F(Stretch, GoesOnBehindFramesThatAreLost) {
  store->lost_from = 700;
  store->lost_to = 1300;  // more than two pieces, and the one at the beginning of the stretch
  EXPECT_EQ(indices(history.stretch(7.5, 14)), all(1300, 1401));
}

TEST_F(Stretch, OutlivesTheHistory) {
  FrameRange frames;
  {
    FrameHistory passing;
    passing.set_store(store);
    for (std::uint64_t i = 4000; i < 4010; ++i) passing.append(made(i));
    frames = passing.stretch(39.9, 50);
  }
  EXPECT_EQ(indices(frames), all(3990, 4010));
}

TEST_F(Stretch, IsEmptyWhereThereIsNothing) {
  EXPECT_TRUE(history.stretch(200, 300).empty());
  EXPECT_TRUE(history.stretch(3, 2).empty());
  EXPECT_TRUE(FrameHistory().stretch(0, 1).empty());
  EXPECT_FALSE(FrameRange().next());
}

TEST_F(Stretch, ShowsTheLastFrameNotAfterATime) {
  FrameRangeAtTimes shown(history.stretch(39, 41));
  EXPECT_EQ(shown.at(39.004)->index, 3900U);
  EXPECT_EQ(shown.at(38)->index, 3900U) << "the first one when all are after";
  EXPECT_EQ(shown.at(40.017)->index, 4001U);
  EXPECT_EQ(shown.at(99)->index, 4100U);
  EXPECT_EQ(shown.at(39.5)->index, 3950U) << "backwards, too";
  EXPECT_FALSE(FrameRangeAtTimes(FrameRange()).at(1));
}

TEST(HistoryRecord, CountsTheFramesThatAreLostInWhatIsAskedFor) {
  const auto store = std::make_shared<Stored>(1000);
  store->lost_from = 300, store->lost_to = 400;
  const auto record = HistoryRecord::create({"session", FrameRange(store, 0, 1000, {}), nullptr, "", ""}, {});
  ASSERT_TRUE(record) << record.error().text();
  const auto lost = [&](double from_s, double to_s) {
    return (*record)
        ->each_frame(from_s, to_s, [](const FrameSnapshot&) -> Status { return Done{}; })
        ->damaged;
  };
  EXPECT_EQ(lost(0, 10), 100U);
  EXPECT_EQ(lost(2, 5), 100U);
  EXPECT_EQ(lost(0, 2), 0U);
  EXPECT_EQ(lost(5, 9), 0U);
}

}  // namespace
}  // namespace abrazo::frame_range_test
