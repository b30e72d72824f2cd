#include "core/library/takes/text_grid.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace abrazo::text_grid_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TierDocument read(std::string_view text) {
  auto document = parse_tiers(text, "speech.TextGrid", {});
  EXPECT_TRUE(document) << (document ? "" : document.error().text());
  return document ? *document : TierDocument{};
}

std::string refusal(std::string_view text) {
  const auto document = parse_tiers(text, "speech.TextGrid", {});
  return document ? "read" : document.error().text();
}

// As Praat's manual shows the two forms on the page "TextGrid file formats".
constexpr const char* long_form = R"(File type = "ooTextFile"
Object class = "TextGrid"

xmin = 0
xmax = 2.3
tiers? <exists>
size = 2
item []:
    item [1]:
        class = "IntervalTier"
        name = "move"
        xmin = 0
        xmax = 2.3
        intervals: size = 3
        intervals [1]:
            xmin = 0
            xmax = 1.5
            text = "a ""basic"" 1"
        intervals [2]:
            xmin = 1.5
            xmax = 2
            text = ""
        intervals [3]:
            xmin = 2
            xmax = 2.3
            text = "turn"
    item [2]:
        class = "TextTier"
        name = "beat"
        xmin = 0
        xmax = 2.3
        points: size = 1
        points [1]:
            number = 1
            mark = "x"
)";
constexpr const char* short_form =
    "File type = "
    "\"ooTextFile\"\n\"TextGrid\"\n\n0\n2.3\n<exists>\n2\n\"IntervalTier\"\n\"move\"\n0\n2.3\n3\n0\n1."
    "5\n\"a \"\"basic\"\" 1\"\n1.5\n2\n\"\"\n2\n2.3\n\"turn\"\n\"TextTier\"\n\"beat\"\n0\n2.3\n1\n1\n\"x\"\n";

TEST(TextGrid, BothFormsAreReadAndPointsAreCounted) {
  const std::vector<Tier> expected = {
      {"move", {{0, 1.5, "a \"basic\" 1"}, {2, 2.3, "turn"}}, {}, TierKind::Move}};
  for (const char* text : {long_form, short_form}) {
    const TierDocument document = read(text);
    EXPECT_EQ(document.tiers, expected);
    EXPECT_THAT(document.warnings, ElementsAre("1 point without length was left out"));
  }
}

TEST(TextGrid, IsReadInUtf16AsPraatWritesIt) {
  for (const bool is_big_endian : {true, false}) {
    std::string bytes = is_big_endian ? "\xFE\xFF" : "\xFF\xFE";
    const auto append = [&](char16_t unit) {
      const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit & 0xFF);
      bytes += is_big_endian ? std::string{high, low} : std::string{low, high};
    };
    const std::u16string text =
        u"\"ooTextFile\" \"TextGrid\" 0 1 <exists> 1 \"IntervalTier\" \"ö\" 0 1 1 0 1 \"ŋ 𝄞\"";
    for (const char16_t unit : text) append(unit);
    const TierDocument document = read(bytes);
    ASSERT_EQ(document.tiers.size(), 1U);
    EXPECT_EQ(document.tiers[0].name, "ö");
    EXPECT_EQ(document.tiers[0].intervals[0].value, "ŋ 𝄞");
    EXPECT_THAT(refusal(bytes + "\xD8"), HasSubstr("is not UTF-8 or UTF-16 text"));
  }
}

TEST(TextGrid, WhatItHoldsComesBackToTheSameDoublesAndWhatItDoesNotIsCounted) {
  const std::vector<Tier> tiers = {{"move",
                                    {{-0.5, 1.0 / 3, "say \"so\"\nagain", "", "high"}, {0.5, 0.7, " "}},
                                    {{"turn"}},
                                    TierKind::Move},
                                   {"empty", {}, {}, TierKind::Note}};
  const TierText written = text_grid(tiers);
  EXPECT_EQ(read(written.text).tiers,
            (std::vector<Tier>{{"move", {{-0.5, 1.0 / 3, "say \"so\"\nagain"}}, {}, TierKind::Move},
                               {"empty", {}}}));
  EXPECT_THAT(written.warnings, ElementsAre("the vocabulary of 1 tier was left out; .eaf and .json keep it",
                                            "1 interval without a value is a gap",
                                            "detail and confidence of 1 interval were left out"));
  EXPECT_THAT(written.text, HasSubstr("xmin = -0.5\nxmax = 0.7\ntiers? <exists>\nsize = 2\n"));
}

TEST(TextGrid, SaysTheLineAndWhatIsExpectedThere) {
  EXPECT_THAT(refusal("File type = \"ooTextFile\"\nObject class = \"Pitch\"\n"),
              HasSubstr("is not a TextGrid"));
  EXPECT_THAT(refusal("hello\n"),
              HasSubstr("speech.TextGrid:2: expected \"ooTextFile\", found the end of the file"));
  EXPECT_THAT(refusal("\"ooTextFile\"\n\"TextGrid\"\n0\n1\n<exists>\n1\n\"Spans\"\n"),
              HasSubstr("expected \"IntervalTier\" or \"TextTier\", found 'Spans'"));
  EXPECT_THAT(refusal("\"ooTextFile\"\n\"TextGrid\"\n0\n1\n<exists>\n-1\n"),
              HasSubstr("speech.TextGrid:6: expected the number of tiers, found '-1'"));
  EXPECT_THAT(
      refusal(
          "\"ooTextFile\"\n\"TextGrid\"\n0\n1\n<exists>\n1\n\"IntervalTier\"\n\"m\"\n0\n1\n1\n0\n1\n\"never"),
      HasSubstr("speech.TextGrid:14: the quotes that begin here do not end"));
}

}  // namespace
}  // namespace abrazo::text_grid_test
