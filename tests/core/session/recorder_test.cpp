#include "core/session/run/recorder.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <functional>
#include <future>
#include <thread>

#include "core/session/file/library_fingerprints.hpp"
#include "core/session/file/library_reference.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/file/session_file.hpp"
#include "core/synthesis/step/synthesizer_state.hpp"
#include "tests/core/session/recorded_session.hpp"

namespace abrazo::recorder_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr double all_from_s = -1e9, all_to_s = 1e9;

/// A session driven by hand with a recorder behind it.
struct Recorded : test::TemporaryFolder, test::DrivenSession {
  explicit Recorded(const RecorderOptions& options = {}) : path(file("s.abrazo")) {
    auto opened = Recorder::open(path, test::session_facts(), options);
    EXPECT_TRUE(opened) << opened.error().text();
    keeper->recorder = std::move(*opened);
  }
  Recorder& recorder() { return *keeper->recorder; }
  std::string path;
};

std::shared_ptr<const SessionFile> opened(const std::string& path) {
  auto file = SessionFile::open(path);
  EXPECT_TRUE(file) << (file ? "" : file.error().text());
  return file ? *file : nullptr;
}

std::vector<FrameSnapshot> frames_of(const SessionFile& file) {
  std::vector<FrameSnapshot> frames;
  const auto pass = file.each_frame(all_from_s, all_to_s, [&](const FrameSnapshot& frame) -> Status {
    frames.push_back(frame);
    return Done{};
  });
  EXPECT_TRUE(pass);
  EXPECT_EQ(pass->damaged, 0U) << pass->damage;
  return frames;
}

void expect_same(const FrameSnapshot& read, const FrameSnapshot& solved) {
  const FrameResult &a = read.result, &b = solved.result;
  EXPECT_EQ(read.index, solved.index);
  EXPECT_EQ(read.time_s, solved.time_s);
  EXPECT_EQ(read.elapsed_s, solved.elapsed_s);
  EXPECT_EQ(read.input_frame, solved.input_frame);
  EXPECT_EQ(read.user, solved.user);
  EXPECT_EQ(read.settings, solved.settings);
  EXPECT_EQ(read.before != nullptr, solved.before != nullptr);
  EXPECT_EQ(a.query_world, b.query_world);
  EXPECT_EQ(a.query_normalized, b.query_normalized);
  EXPECT_EQ(a.features, b.features);
  EXPECT_EQ(a.result, b.result);
  EXPECT_EQ(a.selected, b.selected);
  EXPECT_EQ(a.source_changed, b.source_changed);
  EXPECT_EQ(a.status_text(), b.status_text());
  EXPECT_EQ(a.foot_locks, b.foot_locks);
  ASSERT_EQ(a.candidates.size(), b.candidates.size());
  for (std::size_t i = 0; i < a.candidates.size(); ++i) {
    EXPECT_EQ(a.candidates[i].pair, b.candidates[i].pair);
    EXPECT_EQ(a.candidates[i].continuation, b.candidates[i].continuation);
    EXPECT_EQ(a.candidates[i].feature_distance, b.candidates[i].feature_distance);
    EXPECT_EQ(a.candidates[i].cost.pose, b.candidates[i].cost.pose);
    EXPECT_EQ(a.candidates[i].cost.temporal_active, b.candidates[i].cost.temporal_active);
    EXPECT_EQ(a.candidates[i].cost.temporal_passive, b.candidates[i].cost.temporal_passive);
    EXPECT_EQ(a.candidates[i].cost.total, b.candidates[i].cost.total);
  }
  ASSERT_EQ(a.collisions.size(), b.collisions.size());
  for (std::size_t i = 0; i < a.collisions.size(); ++i) {
    EXPECT_EQ(a.collisions[i].a, b.collisions[i].a);
    EXPECT_EQ(a.collisions[i].b, b.collisions[i].b);
    EXPECT_EQ(a.collisions[i].depth_m, b.collisions[i].depth_m);
  }
  EXPECT_EQ(a.energy.deformation, b.energy.deformation);
  EXPECT_EQ(a.residual.morph_rms_m, b.residual.morph_rms_m);
  EXPECT_EQ(a.timing.total_us, b.timing.total_us);
  EXPECT_EQ(read.times.solved_s, solved.times.solved_s);
}

