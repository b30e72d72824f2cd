#include "core/base/mapped_file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace abrazo::mapped_file_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr std::size_t page = 4096;

class MappedFileTest : public testing::Test {
 protected:
  MappedFileTest()
      : file(fs::temp_directory_path() / ("abrazo_mapped_file_test." + std::to_string(::getpid()))) {
    write(file, std::string(4 * page, 'x'));
  }
  ~MappedFileTest() override { fs::remove(file); }

  static void write(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
  }
  static std::shared_ptr<const MappedFile> map(const fs::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY);
    const auto mapped = MappedFile::map(descriptor, path.string());
    ::close(descriptor);
    EXPECT_TRUE(mapped.ok());
    return *mapped;
  }
  static bool holds(const MappedFile& mapped, std::size_t begin, std::size_t end, char byte) {
    return std::all_of(mapped.bytes().data() + begin, mapped.bytes().data() + end,
                       [&](std::byte b) { return b == static_cast<std::byte>(byte); });
  }

  static std::size_t mappings() {
    std::ifstream maps("/proc/self/maps");
    std::size_t count = 0;
    for (std::string line; std::getline(maps, line);) ++count;
    return count;
  }

  const fs::path file;
};

TEST_F(MappedFileTest, ShowsTheBytesOfTheFileAfterItsDescriptorIsClosed) {
  const auto mapped = map(file);
  EXPECT_EQ(mapped->bytes().size(), 4 * page);
  EXPECT_TRUE(holds(*mapped, 0, 4 * page, 'x'));
  EXPECT_FALSE(mapped->lost_pages());
  EXPECT_FALSE(mapped->was_changed());
}

TEST_F(MappedFileTest, HoweverManyPagesAreGoneTheyAreNotManyMappings) {
  // The kernel allows a program some 65 000; every second of these would be one of its own.
  constexpr std::size_t pages = 2000;
  fs::resize_file(file, pages * page);
  const auto mapped = map(file);
  fs::resize_file(file, 0);
  const std::size_t before = mappings();
  for (std::size_t at = pages; at > 0; at -= 2)
    EXPECT_TRUE(holds(*mapped, (at - 1) * page, at * page - 1, 0));
  EXPECT_LT(mappings(), before + 5);
}

TEST_F(MappedFileTest, PagesCutFromUnderItReadAsZerosAndItSaysSo) {
  const auto mapped = map(file);
  fs::resize_file(file, page);
  EXPECT_TRUE(mapped->was_changed());
  EXPECT_TRUE(holds(*mapped, 0, page, 'x'));
  EXPECT_FALSE(mapped->lost_pages()) << "what is left can be read";
  EXPECT_TRUE(holds(*mapped, page, 4 * page, '\0'));
  EXPECT_TRUE(mapped->lost_pages());
}

TEST_F(MappedFileTest, OneThatLostPagesDoesNotBlameAnother) {
  const fs::path second = file.string() + ".second";
  write(second, std::string(2 * page, 'y'));
  const auto a = map(file), b = map(second);
  fs::resize_file(file, 0);
  EXPECT_TRUE(holds(*a, 0, page, '\0'));
  EXPECT_TRUE(holds(*b, 0, 2 * page, 'y'));
  EXPECT_TRUE(a->lost_pages());
  EXPECT_FALSE(b->lost_pages());
  EXPECT_FALSE(b->was_changed());
  fs::remove(second);
}

TEST_F(MappedFileTest, StaysAsItWasWhenItsNameIsGivenToAnotherFileOrTaken) {
  const auto mapped = map(file);
  const fs::path other = file.string() + ".other";
  write(other, "short");
  fs::rename(other, file);
  EXPECT_TRUE(holds(*mapped, 0, 4 * page, 'x'));
  EXPECT_FALSE(mapped->was_changed());
  fs::remove(file);
  EXPECT_TRUE(holds(*mapped, 0, 4 * page, 'x'));
  EXPECT_FALSE(mapped->lost_pages());
}

TEST_F(MappedFileTest, SeesThatTheFileGrewOrWasWrittenInto) {
  const auto grown = map(file);
  fs::resize_file(file, 8 * page);
  EXPECT_TRUE(grown->was_changed());
  EXPECT_EQ(grown->bytes().size(), 4 * page);

  const auto written = map(file);
  // A file's time is as fine as the system's clock ticks: an earlier one stands for the time that passes.
  fs::last_write_time(file, fs::last_write_time(file) - std::chrono::seconds(1));
  EXPECT_TRUE(written->was_changed());
}

TEST_F(MappedFileTest, RefusesWhatHasNoBytes) {
  write(file, "");
  const int descriptor = ::open(file.c_str(), O_RDONLY);
  const auto mapped = MappedFile::map(descriptor, "salsa.h5");
  ::close(descriptor);
  ASSERT_FALSE(mapped.ok());
  EXPECT_THAT(mapped.error().text(), HasSubstr("salsa.h5: is empty"));
}

TEST_F(MappedFileTest, GivesItsPlaceBackAndRefusesWhenThereIsNone) {
  for (int round = 0; round < 200; ++round) map(file);
  std::vector<std::shared_ptr<const MappedFile>> held;
  const int descriptor = ::open(file.c_str(), O_RDONLY);
  for (int i = 0; i < 1000; ++i) {
    auto mapped = MappedFile::map(descriptor, "salsa.h5");
    if (!mapped) {
      EXPECT_THAT(mapped.error().text(), HasSubstr("too many files are mapped at once"));
      break;
    }
    held.push_back(*mapped);
  }
  ::close(descriptor);
  EXPECT_GE(held.size(), 32U);
  EXPECT_LT(held.size(), 1000U);
}

using MappedFileDeathTest = MappedFileTest;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
/// The sanitizer's handler, which was there before, reports the signal and exits.
bool is_ended_by_it(int status) {
  return WIFEXITED(status) && WEXITSTATUS(status) != 0;
}
#else
const testing::KilledBySignal is_ended_by_it(SIGBUS);
#endif

TEST_F(MappedFileDeathTest, ABusErrorElsewhereStillEndsTheProgram) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        const auto mapped = map(file);
        fs::remove(file);  // this program is another, with a file of its own, and does not come to its end
        ::raise(SIGBUS);
        ::raise(SIGBUS);
      },
      is_ended_by_it, "");
}

}  // namespace
}  // namespace abrazo::mapped_file_test
