#include "core/base/printable.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/base/limits.hpp"

namespace abrazo::printable_test {
namespace {

TEST(Printable, ShowsWhatWouldSteerATerminalAsAQuestionMark) {
  EXPECT_EQ(printable("\x1b[31mred\a\b\r\x7f"), "?[31mred????");
  EXPECT_EQ(printable(std::string_view("\0", 1)), "?");
}

TEST(Printable, KnowsControlCharactersOfTwoBytes) {
  EXPECT_EQ(printable("a\xC2\x80\xC2\x9B\xC2\x9F"
                      "b"),
            "a???b");
  EXPECT_EQ(printable("\xC2\xA0\xC3\x9B \xE2\x80\x9B"), "\xC2\xA0\xC3\x9B \xE2\x80\x9B")
      << "letters and quotes";
  EXPECT_EQ(printable("\xC2"), "\xC2") << "cut off";
}

TEST(Printable, CutsALineThatIsLongerThanAnyOfOurOwnBetweenTwoCharacters) {
  const std::string longest(limits::line_bytes, 'a');
  EXPECT_EQ(printable_line(longest), longest);
  EXPECT_EQ(printable_line(longest + "a"), longest + "... (8001 bytes)");
  EXPECT_EQ(printable_line(longest.substr(1) + "\xC3\xA9"), longest.substr(1) + "... (8001 bytes)");
}

TEST(Printable, KeepsTheLinesOfATextAndPutsANameOnOne) {
  EXPECT_EQ(printable("a\n\tb"), "a\n\tb");
  EXPECT_EQ(printable_line("a\n\tb"), "a??b");
}

}  // namespace
}  // namespace abrazo::printable_test
