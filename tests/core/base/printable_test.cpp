#include "core/base/printable.hpp"

#include <gtest/gtest.h>

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

TEST(Printable, KeepsTheLinesOfATextAndPutsANameOnOne) {
  EXPECT_EQ(printable("a\n\tb"), "a\n\tb");
  EXPECT_EQ(printable_line("a\n\tb"), "a??b");
}

}  // namespace
}  // namespace abrazo::printable_test
