#include "core/session/run/history_keeper.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "core/session/edit/ending_history.hpp"
#include "core/session/file/session_file.hpp"
#include "core/session/run/recorder.hpp"
#include "tests/core/session/recorded_session.hpp"

namespace abrazo::history_keeper_test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t megabyte = 1 << 20;
constexpr std::size_t little_memory = 2 * megabyte;  // some seconds

/// A session whose memory holds a few seconds, with a keeper that is tended by hand.
struct Kept : test::TemporaryFolder, test::DrivenSession {
  explicit Kept(std::uint64_t bound = 512 * megabyte)
      : test::DrivenSession(little_memory), folder(file("history")) {
    auto opened = HistoryKeeper::open(folder, test::session_facts(), {.bytes = bound, .tend_every_s = 0});
    EXPECT_TRUE(opened) << opened.error().text();
    kept = std::move(*opened);
    history.set_store(kept->store());
    commands.push(AttachListener{kept});
  }
  /// Driven faster than real time: what waits is on disk before more comes.
  void run_on_disk_until(double to_s) {
    while (now_s < to_s) {
      run_until(std::min(to_s, now_s + 0.5));
      kept->tend();
      const std::uint64_t newest = latest.newest()->index;
      for (int tries = 0; tries < 2000 && kept->store()->span().last_index < newest; ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  std::size_t files() const {
    std::size_t count = 0;
    for (const auto& each : fs::directory_iterator(folder)) count += each.path().extension() == ".abrazo";
    return count;
  }
  std::string folder;
  std::shared_ptr<HistoryKeeper> kept;
};

TEST(HistoryKeeper, FramesThatMemoryDroppedAreReadFromDisk) {
  Kept session;
  session.run_until(1);
  const FrameSnapshotPtr first = session.history.at(0);
  session.run_on_disk_until(10);
  const auto span = session.history.span();
  ASSERT_GT(span.evicted, 0U) << "memory is too small for all";
  EXPECT_EQ(span.first_index, first->index);
  const FrameSnapshotPtr again = session.history.at(0);
  ASSERT_TRUE(again);
  EXPECT_NE(again, first);
  EXPECT_EQ(again->result.result, first->result.result);
  EXPECT_EQ(session.history.range(0, 10).size(), session.latest.newest()->index + 1) << "none is missing";
}

TEST(HistoryKeeper, OverTheBoundTheOldestIsRemovedAndSaid) {
  Kept session(4 * megabyte);
  session.run_on_disk_until(30);
  session.kept->tend();
  const auto state = session.kept->state();
  EXPECT_GT(state.removed_files, 0U);
  EXPECT_LE(state.bytes, 4 * megabyte + megabyte / 2);
  EXPECT_EQ(state.bound, 4 * megabyte);
  const auto span = session.kept->store()->span();
  EXPECT_GT(span.first_s, 1) << "history begins later";
  EXPECT_EQ(span.last_index, session.latest.newest()->index) << "and goes on";
  const auto whole = session.kept->store()->range(span.first_s, span.last_s, FrameHistory::all_frames);
  ASSERT_EQ(whole.size(), span.last_index - span.first_index + 1);
  for (std::size_t i = 1; i < whole.size(); ++i)
    ASSERT_EQ(whole[i]->index, whole[i - 1]->index + 1) << "no frame is lost between two files";
}

TEST(HistoryKeeper, EachFileIsASessionOfItsOwn) {
  Kept session(4 * megabyte);
  session.run_on_disk_until(12);
  ASSERT_GT(session.files(), 1U);
  for (const auto& each : fs::directory_iterator(session.folder)) {
    if (each.path().extension() != ".abrazo") continue;
    const auto opened = SessionFile::open(each.path().string());
    ASSERT_TRUE(opened) << opened.error().text();
  }
}

TEST(HistoryKeeper, WhileARecorderWritesTheFramesItRestsAndNoneIsMissing) {
  Kept session;
  session.run_on_disk_until(2);
  auto recorder = *Recorder::open(session.file("mine.abrazo"), [] {
    auto facts = test::session_facts();
    facts.has_times_of_file = true;
    return facts;
  }());
  session.kept->rest(recorder->store());
  session.commands.push(AttachListener{recorder});
  session.run_on_disk_until(4);
  session.kept->tend();
  const std::uint64_t resting = session.kept->state().bytes;
  // It rests from the first look on that finds frames of the recorder on disk.
  const double before_s = session.kept->kept_after_s(0);
  EXPECT_GE(before_s, 2);
  EXPECT_LE(before_s, 4);
  session.run_on_disk_until(8);
  EXPECT_EQ(session.kept->state().bytes, resting) << "the same frames are not written twice";
  EXPECT_EQ(session.kept->kept_after_s(0), before_s) << "while it rests the recorder writes";
  ASSERT_TRUE(session.kept->go_on());
  session.run_on_disk_until(8.5);
  session.commands.push(DetachListener{recorder});
  session.run_on_disk_until(11);
  ASSERT_TRUE(recorder->finish());
  EXPECT_GT(session.kept->state().bytes, resting);
  EXPECT_NEAR(session.kept->kept_after_s(0), before_s + (11 - 8), 0.2) << "again from 8 s on";
  EXPECT_NEAR(session.kept->kept_after_s(10), 1, 0.2);
  EXPECT_EQ(session.kept->kept_after_s(12), 0);
  const auto all = session.kept->store()->range(0, 11, FrameHistory::all_frames);
  ASSERT_EQ(all.size(), session.latest.newest()->index + 1);
  for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(all[i]->index, i);
}

TEST(HistoryKeeper, TellsHowMuchOfItsFramesIsOfALivePerformerAndInNoRecording) {
  Kept session;
  session.run_until(2);
  EXPECT_EQ(session.kept->performed_after_s(0), 0) << "a clip plays the user";
  std::uint64_t index = session.latest.newest()->index;
  const auto perform = [&](double from_s, double seconds) {
    for (int step = 0; step <= 50 * seconds; ++step) {
      auto frame = std::make_shared<FrameSnapshot>(*session.latest.newest());
      frame->index = ++index;
      frame->time_s = frame->times.arrived_s = from_s + 0.02 * step;
      session.kept->frame_solved(frame);
    }
  };
  perform(3, 2);
  EXPECT_NEAR(session.kept->performed_after_s(0), 2, 1e-9);
  EXPECT_NEAR(session.kept->performed_after_s(4.5), 0.5, 1e-9);
  perform(35, 1);
  EXPECT_NEAR(session.kept->performed_after_s(0), 3, 1e-9) << "nobody performed in the pause";
  const auto recorder = *Recorder::open(session.file("mine.abrazo"), test::session_facts());
  session.kept->rest(recorder->store());
  perform(36.02, 2);
  EXPECT_NEAR(session.kept->performed_after_s(0), 3, 1e-9) << "the recording has it";
  ASSERT_TRUE(session.kept->go_on());
  perform(40, 1);
  EXPECT_NEAR(session.kept->performed_after_s(0), 4, 1e-9);
}

TEST(EndingHistory, OfALivePerformerASecondIsWorthAQuestion) {
  EXPECT_FALSE(asks_before_deleting({.unsaved_s = 9, .performed_s = 0.5}));
  EXPECT_TRUE(asks_before_deleting({.unsaved_s = 3, .performed_s = 1}));
  EXPECT_FALSE(asks_before_deleting({.unsaved_s = 9})) << "of a clip, which can be played again";
  EXPECT_TRUE(asks_before_deleting({.unsaved_s = 10}));
}

TEST(EndingHistory, OfADemoThatNobodyTouchedNothingIsAskedAbout) {
  EXPECT_FALSE(asks_before_deleting({.unsaved_s = 1000, .is_demo = true}));
  EXPECT_TRUE(asks_before_deleting({.unsaved_s = 1000, .is_demo = true, .is_touched = true}));
}

TEST(HistoryKeeper, WhatIsRemovedIsGoneFromDiskAndFromTheStore) {
  Kept session;
  session.run_on_disk_until(3);
  session.kept->remove();
  EXPECT_FALSE(fs::exists(session.folder));
  EXPECT_EQ(session.kept->store()->span().frames, 0U);
  session.run_until(4);  // the session goes on in memory
  EXPECT_TRUE(session.history.at(3.9));
}

TEST(HistoryKeeper, AFolderThatCannotBeMadeIsAnError) {
  const test::TemporaryFolder place;
  const std::string taken = place.file("taken");
  std::ofstream(taken) << "a file";
  const auto opened = HistoryKeeper::open(taken + "/history", test::session_facts());
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().text().find("the folder for the history cannot be made"), std::string::npos);
}

}  // namespace
}  // namespace abrazo::history_keeper_test
