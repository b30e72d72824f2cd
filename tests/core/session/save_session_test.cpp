// Saving an open session: into its own file, as another one, and with its library.
#include "core/session/run/save_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "core/library/store/motion_library_file.hpp"
#include "core/session/file/library_reference.hpp"
#include "core/session/file/recorded_frames.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/file/session_file.hpp"
#include "core/session/run/history_keeper.hpp"
#include "tests/core/session/project_values.hpp"
#include "tests/core/session/recorded_session.hpp"

namespace abrazo::save_session_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Without references: those of ProjectMaker name files that are not there.
Project project_of(unsigned seed) {
  Project project = test::ProjectMaker(seed).make();
  project.data.clear();
  project.videos.clear();
  return project;
}

struct SaveSession : testing::Test {
  const test::TemporaryFolder folder;
  test::DrivenSession session;

  SessionToSave to(const std::string& name, unsigned seed) const {
    SessionToSave what;
    what.project = project_of(seed);
    what.to = folder.file(name);
    return what;
  }
  /// Half a second with two takes; the recorder is kept.
  std::string record(const std::string& name) {
    const std::string file = folder.file(name);
    session.keeper->recorder = *Recorder::open(file, test::session_facts());
    for (const char* take : {"one", "two"}) {
      session.keeper->recorder->begin_take(take);
      session.run_until(session.now_s + 0.25);
    }
    session.keeper->recorder->end_take();
    return file;
  }
  static std::vector<std::string> takes_in(const std::string& file) {
    std::vector<std::string> names;
    const auto opened = SessionFile::open(file);
    if (opened)
      for (const SessionTake& take : (*opened)->contents().takes) names.push_back(take.name);
    return names;
  }
  /// Drives the session, and what is to be kept on disk is there before more comes.
  void run_for(double seconds, const std::shared_ptr<HistoryKeeper>& kept = nullptr) {
    for (const double end = session.now_s + seconds; session.now_s < end;) {
      session.run_until(std::min(end, session.now_s + 0.5));
      if (!kept) continue;
      kept->tend();
      const std::uint64_t newest = session.latest.newest()->index;
      for (int tries = 0; tries < 2000 && kept->store()->span().last_index < newest; ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  static RecordingFacts facts_with_times() {
    auto facts = test::session_facts();
    facts.has_times_of_file = true;
    return facts;
  }
  /// Drives the session, whose frames are all kept on disk.
  std::shared_ptr<HistoryKeeper> keep_history(double seconds) {
    auto kept = *HistoryKeeper::open(folder.file("history"), facts_with_times(),
                                     {.bytes = 64 << 20, .tend_every_s = 0});
    session.commands.push(AttachListener{kept});
    run_for(seconds, kept);
    return kept;
  }
  HistoryToSave history(double from_s = 0) const {
    return {session.history.stretch(from_s, session.now_s), test::session_facts()};
  }
  /// Every frame of the session, as it was solved.
  void expect_all_frames_in(const std::string& file) const {
    const auto opened = SessionFile::open(file);
    ASSERT_TRUE(opened) << opened.error().text();
    const auto stored = *RecordedFrames::open(file, test::session_library());
    const std::vector<FrameSnapshotPtr>& solved = session.keeper->frames;
    const auto all = stored->between(0, solved.back()->index, FrameHistory::all_frames);
    ASSERT_EQ(all.size(), solved.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      ASSERT_EQ(all[i]->index, solved[i]->index);
      ASSERT_EQ(all[i]->time_s, solved[i]->time_s);
      ASSERT_EQ(all[i]->result.result, solved[i]->result.result) << "frame " << i;
      ASSERT_EQ(all[i]->settings, solved[i]->settings) << "frame " << i;
      ASSERT_EQ(all[i]->user, solved[i]->user);
      ASSERT_EQ(all[i]->before != nullptr, solved[i]->before != nullptr);
      ASSERT_EQ(all[i]->result.edges, solved[i]->result.edges) << "its library is known";
    }
  }
  void change_settings() {
    Settings other = session.keeper->frames.back()->settings;
    other.alpha += 0.125;
    session.commands.push(SetSettings{other});
  }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& each : std::filesystem::directory_iterator(folder.file("")))
      names.push_back(each.path().filename().string());
    std::ranges::sort(names);
    return names;
  }
};

TEST_F(SaveSession, ThatWasNeverRecordedIsAFileWithTheProjectAlone) {
  const auto saved = save_session(to("p.abrazo", 1), {});
  ASSERT_TRUE(saved) << saved.error().text();
  EXPECT_EQ(*load_project(folder.file("p.abrazo")), project_of(1));
  EXPECT_THAT(files(), ElementsAre("p.abrazo"));
}

TEST_F(SaveSession, ThatAnotherWindowHasSavedSinceIsNotReplaced) {
  SessionToSave here = to("p.abrazo", 1);
  const auto first = save_session(here, {});
  ASSERT_TRUE(first);
  here.file = here.to;
  here.saved_at = first->saved_at;
  here.project = project_of(2);
  ASSERT_TRUE(save_session(here, {})) << "nobody else did";
  {
    auto other = SessionDatabase::open(here.file, SessionDatabase::Access::Write);
    ASSERT_TRUE(other);
    ASSERT_TRUE(other->execute("UPDATE project SET value = '2999-01-01T00:00:00Z' WHERE key = 'saved_at'"));
  }
  here.project = project_of(3);
  const auto refused = save_session(here, {});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(),
              HasSubstr("p.abrazo: was saved by another window at 2999-01-01T00:00:00Z, after"));
  EXPECT_EQ(*load_project(here.file), project_of(2));
  here.to = folder.file("mine.abrazo");
  ASSERT_TRUE(save_session(here, {})) << "under another name it can be";
  EXPECT_EQ(*load_project(here.to), project_of(3));
}

