#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>

#include "core/base/atomic_file.hpp"
#include "core/library/takes/tier_file.hpp"

namespace abrazo::tier_messages_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* fixtures = ABRAZO_FIXTURES "/labels";
constexpr const char* table = ABRAZO_FIXTURES "/label_messages.md";

/// "| `overlap.eaf` | tier 'move': ... |" for each broken file, with the place as it stands beside the name.
std::set<std::string> rows() {
  std::set<std::string> rows;
  for (const fs::directory_entry& entry : fs::directory_iterator(fixtures)) {
    const std::string name = entry.path().filename().string();
    const auto document = read_tiers(entry.path(), {});
    if (document) {
      ADD_FAILURE() << name << " is read, though it is broken";
      continue;
    }
    std::string text = document.error().text();
    if (const auto folder = text.find(fixtures); folder != std::string::npos)
      text.erase(folder, std::string(fixtures).size() + 1);
    rows.insert("| `" + name + "` | " + text + " |");
  }
  return rows;
}

TEST(TierMessages, OfEveryBrokenFileStandInTheirTable) {
  std::string text = "# Broken label files and their messages\n\n| file | message |\n|---|---|\n";
  for (const std::string& row : rows()) text += row + "\n";
  if (std::getenv("ABRAZO_UPDATE_GOLDEN")) {
    ASSERT_TRUE(write_whole_file(table, text));
  }
  EXPECT_EQ(text, read_whole_file(table).value());
}

TEST(TierMessages, SayWhatAndWhereInOneLine) {
  for (const std::string& row : rows()) {
    EXPECT_EQ(row.find('\n'), std::string::npos) << row;
    EXPECT_LT(row.size(), 300u) << row;
  }
}

}  // namespace
}  // namespace abrazo::tier_messages_test
