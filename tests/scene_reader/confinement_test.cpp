#include "app/scene_reader/confinement.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/landlock.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>

namespace abrazo::app::confinement_test {
namespace {

namespace fs = std::filesystem;

long landlock_version() {
  return ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
}

/// A folder with a file, and a file beside the folder that everybody may read.
class Confined : public ::testing::Test {
 protected:
  Confined() : place_(fs::temp_directory_path() / ("confined-" + std::to_string(::getpid()))) {
    fs::create_directories(place_ / "scene/parts");
    for (const char* name : {"scene/dance.bin", "scene/parts/dance.bin", "outside.bin"})
      std::ofstream(place_ / name) << "numbers";
  }
  ~Confined() override { fs::remove_all(place_); }

  std::string path(const std::string& name) const { return (place_ / name).string(); }
  Confinement in(const std::string& folder) const { return {std::size_t{1} << 32U, 20, folder}; }

  fs::path place_;
};

/// 0, or why not.
int opened(const std::string& path, int how) {
  const int fd = ::open(path.c_str(), how | O_CLOEXEC, 0600);
  if (fd < 0) return errno;
  ::close(fd);
  return 0;
}

/// Ends this process, with 0 if everything in it was as it has to be.
[[noreturn]] void end_confined(const Confinement& to, const std::function<bool()>& holds) {
  if (!confine(to)) std::_Exit(2);
  std::_Exit(holds() ? 0 : 1);
}

#define SKIP_WITHOUT_LANDLOCK() \
  if (landlock_version() < 1)   \
  GTEST_SKIP() << "this kernel has no Landlock, or it is switched off: only the reader's own checks apply"

TEST_F(Confined, ReadsBelowItsFolderAndOpensNothingElse) {
  SKIP_WITHOUT_LANDLOCK();
  const auto holds = [this] {
    return opened(path("scene/dance.bin"), O_RDONLY) == 0 &&
           opened(path("scene/parts/dance.bin"), O_RDONLY) == 0 &&
           opened(path("outside.bin"), O_RDONLY) == EACCES &&
           opened(path("scene/../outside.bin"), O_RDONLY) == EACCES &&
           opened("/etc/passwd", O_RDONLY) == EACCES && opened("/dev/zero", O_RDONLY) == EACCES;
  };
  EXPECT_EXIT(end_confined(in(path("scene")), holds), ::testing::ExitedWithCode(0), "");
}

TEST_F(Confined, WritesMakesAndRemovesNothingInItsFolderEither) {
  SKIP_WITHOUT_LANDLOCK();
  const auto holds = [this] {
    return opened(path("scene/dance.bin"), O_WRONLY) == EACCES &&
           opened(path("scene/new.bin"), O_WRONLY | O_CREAT) == EACCES &&
           ::unlink(path("scene/dance.bin").c_str()) == -1 && errno == EACCES &&
           ::mkdir(path("scene/folder").c_str(), 0700) == -1 && errno == EACCES;
  };
  EXPECT_EXIT(end_confined(in(path("scene")), holds), ::testing::ExitedWithCode(0), "");
  EXPECT_TRUE(fs::exists(path("scene/dance.bin")));
  EXPECT_FALSE(fs::exists(path("scene/new.bin")) || fs::exists(path("scene/folder")));
}

TEST_F(Confined, WithoutAFolderNothingIsOpened) {
  SKIP_WITHOUT_LANDLOCK();
  const auto holds = [this] { return opened(path("scene/dance.bin"), O_RDONLY) == EACCES; };
  EXPECT_EXIT(end_confined(in(""), holds), ::testing::ExitedWithCode(0), "");
}

TEST_F(Confined, LinksDoNotLeadOut) {
  SKIP_WITHOUT_LANDLOCK();
  fs::create_symlink(path("outside.bin"), path("scene/link.bin"));
  const auto holds = [this] { return opened(path("scene/link.bin"), O_RDONLY) == EACCES; };
  EXPECT_EXIT(end_confined(in(path("scene")), holds), ::testing::ExitedWithCode(0), "");
}

TEST_F(Confined, HasLimitsThatItCannotRaise) {
  const auto holds = [] {
    const auto most = [](__rlimit_resource_t what) {
      rlimit now{};
      ::getrlimit(what, &now);
      return now.rlim_max;
    };
    return most(RLIMIT_CPU) <= 22 && most(RLIMIT_FSIZE) == 0 && most(RLIMIT_CORE) == 0 &&
           most(RLIMIT_NOFILE) <= 16 && most(RLIMIT_NPROC) == 0;
  };
  EXPECT_EXIT(end_confined(in(""), holds), ::testing::ExitedWithCode(0), "");
}

TEST_F(Confined, MemoryBeyondItsLimitIsRefused) {
#ifdef ABRAZO_INSTRUMENTED
  GTEST_SKIP() << "instrumented programs have no limit of addresses";
#endif
  const auto holds = [] { return std::malloc(std::size_t{5} << 30U) == nullptr; };
  EXPECT_EXIT(end_confined(in(""), holds), ::testing::ExitedWithCode(0), "");
}

TEST_F(Confined, AProcessThatNeverEndsIsEndedByTheProcessorsLimit) {
  Confinement short_of_time = in("");
  short_of_time.processor_s = 1;
  EXPECT_EXIT(
      {
        (void)confine(short_of_time);
        for (volatile int turns = 0;;) turns = turns + 1;
      },
      ::testing::KilledBySignal(SIGXCPU), "");
}

}  // namespace
}  // namespace abrazo::app::confinement_test