TEST_F(SaveSession, ThatIsBeingRecordedGoesThroughTheRecorder) {
  SessionToSave what = to("s.abrazo", 2);
  what.file = record("s.abrazo");
  what.recorder = session.keeper->recorder;
  ASSERT_TRUE(save_session(what, {}));
  EXPECT_EQ(*load_project(what.file), what.project);
}

TEST_F(SaveSession, AsAnotherOneIsACopyWithAllThatWasRecordedAndTheEditsOfItsTakes) {
  SessionToSave what = to("copy.abrazo", 3);
  what.file = record("s.abrazo");
  what.recorder = session.keeper->recorder;
  what.takes = {{"one", "uno"}, {"two", std::nullopt}};
  const auto saved = save_session(what, {});
  ASSERT_TRUE(saved) << saved.error().text();
  EXPECT_EQ(*load_project(what.to), what.project);
  EXPECT_THAT(takes_in(what.to), ElementsAre("uno"));
  EXPECT_EQ((*SessionFile::open(what.to))->contents().frames, session.keeper->frames.size())
      << "also what the recorder had not written yet";
  ASSERT_TRUE(session.keeper->recorder->finish());
  EXPECT_THAT(takes_in(what.file), ElementsAre("one", "two")) << "the session itself is as it was";
}

/// The copy of a running recording is not one that was cut off.
TEST_F(SaveSession, AsAnotherOneDuringATakeIsACompleteFile) {
  SessionToSave what = to("copy.abrazo", 3);
  what.file = folder.file("s.abrazo");
  session.keeper->recorder = *Recorder::open(what.file, test::session_facts());
  what.recorder = session.keeper->recorder;
  what.recorder->begin_take("one");
  session.run_until(0.5);
  ASSERT_TRUE(save_session(what, {}));
  const auto copy = SessionFile::open(what.to);
  ASSERT_TRUE(copy) << copy.error().text();
  EXPECT_THAT((*copy)->recovery(), testing::IsEmpty());
  EXPECT_FALSE((*copy)->is_being_recorded());
  ASSERT_EQ((*copy)->contents().takes.size(), 1U);
  EXPECT_FALSE((*copy)->contents().takes[0].interrupted);
  EXPECT_EQ((*copy)->contents().takes[0].end_s, (*copy)->contents().last_s);
  session.run_until(0.7);
  ASSERT_TRUE(what.recorder->finish());
  EXPECT_GT((*SessionFile::open(what.file))->contents().frames, (*copy)->contents().frames)
      << "the recording goes on in its own file";
}

TEST_F(SaveSession, OverAFileThatIsBeingRecordedIsRefused) {
  record("s.abrazo");
  const auto saved = save_session(to("s.abrazo", 4), {});
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().text(), HasSubstr("recording into this file; choose another name"));
}

TEST_F(SaveSession, WritesTheLibraryBesideItAndCompletesTheReferenceToIt) {
  SessionToSave what = to("p.abrazo", 5);
  what.library = test::session_library();
  what.library_file = folder.file("small.h5");
  what.project.data.push_back(unread_reference(DataReference::Use::Library, what.library_file));
  const auto saved = save_session(what, {});
  ASSERT_TRUE(saved) << saved.error().text();
  ASSERT_EQ(saved->project.data.size(), 1U);
  EXPECT_EQ(saved->project.data[0].relative_path, "small.h5");
  EXPECT_EQ(saved->project.data[0].bytes, std::filesystem::file_size(what.library_file));
  EXPECT_EQ(saved->project.data[0].hash.size(), 16U);
  EXPECT_EQ(*load_project(what.to), saved->project);
}

