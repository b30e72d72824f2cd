// What `hardening-check` of Debian's devscripts wants, asked of binutils, which every machine that builds
// has.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST_F(Hardening, ItsFunctionsGuardTheirStackAndTheirCopies) {
  for (const fs::path& file : binaries()) {
    const std::string symbols = told_by_readelf({"--dyn-syms", "-W"}, file);
    EXPECT_THAT(symbols, HasSubstr("__stack_chk_fail")) << file;
    EXPECT_THAT(symbols, ContainsRegex("__[a-z]+_chk")) << file;
  }
}

}  // namespace
}  // namespace abrazo::test::hardening_test