TEST(Recorder, EveryFrameIsInTheFileWithTheSameBits) {
  Recorded session;
  session.run_until(2);
  ASSERT_TRUE(session.recorder().finish());
  const auto file = opened(session.path);
  const auto frames = frames_of(*file);
  ASSERT_EQ(frames.size(), session.keeper->frames.size());
  ASSERT_GT(frames.size(), 100U);
  for (std::size_t i = 0; i < frames.size(); ++i) expect_same(frames[i], *session.keeper->frames[i]);
  EXPECT_THAT(file->recovery(), IsEmpty());
  EXPECT_FALSE(file->is_being_recorded());
  EXPECT_TRUE(file->contents().runs.front().finished);
}

TEST(Recorder, AFinishedRecordingIsOneFile) {
  Recorded session;
  session.run_until(0.5);
  ASSERT_TRUE(session.recorder().finish());
  EXPECT_FALSE(std::filesystem::exists(session.path + "-wal"));
  EXPECT_FALSE(std::filesystem::exists(session.path + "-shm"));
}

TEST(Recorder, SaysWhereTheSessionCameFrom) {
  Recorded session;
  session.run_until(0.3);
  session.commands.push(ReplaceSource{std::make_shared<ClipSource>(test::swinging_take("other", 200, 9).a),
                                      std::make_shared<const std::string>("vmc://0.0.0.0:39539")});
  session.run_until(0.6);
  ASSERT_TRUE(session.recorder().finish());
  const SessionContents contents = opened(session.path)->contents();
  ASSERT_EQ(contents.libraries.size(), 1U);
  EXPECT_EQ(contents.libraries[0].pairs, static_cast<std::uint64_t>(test::session_library()->pair_count()));
  EXPECT_EQ(contents.libraries[0].fingerprint, library_fingerprint(*test::session_library()));
  ASSERT_EQ(contents.inputs.size(), 2U);
  EXPECT_EQ(contents.inputs[0].text, "clip:user.bvh");
  EXPECT_EQ(contents.inputs[1].text, "vmc://0.0.0.0:39539");
  EXPECT_EQ(contents.inputs[0].first_frame, 0U);
  const auto& frames = session.keeper->frames;
  const auto first = std::find_if(frames.begin(), frames.end(), [](const auto& one) { return one->input; });
  ASSERT_NE(first, frames.end());
  EXPECT_EQ(contents.inputs[1].first_frame, (*first)->index);
  EXPECT_THAT(contents.program, HasSubstr("abrazo"));
}

/// A fingerprint that takes until it is released, or so long that a test which waits for it is no fun.
struct SlowFingerprint {
  std::shared_ptr<LibraryFingerprints> shared =
      std::make_shared<LibraryFingerprints>([this](const MotionLibrary&) {
        ++calls;
        released.get_future().wait_for(std::chrono::seconds(20));
        is_done = true;
        return std::string("0123456789abcdef");
      });
  RecordingFacts facts() const {
    RecordingFacts facts = test::session_facts();
    facts.fingerprints = shared;
    return facts;
  }
  std::promise<void> released;
  std::atomic<int> calls = 0;
  std::atomic<bool> is_done = false;
};

TEST(Recorder, NobodyWaitsForTheFingerprintOfALargeLibraryUntilTheEnd) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("s.abrazo");
  SlowFingerprint fingerprint;
  test::DrivenSession session;
  session.keeper->recorder = *Recorder::open(path, fingerprint.facts());
  session.run_until(1);
  ASSERT_TRUE(session.keeper->recorder->flush());
  EXPECT_EQ(session.keeper->recorder->state().frames, session.keeper->frames.size());
  EXPECT_EQ(opened(path)->contents().libraries.at(0).fingerprint, "");
  const FrameSnapshotPtr read = session.keeper->recorder->store()->frame(20);
  EXPECT_EQ(read->library, test::session_library());
  EXPECT_EQ(read->result.edges, session.keeper->frames[20]->result.edges) << "which only the library has";
  EXPECT_FALSE(fingerprint.is_done);
  fingerprint.released.set_value();
  ASSERT_TRUE(session.keeper->recorder->finish());
  EXPECT_EQ(opened(path)->contents().libraries.at(0).fingerprint, "0123456789abcdef");
}