TEST_F(SaveSession, WhatIsKnownOfAFileThatIsGoneIsKept) {
  SessionToSave what = to("p.abrazo", 6);
  DataReference known = unread_reference(DataReference::Use::Motion, folder.file("gone.bvh"));
  what.project.data.push_back(known);
  known.bytes = 4711;
  known.hash = "0123456789abcdef";
  what.saved.data.push_back(known);
  EXPECT_THAT(save_session(what, {})->project.data, ElementsAre(known));
}

TEST_F(SaveSession, ThatFailsLeavesNothingBehind) {
  SessionToSave what = to("no/where/p.abrazo", 7);
  what.library = test::session_library();
  what.library_file = folder.file("small.h5");
  const auto saved = save_session(what, {});
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().text(), HasSubstr("no/where/p.abrazo"));
  EXPECT_THAT(files(), ElementsAre());
  ASSERT_TRUE(write_library(*what.library, what.library_file));
  EXPECT_FALSE(save_session(what, {}));
  EXPECT_THAT(files(), ElementsAre("small.h5")) << "it was there before";
}

TEST_F(SaveSession, ACopyThatFailsLeavesTheFileThatWasThere) {
  std::ofstream(folder.file("other.abrazo")) << "as it was";
  SessionToSave what = to("other.abrazo", 8);
  what.file = folder.file("broken.abrazo");
  std::ofstream(what.file) << "no session";
  EXPECT_FALSE(save_session(what, {}));
  std::ifstream other(what.to);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(other), {}), "as it was");
}

TEST_F(SaveSession, HasTheFramesOfTheHistory) {
  run_for(4);
  change_settings();
  run_for(3);
  SessionToSave what = to("s.abrazo", 9);
  what.history = history();
  const auto saved = save_session(what, {});
  ASSERT_TRUE(saved) << saved.error().text();
  EXPECT_TRUE(saved->has_history);
  EXPECT_EQ(saved->frames_left_out, 0U);
  EXPECT_EQ(*load_project(what.to), what.project);
  expect_all_frames_in(what.to);
  EXPECT_THAT((*SessionFile::open(what.to))->recovery(), ElementsAre());
  const SessionContents contents = (*SessionFile::open(what.to))->contents();
  EXPECT_EQ(contents.settings.size(), 2U);
  ASSERT_EQ(contents.libraries.size(), 1U);
  EXPECT_EQ(contents.libraries[0].fingerprint, library_fingerprint(*test::session_library()));
  EXPECT_EQ(contents.inputs.size(), 1U);
  EXPECT_THAT(files(), ElementsAre("s.abrazo")) << "one file, without a log beside it";
}

TEST_F(SaveSession, HasFramesThatAreNoLongerInMemoryAndThoseThatTheDiskOfTheHistoryDidNotTake) {
  FrameHistory little(2 << 20);
  const auto kept = keep_history(8);
  for (const FrameSnapshotPtr& frame : session.keeper->frames) little.append(frame);
  ASSERT_GT(little.span().evicted, 0U);
  session.commands.push(DetachListener{kept});  // as if the disk were full
  run_for(1);
  for (const FrameSnapshotPtr& frame : session.keeper->frames)
    if (frame->index > little.at(1e9)->index) little.append(frame);
  little.set_store(kept->store());
  SessionToSave what = to("s.abrazo", 10);
  what.history = HistoryToSave{little.stretch(0, session.now_s), test::session_facts()};
  const auto saved = save_session(what, {});
  ASSERT_TRUE(saved) << saved.error().text();
  EXPECT_EQ(saved->frames_left_out, 0U);
  expect_all_frames_in(what.to);
}

TEST_F(SaveSession, FramesThatCannotBeReadAreLeftOutAndCounted) {
  FrameHistory little(2 << 20);
  const auto kept = keep_history(8);
  for (const FrameSnapshotPtr& frame : session.keeper->frames) little.append(frame);
  little.set_store(kept->store());
  const std::uint64_t evicted = little.span().evicted;
  ASSERT_GT(evicted, 0U);
  SessionToSave what = to("s.abrazo", 17);
  what.history = HistoryToSave{little.stretch(0, session.now_s), test::session_facts()};
  kept->remove();
  const auto saved = save_session(what, {});
  ASSERT_TRUE(saved) << "the others are saved";
  EXPECT_EQ(saved->frames_left_out, evicted);
  EXPECT_EQ((*SessionFile::open(what.to))->contents().frames, session.keeper->frames.size() - evicted);
}

TEST_F(SaveSession, ALongHistoryIsNotTakenForTheWritingOfAnotherProgram) {
  run_for(40);  // more than SQLite keeps in its cache
  SessionToSave what = to("s.abrazo", 18);
  what.history = history();
  const auto saved = save_session(what, {});
  ASSERT_TRUE(saved) << saved.error().text();
  expect_all_frames_in(what.to);
}

