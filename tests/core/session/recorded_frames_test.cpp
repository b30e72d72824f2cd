#include "core/session/file/recorded_frames.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/library/build/motion_library_builder.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/frames/frame_in_library.hpp"
#include "core/session/run/re_solver.hpp"
#include "tests/core/session/recorded_session.hpp"

namespace abrazo::recorded_frames_test {
namespace {

/// A recorded session, and what memory had of it.
class RecordedFramesTest : public testing::Test {
 protected:
  void record(double seconds, std::size_t history_bytes = std::size_t{512} << 20) {
    path = folder.file("s.abrazo");
    session = std::make_unique<test::DrivenSession>(history_bytes);
    session->keeper->recorder = *Recorder::open(path, test::session_facts());
    session->run_until(seconds);
    ASSERT_TRUE(session->keeper->recorder->flush());
  }
  const std::vector<FrameSnapshotPtr>& kept() const { return session->keeper->frames; }

  test::TemporaryFolder folder;
  std::string path;
  std::unique_ptr<test::DrivenSession> session;
};

TEST_F(RecordedFramesTest, AreFoundByTimeAndIndex) {
  record(2);
  const auto frames = *RecordedFrames::open(path);
  EXPECT_EQ(frames->span().frames, kept().size());
  EXPECT_EQ(frames->span().last_s, kept().back()->time_s);
  EXPECT_EQ(frames->at(-1), nullptr);
  EXPECT_EQ(frames->at(1e9)->index, kept().back()->index);
  for (const std::size_t i : {0U, 7U, 50U}) {
    EXPECT_EQ(frames->at(kept()[i]->time_s)->index, i);
    EXPECT_EQ(frames->at(kept()[i]->time_s + 0.001)->index, i);
    EXPECT_EQ(frames->frame(i)->result.result, kept()[i]->result.result);
  }
  EXPECT_EQ(frames->frame(kept().size()), nullptr);
  EXPECT_EQ(frames->frame(3), frames->frame(3));  // kept in memory
}

TEST_F(RecordedFramesTest, HaveTheMeshOfTheLibraryTheyWereSolvedWith) {
  record(1);
  const auto without = *RecordedFrames::open(path);
  EXPECT_TRUE(without->frame(20)->result.edges.empty());
  const auto with = *RecordedFrames::open(path, test::session_library());
  const FrameResult &read = with->frame(20)->result, &solved = kept()[20]->result;
  EXPECT_EQ(read.edges, solved.edges);
  EXPECT_EQ(read.tetrahedra, solved.tetrahedra);
  EXPECT_EQ(read.selected_pair, solved.selected_pair);
  EXPECT_EQ(read.edge_weights, solved.edge_weights);
  EXPECT_EQ(read.edge_residuals_m, solved.edge_residuals_m);
  EXPECT_EQ(with->frame(20)->library, test::session_library());
}

/// The numbers of pairs say nothing in another library; the recorded takes and frames do.
TEST_F(RecordedFramesTest, OfALibraryThatIsNotAtHandAreShownOnlyWithPairsOfTheSameTakes) {
  record(1);
  const auto frames = *RecordedFrames::open(path);
  const FrameSnapshotPtr frame = frames->frame(20);
  const FrameResult& solved = kept()[20]->result;
  ASSERT_GE(solved.selected, 0);
  EXPECT_EQ(frame->library, nullptr);
  const auto other = std::make_shared<const MotionLibrary>(
      *build_library("other", {test::swinging_take("another take", 60, 8)}, {}, {}));
  EXPECT_EQ(selected_pair(*frame, other), -1);
  EXPECT_TRUE(in_library(frame, other)->result.candidates.empty());
  EXPECT_EQ(in_library(frame, other)->result.selected, -1);
  EXPECT_EQ(in_library(frame, other)->result.result, solved.result) << "the poses that were recorded";
  EXPECT_EQ(absence_text(*in_library(frame, other)), "Danced with library “small”, which is not open");
  EXPECT_FALSE(has_pairs_of(*other, *frame)) << "and is not solved again with it";
  const auto same = in_library(frame, test::session_library());
  ASSERT_EQ(same->result.candidates.size(), solved.candidates.size());
  for (std::size_t i = 0; i < solved.candidates.size(); ++i)
    EXPECT_EQ(same->result.candidates[i].pair, solved.candidates[i].pair);
  EXPECT_EQ(same->result.selected, solved.selected);
  EXPECT_EQ(absence_text(*same), "");
  EXPECT_TRUE(has_pairs_of(*test::session_library(), *frame));
}

TEST_F(RecordedFramesTest, ALongRangeIsThinnedEvenly) {
  record(4);
  const auto frames = *RecordedFrames::open(path);
  EXPECT_EQ(frames->range(1, 2, 1000).size(), session->history.range(1, 2).size());
  const auto thinned = frames->range(0, 4, 20);
  ASSERT_EQ(thinned.size(), 20U);
  EXPECT_EQ(thinned.front()->index, 0U);
  EXPECT_EQ(thinned.back()->index, kept().back()->index);
  for (std::size_t i = 1; i < thinned.size(); ++i)
    EXPECT_NEAR(static_cast<double>(thinned[i]->index - thinned[i - 1]->index),
                static_cast<double>(kept().size() - 1) / 19, 1);
  EXPECT_EQ(frames->between(10, 20, 1000).size(), 11U);
  EXPECT_TRUE(frames->between(100000, 200000, 1000).empty());
}

TEST_F(RecordedFramesTest, AnOverviewIsReadOnceForAllWhoAsk) {
  record(2);
  const auto frames = *RecordedFrames::open(path, test::session_library());
  const std::uint64_t last = kept().back()->index;
  const auto first = frames->between(0, last, 20);
  ASSERT_EQ(first.size(), 20U);
  EXPECT_EQ(frames->between(0, last, 20), first) << "the same frames, not read again";
  EXPECT_EQ(frames->between(0, last, 10).size(), 10U);
  EXPECT_EQ(frames->between(5, last, 20).front()->index, 5U);
  EXPECT_EQ(frames->between(0, last - 5, 20).back()->index, last - 5);
  const auto whole = frames->between(0, last, 20);
  frames->add_library(test::session_library());
  EXPECT_NE(frames->between(0, last, 20), whole) << "what the library says of them may be something else";
  session->run_until(3);
  ASSERT_TRUE(session->keeper->recorder->flush());
  EXPECT_EQ(frames->between(0, kept().back()->index, 20).back()->index, kept().back()->index);
}

/// Opening a session reads the frames of its file, and the views of the window ask for them again.
TEST_F(RecordedFramesTest, AShortFileIsKeptWhole) {
  record(2);
  const auto frames = *RecordedFrames::open(path, test::session_library());
  const std::uint64_t last = kept().back()->index;
  EXPECT_FALSE(frames->is_kept(0, last, 1000));
  const auto whole = frames->between(0, last, 1000);
  ASSERT_EQ(whole.size(), last + 1);
  EXPECT_TRUE(frames->is_kept(0, last, 1000));
  EXPECT_TRUE(frames->is_kept(0, last, 2000)) << "of neither anything is left out";
  EXPECT_FALSE(frames->is_kept(0, last, 20));
  EXPECT_FALSE(frames->is_kept(1, last, 1000));
  EXPECT_EQ(frames->between(0, last, 2000), whole);
  frames->add_library(test::session_library());
  EXPECT_FALSE(frames->is_kept(0, last, 1000)) << "what the library says of them may be something else";
}

TEST_F(RecordedFramesTest, APieceIsReadOnceForAllWhoGoThroughTheFile) {
  record(3);
  const auto frames = *RecordedFrames::open(path, test::session_library());
  const auto piece = frames->between(20, 100, FrameHistory::read_at_once);
  ASSERT_EQ(piece.size(), 81U);
  EXPECT_EQ(frames->between(20, 100, FrameHistory::read_at_once), piece);
  const auto overlapping = frames->between(60, 140, FrameHistory::read_at_once);
  ASSERT_EQ(overlapping.size(), 81U);
  EXPECT_EQ(overlapping.back()->index, 140U);
  EXPECT_EQ(frames->between(60, 140, FrameHistory::read_at_once).back(), overlapping.back());
}

TEST_F(RecordedFramesTest, SeeWhatIsRecordedMeanwhile) {
  record(1);
  const auto frames = *RecordedFrames::open(path);
  const auto before = frames->span().frames;
  session->run_until(2);
  ASSERT_TRUE(session->keeper->recorder->flush());
  EXPECT_GT(frames->span().frames, before);
  EXPECT_EQ(frames->at(1e9)->index, kept().back()->index);
}

TEST_F(RecordedFramesTest, AHistoryReachesThroughThemToTheBeginning) {
  record(4, 400 << 10);  // memory has the last frames only
  FrameHistory& history = session->history;
  const auto in_memory = history.span();
  ASSERT_GT(in_memory.evicted, 100U);
  ASSERT_GT(in_memory.first_s, 1);
  history.set_store(session->keeper->recorder->store());

  const auto span = history.span();
  EXPECT_EQ(span.first_s, kept().front()->time_s);
  EXPECT_EQ(span.memory_first_s, in_memory.first_s);
  EXPECT_EQ(span.stored, in_memory.evicted);
  EXPECT_EQ(span.first_index, 0U);
  EXPECT_EQ(history.at(0.5)->index, 30U);
  EXPECT_EQ(history.at(-5)->index, 0U);
  EXPECT_EQ(history.at(1e9), kept().back());
  EXPECT_EQ(history.stepped(0.5, 3)->index, 33U);
  EXPECT_EQ(history.stepped(0.5, -100)->index, 0U);
  const auto across = static_cast<int>(in_memory.evicted) - 30 + 5;
  EXPECT_EQ(history.stepped(0.5, across), kept()[in_memory.evicted + 5]);
  EXPECT_EQ(history.stepped(1e9, -static_cast<int>(kept().size()) + 3)->index, 2U);

  const auto all = history.range(-1, 1e9);
  ASSERT_EQ(all.size(), kept().size());
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i]->index, i);
  EXPECT_EQ(history.range(-1, 1e9, 10).size(), 10U + in_memory.frames);
  EXPECT_EQ(history.range(0.5, 0.6).size(), 7U);
  EXPECT_EQ(history.since(5).size(), kept().size() - 5);
  EXPECT_EQ(history.since(kept().size() - 2).size(), 2U);
}