TEST(Recorder, TheRecordingsOfASessionGoThroughItsLibraryOnce) {
  const test::TemporaryFolder folder;
  SlowFingerprint fingerprint;
  fingerprint.released.set_value();
  for (const std::string name : {"a.abrazo", "b.abrazo"}) {
    test::DrivenSession session;
    session.keeper->recorder = *Recorder::open(folder.file(name), fingerprint.facts());
    session.run_until(0.2);
    ASSERT_TRUE(session.keeper->recorder->finish());
    EXPECT_EQ(opened(folder.file(name))->contents().libraries.at(0).fingerprint, "0123456789abcdef");
  }
  EXPECT_EQ(fingerprint.calls, 1);
}

TEST(LibraryFingerprints, KeepNoLibrary) {
  LibraryFingerprints fingerprints;
  auto library = std::make_shared<const MotionLibrary>(*test::session_library());
  const std::weak_ptr<const MotionLibrary> gone = library;
  const auto fingerprint = fingerprints.of(library);
  EXPECT_EQ(fingerprint.get(), library_fingerprint(*test::session_library()));
  library.reset();
  EXPECT_TRUE(gone.expired());
}

TEST(LibraryFingerprints, OfADamagedLibraryThereIsNone) {
  LibraryColumns columns = test::session_library()->columns();
  columns.damage = Error{"the file was cut short", "small"};
  LibraryFingerprints fingerprints;
  EXPECT_EQ(fingerprints.of(std::make_shared<const MotionLibrary>(std::move(columns))).get(), "");
}

TEST(Recorder, SettingsAndDecisionsAreKeptWhereTheyChange) {
  Recorded session;
  session.run_until(0.4);
  Settings settings = *preset("paper");
  settings.alpha = 0.1 + 0.2;  // has no short decimal
  session.commands.push(SetSettings{settings});
  session.commands.push(SetVetoes{{{3, 5}, {"first"}, {""}}});
  session.run_until(0.8);
  session.commands.push(PinPair{33});
  session.run_until(1.2);
  ASSERT_TRUE(session.recorder().finish());
  const auto file = opened(session.path);
  ASSERT_EQ(file->contents().settings.size(), 2U);
  EXPECT_EQ(file->contents().settings[1].settings, settings);
  ASSERT_EQ(file->contents().decisions.size(), 3U);
  EXPECT_EQ(file->contents().decisions[0].decisions, Decisions{});
  EXPECT_EQ(file->contents().decisions[1].decisions.vetoes.pairs, (std::set<int>{3, 5}));
  EXPECT_EQ(file->contents().decisions[1].decisions.vetoes.labels, (std::set<std::string>{""}));
  EXPECT_EQ(file->contents().decisions[2].decisions.pinned, 33);
  const auto frames = frames_of(*file);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Decisions none, *wanted = session.keeper->frames[i]->decisions.get();
    EXPECT_EQ(frames[i].settings, session.keeper->frames[i]->settings);
    EXPECT_EQ(frames[i].decisions ? *frames[i].decisions : none, wanted ? *wanted : none);
  }
}

TEST(Recorder, EveryPoseOfEveryPerformerIsKept) {
  Recorded session;
  const Clip clip = test::swinging_take("user", 60, 4).a;
  for (int i = 0; i < 60; ++i) {
    session.recorder().pose_received(
        test::received("Ana", i / 60.0, clip.poses[static_cast<std::size_t>(i)]));
    if (i % 2) session.recorder().pose_received(test::received("Luis", i / 60.0, clip.poses[0]));
  }
  ASSERT_TRUE(session.recorder().finish());
  const auto file = opened(session.path);
  ASSERT_EQ(file->contents().performers.size(), 2U);
  EXPECT_EQ(file->contents().performers[0].poses, 60U);
  EXPECT_EQ(file->contents().performers[1].poses, 30U);
  int count = 0;
  const auto pass = file->each_pose(file->contents().performers[0].id, all_from_s, all_to_s,
                                    [&](const ReceivedPose& pose) -> Status {
                                      EXPECT_EQ(pose.performer, "Ana");
                                      EXPECT_EQ(pose.pose.pose, clip.poses[static_cast<std::size_t>(count)]);
                                      EXPECT_EQ(pose.pose.arrived_s, count / 60.0);
                                      EXPECT_EQ(pose.sender_time_s, 100 + count / 60.0);
                                      ++count;
                                      return Done{};
                                    });
  ASSERT_TRUE(pass);
  EXPECT_EQ(count, 60);
}

