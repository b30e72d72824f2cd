#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/library/takes/manifest.hpp"

namespace abrazo::label_file_test {
namespace {

using testing::HasSubstr;

Error refusal(std::string_view csv) {
  const auto labels = parse_labels(csv, "t1", "moves.csv");
  EXPECT_FALSE(labels.ok());
  return labels.ok() ? Error{} : labels.error();
}

TEST(LabelFile, ReadsTheRowsOfOneTake) {
  const auto labels = parse_labels(
      "take,start_frame,end_frame,label,detail,confidence\n"
      "t1,0,10,turn,follower right,high\n"
      "t2,0,99,walk,,\n"
      "t1,10,12,walk,,low\n",
      "t1", "moves.csv");
  ASSERT_TRUE(labels.ok()) << labels.error().text();
  ASSERT_EQ(labels->size(), 2U);
  EXPECT_EQ((*labels)[0].start, 0);
  EXPECT_EQ((*labels)[0].end, 10);
  EXPECT_EQ((*labels)[0].label, "turn");
  EXPECT_EQ((*labels)[0].detail, "follower right");
  EXPECT_EQ((*labels)[0].confidence, "high");
  EXPECT_EQ((*labels)[1].label, "walk");
}

TEST(LabelFile, NeedsNoHeaderDetailOrConfidence) {
  const auto labels = parse_labels("t1,3,4,turn\r\n\r\nt1,8,9,walk\r\n", "t1", "moves.csv");
  ASSERT_TRUE(labels.ok()) << labels.error().text();
  ASSERT_EQ(labels->size(), 2U);
  EXPECT_EQ((*labels)[0].detail, "");
}

TEST(LabelFile, ALineMayEndWithACarriageReturnAlone) {
  const auto labels = parse_labels("t1,3,4,turn\r\rt1,8,9,walk\r", "t1", "moves.csv");
  ASSERT_TRUE(labels.ok()) << labels.error().text();
  ASSERT_EQ(labels->size(), 2U);
  EXPECT_EQ((*labels)[0].label, "turn");
  EXPECT_EQ((*labels)[1].label, "walk");
  EXPECT_EQ(refusal("t1,3,4,turn\r\rt1,8\r").where, "moves.csv:3");
  EXPECT_EQ(refusal("t1,3,4,turn\n\nt1,8\n").where, "moves.csv:3");
  EXPECT_EQ(refusal("t1,3,4,turn\r\n\r\nt1,8\r\n").where, "moves.csv:3");
}

TEST(LabelFile, ToleratesFurtherColumnsAndAByteOrderMark) {
  const auto labels = parse_labels("\xEF\xBB\xBFt1,3,4,turn,d,c,annotator,2024\n", "t1", "moves.csv");
  ASSERT_TRUE(labels.ok()) << labels.error().text();
  ASSERT_EQ(labels->size(), 1U);
  EXPECT_EQ((*labels)[0].confidence, "c");
}

TEST(LabelFile, PutsRowsInOrder) {
  const auto labels = parse_labels("t1,8,9,walk\nt1,3,4,turn\n", "t1", "moves.csv");
  ASSERT_TRUE(labels.ok());
  EXPECT_EQ((*labels)[0].label, "turn");
}

TEST(LabelFile, IsEmptyForATakeThatItDoesNotName) {
  const auto labels = parse_labels("t2,3,4,turn\n", "t1", "moves.csv");
  ASSERT_TRUE(labels.ok());
  EXPECT_TRUE(labels->empty());
}

TEST(LabelFile, RefusesARowThatIsTooShort) {
  const Error error = refusal("take,start_frame,end_frame,label\nt1,3,4\n");
  EXPECT_EQ(error.where, "moves.csv:2");
  EXPECT_THAT(error.message, HasSubstr("expected take,start_frame,end_frame,label, found 3 fields"));
}

TEST(LabelFile, RefusesWhatIsNotAFrameNumber) {
  EXPECT_THAT(refusal("t1,0,1,x\nt1,three,4,turn\n").text(),
              HasSubstr("moves.csv:2: expected start_frame as a frame number from 0 on, found \"three\""));
  EXPECT_THAT(refusal("t1,3,4.5,turn\n").text(), HasSubstr("expected end_frame"));
  EXPECT_THAT(refusal("t1,-3,4,turn\n").text(), HasSubstr("found \"-3\""));
}

TEST(LabelFile, RefusesEmptyAndReversedIntervals) {
  EXPECT_THAT(refusal("t1,4,4,turn\n").text(),
              HasSubstr("moves.csv:1: the label ends at frame 4, which is not after its start 4"));
  EXPECT_THAT(refusal("t1,9,4,turn\n").text(), HasSubstr("ends at frame 4"));
}

TEST(LabelFile, RefusesAnEmptyLabel) {
  EXPECT_THAT(refusal("t1,3,4,,detail\n").text(), HasSubstr("the label is empty"));
}

TEST(LabelFile, RefusesOverlapsAndNamesBothLines) {
  EXPECT_THAT(refusal("t1,10,20,turn\nt1,0,11,walk\n").text(),
              HasSubstr("moves.csv:1: frames 10-20 overlap those of line 2 (until 11)"));
}

}  // namespace
}  // namespace abrazo::label_file_test
