#include "core/session/file/project.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

#include "core/session/file/session_database.hpp"
#include "core/session/file/session_edit.hpp"
#include "core/session/file/session_file.hpp"
#include "tests/core/session/project_values.hpp"
#include "tests/core/session/recorded_session.hpp"

namespace abrazo::project_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void change(const std::string& path, const std::string& sql) {
  auto database = SessionDatabase::open(path, SessionDatabase::Access::Write);
  ASSERT_TRUE(database);
  const Status done = database->execute(sql);
  ASSERT_TRUE(done) << done.error().text();
}

TEST(Project, EveryFieldOfAnyProjectReadsBackTheSame) {
  const test::TemporaryFolder folder;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Project project = test::ProjectMaker(seed).make();
    const std::string path = folder.file(seed % 3 ? "one.abrazo" : std::to_string(seed) + ".abrazo");
    const Status saved = save_project(path, project);  // also over another one
    ASSERT_TRUE(saved) << saved.error().text();
    const auto read = read_project(path);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_THAT(read->damage, SizeIs(0));
    EXPECT_TRUE(read->is_saved);
    EXPECT_EQ(read->project.data, project.data);
    EXPECT_EQ(read->project.annotations, project.annotations);
    EXPECT_EQ(read->project.videos, project.videos);
    EXPECT_EQ(read->project.markers, project.markers);
    EXPECT_EQ(read->project.settings, project.settings);
    EXPECT_EQ(read->project.decisions, project.decisions);
    EXPECT_EQ(read->project, project) << seed;
  }
}

TEST(Project, IsASessionFileThatLeavesNothingBesideItself) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("p.abrazo");
  ASSERT_TRUE(save_project(path, test::ProjectMaker(1).make()));
  const auto file = SessionFile::open(path);
  ASSERT_TRUE(file) << file.error().text();
  EXPECT_THAT((*file)->recovery(), SizeIs(0));
  EXPECT_EQ((*file)->contents().frames, 0U);
  const auto here = std::filesystem::directory_iterator(std::filesystem::path(path).parent_path());
  EXPECT_EQ(std::distance(begin(here), end(here)), 1);
}

TEST(Project, IsSavedBesideWhatWasRecordedAndRecordedBehind) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("s.abrazo");
  const Project project = test::ProjectMaker(5).make();
  ASSERT_TRUE(save_project(path, project));
  test::DrivenSession session;
  RecordingFacts facts = test::session_facts();
  facts.has_times_of_file = true;
  session.keeper->recorder = *Recorder::open(path, facts);
  session.run_until(1);
  ASSERT_TRUE(session.keeper->recorder->finish());
  EXPECT_EQ(*load_project(path), project);
  const Project other = test::ProjectMaker(6).make();
  ASSERT_TRUE(save_project(path, other));
  EXPECT_EQ(*load_project(path), other);
  const auto file = SessionFile::open(path);
  EXPECT_EQ((*file)->contents().frames, session.keeper->frames.size());
}

TEST(Project, IsSavedByTheRecorderWhileItRecords) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("s.abrazo");
  test::DrivenSession session;
  session.keeper->recorder = *Recorder::open(path, test::session_facts());
  session.run_until(0.5);
  const auto project = std::make_shared<const Project>(test::ProjectMaker(7).make());
  const Status by_another = save_project(path, *project);
  ASSERT_FALSE(by_another);
  EXPECT_THAT(by_another.error().message, HasSubstr("is recording into this file"));
  session.keeper->recorder->save_project(project);
  session.run_until(0.8);
  ASSERT_TRUE(session.keeper->recorder->flush());
  EXPECT_EQ(*load_project(path), *project);  // while it goes on
  ASSERT_TRUE(session.keeper->recorder->finish());
  EXPECT_EQ(*load_project(path), *project);
  EXPECT_EQ((*SessionFile::open(path))->contents().frames, session.keeper->frames.size());
}

TEST(Project, TakesAreRenamedWhileTheFileIsRecorded) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("s.abrazo");
  test::DrivenSession session;
  session.keeper->recorder = *Recorder::open(path, test::session_facts());
  for (const char* name : {"one", "two", "three"}) {
    session.keeper->recorder->begin_take(name);
    session.run_until(session.now_s + 0.3);
  }
  session.keeper->recorder->edit_takes({{"one", "uno"}, {"two", std::nullopt}});
  ASSERT_TRUE(session.keeper->recorder->flush());
  std::vector<std::string> names;
  const auto file = SessionFile::open(path);
  for (const SessionTake& take : (*file)->contents().takes) names.push_back(take.name);
  EXPECT_THAT(names, ElementsAre("uno", "three"));
}