TEST(Recorder, TakesBeginAndEndWithTheFramesInBetween) {
  Recorded session;
  session.run_until(0.5);
  session.recorder().begin_take("salsa 1");
  EXPECT_EQ(session.recorder().state().take, "salsa 1");
  session.run_until(1.0);
  session.recorder().begin_take("salsa 2");
  session.run_until(1.5);
  session.recorder().end_take();
  EXPECT_EQ(session.recorder().state().take, "");
  session.run_until(2.0);
  ASSERT_TRUE(session.recorder().finish());
  const auto takes = opened(session.path)->contents().takes;
  ASSERT_EQ(takes.size(), 2U);
  EXPECT_EQ(takes[0].name, "salsa 1");
  EXPECT_NEAR(takes[0].start_s, 0.5, 0.02);
  EXPECT_EQ(takes[0].last_frame + 1, takes[1].first_frame);
  EXPECT_NEAR(takes[1].end_s, 1.5, 0.02);
  EXPECT_FALSE(takes[1].interrupted);
  EXPECT_EQ(takes[1].begun_at.size(), std::string("2024-05-17T14:03:22Z").size());
}

TEST(Recorder, TellsTheFramesOfATakeAsItsFileHasThem) {
  Recorded session;
  session.run_until(0.5);
  session.recorder().begin_take("salsa 1");
  EXPECT_EQ(session.recorder().state().take_span, TakeSpan{}) << "the next frame is its first";
  session.run_until(1.0);
  session.recorder().end_take();
  session.run_until(1.5);
  const TakeSpan told = session.recorder().state().take_span;
  session.recorder().begin_take("salsa 2");
  EXPECT_EQ(session.recorder().state().take_span, TakeSpan{}) << "another take";
  ASSERT_TRUE(session.recorder().finish());
  const auto takes = opened(session.path)->contents().takes;
  ASSERT_EQ(takes.size(), 1U) << "one without frames is not kept";
  EXPECT_EQ(told,
            (TakeSpan{takes[0].start_s, takes[0].end_s, takes[0].last_frame + 1 - takes[0].first_frame}));
}

TEST(Recorder, GoesOnInAFileBehindItsLastFrame) {
  Recorded session;
  session.run_until(1);
  session.recorder().begin_take("first");
  session.run_until(1.5);
  ASSERT_TRUE(session.recorder().finish());
  const std::size_t before = session.keeper->frames.size();

  test::DrivenSession again;
  auto recorder = Recorder::open(session.path, test::session_facts());
  ASSERT_TRUE(recorder) << recorder.error().text();
  again.keeper->recorder = *recorder;
  again.run_until(0.5);
  ASSERT_TRUE((*recorder)->flush());
  // The recorder's own store speaks of this session alone, in its own times.
  EXPECT_EQ((*recorder)->store()->span().first_index, 0U);
  EXPECT_EQ((*recorder)->store()->span().frames, again.keeper->frames.size());
  EXPECT_NEAR((*recorder)->store()->at(0.25)->time_s, again.history.at(0.25)->time_s, 1e-9);
  ASSERT_TRUE((*recorder)->finish());

  const auto file = opened(session.path);
  const auto frames = frames_of(*file);
  ASSERT_EQ(frames.size(), before + again.keeper->frames.size());
  EXPECT_EQ(frames[before].index, before);
  EXPECT_GT(frames[before].time_s, frames[before - 1].time_s);
  EXPECT_EQ(frames[before].result.result, again.keeper->frames[0]->result.result);
  ASSERT_EQ(file->contents().runs.size(), 2U);
  EXPECT_EQ(file->contents().runs[0].frames, before);
  EXPECT_EQ(file->contents().runs[1].frames, again.keeper->frames.size());
  EXPECT_LT(file->contents().takes[0].end_s, file->contents().runs[1].first_s);
}

TEST(Recorder, MarkersAreThoseSetLast) {
  Recorded session;
  Markers markers;
  markers.add(0.1, "cross-body");
  session.recorder().set_markers(markers);
  markers.add(0.7, "turn");
  session.recorder().set_markers(markers);
  ASSERT_TRUE(session.recorder().finish());
  const auto read = opened(session.path)->contents().markers;
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[1].name, "turn");
  EXPECT_EQ(read[1].time_s, 0.7);
}

