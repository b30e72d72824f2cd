#include "tests/cli/command_line_fixture.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "core/base/text.hpp"

namespace abrazo::test {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

namespace {

/// The lines of stderr but for remarks that stop nothing.
std::vector<std::string> sentences_of(const std::string& errors) {
  std::vector<std::string> sentences;
  for (const std::string_view line : split_lines(errors))
    if (!line.empty() && !line.starts_with("abrazo: warning: ")) sentences.emplace_back(line);
  return sentences;
}

}  // namespace

CommandLineTest::CommandLineTest() {
  std::string name = (fs::temp_directory_path() / "abrazo-cli-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder can be made");
  folder_ = name;
}

CommandLineTest::~CommandLineTest() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

Outcome CommandLineTest::run(const std::string& line) const {
  std::istringstream in(line);
  return run(std::vector<std::string>(std::istream_iterator<std::string>(in), {}));
}

void CommandLineTest::write(const std::string& name, const std::string& content) const {
  std::ofstream(path(name), std::ios::binary) << content;
}

std::string CommandLineTest::read(const std::string& name) const {
  std::ifstream in(path(name), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::vector<std::string> CommandLineTest::names() const {
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(folder_)) all.push_back(entry.path().filename().string());
  std::sort(all.begin(), all.end());
  return all;
}

void CommandLineTest::make_demo(const std::string& minutes) const {
  ASSERT_EQ(run("demo -o demo --seed 3 --minutes " + minutes).status, 0);
}

void CommandLineTest::make_library() const {
  make_demo();
  ASSERT_EQ(run("library build demo/manifest.json -o demo.h5").status, 0);
}

void CommandLineTest::expect_failure(const Outcome& outcome, const std::string& part) {
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, IsEmpty());
  const std::vector<std::string> sentences = sentences_of(outcome.err);
  ASSERT_THAT(sentences, ::testing::SizeIs(1)) << outcome.err;
  EXPECT_THAT(sentences[0], AllOf(StartsWith("abrazo: "), HasSubstr(part)));
}

void CommandLineTest::expect_wrong_usage(const Outcome& outcome, const std::string& part) {
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.out, IsEmpty());
  const std::vector<std::string> sentences = sentences_of(outcome.err);
  ASSERT_THAT(sentences, ::testing::SizeIs(1)) << outcome.err;
  EXPECT_THAT(sentences[0], AllOf(StartsWith("abrazo: "), HasSubstr(part), EndsWith("--help")));
}

const std::string CommandLineTest::hostile_name =
    "name\x1b[2J\x7f\xC2\x9B"
    "31m\nFORGED";

void CommandLineTest::expect_harmless(const std::string& text) {
  EXPECT_THAT(text, HasSubstr("name?[2J??31m?FORGED"));
  for (const char c : text) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 || c == '\n') << text;
  EXPECT_THAT(text, AllOf(Not(HasSubstr("\x7f")), Not(HasSubstr("\xC2\x9B")), Not(HasSubstr("\nFORGED"))));
}

double Table::at(std::size_t row, const std::string& column) const {
  const auto found = std::find(columns.begin(), columns.end(), column);
  if (found == columns.end()) throw std::out_of_range("no column " + column);
  return rows.at(row).at(static_cast<std::size_t>(found - columns.begin()));
}

Table parse_table(const std::string& csv) {
  Table table;
  for (const std::string_view line : split_lines(csv)) {
    if (line.empty()) continue;
    const auto fields = split_fields(line, ',');
    if (table.columns.empty()) {
      table.columns.assign(fields.begin(), fields.end());
      continue;
    }
    std::vector<double>& row = table.rows.emplace_back();
    for (const std::string_view field : fields) row.push_back(parse_number(field).value());
  }
  return table;
}

std::vector<nlohmann::json> parse_lines(const std::string& json_lines) {
  std::vector<nlohmann::json> objects;
  for (const std::string_view line : split_lines(json_lines))
    if (!line.empty()) objects.push_back(nlohmann::json::parse(line));
  return objects;
}

}  // namespace abrazo::test
