#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo::fuzz {

using Bytes = std::span<const std::uint8_t>;

inline std::string_view text_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// What must hold whatever the bytes are. @throws std::logic_error, which no target catches
void expect(bool holds, const std::string& what);

/// An Error that a person can use: it says something, of bounded length, and nothing in it steers a terminal.
void expect_readable(const Error& error);

template <typename T>
bool accepted(const Result<T>& result) {
  if (!result) expect_readable(result.error());
  return result.ok();
}

/// Each is read further as an import does; what comes out is finite and complete.
void expect_motions(const Result<std::vector<NamedMotion>>& motions);

/// The bytes as a file of this process in memory, for readers that take a path; gone afterwards.
class ScratchFile {
 public:
  ScratchFile(std::string_view name, Bytes bytes);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Packets of a stream as an input holds them: two bytes length (little-endian), one of milliseconds since
/// the one before, then so many bytes; the last may be cut short.
void each_packet(Bytes bytes, const std::function<void(Bytes packet, double elapsed_s)>& take);
void add_packet(std::vector<std::uint8_t>& stream, Bytes packet, std::uint8_t elapsed_ms);

/// A parser as libFuzzer and the test of the kept inputs run it.
struct Target {
  std::string_view name;
  void (*read)(Bytes bytes);
};
std::vector<Target>& targets();
bool register_target(std::string_view name, void (*read)(Bytes bytes));

}  // namespace abrazo::fuzz

/// ABRAZO_FUZZ_TARGET(bvh)(abrazo::fuzz::Bytes bytes) { ... }: the entry of a program of its own where
/// libFuzzer drives it, one of many in the test.
#ifdef ABRAZO_LIBFUZZER
#define ABRAZO_FUZZ_TARGET(name)                                                   \
  static void name##_target(abrazo::fuzz::Bytes bytes);                            \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t n) { \
    name##_target({data, n});                                                      \
    return 0;                                                                      \
  }                                                                                \
  static void name##_target
#else
#define ABRAZO_FUZZ_TARGET(name)                                                                            \
  static void name##_target(abrazo::fuzz::Bytes bytes);                                                     \
  [[maybe_unused]] static const bool name##_is_known = abrazo::fuzz::register_target(#name, name##_target); \
  static void name##_target
#endif
