#include "core/motion/tables/point_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

#include "core/motion/body/joint_set.hpp"
#include "core/motion/tables/clip_csv.hpp"
#include "tests/core/motion/motion_fixtures.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::point_csv_test {
namespace {

using test::place;
using test::the_warning;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<NamedMotion> read(const std::string& text) {
  Result<std::vector<NamedMotion>> motions = read_point_csv(text, "walk.csv");
  if (motions) return std::move(*motions);
  ADD_FAILURE() << motions.error().text();
  return std::vector<NamedMotion>(1);
}
std::string message_of(const std::string& text) {
  const auto motions = read_point_csv(text, "walk.csv");
  return motions ? "read" : motions.error().text();
}

std::vector<Clip> two_clips() {
  std::vector<Clip> clips(2);
  for (std::size_t c = 0; c < 2; ++c) {
    clips[c].name = c == 0 ? "active" : "passive";
    clips[c].fps = 59.94;
    for (int f = 0; f < 7; ++f)
      clips[c].poses.push_back(
          test::moved(test::standing_pose(), 0.1 * f, Vec3(static_cast<double>(c), 0, 1.0 / 3)));
  }
  return clips;
}

TEST(PointCsv, ReadsWhatAbrazoWritesToTheSameNumbers) {
  const std::vector<Clip> clips = two_clips();
  const std::vector<NamedMotion> motions = read(*write_clip_csv(clips));
  ASSERT_EQ(motions.size(), 2U);
  EXPECT_EQ(motions[1].name, "passive");
  EXPECT_NEAR(*motions[1].fps, 59.94, 1e-9);
  EXPECT_EQ(motions[1].metres_per_unit, 1.0);
  for (std::size_t f = 0; f < 7; ++f) EXPECT_EQ(motions[1].frames[f], Positions(clips[1].poses[f]));
  const std::vector<NamedMotion> alone = read(*write_clip_csv(std::span(clips).first(1)));
  ASSERT_EQ(alone.size(), 1U);
  EXPECT_EQ(alone[0].points[3], "ltibia");
}

TEST(PointCsv, ReadsColumnsNamedInManyWays) {
  for (const char* names :
       {"a_x,a_y,a_z,b_x,b_y,b_z", "a.X,a.Y,a.Z,b.X,b.Y,b.Z", "a:X,a:Y,a:Z,b:X,b:Y,b:Z",
        "a x,a y,a z,b x,b y,b z", "aX,aY,aZ,bX,bY,bZ", "x_a,y_a,z_a,x_b,y_b,z_b",
        "\"a_x [mm]\",a_y [mm],a_z [mm],b_x [mm],b_y [mm],b_z [mm]", "a_x,b_x,a_y,b_y,a_z,b_z"}) {
    SCOPED_TRACE(names);
    const bool mixed = std::string(names).starts_with("a_x,b_x");
    const NamedMotion motion =
        read(std::string("time,") + names +
             (mixed ? "\n0,1,4,2,5,3,6\n0.5,1,4,2,5,3,6\n" : "\n0,1,2,3,4,5,6\n0.5,1,2,3,4,5,6\n"))
            .front();
    EXPECT_THAT(motion.points, ElementsAre("a", "b"));
    EXPECT_EQ(place(motion, 1, "b"), Vec3(4, 5, 6));
    EXPECT_EQ(motion.fps, 2.0);
  }
  EXPECT_EQ(read("a_x [mm],a_y [mm],a_z [mm]\n1,2,3\n").front().metres_per_unit, 0.001);
  EXPECT_EQ(read("time_ms,a_x,a_y,a_z\n0,1,2,3\n20,1,2,3\n").front().fps, 50.0);
}

TEST(PointCsv, ReadsSemicolonsWithDecimalCommas) {
  const NamedMotion motion = read("t;a_x;a_y;a_z\n0;1,5;-2;3\n0,1;;;\n").front();
  EXPECT_EQ(place(motion, 0, "a"), Vec3(1.5, -2, 3));
  EXPECT_FALSE(place(motion, 1, "a").allFinite());
  EXPECT_EQ(motion.fps, 10.0);
}

TEST(PointCsv, ReadsNamesOverALineOfAxes) {
  const NamedMotion motion =
      read(
          "Trajectories\n120\n,,Anna:LASI,,,Anna:RASI,,\nFrame,Sub Frame,X,Y,Z,X,Y,Z\n,,mm,mm,mm,mm,mm,mm\n"
          "1,0,1,2,3,4,5,6\n2,0,1,2,3,,,\n")
          .front();
  EXPECT_THAT(motion.points, ElementsAre("Anna:LASI", "Anna:RASI"));
  EXPECT_EQ(motion.fps, 120.0);
  EXPECT_EQ(motion.metres_per_unit, 0.001);
  EXPECT_EQ(motion.frames.size(), 2U);
}

/// An export of Motive with a bone, its rotation before its position, and a marker.
std::string motive_export(const std::string& space) {
  std::string types = ",Type", names = ",Name", ids = ",ID", properties = ",", axes = "Frame,Time (Seconds)",
              row = "0,0";
  for (int bone = 0; bone < 9; ++bone) {
    const std::string name = ",Fred:Bone" + std::to_string(bone);
    for (int i = 0; i < 7; ++i) types += ",Bone", names += name, ids += ",1";
    properties += ",Rotation,Rotation,Rotation,Rotation,Position,Position,Position";
    axes += ",X,Y,Z,W,X,Y,Z";
    row += ",0,0,0,1," + std::to_string(bone) + ",2,3";
  }
  types += ",Marker,Marker,Marker", names += ",M,M,M", ids += ",1,1,1",
      properties += ",Position,Position,Position";
  axes += ",X,Y,Z", row += ",9,9,9";
  return "Format Version,1.23,Take Name,t,Capture Frame Rate,120,Export Frame Rate,60,Length "
         "Units,Millimeters,"
         "Coordinate Space," +
         space + "\n\n" + types + "\n" + names + "\n" + ids + "\n" + properties + "\n" + axes + "\n" + row +
         "\n";
}

TEST(PointCsv, ReadsTheBonesOfAnExportOfMotive) {
  const NamedMotion motion = read(motive_export("Global")).front();
  EXPECT_EQ(motion.name, "Fred");
  EXPECT_EQ(motion.points.size(), 9U);
  EXPECT_EQ(place(motion, 0, "Bone4"), Vec3(4, 2, 3));
  EXPECT_EQ(motion.fps, 60.0);
  EXPECT_EQ(motion.metres_per_unit, 0.001);
  EXPECT_THAT(message_of(motive_export("Local")), HasSubstr("coordinate space Global"));
}

/// Saved again by a table program of a country with decimal commas.
TEST(PointCsv, ReadsAnExportOfMotiveWithSemicolonsOrTabs) {
  for (const char separator : {';', '\t'}) {
    std::string text = motive_export("Global");
    std::ranges::replace(text, ',', separator);
    text.replace(text.find("60"), 2, "59,94");
    text.replace(text.rfind("4"), 1, "4,5");
    const NamedMotion motion = read(text).front();
    EXPECT_EQ(motion.points.size(), 9U);
    EXPECT_EQ(place(motion, 0, "Bone4"), Vec3(4.5, 2, 3));
    EXPECT_EQ(motion.fps, 59.94);
  }
}

TEST(PointCsv, TheFirstBoneOfMotiveMayBeCalledLikeItsSkeleton) {
  std::string text = motive_export("Global");
  for (auto at = text.find("Fred:Bone0"); at != std::string::npos; at = text.find("Fred:Bone0"))
    text.replace(at, 10, "Fred");
  const NamedMotion motion = read(text).front();
  EXPECT_EQ(motion.name, "Fred");
  EXPECT_EQ(place(motion, 0, "Hip"), Vec3(0, 2, 3));
  EXPECT_EQ(motion.points.size(), 9U);
}

TEST(PointCsv, Motive3CallsTheFirstBoneTwiceLikeItsSkeleton) {
  std::string text = motive_export("Global");
  for (auto at = text.find("Fred:Bone0"); at != std::string::npos; at = text.find("Fred:Bone0"))
    text.replace(at, 10, "Fred:Fred");
  EXPECT_THAT(read(text).front().points, testing::Contains("Hip"));
}

TEST(PointCsv, OfSeveralTablesOfNexusTheTrajectoriesAreRead) {
  const std::string devices =
      "Devices\n1000\n,,Force,,\nFrame,Sub Frame,Fx,Fy,Fz\n,,N,N,N\n1,0,5,6,7\n1,1,5,6,7\n\n";
  const std::string model =
      "Model Outputs,,,,\n100,,,,\n,,Angles,,\nFrame,Sub Frame,X,Y,Z\n,,deg,deg,deg\n1,0,8,8,8\n\n";
  const std::string trajectories =
      "Trajectories,,,,\n100,,,,\n,,M1,,\nFrame,Sub Frame,X,Y,Z\n,,mm,mm,mm\n1,0,1,2,3\n2,0,4,5,6\n\n";
  for (const std::string& text : {devices + model + trajectories, trajectories + devices + model,
                                  model + trajectories + devices, trajectories}) {
    const NamedMotion motion = read(text).front();
    EXPECT_THAT(motion.points, ElementsAre("M1"));
    ASSERT_EQ(motion.frames.size(), 2U) << text;
    EXPECT_EQ(place(motion, 1, "M1"), Vec3(4, 5, 6));
    EXPECT_EQ(motion.fps, 100);
    EXPECT_EQ(motion.metres_per_unit, 0.001);
    EXPECT_EQ(test::has_warning(motion.warnings, "sections"), text != trajectories);
  }
}

TEST(PointCsv, TheRateOfAWorkstationIsBesideItsUnit) {
  const NamedMotion motion =
      read("Title\n\nTRAJECTORIES\n100,Hz\n,M1,,\nField #,X,Y,Z\n1,1,2,3\n2,4,5,6\n").front();
  EXPECT_EQ(motion.fps, 100);
}

TEST(PointCsv, AnglesInColumnsLikePlacesAreRefused) {
  std::string text;
  for (const std::string_view joint : joint_names)
    for (const char* axis : {".z", ".x", ".y"}) text += (text.empty() ? "" : ",") + std::string(joint) + axis;
  for (int frame = 0; frame < 12; ++frame) {
    text += "\n";
    for (int column = 0; column < 3 * joint_count; ++column)
      text += (column > 0 ? "," : "") +
              std::to_string(40 * std::sin((0.5 + 0.07 * column) * frame + 1.3 * column));
  }
  EXPECT_THAT(message_of(text + "\n"), HasSubstr("its numbers look like angles, not positions"));
}

TEST(PointCsv, TakesTheColumnsThatAreCalledPositions) {
  for (const char* word : {"_pos_", ".position.", "Position", " T", "_t", "_trans_"}) {
    SCOPED_TRACE(word);
    const bool capital =
        std::isalpha(static_cast<unsigned char>(std::string(word).back())) != 0 && *word != '_';
    std::string names = "time", row = "0";
    for (int point = 0; point < 8; ++point)
      for (const char* kind : {word, "_rot_"})
        for (const char* axis : {"x", "y", "z"}) {
          const std::string letter =
              capital && kind == word ? std::string(1, static_cast<char>(*axis - 32)) : axis;
          names += ",M" + std::to_string(point) + kind + letter;
          row += kind == word ? "," + std::to_string(point) : ",9";
        }
    const NamedMotion motion = read(names + "\n" + row + "\n").front();
    ASSERT_EQ(motion.points.size(), 8U);
    EXPECT_EQ(place(motion, 0, "M3"), Vec3(3, 3, 3));
    EXPECT_THAT(the_warning(motion.warnings, "columns").detail, HasSubstr("8 of 16 groups of columns"));
  }
  EXPECT_EQ(read("a[X],a[Y],a[Z]\n1,2,3\n").front().points, std::vector<std::string>{"a"});
}

TEST(PointCsv, IsToldFromLabels) {
  EXPECT_TRUE(holds_positions("frame,time,root_x,root_y,root_z\n"));
  EXPECT_FALSE(holds_positions("take,start_frame,end_frame,label\nsalsa_01,0,120,basic\n"));
  EXPECT_FALSE(holds_positions("tier,start,end,value\n"));
}

/// Ten seconds at a rate, without some of the rows. A point moves 1 in a second. @param digits  of the times
std::string ten_seconds(double rate, int digits, int first_missing, int missing,
                        const std::string& above = "") {
  std::string text = above + "time,a_x,a_y,a_z\n";
  for (int row = 0; row < 10 * rate; ++row) {
    if (row >= first_missing && row < first_missing + missing) continue;
    char line[80];
    std::snprintf(line, sizeof line, "%.*f,%.6f,0,0\n", digits, row / rate, row / rate);
    text += line;
  }
  return text;
}

TEST(PointCsv, RowsThatAreMissingLeaveTheOthersWhereTheyWere) {
  for (const char* rate_above : {"", "100\n"}) {
    const NamedMotion motion = read(ten_seconds(100, 3, 400, 50, rate_above)).front();
    EXPECT_EQ(motion.fps, 100.0);
    ASSERT_EQ(motion.frames.size(), 1000U);
    EXPECT_NEAR(place(motion, 399, "a").x(), 3.99, 1e-9);
    EXPECT_FALSE(place(motion, 400, "a").allFinite());
    EXPECT_FALSE(place(motion, 449, "a").allFinite());
    EXPECT_NEAR(place(motion, 450, "a").x(), 4.5, 1e-9);
    EXPECT_THAT(the_warning(motion.warnings, "time-jump").detail,
                HasSubstr("jumps once, from 3.99 to 4.5 s; the 50 frames"));
    EXPECT_EQ(the_warning(motion.warnings, "time-jump").line, *rate_above ? 403 : 402);
  }
}

// As Excel leaves them: they have no time, and the rate of the others stays.
TEST(PointCsv, EmptyRowsAreNoFramesAndAreCounted) {
  const std::string written = *write_clip_csv(two_clips());
  const std::string empty(
      static_cast<std::size_t>(std::count(
          written.begin(), written.begin() + static_cast<std::ptrdiff_t>(written.find('\n')), ',')),
      ',');
  const auto motions = read(written + empty + "\n" + empty + "\r\n");
  ASSERT_EQ(motions.size(), 2U);
  EXPECT_EQ(motions[0].frames.size(), 7U);
  EXPECT_NEAR(*motions[0].fps, 59.94, 1e-6);
  EXPECT_THAT(the_warning(motions[0].warnings, "empty-rows").detail, HasSubstr("2 empty rows were left out"));
}

// As Excel writes them: a line that names the separator, and in quotes what holds it.
TEST(PointCsv, QuotedDecimalCommasAndAStatedSeparatorAreRead) {
  const std::string written = *write_clip_csv(two_clips());
  std::string quoted = "\"";
  for (const char c : written)
    quoted += c == ','    ? std::string("\",\"")
              : c == '\n' ? std::string("\"\n\"")
                          : std::string(1, c == '.' ? '.' : c);
  quoted.pop_back();
  std::string numbers = quoted.substr(quoted.find('\n'));
  std::ranges::replace(numbers, '.', ',');
  const auto expected = read(written);
  const auto motions = read(quoted.substr(0, quoted.find('\n')) + numbers);
  ASSERT_EQ(motions.size(), 2U);
  EXPECT_EQ(motions[1].frames, expected[1].frames);
  EXPECT_EQ(motions[1].fps, expected[1].fps);
  std::string semicolons = written;
  std::ranges::replace(semicolons, ',', ';');
  EXPECT_EQ(read("sep=;\r\n" + semicolons)[1].frames, expected[1].frames);
}

TEST(PointCsv, WithoutTimesAnEmptyRowBetweenOthersIsAFrameInWhichNobodyWasSeen) {
  const auto columns = [](int frame) {
    std::string row;
    for (int point = 0; point < 8; ++point)
      for (int axis = 0; axis < 3; ++axis)
        row += (row.empty() ? "" : ",") +
               (frame < 0 ? "p" + std::to_string(point) + "_" + "xyz"[axis] : std::to_string(frame));
    return row + "\n";
  };
  const std::string empty = std::string(23, ',') + "\n";
  const auto motions = read(columns(-1) + columns(1) + empty + columns(2) + empty);
  ASSERT_EQ(motions[0].frames.size(), 3U);
  EXPECT_TRUE(std::isnan(motions[0].frames[1](0, 0)));
  EXPECT_EQ(motions[0].frames[2](7, 2), 2);
}

TEST(PointCsv, RoundedTimesDoNotJump) {
  for (const double rate : {75.0, 90.0, 120.0, 29.97})
    for (const int digits : {2, 3, 6}) {
      const NamedMotion motion = read(ten_seconds(rate, digits, 0, 0)).front();
      EXPECT_EQ(motion.frames.size(), static_cast<std::size_t>(std::ceil(10 * rate)));
      EXPECT_FALSE(test::has_warning(motion.warnings, "time-jump")) << rate << " Hz, digits: " << digits;
    }
}

TEST(PointCsv, AWrongTimeMakesNoHoursOfNothing) {
  const NamedMotion motion = read("time,a_x,a_y,a_z\n0,1,2,3\n1,1,2,3\n2,1,2,3\n1e300,1,2,3\n").front();
  EXPECT_EQ(motion.frames.size(), 4U);
  EXPECT_THAT(the_warning(motion.warnings, "time-jump").detail, HasSubstr("put one behind the other"));
}

TEST(PointCsv, SaysWhatIsWrong) {
  EXPECT_THAT(message_of(""), HasSubstr("is empty"));
  EXPECT_THAT(message_of("one,two\n1,2\n"), HasSubstr("no line names the x, y and z"));
  EXPECT_THAT(message_of("a_x,a_y,a_z\n"), HasSubstr("no rows of numbers"));
  EXPECT_THAT(message_of("a_x,a_y,a_z\n1,oops,3\n"),
              HasSubstr("walk.csv:2: expected a number for a's y (column 2), found 'oops'"));
  EXPECT_THAT(message_of("a_x,a_y,a_z\n1,2\n1,2,3\n"), HasSubstr("walk.csv:2: expected at least 3 fields"));
  EXPECT_THAT(the_warning(read("a_x,a_y,a_z\n1,2,3\n1,2").front().warnings, "truncated").detail,
              HasSubstr("the 1 whole ones"));
}

TEST(PointCsv, SurvivesDamagedFiles) {
  std::mt19937 random(5);
  const std::string whole = motive_export("Global");
  for (int n = 0; n < 1000; ++n) {
    (void)read_point_csv(test::damaged(whole, random), "damaged.csv");
    (void)read_point_csv(test::damaged("time,a_x,a_y,a_z\n0,1,2,3\n0.5,1,2,3\n", random), "damaged.csv");
  }
}

}  // namespace
}  // namespace abrazo::point_csv_test