TEST(Recorder, MayBeReadWhileItGoesOn) {
  Recorded session;
  session.run_until(0.5);
  ASSERT_TRUE(session.recorder().flush());
  const auto file = opened(session.path);
  EXPECT_TRUE(file->is_being_recorded());
  EXPECT_THAT(file->recovery(), IsEmpty());
  const std::size_t then = frames_of(*file).size();
  EXPECT_EQ(then, session.keeper->frames.size());
  session.run_until(1.0);
  ASSERT_TRUE(session.recorder().flush());
  EXPECT_GT(frames_of(*file).size(), then);
}

/// The log beside the file has pages of it again: with them a recording became smaller when it ended.
TEST(Recorder, TheSizeOfTheFileDoesNotFallWhenTheRecordingEnds) {
  Recorded session;
  std::uint64_t before = 0;
  for (const double until_s : {0.5, 1.0, 1.5}) {
    session.run_until(until_s);
    ASSERT_TRUE(session.recorder().flush());
    const std::uint64_t now = session.recorder().state().file_bytes;
    EXPECT_GT(now, before);
    EXPECT_LE(now, session.recorder().state().bytes) << "the log is on the disk, too";
    before = now;
  }
  ASSERT_TRUE(session.recorder().finish());
  EXPECT_GE(session.recorder().state().file_bytes, before);
  EXPECT_EQ(session.recorder().state().file_bytes, std::filesystem::file_size(session.path));
}

TEST(Recorder, AFullDiskIsSaidAndTheSessionGoesOn) {
  RecorderOptions options;
  options.largest_file_bytes = 640 << 10;
  options.waiting_frames = 100;
  Recorded session(options);
  session.run_until(2);
  EXPECT_FALSE(session.recorder().flush());
  session.run_until(5);  // nobody waits for the disk
  const Recorder::State state = session.recorder().state();
  EXPECT_THAT(state.failure, HasSubstr("the disk is full"));
  EXPECT_GT(state.lost, 0U);
  const Status finished = session.recorder().finish();
  ASSERT_FALSE(finished);
  EXPECT_THAT(finished.error().message, HasSubstr("are missing"));
  // What was on disk by then is whole.
  const auto file = opened(session.path);
  const auto frames = frames_of(*file);
  for (std::size_t i = 0; i < frames.size(); ++i) EXPECT_EQ(frames[i].index, i);
  EXPECT_EQ(frames.size(), session.recorder().state().frames);
  EXPECT_EQ(frames.size() + session.recorder().state().lost, session.keeper->frames.size());
}

TEST(Recorder, WhatTheQueueCannotHoldIsCountedAsLost) {
  RecorderOptions options;
  options.waiting_frames = 10;
  options.commit_interval_s = 3600;  // never by itself
  Recorded session(options);
  session.run_until(1);
  EXPECT_EQ(session.recorder().state().lost, session.keeper->frames.size() - 10);
  EXPECT_THAT(session.recorder().state().failure, HasSubstr("does not keep up"));
  ASSERT_TRUE(session.recorder().flush());
  EXPECT_EQ(session.recorder().state().failure, "");
  const Status finished = session.recorder().finish();
  ASSERT_FALSE(finished);
  const auto file = opened(session.path);
  EXPECT_EQ(frames_of(*file).size(), 10U);
  EXPECT_EQ(file->contents().runs[0].lost, session.keeper->frames.size() - 10);
}

/// Whether another process would find SQLite's lock of a connection on the file: bytes 2 to 511 behind the
/// first GiB. Of its own locks a process is told nothing.
bool is_locked_for_others(const std::string& path) {
  const pid_t child = ::fork();
  if (child == 0) {
    struct flock lock {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    lock.l_start = 0x40000002;
    lock.l_len = 510;
    const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
    const bool is_known = file >= 0 && ::fcntl(file, F_GETLK, &lock) == 0;
    ::_exit(is_known && lock.l_type != F_UNLCK ? 1 : 0);
  }
  int status = 0;
  return ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 1;
}

// A process loses all its locks on a file when it closes any descriptor of it: another program would then
// take the log for one that nobody needs.
TEST(Recorder, KeepsItsLockWhileTheSameProgramReadsTheFile) {
  Recorded session;
  session.run_until(0.2);
  ASSERT_TRUE(session.recorder().flush());
  ASSERT_TRUE(is_locked_for_others(session.path));
  {
    const auto file = opened(session.path);
    EXPECT_TRUE(is_locked_for_others(session.path)) << "while it is open";
  }
  EXPECT_TRUE(is_locked_for_others(session.path)) << "after it was closed";
  EXPECT_TRUE(session.recorder().finish());
}

TEST(Recorder, RefusesAFileThatAnotherOneWrites) {
  Recorded session;
  session.run_until(0.2);
  const auto second = Recorder::open(session.path, test::session_facts());
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().text(), HasSubstr("another program or window is recording into this file"));
  session.run_until(0.4);
  EXPECT_TRUE(session.recorder().finish());
}

