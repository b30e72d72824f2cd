#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "core/motion/files/import_clip.hpp"
#include "tests/core/motion/motion_fixtures.hpp"

namespace abrazo::broken_motion_test {
namespace {

namespace fs = std::filesystem;

std::string with(std::string text, const std::string& what, const std::string& by) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

/// One cell of a table: long lists of points are cut, bars would end the cell.
std::string cell(std::string text) {
  if (const auto points = text.find(" The file's points: "); points != std::string::npos) text.resize(points);
  text = with(text, "|", "\\|");
  return text.size() > 400 ? text.substr(0, 400) + "..." : text;
}

/// The broken files with their messages.
std::string page_of_broken_files() {
  std::string page =
      "# Broken motion files and their messages\n\n"
      "The files are in `tests/fixtures/motion/broken/`. A test reads each of them and compares the messages "
      "with this page (`ABRAZO_UPDATE_GOLDEN=1` regenerates the page). \"read\" means: read as far as "
      "possible, with these warnings.\n\n"
      "| file | message |\n|---|---|\n";
  const fs::path folder = test::motion_fixture("broken");
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    const auto clips = load_motion(file.string(), "", {});
    std::string message;
    if (clips) {
      message = "read";
      for (const ImportWarning& warning : clips->front().report.warnings)
        message += "; " + warning.kind +
                   (warning.line > 0 ? " (line " + std::to_string(warning.line) + ")" : "") + ": " +
                   warning.detail;
    } else {
      message = with(clips.error().text(), folder.string() + "/", "");
    }
    page += "| `" + file.filename().string() + "` | " + cell(message) + " |\n";
  }
  return page;
}

TEST(BrokenMotions, GetTheMessagesOfTheirTable) {
  const fs::path table = test::motion_fixture("broken_messages.md");
  const std::string page = page_of_broken_files();
  if (std::getenv("ABRAZO_UPDATE_GOLDEN")) {
    ASSERT_TRUE(write_whole_file(table, page));
  }
  EXPECT_EQ(page, read_whole_file(table).value());
}

TEST(BrokenMotions, AreAllRefusedOrReadWithAWarning) {
  for (const fs::directory_entry& entry : fs::directory_iterator(test::motion_fixture("broken"))) {
    const auto clips = load_motion(entry.path().string(), "", {});
    if (!clips)
      EXPECT_THAT(clips.error().where, ::testing::HasSubstr(entry.path().filename().string()));
    else
      EXPECT_FALSE(clips->front().report.warnings.empty()) << entry.path();
  }
}

}  // namespace
}  // namespace abrazo::broken_motion_test
