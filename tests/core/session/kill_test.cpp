#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <sstream>

#include "core/session/session_file.hpp"
#include "tests/core/session/recorded_session.hpp"

namespace abrazo {
namespace {

/// What a killed recording had said of its last frames.
struct Killed {
  struct Line {
    std::uint64_t index = 0;
    double time_s = 0, handed_over_s = 0;
    std::uint64_t on_disk = 0;
    double behind_s = 0;
  };
  std::vector<Line> lines;
  double killed_s = 0;
};

double monotonic_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Lets it record so many frames, then ends it without any warning.
Killed record_and_kill(const std::string& path, std::size_t frames) {
  int ends[2];
  EXPECT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
    execl(ABRAZO_VICTIM, ABRAZO_VICTIM, path.c_str(), nullptr);
    _exit(127);
  }
  close(ends[1]);
  Killed killed;
  std::FILE* said = fdopen(ends[0], "r");
  char text[256];
  const auto take = [&] {
    if (!std::fgets(text, sizeof text, said)) return false;
    Killed::Line line;
    std::istringstream(text) >> line.index >> line.time_s >> line.handed_over_s >> line.on_disk >>
        line.behind_s;
    killed.lines.push_back(line);
    return true;
  };
  while (killed.lines.size() < frames && take()) continue;
  killed.killed_s = monotonic_s();
  kill(child, SIGKILL);
  while (take()) continue;  // what it still said
  std::fclose(said);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status)) << "it ended by itself";
  return killed;
}

class KilledRecording : public testing::TestWithParam<std::size_t> {};

TEST_P(KilledRecording, OpensAndHasAllButTheLastHalfSecond) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("killed.abrazo");
  const Killed killed = record_and_kill(path, GetParam());
  ASSERT_GE(killed.lines.size(), GetParam());
  const auto file = SessionFile::open(path);
  ASSERT_TRUE(file) << file.error().text();
  std::uint64_t next = 0;
  const auto pass = (*file)->each_frame(-1e9, 1e9, [&](const FrameSnapshot& frame) -> Status {
    EXPECT_EQ(frame.index, next++);
    return Done{};
  });
  ASSERT_TRUE(pass);
  EXPECT_EQ(pass->damaged, 0U);
  EXPECT_GE(next, killed.lines.back().on_disk);  // what was said to be on disk is
  for (const Killed::Line& line : killed.lines) {
    // A disk that needs longer for one commit says so in its delay.
    const double wait_s = std::max(0.5, killed.lines.back().behind_s + 0.4);
    if (line.handed_over_s < killed.killed_s - wait_s) {
      EXPECT_LT(line.index, next);
    }
  }
  EXPECT_EQ((*file)->recovery().size(), 2U);  // that it was cut off, and the open take
  const auto& last = killed.lines.back();
  std::printf("frames handed over %zu, on disk %llu, lost %.3f s\n", killed.lines.size(),
              static_cast<unsigned long long>(next), static_cast<double>(last.index + 1 - next) / 120);
}

INSTANTIATE_TEST_SUITE_P(AfterFrames, KilledRecording, testing::Values(70U, 131U, 243U));

}  // namespace
}  // namespace abrazo
