// Pictures and films without a display. The drawing itself needs the workbench's program beside `abrazo`.
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "tests/cli/command_line_fixture.hpp"
#include "tests/cli/live_fixture.hpp"
#include "tests/support/humanoid_rig.hpp"

namespace abrazo::test::render_command_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class RenderCommand : public CommandLineTest {
 protected:
  /// A trace of 2 s of the generated dance.
  void make_trace() const {
    make_library();
    ASSERT_EQ(run("synth --library demo.h5 --input demo/salsa_01_a.bvh --preset paper --trace all.jsonl -o "
                  "out.bvh --quiet")
                  .status,
              0);
    std::string all = read("all.jsonl");
    std::size_t end = 0;
    for (int line = 0; line < 31; ++line) end = all.find('\n', end) + 1;
    write("T.jsonl", all.substr(0, end));
  }
};

TEST_F(RenderCommand, RefusesWordsThatCannotBe) {
  expect_wrong_usage(run("render T.jsonl"), "--output is required");
  expect_wrong_usage(run("render T.jsonl -o a.png --size 10x10"), "write a size as 1280x720");
  expect_wrong_usage(run("render T.jsonl -o a.png --camera behind"),
                     "expected follow, front, right, top, iso");
  for (const char* direction : {"nan,9", "0,nan", "361,0", "0,90"})
    expect_wrong_usage(run(std::string("render T.jsonl -o a.png --camera ") + direction),
                       "expected follow, front, right, top, iso");
  expect_wrong_usage(run("render T.jsonl -o a.mp4 --rate 0"), "expected a rate of 0.1 to 240 Hz");
  expect_failure(run("render T.jsonl -o a.gif"), "a film (.mp4), a picture (.png) or a series");
  expect_failure(run("render T.jsonl -o a%s.png"), "has a '%' that is not a number");
  expect_failure(run("render T.jsonl -o a.mp4 --size 641x360"), "a film needs an even size; found 641x360");
  expect_failure(run("render T.jsonl -o a.png --from 1 --to 2"), "one picture has no --to");
  expect_failure(run("render T.jsonl -o a.mp4 --from 2 --to 1"), "--to 1 is before --from 2");
  expect_failure(run("render T.jsonl -o none/a.mp4"), "none");
}

TEST_F(RenderCommand, DrawsTheSamePictureEachTime) {
  make_trace();
  for (const std::string name : {"a.png", "b.png"}) {
    const Outcome outcome = run({"render", "T.jsonl", "-o", name, "--from", "1", "--size", "320x240"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, name + ": 1 picture, 320x240\n");
  }
  EXPECT_THAT(read("a.png"), StartsWith("\x89PNG"));
  EXPECT_EQ(read("a.png"), read("b.png"));
}

TEST_F(RenderCommand, ShowsACharacterOfAnotherProgramAsTheSkinOfABody) {
  make_trace();
  write("ana.vrm", skinned_rig(Naming::Vrm1));
  const std::string look = "render T.jsonl --from 1 --size 320x240 --mesh off ";
  for (const char* wish : {"-o capsules.png", "-o active.png --active-character ana.vrm",
                           "-o passive.png --passive-character ana.vrm"})
    ASSERT_EQ(run(look + wish).status, 0) << wish;
  EXPECT_NE(read("active.png"), read("capsules.png"));
  EXPECT_NE(read("passive.png"), read("capsules.png"));
  EXPECT_NE(read("passive.png"), read("active.png"));
  expect_failure(run(look + "-o a.png --active-character none.vrm"), "none.vrm");
  write("bare.glb", rig(Naming::Mixamo));
  expect_failure(run(look + "-o a.png --passive-character bare.glb"), "bare.glb: has no mesh to show");
  expect_failure(run(look + "-o ana.vrm.png --active-character T.jsonl"), "is no GLB or VRM file");
  EXPECT_FALSE(std::filesystem::exists(path("a.png")));
}

TEST_F(RenderCommand, MakesAFilmAndANumberedSeries) {
  make_trace();
  Outcome outcome = run("render T.jsonl -o a.mp4 --to 0.5 --rate 10 --size 320x240");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "a.mp4: 6 pictures, 320x240\n");
  std::filesystem::create_directory(path("s"));
  outcome = run(
      "render T.jsonl -o s/f_%03d.png --to 0.2 --rate 10 --size 320x240 --mesh off --theme light --quiet");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  for (const char* name : {"s/f_000.png", "s/f_001.png", "s/f_002.png"})
    EXPECT_TRUE(std::filesystem::exists(path(name))) << name;
  EXPECT_FALSE(std::filesystem::exists(path("s/f_003.png")));
}

