// Sessions on drives that lock no files, or share no memory of them.
#include "tests/core/session/network_drive.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/atomic_file.hpp"
#include "core/session/file/session_reading.hpp"
#include "tests/core/session/recorded_session.hpp"

namespace abrazo::network_drive_test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct Recorded : test::TemporaryFolder, test::DrivenSession {
  Recorded() {
    keeper->recorder = *Recorder::open(path, test::session_facts());
    run_until(0.3);
  }
  const std::string path = file("evening.abrazo");
};

class NetworkDrive : public testing::Test {
 protected:
  void SetUp() override {
    Recorded session;
    ASSERT_TRUE(session.keeper->recorder->finish());
    fs::create_directory(drive());
    fs::copy(session.path, file());
    before_ = read_whole_file(file()).value();
  }
  void TearDown() override { test::network_drive_has(true, true); }
  fs::path drive() const { return folder_.file("netdrive"); }
  std::string file() const { return (drive() / "evening.abrazo").string(); }
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(drive()))
      names.push_back(entry.path().filename().string());
    return names;
  }
  bool is_untouched() const { return read_whole_file(file()).value() == before_; }

 private:
  test::TemporaryFolder folder_;
  std::string before_;
};

TEST_F(NetworkDrive, WithoutLocksASessionIsReadAndNothingIsRecorded) {
  test::network_drive_has(false, true);
  const auto reading = read_session(file());
  ASSERT_TRUE(reading) << reading.error().text();
  EXPECT_GT(reading->contents.frames, 10U);
  EXPECT_FALSE(reading->is_being_recorded);
  for (const std::string& path : {file(), (drive() / "new.abrazo").string()}) {
    const auto recorder = Recorder::open(path, test::session_facts());
    ASSERT_FALSE(recorder);
    EXPECT_THAT(recorder.error().text(), HasSubstr("locks no files (is it a network drive?)"));
  }
  EXPECT_THAT(names(), ElementsAre("evening.abrazo")) << "no debris";
  EXPECT_TRUE(is_untouched());
}

TEST_F(NetworkDrive, WithoutLocksALogCannotBeReadAndThatIsSaid) {
  ASSERT_TRUE(write_whole_file(file() + "-wal", "what was recorded last"));
  test::network_drive_has(false, true);
  const auto reading = read_session(file());
  ASSERT_FALSE(reading);
  EXPECT_THAT(reading.error().text(), HasSubstr("copy it to a local disk"));
}

TEST_F(NetworkDrive, WithoutSharedMemoryASessionIsReadAndNothingIsChanged) {
  test::network_drive_has(true, false);
  for (const std::string& path : {file(), (drive() / "new.abrazo").string()}) {
    const auto recorder = Recorder::open(path, test::session_facts());
    ASSERT_FALSE(recorder);
    EXPECT_THAT(recorder.error().text(), HasSubstr("shares no memory of files (is it a network drive?)"));
  }
  EXPECT_THAT(names(), ElementsAre("evening.abrazo")) << "no debris";
  EXPECT_TRUE(is_untouched()) << "it would be one with a log, unreadable there";
  const auto reading = read_session(file());
  ASSERT_TRUE(reading) << reading.error().text();
  EXPECT_GT(reading->contents.frames, 10U);
}

TEST_F(NetworkDrive, ACopyWithoutItsLogNamesIt) {
  Recorded session;
  ASSERT_TRUE(session.keeper->recorder->flush());
  fs::copy_file(session.path, drive() / "copy.abrazo");  // while it is being recorded, and without -wal
  const auto reading = read_session((drive() / "copy.abrazo").string());
  const std::string said =
      reading ? reading->recovery.empty() ? "nothing" : reading->recovery.front() : reading.error().text();
  EXPECT_THAT(said, HasSubstr("its log 'copy.abrazo-wal' is not beside it; copy that too"));
  EXPECT_TRUE(session.keeper->recorder->finish());
}

}  // namespace
}  // namespace abrazo::network_drive_test
