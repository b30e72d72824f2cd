// Sessions whose frames name pairs that their library does not have, with checksums that are right.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/session/file/frame_row.hpp"
#include "core/session/file/recorded_frames.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/file/session_file.hpp"
#include "core/session/frames/frame_in_library.hpp"
#include "core/session/run/session_replay.hpp"
#include "core/synthesis/step/synthesizer_state.hpp"
#include "tests/core/session/recorded_session.hpp"

namespace abrazo::foreign_pairs_test {
namespace {

using testing::HasSubstr;

constexpr int beyond = 1'000'000;

class ForeignPairs : public testing::Test, protected test::TemporaryFolder {
 protected:
  ForeignPairs() {
    session_.keeper->recorder = *Recorder::open(path_, test::session_facts());
    session_.run_until(0.3);
    EXPECT_TRUE(session_.keeper->recorder->finish());
  }
  FrameSnapshot recorded(std::size_t index) const { return *session_.keeper->frames.at(index); }
  /// In place of the frame of its index, as whoever knows the format would.
  void replace(const FrameSnapshot& frame) {
    auto database = SessionDatabase::open(path_, SessionDatabase::Access::Write);
    ASSERT_TRUE(database) << database.error().text();
    auto old = database->prepare("SELECT library FROM frames WHERE frame = ?");
    ASSERT_TRUE(*old->bind(0, static_cast<std::int64_t>(frame.index)).step());
    FrameRow row = row_of(frame, frame.index, 0);
    row.library = old->integer(0);
    old->reset();
    ASSERT_TRUE(database->execute("DELETE FROM frames WHERE frame = " + std::to_string(frame.index)));
    auto insert = database->prepare(frame_insert());
    bind_row(*insert, row);
    ASSERT_TRUE(insert->run());
  }
  /// Frame 4 as it would be shown and solved again.
  void expect_shown_without_pairs() const {
    const auto frames = *RecordedFrames::open(path_, test::session_library());
    const FrameSnapshotPtr frame = frames->frame(4);
    ASSERT_NE(frame, nullptr);
    EXPECT_EQ(frame->result.result, recorded(4).result.result) << "the poses that were recorded";
    EXPECT_TRUE(frame->result.candidates.empty());
    EXPECT_EQ(frame->result.selected, -1);
    EXPECT_EQ(frame->before, nullptr);
    EXPECT_EQ(frames->damaged(), 1U);
    EXPECT_THAT(frames->damage(), HasSubstr("frame 4 names pairs that its library does not have"));
    EXPECT_FALSE(frames->frame(5)->result.candidates.empty());
    const auto file = SessionFile::open(path_);
    ASSERT_TRUE(file) << file.error().text();
    const auto replay = re_solve_session(**file, test::session_library(), -1e9, 1e9,
                                         [](const FrameSnapshot&) -> Status { return Done{}; });
    ASSERT_FALSE(replay);
    EXPECT_THAT(replay.error().text(), HasSubstr("frame 4 names pairs that its library does not have"));
  }

  const std::string path_ = TemporaryFolder::file("s.abrazo");
  test::DrivenSession session_;
};

TEST_F(ForeignPairs, AmongTheCandidatesAreCountedAsDamageAndNotShown) {
  for (const int pair : {beyond, test::session_library()->pair_count(), -1}) {
    FrameSnapshot frame = recorded(4);
    ASSERT_FALSE(frame.result.candidates.empty());
    frame.result.candidates.back().pair = pair;
    replace(frame);
    expect_shown_without_pairs();
  }
}

TEST_F(ForeignPairs, InTheSolversStateAreNotSolvedWith) {
  FrameSnapshot frame = recorded(4);
  SynthesizerState state;
  state.vetoes = std::make_shared<const Vetoes>();
  state.memory.frames_since_reset = 3;
  state.memory.current_pair = beyond;
  frame.before = std::make_shared<const SynthesizerState>(state);
  replace(frame);
  expect_shown_without_pairs();
}

TEST_F(ForeignPairs, OfAFrameOfAnUnknownLibraryAreNoneOfThisOne) {
  auto frame = std::make_shared<FrameSnapshot>(recorded(4));
  frame->library = nullptr;
  frame->result.candidates.front().pair = beyond;
  frame->result.selected = 0;
  const auto shown = in_library(frame, test::session_library());
  EXPECT_EQ(shown->result.candidates.front().pair, -1);
  EXPECT_EQ(shown->result.candidates.back().pair, frame->result.candidates.back().pair);
  EXPECT_EQ(selected_pair(*frame, test::session_library()), -1);
}

}  // namespace
}  // namespace abrazo::foreign_pairs_test
