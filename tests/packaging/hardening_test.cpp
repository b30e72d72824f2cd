// What `hardening-check` of Debian's devscripts wants, asked of binutils, which every machine that builds
// has.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <string_view>

#include "tests/cli/run_command.hpp"
#include "tests/packaging/installed_files.hpp"

namespace abrazo::test::hardening_test {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

/// Programs, modules and plugins that are installed.
std::vector<fs::path> binaries() {
  std::vector<fs::path> found;
  for (const fs::path& file : installed_files())
    if (content_of(file).starts_with("\x7f"
                                     "ELF"))
      found.push_back(file);
  return found;
}

std::string told_by_readelf(const std::vector<std::string>& options, const fs::path& file) {
  std::vector<std::string> words = {program_at("readelf")};
  words.insert(words.end(), options.begin(), options.end());
  words.push_back(file.string());
  return RunningCommand(words, fs::temp_directory_path()).wait().out;
}

class Hardening : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!ABRAZO_OPTIMISED) GTEST_SKIP() << "only optimised programs have these guards";
    if (program_at("readelf").empty()) GTEST_SKIP() << "needs readelf";
    ASSERT_GE(binaries().size(), 3U);
  }
};

TEST_F(Hardening, WhatIsInstalledIsAtNoFixedPlace) {
  for (const fs::path& file : binaries())
    EXPECT_THAT(told_by_readelf({"-hW"}, file), ContainsRegex("Type: +DYN")) << file;
}

TEST_F(Hardening, ItsRelocationsAreResolvedAtTheStartAndReadOnlyThen) {
  for (const fs::path& file : binaries()) {
    const std::string segments = told_by_readelf({"-lW"}, file);
    EXPECT_THAT(segments, HasSubstr("GNU_RELRO")) << file;
    EXPECT_THAT(segments, ContainsRegex("GNU_STACK .* RW ")) << file << " may run code on its stack";
    EXPECT_THAT(told_by_readelf({"-dW"}, file), HasSubstr("NOW")) << file;
  }
}

TEST_F(Hardening, ItsFunctionsGuardTheirStack) {
  for (const fs::path& file : binaries())
    EXPECT_THAT(told_by_readelf({"--dyn-syms", "-W"}, file), HasSubstr("__stack_chk_fail")) << file;
}

/// Functions of the C library that check their bounds, such as __memcpy_chk. __stack_chk_fail is none.
std::size_t checked_functions(const std::string& symbols) {
  static const std::regex checked(R"(\b__(?!stack_)\w+_chk\b)");
  return static_cast<std::size_t>(
      std::distance(std::sregex_iterator(symbols.begin(), symbols.end(), checked), std::sregex_iterator()));
}

TEST_F(Hardening, ItsCopiesAndPrintsCheckTheirBounds) {
  EXPECT_EQ(checked_functions("__stack_chk_fail@GLIBC_2.4 memcpy@GLIBC_2.14"), 0U);
  for (const fs::path& file : binaries()) {
    // Its only copies are those inside std::string and std::vector, which have no checked form.
    if (file.filename() == "libabrazo-video.so") continue;
    EXPECT_GT(checked_functions(told_by_readelf({"--dyn-syms", "-W"}, file)), 0U) << file;
  }
}

TEST_F(Hardening, EverySourceOfWhatIsInstalledIsCompiledWithAllGuards) {
  const auto commands =
      nlohmann::json::parse(content_of(fs::path(ABRAZO_BUILD_DIR) / "compile_commands.json"));
  static const std::regex shipped(R"( -o (core|widgets|app/(cli|render|workbench|python|scene_reader))/)");
  std::size_t count = 0;
  for (const auto& entry : commands) {
    const auto command = entry.at("command").get<std::string>();
    if (!std::regex_search(command, shipped)) continue;
    ++count;
    for (const char* guard : {"-fstack-protector-strong", "-D_FORTIFY_SOURCE=2", "-fstack-clash-protection"})
      EXPECT_THAT(command, HasSubstr(guard)) << entry.at("file");
  }
  EXPECT_GT(count, 10U);
}

#ifdef __x86_64__
/// How often these bytes stand in a program's code and data.
std::size_t count_of(std::string_view bytes, const std::string& content) {
  std::size_t count = 0;
  for (auto at = content.find(bytes); at != std::string::npos; at = content.find(bytes, at + bytes.size()))
    ++count;
  return count;
}

TEST_F(Hardening, ItsIndirectCallsLandOnlyWhereFunctionsBegin) {
  constexpr std::string_view endbr64 = "\xf3\x0f\x1e\xfa";
  for (const fs::path& file : binaries()) EXPECT_GT(count_of(endbr64, content_of(file)), 20U) << file;
}

TEST_F(Hardening, ALargeFrameTouchesEveryPageOfItsStack) {
  constexpr std::string_view or_zero_to_stack("\x48\x83\x0c\x24\x00", 5);
  std::size_t large = 0;
  for (const fs::path& file : binaries()) {
    if (fs::file_size(file) < (4U << 20U)) continue;
    ++large;
    EXPECT_GT(count_of(or_zero_to_stack, content_of(file)), 0U) << file;
  }
  EXPECT_GT(large, 0U);
}
#endif

}  // namespace
}  // namespace abrazo::test::hardening_test
