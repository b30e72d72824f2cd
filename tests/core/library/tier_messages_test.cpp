#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "core/base/atomic_file.hpp"
#include "core/library/takes/tier_file.hpp"

namespace abrazo::tier_messages_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* fixtures = ABRAZO_FIXTURES "/labels";
constexpr const char* guide = ABRAZO_FIXTURES "/../../docs/guide/labels.md";

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

TEST(TierMessages, OfEveryBrokenFileStandInTheGuide) {
  const auto text = read_whole_file(guide);
  ASSERT_TRUE(text) << text.error().text();
  const std::set<std::string> all = rows();
  EXPECT_GE(all.size(), 50u);
  std::string missing;
  for (const std::string& row : all)
    if (text->find(row + "\n") == std::string::npos) missing += row + "\n";
  EXPECT_EQ(missing, "") << "put these into " << guide;
}

TEST(TierMessages, SayWhatAndWhereInOneLine) {
  for (const std::string& row : rows()) {
    EXPECT_EQ(row.find('\n'), std::string::npos) << row;
    EXPECT_LT(row.size(), 300u) << row;
  }
}

}  // namespace
}  // namespace abrazo::tier_messages_test
