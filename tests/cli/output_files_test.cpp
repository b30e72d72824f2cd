#include "tests/cli/command_line_fixture.hpp"

namespace abrazo::test::output_files_test {
namespace {

using ::testing::ElementsAre;

class OutputFiles : public CommandLineTest {
 protected:
  /// As on a disk on which no file grows beyond 4 kB.
  Outcome run_on_a_full_disk(const std::string& line) const {
    const std::string limited = "ulimit -f 8; exec " ABRAZO_PROGRAM " " + line;
    return RunningCommand({"/bin/sh", "-c", limited}, folder()).wait();
  }
  /// Commands that write a file, but for its name.
  static std::vector<std::string> writers() {
    const std::string synth = "synth --library demo.h5 --input demo/salsa_01_a.bvh ";
    return {"motion positions demo/salsa_01_a.bvh -o ", "library build demo/manifest.json --rate 5 -o ",
            synth + "-o ", synth + "--trace "};
  }
};

TEST_F(OutputFiles, WhatStoodThereIsReplacedWhole) {
  make_library();
  for (const std::string& writer : writers()) {
    write("out.csv", std::string(30'000'000, '#'));
    ASSERT_EQ(run(writer + "out.csv").status, 0) << writer;
    EXPECT_LT(std::filesystem::file_size(path("out.csv")), 30'000'000u) << writer;
    EXPECT_EQ(read("out.csv").find("####"), std::string::npos) << writer;
    EXPECT_THAT(names(), ElementsAre("demo", "demo.h5", "out.csv")) << writer;
  }
}

TEST_F(OutputFiles, AFolderThatIsNotThereIsSaidBeforeTheWork) {
  make_library();
  for (const std::string& writer : writers()) {
    expect_failure(run(writer + "gone/out.csv"), "gone: the folder does not exist");
    expect_failure(run(writer + "demo.h5/out.csv"), "demo.h5: is not a folder");
  }
  EXPECT_THAT(names(), ElementsAre("demo", "demo.h5"));
}

TEST_F(OutputFiles, AFolderThatTakesNoFilesIsSaid) {
  make_library();
  for (const std::string& writer : writers())
    expect_failure(run(writer + "/proc/out.csv"), "/proc/out.csv: cannot");
}

TEST_F(OutputFiles, OnAFullDiskWhatStoodThereStaysAndNothingHalfDoneIsLeft) {
  make_library();
  write("out.csv", "mine");
  for (const std::string& writer : writers()) {
    expect_failure(run_on_a_full_disk(writer + "out.csv"), "full");
    EXPECT_EQ(read("out.csv"), "mine") << writer;
    EXPECT_THAT(names(), ElementsAre("demo", "demo.h5", "out.csv")) << writer;
  }
}

TEST_F(OutputFiles, ARecordingOnAFullDiskSaysSoAndKeepsWhatWasCommitted) {
  make_library();
  const std::string live =
      "live --library demo.h5 --listen clip:demo/salsa_01_a.bvh --record s.abrazo --seconds ";
  ASSERT_EQ(run(live + "0.3").status, 0);
  const std::string before = run("session info s.abrazo --json").out;
  const std::string limit =
      "ulimit -f " + std::to_string(std::filesystem::file_size(path("s.abrazo")) / 512 + 8);
  const Outcome full =
      RunningCommand({"/bin/sh", "-c", limit + "; exec " ABRAZO_PROGRAM " " + live + "4"}, folder()).wait();
  EXPECT_EQ(full.status, 1) << full.err;
  EXPECT_THAT(full.err, ::testing::HasSubstr("full"));
  EXPECT_EQ(run("session info s.abrazo").status, 0) << "what was committed opens";
}

TEST_F(OutputFiles, ADeviceIsNotReplaced) {
  make_library();
  // A pipe stands for it: a program that replaced a device would harm the machine that tests it.
  ASSERT_EQ(RunningCommand({"/usr/bin/mkfifo", "pipe.csv"}, folder()).wait().status, 0);
  for (const std::string& writer : writers()) {
    expect_failure(run(writer + "pipe.csv"), "pipe.csv: is a device or pipe");
    EXPECT_TRUE(std::filesystem::is_fifo(path("pipe.csv"))) << writer;
  }
}

TEST_F(OutputFiles, AFolderInTheFilesPlaceIsLeftAlone) {
  make_library();
  std::filesystem::create_directory(path("out.csv"));
  for (const std::string& writer : writers()) expect_failure(run(writer + "out.csv"), "out.csv: is a folder");
  EXPECT_TRUE(std::filesystem::is_empty(path("out.csv")));
}

TEST_F(OutputFiles, AnInputIsNotWrittenOver) {
  make_library();
  const std::string motion = read("demo/salsa_01_a.bvh");
  const std::string manifest = read("demo/manifest.json");
  expect_failure(run("motion positions demo/salsa_01_a.bvh -o demo/salsa_01_a.bvh"), "is also read");
  expect_failure(run("library build demo/manifest.json -o ./demo/../demo/manifest.json"), "is also read");
  const std::string synth = "synth --library demo.h5 --input demo/salsa_01_a.bvh ";
  expect_failure(run(synth + "-o demo/salsa_01_a.bvh"), "is also read");
  expect_failure(run(synth + "--trace demo.h5"), "is also read");
  expect_failure(run(synth + "-o same.csv --trace same.csv"), "cannot share a file");
  EXPECT_EQ(read("demo/salsa_01_a.bvh"), motion);
  EXPECT_EQ(read("demo/manifest.json"), manifest);
  EXPECT_EQ(run("library info demo.h5").status, 0);
}

}  // namespace
}  // namespace abrazo::test::output_files_test
