#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "core/base/text.hpp"
#include "tests/cli/run_command.hpp"
#include "tests/packaging/installed_files.hpp"

namespace abrazo::test::manual_test {
namespace {

using ::testing::HasSubstr;

std::string manual(const std::string& program) {
  return content_of(installed("share/man/man1/" + program + ".1"));
}

std::string help(const std::string& program, const std::string& command = "") {
  std::istringstream in(command);
  std::vector<std::string> words = {installed("bin/" + program).string()};
  words.insert(words.end(), std::istream_iterator<std::string>(in), {});
  words.emplace_back("--help");
  return RunningCommand(words, std::filesystem::temp_directory_path()).wait().out;
}

/// "-o,--output" and "MANIFEST" of a text of --help, of the group `only` or of all groups but that of the
/// commands.
std::vector<std::string> names_in(const std::string& text, const std::string& only) {
  std::vector<std::string> names;
  std::string group;
  for (const std::string_view line : split_lines(text)) {
    if (!line.empty() && line.front() != ' ') group = line;
    if (line.size() < 3 || !line.starts_with("  ") || line[2] == ' ') continue;
    if (only.empty() ? group == "Subcommands:" : group != only) continue;
    const std::string_view rest = line.substr(2);
    names.emplace_back(rest.substr(0, rest.find(' ')));
  }
  return names;
}

/// The part of a page below a heading, up to the next one of its kind.
std::string part(const std::string& page, const std::string& heading) {
  const std::size_t begin = page.find(heading + "\n");
  if (begin == std::string::npos) return {};
  const std::size_t end = page.find("\n.S", begin + 1);
  return page.substr(begin, end == std::string::npos ? end : end - begin);
}

std::string in_roff(const std::string& words) {
  return std::regex_replace(words, std::regex("-"), "\\-");
}

void expect_options_of(const std::string& program, const std::string& command, const std::string& page) {
  const std::string words = command.empty() ? program : program + " " + command;
  const std::string section =
      command.empty() ? part(page, ".SH OPTIONS") : part(page, ".SS " + in_roff(words));
  ASSERT_FALSE(section.empty()) << words << " has no section";
  const std::string settings = part(page, ".SH SETTINGS");
  for (const std::string& name : names_in(help(program, command), "")) {
    if (name == "-h,--help" && !command.empty()) continue;  // said once
    const std::string entry = "\n.B " + in_roff(name);
    const bool is_there =
        section.find(entry) != std::string::npos ||
        (section.find("SETTINGS") != std::string::npos && settings.find(entry) != std::string::npos);
    EXPECT_TRUE(is_there) << words << " " << name;
  }
  for (const std::string& below : names_in(help(program, command), "Subcommands:"))
    expect_options_of(program, command.empty() ? below : command + " " + below, page);
}

TEST(Manual, HasEveryCommandAndOptionThatTheCommandLineTells) {
  const std::string page = manual("abrazo");
  expect_options_of("abrazo", "", page);
  EXPECT_THAT(page, HasSubstr(".SS abrazo library build\n"));
  EXPECT_THAT(page, HasSubstr(in_roff("\n.B --velocity-weight NUMBER")));
}

TEST(Manual, HasEveryOptionOfTheOtherPrograms) {
  if (!ABRAZO_HAS_WORKBENCH) GTEST_SKIP() << "built without the workbench";
  for (const char* program : {"abrazo-render", "abrazo-workbench"})
    expect_options_of(program, "", manual(program));
}

TEST(Manual, IsReadWithoutAWarning) {
  const std::string groff = program_at("groff"), man = program_at("man");
  if (groff.empty() || man.empty()) GTEST_SKIP() << "groff and man are not installed";
  for (const auto& page : installed_files("share/man/man1")) {
    const Outcome read =
        RunningCommand({man, "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", page.string()},
                       std::filesystem::temp_directory_path())
            .wait();
    EXPECT_EQ(read.status, 0);
    EXPECT_EQ(read.err, "") << page;
  }
}

}  // namespace
}  // namespace abrazo::test::manual_test