TEST(Project, OfARecordingInWhichNoneWasSavedIsWhatTheRecordingKnows) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("s.abrazo");
  test::DrivenSession session;
  RecordingFacts facts = test::session_facts();
  facts.library_path = folder.file("lib.h5");
  session.keeper->recorder = *Recorder::open(path, facts);
  session.commands.push(PinPair{3});
  session.run_until(0.4);
  Markers markers;
  markers.add(0.2, "clap");
  session.keeper->recorder->set_markers(markers);
  ASSERT_TRUE(session.keeper->recorder->finish());
  const auto read = read_project(path);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_FALSE(read->is_saved);
  EXPECT_EQ(read->project.settings, test::responsive_by_pose());
  EXPECT_EQ(read->project.decisions.pinned, 3);
  EXPECT_EQ(read->project.input, "clip:user.bvh");
  ASSERT_THAT(read->project.data, SizeIs(1));
  EXPECT_EQ(read->project.data[0].relative_path, "lib.h5");
  ASSERT_THAT(read->project.markers.all(), SizeIs(1));
  EXPECT_EQ(read->project.markers.all()[0].name, "clap");
}

TEST(ProjectVersions, ANewerOneIsRefusedWithWhatToDoAndNotTouched) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("new.abrazo");
  ASSERT_TRUE(save_project(path, {}));
  change(path, "PRAGMA user_version = 2");
  const std::string before = bytes_of(path);
  for (const Status& refused : {save_project(path, {}), edit_session_takes(path, {{"a", "b"}}),
                                read_project(path) ? Status(Done{}) : Status(read_project(path).error())}) {
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message,
              "the session file is of version 2, this program reads version 1; open it with a newer Abrazo");
    EXPECT_EQ(refused.error().where, path);
  }
  EXPECT_FALSE(Recorder::open(path, test::session_facts()));
  EXPECT_EQ(bytes_of(path), before);
}

TEST(DamagedProject, RowsThatCannotBeAreLeftOutCountedAndSaid) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("p.abrazo");
  Project project;
  const Tier moves{"move", {{0, 1, "basic"}, {1, 2, "turn"}, {3, 4, "dip"}}, {{"basic"}}, TierKind::Move};
  project.annotations[""] = *annotations_of(std::vector{moves});
  project.markers.add(1, "clap");
  ASSERT_TRUE(save_project(path, project));
  change(path,
         "UPDATE annotations SET end_s = 0.5 WHERE value = 'turn';"
         "INSERT INTO annotations (tier, number, start_s, end_s, value, detail, confidence) VALUES"
         "  (99, 77, 0, 1, 'of no tier', '', ''), (1, 1, 5, 6, 'the number of the tier', '', '');"
         "UPDATE vocabularies SET key = 'both';"
         "INSERT INTO tiers (subject, number, kind, name) VALUES (1, 78, 'colour', 'x'), (1, 79, 'note', "
         "'move');"
         "UPDATE project SET value = '{\"alpha\":' WHERE key = 'settings';"
         "INSERT INTO videos (id, data, subject, rate) VALUES (1, 44, '', 'fast');"
         "INSERT INTO sync_points (video, subject_s, video_s) VALUES (8, 1, 2);");
  const auto read = read_project(path);
  ASSERT_TRUE(read) << read.error().text();
  std::string said;
  for (const std::string& sentence : read->damage) said += sentence + "\n";
  EXPECT_EQ(read->damaged, 9U) << said;
  EXPECT_THAT(said, HasSubstr("3 of its annotations could not be read: 'turn' does not end after it begins"));
  EXPECT_THAT(said, HasSubstr("2 of its tiers could not be read: a tier is of kind 'colour'"));
  EXPECT_THAT(said, HasSubstr("1 of its words of vocabularies could not be read: 'both' is not one key"));
  EXPECT_THAT(said, HasSubstr("1 of its videos could not be read: the video's rate is 0"));
  EXPECT_THAT(said, HasSubstr("1 of its sync points could not be read"));
  EXPECT_THAT(said, HasSubstr("its settings or decisions could not be read"));
  const std::vector<Tier> tiers = tiers_of(read->project.annotations.at(""));
  ASSERT_THAT(tiers, SizeIs(1));
  EXPECT_THAT(tiers[0].intervals, ElementsAre(moves.intervals[0], moves.intervals[2]));
  EXPECT_EQ(read->project.markers, project.markers);
}

