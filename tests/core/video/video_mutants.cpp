// Damages small videos of every container that is read, opens each in a process with limits, and counts what
// happens:  video_mutants [SECONDS] [SEED], or FILE... as they are. What ends the process by a signal is kept
// in the folder of temporary files.
#include <fmt/core.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "core/base/atomic_file.hpp"
#include "core/video/video_reader.hpp"
#include "tests/core/video/coded_video.hpp"

namespace {

namespace fs = std::filesystem;
using Random = std::mt19937;

constexpr rlim_t memory_bytes = rlim_t{4} << 30U, processor_s = 20;
enum Outcome { Opened = 10, Refused = 11 };

struct Seed {
  std::string extension, bytes;
};

struct Tally {
  int opened = 0, refused = 0, out_of_time = 0, broken = 0;
  long most_kb = 0;
  double most_s = 0;
};

std::string raw_video() {
  std::string bytes = "YUV4MPEG2 W64 H48 F25:1 Ip A1:1 C420\n";
  for (int i = 0; i < 6; ++i) bytes += "FRAME\n" + std::string(64 * 48 * 3 / 2, static_cast<char>(40 * i));
  return bytes;
}

std::vector<Seed> seeds(const fs::path& folder) {
  const std::vector<std::array<std::string, 2>> wanted = {
      {"mp4", "mp4v"}, {"mov", "MJPG"}, {"mkv", "mp4v"},   {"webm", "VP80"}, {"avi", "MJPG"},
      {"avi", "XVID"}, {"mpg", "PIM1"}, {"wmv", "WMV2"},   {"flv", "FLV1"},  {"ogv", "THEO"},
      {"mxf", "MPG2"}, {"m2v", "MPG2"}, {"mjpeg", "MJPG"}, {"ts", "MPG2"}};
  std::vector<Seed> all = {{"y4m", raw_video()}};
  for (const auto& [extension, fourcc] : wanted) {
    const fs::path file = folder / ("seed." + extension);
    if (abrazo::test::write_coded_video(file, fourcc, 12, 25, {176, 144}) &&
        abrazo::VideoReader::open(file, {}))
      all.push_back({extension, *abrazo::read_whole_file(file)});
    else
      fmt::print("no .{} of {} here\n", extension, fourcc);
  }
  return all;
}

std::string damaged(std::string bytes, const std::vector<Seed>& all, Random& random) {
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  constexpr std::array<std::uint32_t, 9> numbers = {0,      1,          0x7f,       0xff,      0x7fff,
                                                    0xffff, 0x7fffffff, 0x80000000, 0xffffffff};
  const std::size_t changes = 1 + below(12);
  for (std::size_t i = 0; i < changes && bytes.size() > 64; ++i) {
    // Most of what decides stands at either end.
    const std::size_t reach = below(3) == 0 ? bytes.size() : std::min<std::size_t>(bytes.size(), 1500);
    const std::size_t from = below(2) == 0 ? below(reach) : bytes.size() - 1 - below(reach);
    const std::size_t count = std::min(bytes.size() - from, 1 + below(200));
    switch (below(7)) {
      case 0:
        bytes[from] = static_cast<char>(below(256));
        break;
      case 1:
        bytes[from] = static_cast<char>(bytes[from] ^ (1 << below(8)));
        break;
      case 2:
      case 3: {
        const std::uint32_t number = numbers[below(numbers.size())];
        const bool is_big = below(2) == 0;
        for (std::size_t b = 0; b < 4 && from + b < bytes.size(); ++b)
          bytes[from + b] = static_cast<char>(number >> (8 * (is_big ? 3 - b : b)));
        break;
      }
      case 4:
        bytes.erase(from, count);
        break;
      case 5:
        bytes.insert(from, bytes.substr(from, count));
        break;
      default: {
        const std::string& other = all[below(all.size())].bytes;
        const std::size_t at = below(other.size());
        bytes.replace(from, count, other.substr(at, count));
      }
    }
  }
  return bytes;
}

[[noreturn]] void open_video(const fs::path& file) {
  const rlimit memory{memory_bytes, memory_bytes}, time{processor_s, processor_s}, none{0, 0};
  ::setrlimit(RLIMIT_AS, &memory);
  ::setrlimit(RLIMIT_CPU, &time);
  ::setrlimit(RLIMIT_CORE, &none);
  ::alarm(3 * processor_s);
  auto reader = abrazo::VideoReader::open(file, {});
  if (!reader) ::_exit(Refused);
  for (const int index : {0, reader->facts().frames() - 1, reader->facts().frames() / 2})
    (void)reader->frame(index);
  ::_exit(Opened);
}

/// Whether the process ended by a signal that no limit sends.
bool tell(const fs::path& file, Tally& tally) {
  const auto begin = std::chrono::steady_clock::now();
  const pid_t child = ::fork();
  if (child == 0) open_video(file);
  int status = 0;
  rusage used{};
  ::wait4(child, &status, 0, &used);
  tally.most_kb = std::max(tally.most_kb, used.ru_maxrss);
  tally.most_s =
      std::max(tally.most_s, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  if (WIFEXITED(status) && WEXITSTATUS(status) == Opened) return ++tally.opened, false;
  if (WIFEXITED(status) && WEXITSTATUS(status) == Refused) return ++tally.refused, false;
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGALRM))
    return ++tally.out_of_time, true;
  return ++tally.broken, true;
}

}  // namespace

int main(int count, char** words) {
  Tally given;
  for (int i = 1; i < count && fs::exists(words[i]); ++i) {
    tell(words[i], given);
    fmt::print("{}: {} opened, {} refused, {} out of time, {} broken so far; at most {} MB, {:.1f} s\n",
               words[i], given.opened, given.refused, given.out_of_time, given.broken, given.most_kb / 1024,
               given.most_s);
    if (i + 1 == count) return given.out_of_time + given.broken > 0 ? 1 : 0;
  }
  const double seconds = count > 1 ? std::atof(words[1]) : 60;
  Random random(count > 2 ? static_cast<unsigned>(std::atoi(words[2])) : 1);
  const fs::path folder = fs::temp_directory_path() / ("video_mutants_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const std::vector<Seed> all = seeds(folder);
  std::map<std::string, Tally> tallies;
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  int kept = 0;
  while (std::chrono::steady_clock::now() < end)
    for (const Seed& seed : all) {
      const fs::path file = folder / ("mutant." + seed.extension);
      if (!abrazo::write_whole_file(file, damaged(seed.bytes, all, random))) return 2;
      if (tell(file, tallies[seed.extension]))
        fs::copy_file(file, folder / fmt::format("broken-{}.{}", ++kept, seed.extension));
      fs::remove(file);
    }
  fmt::print("{:8}{:>9}{:>9}{:>13}{:>9}{:>11}{:>9}\n", "", "opened", "refused", "out of time", "broken",
             "most MB", "most s");
  for (const auto& [extension, t] : tallies)
    fmt::print("{:8}{:>9}{:>9}{:>13}{:>9}{:>11}{:>9.1f}\n", extension, t.opened, t.refused, t.out_of_time,
               t.broken, t.most_kb / 1024, t.most_s);
  if (kept > 0)
    fmt::print("{} are in {}\n", kept, folder.string());
  else
    fs::remove_all(folder);
  return kept > 0 ? 1 : 0;
}
