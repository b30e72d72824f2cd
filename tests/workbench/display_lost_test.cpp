// The workbench ends while it records: its display is gone (the X server was killed, a remote desktop cut
// off), or the system tells it to.
#include <gtest/gtest.h>
#include <unistd.h>

#include <QDir>
#include <QTemporaryDir>
#include <cstdio>
#include <optional>
#include <sstream>
#include <string>

#include "app/workbench/document/session_places.hpp"
#include "app/workbench/project/autosave.hpp"
#include "core/session/file/session_file.hpp"
#include "tests/workbench/process.hpp"

namespace abrazo::app::display_lost_test {
namespace {

/// The workbench on a display of its own while it records, with a marker that was autosaved.
class RecordingWorkbench : public testing::Test {
 protected:
  RecordingWorkbench() : display_(become_display) { qputenv("ABRAZO_HOME", home_.path().toUtf8()); }
  void SetUp() override {
    const std::string number = display_.line();
    if (number.empty()) GTEST_SKIP() << "needs Xvfb";
    workbench_.emplace([&number] {
      use_display(number);
      execl(ABRAZO_DISPLAY_VICTIM, ABRAZO_DISPLAY_VICTIM, nullptr);
    });
    // Autosaving takes its time; the lines come every 50 ms.
    for (int lines = 0; lines < 1200 && (solved_s_ - first_s_ < 3 || !is_kept()); ++lines)
      ASSERT_TRUE(read_line());
    ASSERT_FALSE(file_.empty());
    ASSERT_TRUE(is_kept()) << "the marker was not autosaved";
  }
  bool is_kept() const { return !QDir(autosaves()).entryList({"*.abrazo"}, QDir::Files).isEmpty(); }
  QString autosaves() const { return home_.path() + "/autosave"; }
  /// @return whether there was one
  bool read_line() {
    const std::string line = workbench_->line();
    if (line.starts_with("recording "))
      file_ = line.substr(10, line.size() - 11);
    else
      std::istringstream(line) >> solved_s_;
    if (first_s_ < 0 && solved_s_ > 0) first_s_ = solved_s_;
    return !line.empty();
  }
  /// How it ended, as waitpid says it.
  int end_of_the_workbench() {
    while (read_line()) continue;
    return workbench_->wait();
  }
  void expect_the_marker_is_offered() const {
    EXPECT_EQ(Autosave::leftBehind(autosaves()).size(), 1);
    EXPECT_TRUE(words_of_autosave(Autosave::leftBehind(autosaves()).value(0)).contains("1 marker"));
  }
  /// That it is readable throughout, and until when it goes [s].
  void expect_whole_recording(double until_s) const {
    const auto session = SessionFile::open(file_);
    ASSERT_TRUE(session) << session.error().text();
    double last_s = 0;
    std::uint64_t frames = 0;
    const auto pass = (*session)->each_frame(-1e9, 1e9, [&](const FrameSnapshot& frame) -> Status {
      last_s = frame.time_s;
      ++frames;
      return Done{};
    });
    ASSERT_TRUE(pass);
    EXPECT_EQ(pass->damaged, 0U) << pass->damage;
    EXPECT_GT(frames, 30U);
    EXPECT_GE(last_s, until_s - 1e-6) << "it was told to so many digits";
    std::printf("solved until %.3f s, on disk until %.3f s, %llu frames\n", solved_s_, last_s,
                static_cast<unsigned long long>(frames));
  }

  const QTemporaryDir home_;
  Process display_;
  std::optional<Process> workbench_;
  std::string file_;
  double solved_s_ = 0, first_s_ = -1;
};

TEST_F(RecordingWorkbench, WhoseDisplayIsLostLeavesAWholeRecordingAndTheNextStartOffersItAndTheChanges) {
  display_.end(SIGKILL);
  const int status = end_of_the_workbench();
  EXPECT_TRUE(WIFEXITED(status)) << "it crashed with signal " << WTERMSIG(status);
  EXPECT_EQ(unclosed_sessions(sessions_folder()), QStringList{QString::fromStdString(file_)});
  expect_the_marker_is_offered();
  expect_whole_recording(solved_s_ - 0.5);
}

TEST_F(RecordingWorkbench, ThatIsToldToEndClosesTheRecordingAndKeepsTheChanges) {
  workbench_->tell(SIGTERM);
  const int status = end_of_the_workbench();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  EXPECT_EQ(unclosed_sessions(sessions_folder()), QStringList())
      << "it was closed, nothing is to be recovered";
  expect_the_marker_is_offered();
  expect_whole_recording(solved_s_);
}

}  // namespace
}  // namespace abrazo::app::display_lost_test