TEST_F(SaveSession, SavedAgainItGetsTheFramesSince) {
  run_for(2);
  SessionToSave what = to("s.abrazo", 11);
  what.history = history();
  ASSERT_TRUE(save_session(what, {}));
  const double saved_to_s = session.now_s;
  change_settings();
  run_for(2);
  what.file = what.to;
  what.project = project_of(12);
  what.history = history(saved_to_s - 0.5);
  const auto saved = save_session(what, {});
  ASSERT_TRUE(saved) << saved.error().text();
  EXPECT_EQ(*load_project(what.to), what.project);
  expect_all_frames_in(what.to);
}

TEST_F(SaveSession, WhatWasSolvedBeforeAndAfterARecordingIsAddedToIt) {
  run_for(2);
  change_settings();
  SessionToSave what = to("s.abrazo", 13);
  what.file = record("s.abrazo");
  ASSERT_TRUE(session.keeper->recorder->finish());
  session.keeper->recorder.reset();
  change_settings();
  run_for(2);
  what.history = history();
  const auto saved = save_session(what, {});
  ASSERT_TRUE(saved) << saved.error().text();
  expect_all_frames_in(what.to);
  EXPECT_THAT(takes_in(what.to), ElementsAre("one", "two"));
  const SessionContents contents = (*SessionFile::open(what.to))->contents();
  EXPECT_THAT((*SessionFile::open(what.to))->recovery(), ElementsAre());
  ASSERT_EQ(contents.runs.size(), 3U);
  std::uint64_t in_runs = 0;
  for (const SessionRun& run : contents.runs) {
    EXPECT_EQ(run.first_frame, in_runs) << "in the order of their frames";
    in_runs += run.frames;
  }
  EXPECT_EQ(in_runs, contents.frames);
}

TEST_F(SaveSession, WhatOnlyTheDiskHasFromBeforeARecordingIsAddedToItWhole) {
  FrameHistory little(1 << 20);
  const auto kept = keep_history(8);
  const std::string file = folder.file("s.abrazo");
  session.keeper->recorder = *Recorder::open(file, facts_with_times());
  kept->rest(session.keeper->recorder->store());
  run_for(4, kept);
  ASSERT_TRUE(kept->go_on());
  ASSERT_TRUE(session.keeper->recorder->finish());
  session.keeper->recorder.reset();
  run_for(2, kept);
  const std::vector<FrameSnapshotPtr>& solved = session.keeper->frames;
  for (const FrameSnapshotPtr& frame : solved) little.append(frame);
  little.set_store(kept->store());
  ASSERT_GT(little.span().memory_first_s, 12) << "only the disk has what was before and while it recorded";
  SessionToSave what = to("s.abrazo", 19);
  what.file = file;
  what.history = HistoryToSave{little.stretch(0, session.now_s), test::session_facts()};
  const auto saved = save_session(what, {});
  ASSERT_TRUE(saved) << saved.error().text();
  EXPECT_EQ(saved->frames_left_out, 0U);
  expect_all_frames_in(file);
  EXPECT_THAT((*SessionFile::open(file))->recovery(), ElementsAre());
  const auto again = little.range(0, session.now_s);
  ASSERT_EQ(again.size(), solved.size()) << "the saved file has more frames than its recorder wrote";
  EXPECT_EQ(little.at(1)->time_s, solved[60]->time_s);
}

TEST_F(SaveSession, WhileItIsRecordedAnotherOneGetsTheHistoryAndItsOwnFileDoesNot) {
  run_for(1);
  SessionToSave what = to("s.abrazo", 14);
  what.file = record("s.abrazo");
  what.recorder = session.keeper->recorder;
  what.history = history();
  const auto own = save_session(what, {});
  ASSERT_TRUE(own) << own.error().text();
  EXPECT_FALSE(own->has_history);
  what.to = folder.file("copy.abrazo");
  const auto copied = save_session(what, {});
  ASSERT_TRUE(copied) << copied.error().text();
  EXPECT_TRUE(copied->has_history);
  expect_all_frames_in(what.to);
}

TEST_F(SaveSession, ThatIsCancelledWhileTheHistoryIsWrittenLeavesTheFileAsItWas) {
  run_for(2);
  SessionToSave what = to("s.abrazo", 15);
  what.history = history();
  const auto cancelled = [](double, std::string_view) { return false; };
  EXPECT_FALSE(save_session(what, cancelled));
  EXPECT_THAT(files(), ElementsAre());
  ASSERT_TRUE(save_session(what, {}));
  const auto frames = (*SessionFile::open(what.to))->contents().frames;
  run_for(2);
  what.file = what.to;
  what.project = project_of(16);
  what.history = history();
  EXPECT_FALSE(save_session(what, cancelled));
  EXPECT_EQ((*SessionFile::open(what.to))->contents().frames, frames);
  EXPECT_EQ(*load_project(what.to), project_of(15));
}

}  // namespace
}  // namespace abrazo::save_session_test
