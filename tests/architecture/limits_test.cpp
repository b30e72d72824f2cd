// SECURITY.md has the limits of core/base/limits.hpp, and tests try them.
#include "core/base/limits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include "tests/architecture/source_tree.hpp"

namespace abrazo::test::limits_test {
namespace {

/// As the page writes a number: 8000, 10 000.
std::string with_spaces(std::uint64_t number) {
  std::string digits = std::to_string(number);
  if (digits.size() > 4)
    for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, " ");
  return digits;
}

struct Limit {
  std::string name, words;
};

const std::vector<Limit>& limits_of_the_page() {
  using namespace limits;
  static const std::vector<Limit> all = {
      {"whole_file_bytes", with_spaces(whole_file_bytes >> 30U) + " GiB"},
      {"line_bytes", with_spaces(line_bytes) + " bytes"},
      {"json_depth", with_spaces(json_depth) + " brackets"},
      {"json_values", with_spaces(json_values / 1'000'000) + " million values"},
      {"settings_bytes", "settings " + with_spaces(settings_bytes >> 20U) + " MiB"},
      {"session_row_bytes", with_spaces(session_row_bytes >> 20U) + " MiB a row"},
      {"numpy_numbers", with_spaces(numpy_numbers / 1'000'000) + " million numbers"},
      {"numpy_texts", with_spaces(numpy_texts) + " texts"},
      {"npy_file_bytes", with_spaces(npy_file_bytes >> 20U) + " MiB as doubles"},
      {"archive_entries", with_spaces(archive_entries) + " entries"},
      {"deflate_ratio", with_spaces(deflate_ratio) + " times"},
      {"body_vertices", with_spaces(body_vertices) + " vertices"},
      {"body_shapes", with_spaces(body_shapes) + " shapes"},
      {"character_primitives", with_spaces(character_primitives) + " primitives"},
      {"video_pixels", "8192 x 8192 pixels"}};
  static_assert(video_pixels == 8192.0 * 8192.0);
  return all;
}

std::string content_of(const std::string& path) {
  static const std::vector<SourceFile> tree = read_source_tree(ABRAZO_SOURCE_DIR);
  std::string text;
  for (const SourceFile& file : tree)
    if (path.ends_with('/') ? file.path.starts_with(path) : file.path == path)
      for (const std::string& line : file.lines) text += line + "\n";
  return text;
}

TEST(Limits, AreAllOnThePageAndTried) {
  const std::string page = content_of("SECURITY.md"), tests = content_of("tests/core/");
  for (const Limit& limit : limits_of_the_page()) {
    EXPECT_THAT(page, testing::HasSubstr(limit.words)) << limit.name;
    EXPECT_THAT(tests, testing::HasSubstr("limits::" + limit.name));
  }
}

TEST(Limits, NoneIsMissingAbove) {
  const std::string header = content_of("core/base/limits.hpp");
  std::vector<std::string> named, listed;
  const std::regex name("(\\w+) = ");
  for (std::sregex_iterator found(header.begin(), header.end(), name), end; found != end; ++found)
    named.push_back((*found)[1]);
  for (const Limit& limit : limits_of_the_page()) listed.push_back(limit.name);
  EXPECT_THAT(listed, testing::UnorderedElementsAreArray(named));
}

}  // namespace
}  // namespace abrazo::test::limits_test
