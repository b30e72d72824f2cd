#include "core/session/frames/time_place.hpp"

#include <gtest/gtest.h>

#include <string>

namespace abrazo::time_place_test {
namespace {

using Kind = TimePlace::Kind;
constexpr double rate_hz = 60;

TimePlace frame(std::int64_t index, bool relative = false) {
  return {.kind = Kind::Frame, .relative = relative, .frame = index};
}

void expect_time(std::string_view text, double time_s, bool relative = false) {
  const auto place = parse_time_place(text, rate_hz);
  ASSERT_TRUE(place) << place.error().text();
  EXPECT_EQ(place->kind, Kind::Time) << text;
  EXPECT_NEAR(place->time_s, time_s, 1e-12) << text;
  EXPECT_EQ(place->relative, relative) << text;
}

std::string refusal(std::string_view text, double rate = rate_hz) {
  const auto place = parse_time_place(text, rate);
  EXPECT_FALSE(place) << text;
  return place ? "" : place.error().text();
}

TEST(TimePlace, AWholeNumberIsAFrame) {
  EXPECT_EQ(*parse_time_place("690", rate_hz), frame(690));
  EXPECT_EQ(*parse_time_place("  0 ", rate_hz), frame(0));
}

TEST(TimePlace, ANumberWithAUnitIsATime) {
  expect_time("11.5s", 11.5);
  expect_time("11.5 S", 11.5);
  expect_time("250 ms", 0.25);
  expect_time("2min", 120);
}

TEST(TimePlace, FieldsAreHoursMinutesAndSeconds) {
  expect_time("0:11.5", 11.5);
  expect_time("2:05", 125);
  expect_time("1:02:03.25", 3723.25);
}

TEST(TimePlace, FourFieldsAreATimecodeInFramesOfTheRate) {
  expect_time("00:00:11:15", 11.25);
  expect_time("01:00:00:30", 3600.5);
}

TEST(TimePlace, ASignMakesItRelative) {
  EXPECT_EQ(*parse_time_place("+30", rate_hz), frame(30, true));
  EXPECT_EQ(*parse_time_place("-5", rate_hz), frame(-5, true));
  expect_time("-1s", -1, true);
  expect_time("\u22121 s", -1, true);  // the minus that the state text is written with
  expect_time("+0:02.5", 2.5, true);
}

TEST(TimePlace, WhatIsRefusedIsQuotedWithWhatCanBeWritten) {
  for (const char* nonsense : {"turn", "12x", "1e3", "--4", "+", "s", "1:", ":5", "0x10", "nan", "inf s"}) {
    const std::string why = refusal(nonsense);
    EXPECT_NE(why.find("'" + std::string(nonsense) + "'"), std::string::npos) << why;
    EXPECT_NE(why.find("00:00:11:15"), std::string::npos) << why;
  }
  EXPECT_NE(refusal("").find("nothing is written"), std::string::npos);
}

TEST(TimePlace, SaysWhatIsWrongWithATime) {
  EXPECT_NE(refusal("11,5s").find("the decimal sign is a point"), std::string::npos);
  EXPECT_NE(refusal("11.5").find("11.5s would be a time"), std::string::npos);
  EXPECT_NE(refusal("0:75").find("more than 59"), std::string::npos);
  EXPECT_NE(refusal("1:2:3:4:5").find("more fields"), std::string::npos);
  EXPECT_NE(refusal("00:00:11:60").find("only up to 59"), std::string::npos);
  EXPECT_NE(refusal("00:00:11:15", 0).find("needs a frame rate"), std::string::npos);
  EXPECT_NE(refusal("99999999999 s").find("too far"), std::string::npos);
}

TEST(TimePlace, WritesATimeAsAClock) {
  EXPECT_EQ(clock_text(11.5), "00:11.500");
  EXPECT_EQ(clock_text(3723.25), "1:02:03.250");
  EXPECT_EQ(clock_text(59.9996), "01:00.000");
  EXPECT_EQ(clock_text(-1), "−00:01.000");
  EXPECT_EQ(clock_text(-0.0001), "00:00.000");
}

TEST(TimePlace, WritesATimecodeThatReadsBack) {
  EXPECT_EQ(timecode_text(11.25, 60), "00:00:11:15");
  EXPECT_EQ(timecode_text(3600.5, 60), "01:00:00:30");
  EXPECT_EQ(timecode_text(1.5, 120), "00:00:01:060");
  EXPECT_EQ(timecode_text(11.25, 0), "00:00:11");
  for (int index = 0; index < 600; ++index) {
    const double time_s = index / 60.0;
    EXPECT_NEAR(parse_time_place(timecode_text(time_s, 60), 60)->time_s, time_s, 1e-9);
  }
}

TEST(TimePlace, WritesWhatTheFormatAsks) {
  EXPECT_EQ(time_text(TimeFormat::Clock, 11.5, 690, 60), "00:11.500");
  EXPECT_EQ(time_text(TimeFormat::Seconds, 11.5, 690, 60), "11.500 s");
  EXPECT_EQ(time_text(TimeFormat::Frames, 11.5, 690, 60), "690");
  EXPECT_EQ(time_text(TimeFormat::Frames, 0, 0, 60), "0");
  EXPECT_EQ(time_text(TimeFormat::Frames, 11.5, -1, 60), "no frame");
  EXPECT_EQ(time_text(TimeFormat::Timecode, 11.5, 690, 60), "00:00:11:30");
}

/// Frames 100 .. 199 at 60 Hz; those before were given up.
struct Kept {
  FrameHistory history;
  Kept() {
    for (std::uint64_t index = 100; index < 200; ++index) {
      auto one = std::make_shared<FrameSnapshot>();
      one->index = index;
      one->time_s = static_cast<double>(index) / 60;
      history.append(one);
    }
  }
  Result<double> find(const char* text, double cursor_s = 2) const {
    return find_time(*parse_time_place(text, rate_hz), history, cursor_s);
  }
};

TEST(TimePlace, IsFoundAmongTheFramesThereAre) {
  const Kept kept;
  for (const char* frame : {"100", "150", "199"}) EXPECT_DOUBLE_EQ(*kept.find(frame), std::stod(frame) / 60);
  EXPECT_DOUBLE_EQ(*kept.find("+30"), 2.5);
  EXPECT_DOUBLE_EQ(*kept.find("-6"), 1.9);
  EXPECT_DOUBLE_EQ(*kept.find("2.25s"), 2.25);
  EXPECT_DOUBLE_EQ(*kept.find("-0.25s"), 1.75);
  EXPECT_DOUBLE_EQ(*kept.find("00:00:03:00"), 3);
}

TEST(TimePlace, WhereThereIsNoFrameTheErrorSaysWhichThereAre) {
  const Kept kept;
  EXPECT_NE(kept.find("20").error().text().find("the oldest kept is 100"), std::string::npos);
  EXPECT_NE(kept.find("690").error().text().find("the newest is 199"), std::string::npos);
  EXPECT_NE(kept.find("-500").error().text().find("before the first"), std::string::npos);
  EXPECT_NE(kept.find("1s").error().text().find("the oldest kept is at 00:01.667"), std::string::npos);
  EXPECT_NE(kept.find("11.5s").error().text().find("the newest is at 00:03.317"), std::string::npos);
  EXPECT_NE(kept.find("-9s").error().text().find("before the beginning"), std::string::npos);
  EXPECT_FALSE(find_time({}, FrameHistory(), 0));
}

}  // namespace
}  // namespace abrazo::time_place_test
