// Saving an open session: into its own file, as another one, and with its library.
#include "core/session/run/save_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/library/store/motion_library_file.hpp"
#include "core/session/file/session_file.hpp"
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
  ASSERT_EQ(saved->data.size(), 1U);
  EXPECT_EQ(saved->data[0].relative_path, "small.h5");
  EXPECT_EQ(saved->data[0].bytes, std::filesystem::file_size(what.library_file));
  EXPECT_EQ(saved->data[0].hash.size(), 16U);
  EXPECT_EQ(*load_project(what.to), *saved);
}

TEST_F(SaveSession, WhatIsKnownOfAFileThatIsGoneIsKept) {
  SessionToSave what = to("p.abrazo", 6);
  DataReference known = unread_reference(DataReference::Use::Motion, folder.file("gone.bvh"));
  what.project.data.push_back(known);
  known.bytes = 4711;
  known.hash = "0123456789abcdef";
  what.saved.data.push_back(known);
  EXPECT_THAT(save_session(what, {})->data, ElementsAre(known));
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

}  // namespace
}  // namespace abrazo::save_session_test
