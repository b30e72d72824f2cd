#include "core/motion/tables/trc_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/motion/motion_fixtures.hpp"

namespace abrazo::trc_reader_test {
namespace {

using test::has_warning;
using test::place;
using test::the_warning;
using ::testing::HasSubstr;

const std::string head =
    "PathFileType\t4\t(X/Y/Z)\twalk.trc\n"
    "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\tOrigDataStartFrame\tOrigNumFrames\n"
    "120\t120\t2\t2\tmm\t120\t1\t2\n"
    "Frame#\tTime\tLASI\t\t\tRASI\t\t\n"
    "\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n"
    "\n";

NamedMotion read_one(const std::string& text) {
  Result<std::vector<NamedMotion>> motions = read_trc(text, "walk.trc");
  if (motions && motions->size() == 1) return std::move(motions->front());
  ADD_FAILURE() << (motions ? "not one performer" : motions.error().text());
  return {};
}
std::string message_of(const std::string& text) {
  const auto motions = read_trc(text, "walk.trc");
  return motions ? "read" : motions.error().text();
}

TEST(TrcReader, ReadsMarkersRateAndUnit) {
  const NamedMotion motion = read_one(head + "1\t0.0\t1\t2\t3\t4\t5\t6\n2\t0.00833\t1.5\t2\t3\t4\t5\t-6e1\n");
  EXPECT_EQ(motion.fps, 120.0);
  EXPECT_EQ(motion.metres_per_unit, 0.001);
  EXPECT_TRUE(motion.warnings.empty());
  EXPECT_EQ(place(motion, 1, "LASI"), Vec3(1.5, 2, 3));
  EXPECT_EQ(place(motion, 1, "RASI"), Vec3(4, 5, -60));
}

/// The text with another separator, and as many of them behind each line as programs for tables write.
std::string separated(std::string text, const std::string& separator, const std::string& trailing = "") {
  std::string result;
  for (const char c : text) result += c == '\t' ? separator : c == '\n' ? trailing + "\n" : std::string(1, c);
  return result;
}

TEST(TrcReader, ReadsCommasAndSemicolonsAsItReadsTabs) {
  const std::string text = head + "1\t0.0\t1.5\t2\t3\t\t\t\n2\t0.00833\t1\t2\t3\t4\t5\t6\n";
  for (const std::string& separator : std::vector<std::string>{"\t", ",", ";"})
    for (const std::string& trailing : {std::string(), separator, std::string(40, separator[0])}) {
      SCOPED_TRACE(separator + trailing);
      const NamedMotion motion = read_one(separated(text, separator, trailing));
      EXPECT_TRUE(motion.warnings.empty());
      EXPECT_EQ(motion.fps, 120.0);
      EXPECT_EQ(motion.metres_per_unit, 0.001);
      ASSERT_EQ(motion.frames.size(), 2U);
      EXPECT_EQ(place(motion, 0, "LASI"), Vec3(1.5, 2, 3));
      EXPECT_FALSE(place(motion, 0, "RASI").allFinite());
      EXPECT_EQ(place(motion, 1, "RASI"), Vec3(4, 5, 6));
    }
  const std::string decimal_commas = separated(head, ";") + "1;0,0;1,5;2;3;4;5;6\n2;0,00833;1;2;3;4;5;6\n";
  EXPECT_EQ(place(read_one(decimal_commas), 0, "LASI"), Vec3(1.5, 2, 3));
}

TEST(TrcReader, ReadsValuesThatStandTwoTabsApart) {
  std::string text = head + "1\t0.0\t1\t2\t3\t4\t5\t6\n";
  text.replace(text.find("120\t120\t2\t2\tmm"), 14, "  120.0\t\t 120.0\t\t  1\t\t 2\t\tmm");
  const NamedMotion motion = read_one(text);
  EXPECT_EQ(motion.metres_per_unit, 0.001);
  EXPECT_FALSE(has_warning(motion.warnings, "frame-count"));
}

TEST(TrcReader, SaysWhatIsWrongBetweenCommasToo) {
  const std::string commas = separated(head, ",");
  EXPECT_THAT(message_of(commas), HasSubstr("has no frames"));
  EXPECT_THAT(message_of(commas + "1,0,1,2,x3,4,5,6\n"), HasSubstr("LASI's z (column 5), found 'x3'"));
  EXPECT_THAT(message_of(commas + "1,0,1,2,3,4,5,6,7\n"), HasSubstr("expected at most 8 fields"));
  EXPECT_THAT(message_of(separated(head.substr(0, head.find("LASI")), ",")), HasSubstr("names no marker"));
}

TEST(TrcReader, TakesEmptyFieldsAsGaps) {
  const NamedMotion motion =
      read_one(head + "1\t0.0\t\t\t\t4\t5\t6\n2\t0.00833\t1\t2\t3\n3\t0.01\t1\t2\t3\t1\t1\t1\n");
  EXPECT_FALSE(place(motion, 0, "LASI").allFinite());
  EXPECT_FALSE(place(motion, 1, "RASI").allFinite()) << "fields behind the last value may be missing";
  EXPECT_TRUE(place(motion, 2, "RASI").allFinite());
  const ImportWarning& warning = the_warning(motion.warnings, "short-row");
  EXPECT_THAT(warning.detail, HasSubstr("1 row ends before the last marker"));
  EXPECT_EQ(warning.line, 8);
}

TEST(TrcReader, RowsThatAreMissingAreFramesInWhichNothingWasSeen) {
  std::string text = head;
  for (int row = 0; row < 20; ++row)
    if (row < 5 || row > 7)
      text += std::to_string(row) + "\t" + std::to_string(row / 120.0) + "\t1\t2\t3\t4\t5\t6\n";
  const NamedMotion motion = read_one(text);
  EXPECT_EQ(motion.frames.size(), 20U);
  EXPECT_FALSE(place(motion, 7, "LASI").allFinite());
  EXPECT_TRUE(place(motion, 8, "LASI").allFinite());
  EXPECT_TRUE(has_warning(motion.warnings, "time-jump"));
}

TEST(TrcReader, ShortRowsOfManyMarkersTakeNoMoreMemoryThanAFileIsWorth) {
  std::string text = head.substr(0, head.find("LASI"));
  for (int marker = 0; marker < 9999; ++marker) text += "M" + std::to_string(marker) + "\t\t\t";
  text += "\n";
  for (int row = 0; row < 2000; ++row) text += "1\n";
  EXPECT_THAT(message_of(text), HasSubstr("rows with fewer fields than its 9999 markers have"));
}

TEST(TrcReader, BelievesTheRowsAndNotTheCountsAbove) {
  std::string text = head + "1\t0.0\t1\t2\t3\t4\t5\t6\n";
  text.replace(text.find("\t2\t2\tmm"), 7, "\t900000000000\t77\tmm");
  const NamedMotion motion = read_one(text);
  EXPECT_EQ(motion.frames.size(), 1U);
  EXPECT_THAT(the_warning(motion.warnings, "frame-count").detail,
              HasSubstr("announces 900000000000 frames and there are 1"));
  EXPECT_TRUE(has_warning(motion.warnings, "marker-count"));
}

TEST(TrcReader, SaysWhatIsWrong) {
  EXPECT_THAT(message_of("rubbish\n"), HasSubstr("which begins with PathFileType"));
  EXPECT_THAT(message_of("PathFileType\t4\n"), HasSubstr("ends in its header"));
  EXPECT_THAT(message_of(head), HasSubstr("has no frames"));
  EXPECT_THAT(message_of(head + "1\t0\t1\t2\tx3\t4\t5\t6\n"), HasSubstr("LASI's z (column 5), found 'x3'"));
  EXPECT_THAT(message_of(head + "1\t0\t1\t2\t3\t4\t5\t6\t7\n"), HasSubstr("expected at most 8 fields"));
  EXPECT_THAT(message_of(head + "1\t0\t1\t2\t3\t4\t5\t6\nsummary\t1\n"),
              HasSubstr("walk.trc:8: expected a frame number"));
}

TEST(TrcReader, SurvivesDamagedFiles) {
  std::mt19937 random(3);
  for (int n = 0; n < 2000; ++n)
    (void)read_trc(test::damaged(head + "1\t0.0\t1\t2\t3\t4\t5\t6\n2\t0.01\t1\t2\t3\t4\t5\t6\n", random),
                   "damaged.trc");
}

}  // namespace
}  // namespace abrazo::trc_reader_test