TEST_F(RecordedFramesTest, AHistoryWithoutFramesOfItsOwnShowsThoseOfTheFile) {
  record(2);
  FrameHistory history;
  history.set_store(*RecordedFrames::open(path, test::session_library()));
  EXPECT_EQ(history.span().last_s, kept().back()->time_s);
  EXPECT_GT(history.span().memory_first_s, history.span().last_s);
  EXPECT_EQ(history.since(0).size(), kept().size());
  EXPECT_TRUE(history.since(kept().size()).empty());
  EXPECT_EQ(history.at(1)->index, 60U);
  EXPECT_EQ(history.stepped(1, 1)->index, 61U);
  EXPECT_EQ(history.stepped(1, 100000)->index, kept().back()->index);
}

TEST_F(RecordedFramesTest, AtATimeWhoseFrameIsDamagedTheOneBeforeIsGivenAndTheDamageIsCountedOnce) {
  record(2);
  ASSERT_TRUE(session->keeper->recorder->finish());
  const auto damage = [&](const std::string& which) {
    auto database = SessionDatabase::open(path, SessionDatabase::Access::Write);
    ASSERT_TRUE(database) << database.error().text();
    ASSERT_TRUE(database->execute("UPDATE frames SET active = zeroblob(10) WHERE " + which));
    ASSERT_TRUE(database->close());
  };
  const std::uint64_t last = kept().back()->index;
  damage("frame > " + std::to_string(last - 3));
  const auto frames = *RecordedFrames::open(path);
  for (int look = 0; look < 5; ++look) EXPECT_EQ(frames->at(1e9)->index, last - 3);
  EXPECT_EQ(frames->damaged(), 3U) << "not with every look";
  damage("1");
  EXPECT_EQ((*RecordedFrames::open(path))->at(1e9), nullptr);
}

TEST_F(RecordedFramesTest, WhatTheyGiveCanBeSolvedAgainToTheSameBits) {
  record(4, 400 << 10);
  session->history.set_store(session->keeper->recorder->store());
  const double memory_s = session->history.span().memory_first_s;
  auto again = std::move(*ReSolver::create(test::session_library(), {}));
  const auto expect_bits = [&](double from_s, double to_s) {
    auto found = session->history.solvable_again(from_s, to_s);
    EXPECT_FALSE(found.is_short);
    ASSERT_EQ(found.frames.size(), session->history.range(from_s, to_s).size());
    FrameSnapshotPtr frame = found.frames.next();
    ASSERT_TRUE(frame);
    again->go_to(found.run_up, *frame);
    for (; frame; frame = found.frames.next())
      ASSERT_EQ(again->solve(*frame, frame->settings)->result.result, kept()[frame->index]->result.result);
  };
  expect_bits(0.7, 1.1);
  expect_bits(memory_s - 0.3, memory_s + 0.3);
  expect_bits(memory_s, memory_s + 0.05);
  expect_bits(0, 4);
}

}  // namespace
}  // namespace abrazo::recorded_frames_test
