#include "core/base/utf8.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/limits.hpp"

namespace abrazo::utf8_test {
namespace {

TEST(Utf8, NamesTheFirstByteThatIsNone) {
  EXPECT_EQ(first_broken_byte(""), std::nullopt);
  EXPECT_EQ(first_broken_byte("Übung \xF0\x9F\x92\x83"), std::nullopt);
  EXPECT_EQ(first_broken_byte("caf\xE9"), 3U) << "Latin-1";
  EXPECT_EQ(first_broken_byte("\xED\xA0\x80"), 0U) << "half of a surrogate pair";
  EXPECT_EQ(first_broken_byte("/\xC0\xAF"), 1U) << "longer than it needs to be";
}

/// Against nlohmann's reader, which refuses what is not UTF-8.
TEST(Utf8, IsWhatJsonTakesForText) {
  const std::vector<int> bytes = {0x41, 0x7F, 0x80, 0x8F, 0x90, 0x9F, 0xA0, 0xBF, 0xC0, 0xC1, 0xC2, 0xDF,
                                  0xE0, 0xE1, 0xEC, 0xED, 0xEE, 0xEF, 0xF0, 0xF1, 0xF3, 0xF4, 0xF5, 0xFF};
  std::vector<std::string> texts = {""};
  for (int length = 1; length <= 4; ++length) {
    std::vector<std::string> longer;
    for (const std::string& text : texts)
      for (const int byte : bytes) longer.push_back(text + static_cast<char>(byte));
    texts = length < 4 ? longer : texts;
    for (const std::string& text : longer)
      ASSERT_EQ(!first_broken_byte(text), nlohmann::json::accept('"' + text + '"'))
          << testing::PrintToString(text);
  }
}

TEST(JsonBounds, AreKeptBeforeAnythingIsParsed) {
  const auto said = [](const std::string& json) {
    const char* why = json_beyond_bounds(json);
    return std::string(why ? why : "");
  };
  EXPECT_EQ(said(std::string(limits::json_depth, '[') + std::string(limits::json_depth, ']')), "");
  EXPECT_THAT(said(std::string(limits::json_depth + 1, '[')), testing::HasSubstr("100 deep"));
  EXPECT_EQ(said("\"" + std::string(101, '[') + "\""), "");
  EXPECT_THAT(said("\"a\\\"\"" + std::string(101, '[')), testing::HasSubstr("100 deep"));
  // One in the brackets, one behind each comma.
  EXPECT_EQ(said("[" + std::string(limits::json_values - 1, ',') + "]"), "");
  EXPECT_THAT(said("[" + std::string(limits::json_values, ',') + "]"),
              testing::HasSubstr("6 million values"));
  EXPECT_EQ(said("\"" + std::string(limits::json_values + 1, ',') + "\""), "");
}

}  // namespace
}  // namespace abrazo::utf8_test
