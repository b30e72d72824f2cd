#include "core/library/takes/elan_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/library/takes/tier_csv.hpp"

namespace abrazo::elan_text_test {
namespace {

using ::testing::ElementsAre;
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

// The forms in which ELAN exports the same two annotations, each with what it adds.
TEST(ElanText, ColumnsAreFoundByWhatTheyHold) {
  const std::vector<Tier> both = {{"move", {{1, 2.5, "basic"}, {2.5, 4, "turn"}}, {}, TierKind::Move}};
  const auto rows = [](const std::string& before, const std::string& behind_basic,
                       const std::string& behind_turn) {
    return before + "1.0\t2.5\t1.5\tbasic" + behind_basic + "\n" + before + "2.5\t4.0\t1.5\tturn" +
           behind_turn + "\n";
  };
  EXPECT_EQ(read(rows("move\tana\t", "", "")).tiers, both);
  EXPECT_EQ(read(rows("move\t", "", "")).tiers, both) << "without participants";
  EXPECT_EQ(read(rows("move\tana\tbob\t", "", "")).tiers, both) << "with annotators";
  EXPECT_EQ(read(rows("move\tana\t", "\tthe basic step", "\t")).tiers, both) << "with descriptions";
  EXPECT_EQ(read(rows("move\tana\t", "\ta.eaf\t/x/a.eaf", "\tb.eaf\t/x/b.eaf")).tiers, both)
      << "of several files";
  EXPECT_EQ(read("\"#file:///D:/video/evening.mp4 -- offset: 0\"\n\n" + rows("move\t\t", "", "")).tiers, both)
      << "with the media above";
  EXPECT_EQ(read("move\t0.0\t1.5\t1.5\tbasic\n").tiers[0].intervals,
            (std::vector<TierInterval>{{0, 1.5, "basic"}}))
      << "from 0 on";
  EXPECT_EQ(
      read("move\tana\t00:00:01.000\t1.0\t1000\t00:00:02.500\t2.5\t2500\t00:00:01.500\t1.5\t1500\tbasic\n"
           "move\tana\t00:00:02.500\t2.5\t2500\t00:00:04.000\t4.0\t4000\t00:00:01.500\t1.5\t1500\tturn\n")
          .tiers,
      both)
      << "in three forms";
  EXPECT_EQ(read("move\t00:00:01:00\t1.0\t00:00:02:12\t2.5\t00:00:01:12\t1.5\tbasic\n"
                 "move\t00:00:02:12\t2.5\t00:00:04:00\t4.0\t00:00:01:12\t1.5\tturn\n")
                .tiers,
            both)
      << "SMPTE beside seconds";
  EXPECT_EQ(read("1\tana\t1,0\t2,5\t1,5\t7\n1\tana\t2,5\t4,0\t1,5\t8\n").tiers,
            (std::vector<Tier>{{"1", {{1, 2.5, "7"}, {2.5, 4, "8"}}}}))
      << "tiers and values are numbers too, and points are commas";
}

TEST(ElanText, ATierMayBeginWithAnyCharacter) {
  const TierDocument document = read(
      "move\tana\t1.0\t1.5\t0.5\tbasic\n\"quoted\" "
      "tier\tana\t1.5\t3.0\t1.5\tturn\n#2\tana\t3.0\t4.0\t1.0\tspin\n");
  ASSERT_EQ(document.tiers.size(), 3U);
  EXPECT_EQ(document.tiers[1].name, "\"quoted\" tier");
  EXPECT_EQ(document.tiers[2].name, "#2");
}

TEST(ElanText, ATitleThatIsNoOtherIsATier) {
  const TierDocument document = read(
      "Begin Time - hh:mm:ss.ms\tBegin Time - ss.msec\tEnd Time - hh:mm:ss.ms\tEnd Time - "
      "ss.msec\tmove\trole\n"
      "00:00:01.000\t1.0\t00:00:02.500\t2.5\tbasic\t\n00:00:02.500\t2.5\t00:00:04.000\t4.0\tturn\ta\n");
  EXPECT_EQ(document.tiers,
            (std::vector<Tier>{{"move", {{1, 2.5, "basic"}, {2.5, 4, "turn"}}, {}, TierKind::Move},
                               {"role", {{2.5, 4, "a"}}, {}, TierKind::Role}}));
}

TEST(ElanText, WhatHasNoLengthIsLeftOutAndCounted) {
  const TierDocument document = read("move\tana\t1.0\t1.0\t0.0\tclap\nmove\tana\t1.0\t3.0\t2.0\tturn\n");
  ASSERT_EQ(document.tiers.size(), 1U);
  EXPECT_EQ(document.tiers[0].intervals, (std::vector<TierInterval>{{1, 3, "turn"}}));
  EXPECT_THAT(document.warnings, ElementsAre("1 annotation without length was left out"));
}

TEST(ElanText, TwoTimesWithoutTitlesAreBeginAndEndAndThatIsSaid) {
  const TierDocument ends = read("move\t1.0\t2.5\tbasic\nmove\t2.5\t4.0\tturn\n");
  EXPECT_EQ(ends.tiers[0].intervals, (std::vector<TierInterval>{{1, 2.5, "basic"}, {2.5, 4, "turn"}}));
  EXPECT_THAT(ends.warnings, ElementsAre(HasSubstr("taken as begin and end")));
  const TierDocument durations = read("move\t1.0\t1.5\tbasic\nmove\t2.5\t1.5\tturn\n");
  EXPECT_EQ(durations.tiers[0].intervals, ends.tiers[0].intervals) << "no annotation ends before it begins";
  EXPECT_THAT(durations.warnings, ElementsAre(HasSubstr("taken as begin and duration")));
}

TEST(ElanText, IsReadAsCsvToo) {
  const auto document = parse_tiers(
      "\"move\",\"ana\",00:00:01.000,1.0,00:00:02.500,2.5,00:00:01.500,1.5,\"basic\"\n"
      "\"move\",\"ana\",00:00:02.500,2.5,00:00:04.000,4.0,00:00:01.500,1.5,\"turn, left\"\n",
      "dance.csv", {});
  ASSERT_TRUE(document) << document.error().text();
  EXPECT_EQ(document->tiers,
            (std::vector<Tier>{{"move", {{1, 2.5, "basic"}, {2.5, 4, "turn, left"}}, {}, TierKind::Move}}));
  EXPECT_FALSE(is_elan_table("one,0,12,basic\none,12,20,turn\n")) << "frames of a label file";
  EXPECT_FALSE(is_elan_table("take,start_frame,end_frame,label\none,0,12,12\n"));
}

TEST(ElanText, LabelTracksOfAudacityAreReadAndWritten) {
  const std::vector<Tier> tiers = {{"annotations", {{0, 1.5, "basic"}, {1.5, 3, "turn"}}}};
  const std::string track = "0.000000\t1.500000\tbasic\n1.500000\t3.000000\tturn\n";
  EXPECT_EQ(read(track).tiers, tiers);
  EXPECT_EQ(read("0.000000\t1.500000\tbasic\n\\\t100.000000\t200.000000\n1.500000\t3.000000\tturn\n").tiers,
            tiers)
      << "with the frequencies of a selection";
  const auto written = write_tiers(tiers, "track.txt", {});
  ASSERT_TRUE(written) << written.error().text();
  EXPECT_EQ(written->text, track);
}

TEST(ElanText, SaysWhatIsWrong) {
  EXPECT_THAT(refusal("one\ttwo\n"), HasSubstr("dance.txt:1: expected ELAN's table of annotations"));
  EXPECT_THAT(refusal("moves\t\t1.0\t2.0\t1.0\tbasic\nmoves\t\tsoon\t3.0\t1.0\tturn\n"),
              HasSubstr("dance.txt:2: expected ELAN's table of annotations"));
  EXPECT_THAT(
      refusal("1.0\t2.0\t1.0\tbasic\tleft\n"),
      HasSubstr("2 columns behind the times, and nothing says what they are; export with the option"));
  EXPECT_THAT(refusal("move\t00:00:01:00\t00:00:02:12\tbasic\n"),
              HasSubstr("SMPTE frames of an unknown rate"));
  EXPECT_THAT(refusal("Tier\tBegin Time - ss.msec\tAnnotation\nmoves\t3.0\tbasic\n"),
              HasSubstr("dance.txt:1: lacks a column of begin, of end or duration"));
  EXPECT_THAT(refusal("Tier\tBegin Time - ss.msec\tEnd Time - ss.msec\tAnnotation\nmoves\t3.0\t2.0\tbasic\n"),
              HasSubstr("ends at 2.000 s, and begins at 3.000 s"));
  EXPECT_THAT(refusal("\t\n"), HasSubstr("has no annotations"));
}

}  // namespace
}  // namespace abrazo::elan_text_test
