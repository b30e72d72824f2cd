#include "tests/fuzz/fuzz_target.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "core/motion/files/import_clip.hpp"
#include "core/motion/joints/marker_gaps.hpp"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
/// Assimp and HDF5 do not free all that they have read when they refuse a file, nor Qt what a key twice in
/// JSON had at first: at most as much as the file.
extern "C" const char* __lsan_default_suppressions() {  // NOLINT(bugprone-reserved-identifier)
  return "leak:libassimp\nleak:libhdf5\nleak:libQt5Core\n";
}
/// HDF5 1.10 copies a few bytes from behind an attribute whose parts claim more than it has (H5A__open).
extern "C" const char* __asan_default_suppressions() {  // NOLINT(bugprone-reserved-identifier)
  return "interceptor_via_lib:libhdf5\n";
}
/// What HDF5 is refused it reports, such as a header that claims gigabytes; where ours asks for as much, the
/// run ends.
extern "C" const char* __asan_default_options() {  // NOLINT(bugprone-reserved-identifier)
  return "allocator_may_return_null=1:max_allocation_size_mb=1024";
}
#endif
#endif

namespace abrazo::fuzz {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_message = 20'000;

/// Control characters that do something to a terminal; line ends stand in lists.
bool steers_terminal(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7f;
  });
}

fs::path memory_folder() {
  std::error_code failure;
  return fs::is_directory("/dev/shm", failure) ? fs::path("/dev/shm") : fs::temp_directory_path();
}

}  // namespace

void expect(bool holds, const std::string& what) {
  if (!holds) throw std::logic_error(what);
}

void expect_readable(const Error& error) {
  expect(!error.message.empty(), "an error without a message, at '" + error.where + "'");
  expect(error.message.size() < longest_message, "an error of " + std::to_string(error.message.size()) +
                                                     " characters: " + error.message.substr(0, 200));
  expect(!steers_terminal(error.text()), "control characters in an error: " + error.text());
}

void expect_motions(const Result<std::vector<NamedMotion>>& motions) {
  if (!accepted(motions)) return;
  expect(!motions->empty(), "read, but there is no motion");
  for (NamedMotion motion : *motions) {
    expect(motion.parents.size() == motion.points.size(), "points without parents");
    for (std::size_t p = 0; p < motion.parents.size(); ++p)
      expect(motion.parents[p] < static_cast<int>(motion.points.size()) && motion.parents[p] >= -1,
             "a parent that is not there");
    for (const Positions& frame : motion.frames)
      expect(frame.rows() == static_cast<Eigen::Index>(motion.points.size()), "a frame of another size");
    fill_gaps(motion);
    const Result<ImportedClip> clip = import_clip(motion, {});
    if (!accepted(clip)) continue;
    for (const Pose& pose : clip->clip.poses) expect(pose.allFinite(), "an imported pose is not finite");
    expect(clip->clip.fps > 0, "imported without a rate");
  }
}

ScratchFile::ScratchFile(std::string_view name, Bytes bytes)
    : path_(memory_folder() / ("abrazo-fuzz-" + std::to_string(getpid()) + "-" + std::string(name))) {
  std::ofstream file(path_, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  expect(static_cast<bool>(file.flush()), "cannot write " + path_.string());
}

ScratchFile::~ScratchFile() {
  std::error_code ignored;
  for (const char* beside : {"", "-wal", "-shm", "-journal"}) fs::remove(path_.string() + beside, ignored);
}

void each_packet(Bytes bytes, const std::function<void(Bytes, double)>& take) {
  while (bytes.size() >= 3) {
    const std::size_t wanted = bytes[0] + 256U * bytes[1];
    const double elapsed_s = bytes[2] * 1e-3;
    bytes = bytes.subspan(3);
    const std::size_t size = std::min(wanted, bytes.size());
    take(bytes.first(size), elapsed_s);
    bytes = bytes.subspan(size);
  }
}

void add_packet(std::vector<std::uint8_t>& stream, Bytes packet, std::uint8_t elapsed_ms) {
  stream.push_back(static_cast<std::uint8_t>(packet.size() & 0xffU));
  stream.push_back(static_cast<std::uint8_t>(packet.size() >> 8U));
  stream.push_back(elapsed_ms);
  stream.insert(stream.end(), packet.begin(), packet.end());
}

std::vector<Target>& targets() {
  static std::vector<Target> all;
  return all;
}

bool register_target(std::string_view name, void (*read)(Bytes)) {
  targets().push_back({name, read});
  return true;
}

}  // namespace abrazo::fuzz
