#include "core/library/takes/elan_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace abrazo::elan_text_test {
namespace {

using ::testing::HasSubstr;

TierDocument read(std::string_view text) {
  auto document = parse_tiers(text, "dance.txt", {});
  EXPECT_TRUE(document) << (document ? "" : document.error().text());
  return document ? *document : TierDocument{};
}

std::string refusal(std::string_view text) {
  const auto document = parse_tiers(text, "dance.txt", {});
  return document ? "read" : document.error().text();
}

TEST(ElanText, IsReadAsElanExportsIt) {
  const TierDocument document = read(
      "moves\t\t00:00:01.120\t1.12\t00:00:02.340\t2.34\t00:00:01.220\t1.22\tbasic\n"
      "moves\t\t00:01:02.000\t62.0\t00:01:03.000\t63.0\t00:00:01.000\t1.0\tcross body lead\n"
      "errors\tanna\t00:00:01.500\t1.5\t00:00:02.000\t2.0\t00:00:00.500\t0.5\tlate\n");
  ASSERT_EQ(document.tiers.size(), 2U);
  EXPECT_EQ(document.tiers[0].name, "moves");
  EXPECT_EQ(document.tiers[0].kind, TierKind::Move);
  ASSERT_EQ(document.tiers[0].intervals.size(), 2U);
  EXPECT_DOUBLE_EQ(document.tiers[0].intervals[1].start_s, 62);
  EXPECT_EQ(document.tiers[0].intervals[1].value, "cross body lead");
  EXPECT_DOUBLE_EQ(document.tiers[1].intervals[0].end_s, 2);
}

TEST(ElanText, IsReadWithTitlesWithoutEndsAndInMilliseconds) {
  const TierDocument titled = read(
      "\"#file:///dance.eaf\"\nTier\tBegin Time - ss.msec\tDuration - "
      "ss.msec\tAnnotation\nmoves\t2.0\t0.5\tturn\n"
      "moves\t1.0\t0.5\tbasic\n");
  ASSERT_EQ(titled.tiers.size(), 1U);
  EXPECT_EQ(titled.tiers[0].intervals[0].value, "basic") << "in the order of their begin";
  EXPECT_DOUBLE_EQ(titled.tiers[0].intervals[1].end_s, 2.5);
  const TierDocument thousandths = read("moves\t\t1120\t2340\t1220\tbasic\n");
  EXPECT_DOUBLE_EQ(thousandths.tiers[0].intervals[0].start_s, 1.12);
}

TEST(ElanText, SaysWhatIsWrong) {
  EXPECT_THAT(refusal("one\ttwo\n"), HasSubstr("dance.txt:1: expected ELAN's tab-delimited text"));
  EXPECT_THAT(refusal("moves\t\t1.0\t2.0\t1.0\tbasic\nmoves\t\tsoon\t3.0\t1.0\tturn\n"),
              HasSubstr("dance.txt:2: expected the times of an annotation, found 'soon'"));
  EXPECT_THAT(refusal("Tier\tBegin Time - ss.msec\tEnd Time - ss.msec\tAnnotation\nmoves\t3.0\t2.0\tbasic\n"),
              HasSubstr("ends at 2.000 s, and begins at 3.000 s"));
  EXPECT_THAT(refusal("\t\n"), HasSubstr("has no annotations"));
}

}  // namespace
}  // namespace abrazo::elan_text_test