TEST_F(RenderCommand, SaysWhatIsWrongWithItsInput) {
  make_trace();
  expect_failure(run("render none.jsonl -o a.png"), "none.jsonl: cannot be opened");
  write("t.txt", "");
  expect_failure(run("render t.txt -o a.png"), "neither a session (.abrazo) nor a trace");
  write("l.jsonl", "take,start\n");
  expect_failure(run("render l.jsonl -o a.png"), "l.jsonl:1: is no trace");
  write("cut.jsonl", read("T.jsonl").substr(0, read("T.jsonl").size() - 500));
  expect_failure(run("render cut.jsonl -o a.png"), "cut.jsonl:31: is no JSON object");
  expect_failure(run("render T.jsonl -o a.png --from 99"),
                 "--from 99 is outside of what was recorded, 0.000 to");
  EXPECT_FALSE(std::filesystem::exists(path("a.png")));
}

TEST_F(RenderCommand, KeepsAnOlderSeriesWhenTheNewOneFails) {
  make_trace();
  std::filesystem::create_directories(path("s/f_2.png"));
  for (const char* name : {"s/f_0.png", "s/f_1.png"}) write(name, "old");
  expect_failure(run("render T.jsonl -o s/f_%d.png --to 0.2 --rate 10 --size 320x240"),
                 "f_2.png: is a folder");
  for (const char* name : {"s/f_0.png", "s/f_1.png"}) EXPECT_EQ(read(name), "old") << name;
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("s")), {}), 3);
}

/// Called by itself: what `abrazo render` starts has taken over what that does with the signal.
TEST_F(RenderCommand, OnAFullDiskTheProgramThatDrawsSaysSoAndLeavesNothing) {
  const auto shell = [&](const std::string& line) {
    return RunningCommand({"/bin/sh", "-c", line}, folder()).wait();
  };
  if (shell("command -v Xvfb").status != 0) GTEST_SKIP() << "there is no Xvfb to draw on";
  make_trace();
  write("a.png", "mine");
  // The server itself chooses a number that is free, which xvfb-run does not manage beside others.
  const Outcome full = shell(
      "mkfifo display; Xvfb -displayfd 3 -nolisten tcp 3>display 2>&1 & server=$!; read number <display; "
      "rm display; export DISPLAY=:$number QT_QPA_PLATFORM=xcb; "
      "/bin/sh -c 'ulimit -f 8; exec " ABRAZO_RENDERER
      " T.jsonl -o a.png --size 320x240'; "
      "status=$?; kill $server; wait $server; exit $status");
  EXPECT_EQ(full.status, 1);
  EXPECT_THAT(full.err, HasSubstr("the disk full?"));
  EXPECT_EQ(read("a.png"), "mine");
  EXPECT_THAT(names(), ElementsAre("T.jsonl", "a.png", "all.jsonl", "demo", "demo.h5", "out.bvh"));
}

TEST_F(RenderCommand, LeavesNothingWhenItIsStopped) {
  make_trace();
  std::filesystem::create_directory(path("film"));
  RunningCommand running(
      {ABRAZO_PROGRAM, "render", "T.jsonl", "-o", "film/a.mp4", "--size", "1920x1080", "--rate", "240"},
      folder());
  // The partial file is there from the first picture on.
  while (!running.finished() && std::filesystem::is_empty(path("film"))) std::this_thread::yield();
  running.signal(SIGINT);
  const Outcome outcome = running.wait();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("was stopped; nothing was written"));
  EXPECT_TRUE(std::filesystem::is_empty(path("film")));
}

/// The same signal twice, as from `timeout`, while what draws is too busy to see the first one.
TEST_F(RenderCommand, StaysUntilWhatItStartedHasEnded) {
  make_trace();
  std::filesystem::create_directory(path("film"));
  RunningCommand running(
      {ABRAZO_PROGRAM, "render", "T.jsonl", "-o", "film/a.mp4", "--size", "1920x1080", "--rate", "240"},
      folder());
  while (!running.finished() && std::filesystem::is_empty(path("film"))) std::this_thread::yield();
  const pid_t drawing = running.child("abrazo-render");
  ASSERT_GT(drawing, 0);
  ::kill(drawing, SIGSTOP);
  running.signal(SIGTERM);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  running.signal(SIGTERM);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  ::kill(drawing, SIGCONT);
  const Outcome outcome = running.wait();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("was stopped; nothing was written"));
  EXPECT_TRUE(std::filesystem::is_empty(path("film")));
}

/// As `timeout` and service managers do it: the program that draws gets the signal twice, once passed on.
/// `timeout` signals the program that it started, and then everything in its process group.
TEST_F(RenderCommand, LeavesNothingWhenAllOfItsGroupIsStopped) {
  make_trace();
  std::filesystem::create_directory(path("film"));
  RunningCommand running({"/usr/bin/timeout", "--preserve-status", "3", ABRAZO_PROGRAM, "render", "T.jsonl",
                          "-o", "film/a.mp4", "--size", "1920x1080", "--rate", "240"},
                         folder());
  EXPECT_NE(running.wait().status, 0);
  EXPECT_TRUE(wait_until([&] { return std::filesystem::is_empty(path("film")); }))
      << "what renders ends after the program that started it";
}

}  // namespace
}  // namespace abrazo::test::render_command_test
