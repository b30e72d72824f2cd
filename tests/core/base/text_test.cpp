#include "core/base/text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>
#include <random>

namespace abrazo::text_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Text, TrimsBlanksAndCarriageReturnsAtBothEnds) {
  EXPECT_EQ(trimmed(" \t a b \r\n"), "a b");
  EXPECT_EQ(trimmed(" \r\n"), "");
  EXPECT_EQ(trimmed(""), "");
}

TEST(Text, SplitsWordsAtRunsOfBlanks) {
  EXPECT_THAT(split_words("  one\t two   three\r"), ElementsAre("one", "two", "three"));
  EXPECT_THAT(split_words(" \t "), IsEmpty());
}

TEST(Text, KeepsEmptyFields) {
  EXPECT_THAT(split_fields("a, b,,c ", ','), ElementsAre("a", "b", "", "c"));
  EXPECT_THAT(split_fields("", ','), ElementsAre(""));
  EXPECT_THAT(split_fields(",", ','), ElementsAre("", ""));
}

TEST(Text, SplitsLinesWhateverEndsThem) {
  for (const char* text : {"a\nb\n\nc", "a\r\nb\r\n\r\nc\r\n", "a\rb\r\rc"})
    EXPECT_THAT(split_lines(text), ElementsAre("a", "b", "", "c"));
  EXPECT_THAT(split_lines(""), IsEmpty());
}

TEST(Text, LowersAsciiOnly) {
  EXPECT_EQ(lower_case("End SITE \xC3\x84"), "end site \xC3\x84");
}

TEST(Text, ReadsAWholeWordAsANumberOrNothing) {
  EXPECT_EQ(parse_number("-1.5e-3"), -0.0015);
  EXPECT_EQ(parse_number("+2"), 2.0);
  for (const char* word : {"", "+", "1,5", "1.5x", " 1", "0x10", "--1"})
    EXPECT_EQ(parse_number(word), std::nullopt) << word;
  EXPECT_TRUE(std::isnan(parse_number("nan").value()));  // callers decide what is not finite
}

TEST(Text, ReadsIntegersWithoutFractions) {
  EXPECT_EQ(parse_integer("-12"), -12);
  for (const char* word : {"", "1.0", "1e3", "99999999999999999999"})
    EXPECT_EQ(parse_integer(word), std::nullopt) << word;
}

TEST(Text, WritesNumbersThatReadBackToTheSameDouble) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 10000; ++i) {
    const double value =
        std::ldexp(static_cast<double>(random()) - 9e18, static_cast<int>(random() % 200) - 100);
    EXPECT_EQ(parse_number(exact_text(value)), value);
  }
  for (const double value :
       {0.1, 1.0 / 3.0, std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()})
    EXPECT_EQ(parse_number(exact_text(value)), value);
  EXPECT_EQ(exact_text(0.1), "0.1");
  EXPECT_EQ(exact_text(60.0), "60");
}

TEST(Text, IgnoresTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) GTEST_SKIP() << "locale de_DE.UTF-8 is not installed";
  EXPECT_EQ(parse_number("1.5"), 1.5);
  EXPECT_EQ(exact_text(1.5), "1.5");
  std::setlocale(LC_ALL, before.c_str());
}

TEST(Text, AWordInAMessageIsPrintableAndNotLong) {
  EXPECT_EQ(in_quotes("Hips"), "'Hips'");
  EXPECT_EQ(in_quotes("H\xc3\xbc"
                      "fte"),
            "'H\xc3\xbc"
            "fte'");
  EXPECT_EQ(in_quotes(std::string_view("\x01\xff"
                                       "a\0b",
                                       5)),
            "'??a?b'");
  EXPECT_EQ(in_quotes(std::string(50, 'x')), "'" + std::string(40, 'x') + "...'");
}

}  // namespace
}  // namespace abrazo::text_test