TEST(DamagedProject, CamerasAndSyncsThatCannotBeAreLeftOut) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("p.abrazo");
  Project project;
  ProjectVideo video;
  video.sync.points = {{0, 0}, {10, 10}};
  video.camera = CameraModel{{1920, 1080, 1000, 1000, 960, 540, {}}, {}};
  project.videos.assign(5, video);
  ASSERT_TRUE(save_project(path, project));
  change(path,
         "UPDATE videos SET rate = 0 WHERE id = 1;"
         "DELETE FROM sync_points WHERE video = 1; DELETE FROM cameras WHERE video = 1;"
         "UPDATE sync_points SET video_s = -1 WHERE video = 2 AND subject_s > 0;"
         "UPDATE cameras SET fx = 0 WHERE video = 3;"
         "UPDATE cameras SET r11 = 2 WHERE video = 4;"
         "UPDATE cameras SET width = 4294967297 WHERE video = 5;");
  const auto read = read_project(path);
  ASSERT_TRUE(read) << read.error().text();
  std::string said;
  for (const std::string& sentence : read->damage) said += sentence + "\n";
  EXPECT_EQ(read->damaged, 5U) << said;
  EXPECT_THAT(said, HasSubstr("1 of its videos could not be read: the video's rate is 0"));
  EXPECT_THAT(said, HasSubstr("1 of its sync points could not be read: the sync points are 10.000 s apart"));
  EXPECT_THAT(said, HasSubstr("3 of its cameras could not be read: \"camera_matrix\" has no focal lengths"));
  ASSERT_THAT(read->project.videos, SizeIs(4));
  EXPECT_THAT(read->project.videos[0].sync.points, SizeIs(1));
  EXPECT_TRUE(read->project.videos[0].camera);
  for (std::size_t v = 1; v < 4; ++v) EXPECT_FALSE(read->project.videos[v].camera) << v;
}

TEST(DamagedProject, ATableThatIsGoneCostsItself) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("p.abrazo");
  const Project project = test::ProjectMaker(2).make();
  for (const char* table :
       {"project", "view_state", "data_references", "subjects", "tiers", "vocabularies", "annotations",
        "suggestions", "videos", "sync_points", "cameras", "picked_points", "markers"}) {
    std::filesystem::remove(path);
    ASSERT_TRUE(save_project(path, project));
    change(path, std::string("DROP TABLE ") + table);
    const auto read = read_project(path);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_GE(read->damaged, 1U) << table;
    EXPECT_THAT(read->damage.at(0), HasSubstr("can be read")) << table;
  }
}

TEST(DamagedProject, BytesThatTheDiskChangedNeverCrashTheReader) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("p.abrazo"), broken = folder.file("broken.abrazo");
  ASSERT_TRUE(save_project(path, test::ProjectMaker(4).make()));
  const std::string whole = bytes_of(path);
  std::mt19937 random(11);
  int readable = 0;
  for (int round = 0; round < 200; ++round) {
    std::string bytes = whole;
    for (int flips = 0; flips < 1 + round % 7; ++flips)
      bytes[random() % bytes.size()] ^= static_cast<char>(1 << (random() % 8));
    if (round % 10 == 0) bytes.resize(bytes.size() * (random() % 100) / 100);
    std::ofstream(broken, std::ios::binary | std::ios::trunc) << bytes;
    const auto read = read_project(broken);
    if (!read) {
      EXPECT_FALSE(read.error().message.empty());
    }
    readable += read ? 1 : 0;
  }
  EXPECT_GT(readable, 50);
}

/// Saves one project after the other till it is killed. @return what the file has then
TEST(SavingAProject, ThatIsKilledLeavesTheOldOneOrTheNewOneWhole) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("p.abrazo");
  const Project even = test::ProjectMaker(8).make(), odd = test::ProjectMaker(9).make();
  ASSERT_TRUE(save_project(path, even));
  int of_odd = 0;
  for (int round = 0; round < 12; ++round) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) {
      for (int i = 1;; ++i) {
        (void)save_project(path, i % 2 ? odd : even);
        if (write(ends[1], "x", 1) != 1) _exit(1);
      }
    }
    close(ends[1]);
    char byte;
    for (int saves = 0; saves < 2 + round; ++saves) ASSERT_EQ(read(ends[0], &byte, 1), 1);
    // Somewhere in the next save, whose statements take some milliseconds.
    std::this_thread::sleep_for(std::chrono::microseconds(300 * round));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    close(ends[0]);
    const auto left = read_project(path);
    ASSERT_TRUE(left) << left.error().text();
    EXPECT_THAT(left->damage, SizeIs(0));
    EXPECT_TRUE(left->project == even || left->project == odd) << round;
    of_odd += left->project == odd ? 1 : 0;
  }
  EXPECT_GT(of_odd, 0);
  EXPECT_LT(of_odd, 12);
}

TEST(SavingAProject, SaysWhatIsInTheWay) {
  const test::TemporaryFolder folder;
  const auto trouble = [](const Status& status) { return status ? std::string() : status.error().message; };
  EXPECT_THAT(trouble(save_project(folder.file("."), {})), HasSubstr("this is a folder"));
  EXPECT_THAT(trouble(save_project(folder.file("no/where/p.abrazo"), {})),
              HasSubstr("does its folder exist"));
  const std::string text = folder.file("notes.txt");
  std::ofstream(text) << "This was never a database, and stays as it is, whatever is saved.";
  EXPECT_THAT(trouble(save_project(text, {})), HasSubstr("not a session file"));
  EXPECT_THAT(bytes_of(text), HasSubstr("stays as it is"));
}

}  // namespace
}  // namespace abrazo::project_test