TEST(Recorder, RefusesWhatIsNoSessionFileAndLeavesItAlone) {
  const test::TemporaryFolder folder;
  const std::string other = folder.file("other.db");
  {
    auto database = SessionDatabase::open(other, SessionDatabase::Access::Create);
    ASSERT_TRUE(database->execute("CREATE TABLE songs (name TEXT)"));
  }
  const auto opened = Recorder::open(other, test::session_facts());
  ASSERT_FALSE(opened);
  EXPECT_THAT(opened.error().text(), HasSubstr("another program's SQLite database"));
  EXPECT_THAT(opened.error().text(), HasSubstr("other.db"));
  auto database = SessionDatabase::open(other, SessionDatabase::Access::Read);
  EXPECT_EQ(**database->integer("SELECT count(*) FROM sqlite_schema"), 1);
  EXPECT_FALSE(Recorder::open(folder.file("no/such/folder/s.abrazo"), {}));
  EXPECT_FALSE(Recorder::open(folder.file(""), {}));
}

TEST(Recorder, ThreadsMayHandOverWhileOthersRead) {
  Recorded session;
  session.run_until(0.2);
  const FrameSnapshotPtr frame = session.keeper->frames.back();
  std::jthread poses([&] {
    for (int i = 0; i < 200; ++i) session.recorder().pose_received(test::received("Ana", i, frame->user));
  });
  std::jthread takes([&] {
    for (int i = 0; i < 20; ++i) session.recorder().begin_take("take " + std::to_string(i));
  });
  std::jthread reader([&] {
    const auto store = session.recorder().store();
    while (session.recorder().state().frames < 20) (void)store->span(), (void)store->at(0.1);
  });
  session.run_until(1);
  poses.join();
  takes.join();
  EXPECT_TRUE(session.recorder().flush());
  reader.join();
  EXPECT_TRUE(session.recorder().finish());
  EXPECT_EQ(session.recorder().state().poses, 200U);
  EXPECT_EQ(frames_of(*opened(session.path)).size(), session.keeper->frames.size());
}

/// A take that is annotated after its frames were recorded makes no other meshes.
TEST(LibraryFingerprint, SaysWhetherOnlyLabelsDiffer) {
  const MotionLibrary& library = *test::session_library();
  const std::string usual = library_fingerprint(library);
  LibraryColumns labelled = library.columns();
  ASSERT_FALSE(labelled.takes.front().labels.empty());
  labelled.takes.front().labels.front().label = "dip";
  const std::string other = library_fingerprint(MotionLibrary(std::move(labelled)));
  EXPECT_NE(other, usual);
  EXPECT_TRUE(is_same_motion(other, usual));
  LibraryColumns moved = library.columns();
  moved.poses[5](3, 1) += 1e-9;
  EXPECT_FALSE(is_same_motion(library_fingerprint(MotionLibrary(std::move(moved))), usual));
  EXPECT_FALSE(is_same_motion("", "")) << "a recording that was cut off has none";
}

TEST(LibraryFingerprint, ChangesWithEveryMeasureOfABody) {
  const MotionLibrary& library = *test::session_library();
  const std::string usual = library_fingerprint(library);
  EXPECT_EQ(library_fingerprint(MotionLibrary(library.columns())), usual);
  const std::vector<std::pair<const char*, std::function<void(LibraryBody&)>>> changes = {
      {"bone", [](LibraryBody& body) { body.body.bone_lengths[3] += 1e-6; }},
      {"pseudo bone", [](LibraryBody& body) { body.body.pseudo_lengths[0] += 1e-6; }},
      {"capsule", [](LibraryBody& body) { body.capsule_radii[2] += 1e-6; }},
      {"toe at rest", [](LibraryBody& body) { body.body.toe_rest_height += 1e-6; }},
  };
  for (const auto& [what, change] : changes) {
    LibraryColumns columns = library.columns();
    change(columns.bodies.back());
    EXPECT_NE(library_fingerprint(MotionLibrary(std::move(columns))), usual) << what;
  }
}

}  // namespace
}  // namespace abrazo::recorder_test
