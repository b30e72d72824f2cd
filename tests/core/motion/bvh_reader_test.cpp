#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <chrono>
#include <numbers>
#include <random>

#include "core/motion/bvh/bvh.hpp"
#include "tests/core/motion/motion_fixtures.hpp"

namespace abrazo::bvh_reader_test {
namespace {

using test::expect_near;
using test::fixture_text;
using test::place;
using test::the_warning;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Eigen::Matrix3d about(int axis, double degrees) {
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, Vec3::Unit(axis)).toRotationMatrix();
}
Eigen::Matrix3d x(double degrees) {
  return about(0, degrees);
}
Eigen::Matrix3d y(double degrees) {
  return about(1, degrees);
}
Eigen::Matrix3d z(double degrees) {
  return about(2, degrees);
}

NamedMotion read(const std::string& name) {
  Result<std::vector<NamedMotion>> motions = read_bvh(fixture_text(name), name);
  if (!motions) {
    ADD_FAILURE() << motions.error().text();
    return {};
  }
  EXPECT_EQ(motions->size(), 1u);
  return motions->front();
}

Error refusal(const std::string& name) {
  const Result<std::vector<NamedMotion>> motions = read_bvh(fixture_text(name), name);
  if (!motions) return motions.error();
  ADD_FAILURE() << name << " was read";
  return {};
}

/// The two frames that arm.bvh and its relatives hold, computed from the definition of the format.
void expect_the_arm(const NamedMotion& motion, const std::string& root = "Hips",
                    const std::string& arm = "Arm") {
  ASSERT_EQ(motion.frames.size(), 2u);
  for (const int sign : {1, -1}) {
    const std::size_t frame = sign > 0 ? 0 : 1;
    const Vec3 hips = sign > 0 ? Vec3(1, 2, 3) : Vec3(4, 5, 6);
    const Eigen::Matrix3d hips_rotation = z(30 * sign) * y(20 * sign) * x(10 * sign);
    const Eigen::Matrix3d arm_rotation = hips_rotation * z(40 * sign) * x(50 * sign) * y(60 * sign);
    expect_near(place(motion, frame, root), hips);
    expect_near(place(motion, frame, arm), hips + hips_rotation * Vec3(1, 0, 0));
    expect_near(place(motion, frame, arm + "_End"),
                hips + hips_rotation * Vec3(1, 0, 0) + arm_rotation * Vec3(0, 2, 0));
  }
}

TEST(BvhReader, ComposesEachJointsRotationsInTheOrderOfItsOwnChannels) {
  const NamedMotion motion = read("arm.bvh");
  expect_the_arm(motion);
  EXPECT_EQ(motion.fps, 30.0);
  EXPECT_EQ(motion.metres_per_unit, std::nullopt);
  EXPECT_EQ(motion.parents, (std::vector<int>{-1, 0, 1}));
}

TEST(BvhReader, ReadsRotationsThatStandBeforePositions) {
  expect_the_arm(read("rotation_first.bvh"));
}

TEST(BvhReader, ReadsJointsWithAnyNumberOfChannels) {
  const NamedMotion motion = read("channel_counts.bvh");
  // Root without position: stays at its OFFSET. One turns by 90 about z, Two by 0 and -90 back, Six is put 5
  // along x instead of its OFFSET and turns again.
  expect_near(place(motion, 0, "Hips"), Vec3(0, 10, 0));
  expect_near(place(motion, 0, "One"), Vec3(3, 10, 0));
  expect_near(place(motion, 0, "Two"), Vec3(3, 11, 0));
  expect_near(place(motion, 0, "Six"), Vec3(8, 11, 0));
  expect_near(place(motion, 0, "Six_End"), Vec3(8, 12, 0));
}

TEST(BvhReader, KeepsBlanksInsideJointNames) {
  expect_the_arm(read("spaces_in_names.bvh"), "The Hips", "Left  Upper Arm");
}

TEST(BvhReader, ReadsAllKindsOfLineEndsAndTabs) {
  for (const char* name : {"crlf.bvh", "cr.bvh", "tabs.bvh", "no_final_newline.bvh"}) {
    SCOPED_TRACE(name);
    const NamedMotion motion = read(name);
    expect_the_arm(motion);
    EXPECT_THAT(motion.warnings, IsEmpty());
  }
}

TEST(BvhReader, SkipsAByteOrderMark) {
  const auto motions = read_bvh("\xEF\xBB\xBF" + fixture_text("arm.bvh"), "marked.bvh");
  ASSERT_TRUE(motions);
  expect_the_arm(motions->front());
}

TEST(BvhReader, ReadsBracesAndStatementsOnOneLine) {
  expect_the_arm(read("braces_on_the_line.bvh"));
}

TEST(BvhReader, ReadsTheRowsThereAreWhateverTheFileAnnounces) {
  for (const char* name : {"fewer_frames_announced.bvh", "more_frames_announced.bvh"}) {
    SCOPED_TRACE(name);
    const NamedMotion motion = read(name);
    expect_the_arm(motion);
    const ImportWarning warning = the_warning(motion.warnings, "frame-count");
    EXPECT_EQ(warning.line, 17);
    EXPECT_THAT(warning.detail, HasSubstr("has 2"));
  }
}

TEST(BvhReader, DoesNotReserveMemoryForAnAnnouncedCount) {
  const auto motions = read_bvh(fixture_text("more_frames_announced.bvh"), "more_frames_announced.bvh");
  ASSERT_TRUE(motions);
  EXPECT_LT(motions->front().frames.capacity(), 100u);
}

TEST(BvhReader, GivesNoRateWhenTheFrameTimeIsZero) {
  const NamedMotion motion = read("frame_time_zero.bvh");
  expect_the_arm(motion);
  EXPECT_EQ(motion.fps, std::nullopt);
  EXPECT_EQ(the_warning(motion.warnings, "frame-time").line, 18);
}

TEST(BvhReader, ReadsExponents) {
  expect_the_arm(read("exponents.bvh"));
}

TEST(BvhReader, TakesGluedNumbersApartAndSaysSo) {
  const NamedMotion motion = read("glued_numbers.bvh");
  expect_the_arm(motion);
  const ImportWarning warning = the_warning(motion.warnings, "glued-numbers");
  EXPECT_EQ(warning.line, 20);
  EXPECT_THAT(warning.detail, HasSubstr("4 time(s)"));
}

TEST(BvhReader, ReadsDecimalCommasAndSaysSo) {
  const NamedMotion motion = read("decimal_commas.bvh");
  expect_the_arm(motion);
  EXPECT_EQ(the_warning(motion.warnings, "commas").line, 19);
  EXPECT_EQ(motion.fps, 30.0);
}

TEST(BvhReader, ReadsCommasAsSeparatorsAndSaysSo) {
  const NamedMotion motion = read("comma_separated.bvh");
  expect_the_arm(motion);
  EXPECT_EQ(the_warning(motion.warnings, "commas").line, 19);
}

TEST(BvhReader, ReadsEndSiteInAnyCase) {
  expect_the_arm(read("lower_case_end_site.bvh"));
}

TEST(BvhReader, MakesOneMotionOfEveryRoot) {
  const auto motions = read_bvh(fixture_text("two_roots.bvh"), "two_roots.bvh");
  ASSERT_TRUE(motions) << motions.error().text();
  ASSERT_EQ(motions->size(), 2u);
  EXPECT_EQ((*motions)[0].name, "a");
  EXPECT_EQ((*motions)[1].name, "b");
  EXPECT_EQ((*motions)[1].parents, (std::vector<int>{-1, 0, 1}));
  EXPECT_EQ((*motions)[1].fps, 60.0);
  expect_near(place((*motions)[0], 1, "a:Arm"), Vec3(2, 2, 4));
  expect_near(place((*motions)[1], 1, "b:Arm"), Vec3(12, 2, 4));
  expect_near(place((*motions)[1], 1, "b:Arm_End"), Vec3(10, 2, 4));  // turned by 90 degrees about z
}

TEST(BvhReader, LetsThePositionChannelsReplaceTheRootsOffset) {
  expect_the_arm(read("root_offset.bvh"));
}

TEST(BvhReader, RenamesASecondJointOfTheSameName) {
  const NamedMotion motion = read("duplicate_names.bvh");
  EXPECT_THAT(motion.points,
              testing::ElementsAre("Hips", "Hand", "Hand_End", "Hand_End.2", "Hand.2", "Hand.2_End"));
  EXPECT_EQ(the_warning(motion.warnings, "duplicate-name").line, 19);
  expect_near(place(motion, 0, "Hand.2_End"), Vec3(-2, 0, 0));
}

TEST(BvhReader, NamesLineFrameAndChannelOfWhatIsNotANumber) {
  const Error nan = refusal("nan.bvh");
  EXPECT_EQ(nan.where, "nan.bvh:20");
  EXPECT_THAT(nan.message, HasSubstr("frame 1 (counted from 0) has 'nan'"));
  EXPECT_THAT(nan.message, HasSubstr("Arm Xrotation"));
  EXPECT_THAT(refusal("not_a_number.bvh").message, HasSubstr("'1.#QNAN'"));
  EXPECT_THAT(refusal("infinite.bvh").message, HasSubstr("infinite"));
}

TEST(BvhReader, RoundsTheRateOfARoundedFrameTimeAndSaysSo) {
  const NamedMotion motion = read("rate_30_0003.bvh");
  EXPECT_EQ(motion.fps, 30.0);
  EXPECT_EQ(the_warning(motion.warnings, "fps-rounded").detail, "30.0003 fps was rounded to 30");
}

TEST(BvhReader, LeavesTelevisionRatesAlone) {
  const NamedMotion motion = read("rate_ntsc.bvh");
  EXPECT_NEAR(motion.fps.value_or(0), 29.97, 1e-4);
  EXPECT_THAT(motion.warnings, IsEmpty());
}

TEST(BvhReader, RefusesARowThatIsShortAndNamesItsLine) {
  const Error error = refusal("short_row.bvh");
  EXPECT_EQ(error.where, "short_row.bvh:20");
  EXPECT_EQ(error.message, "expected 9 numbers (one per channel), found 8");
}

TEST(BvhReader, KeepsTheWholeFramesOfAFileThatWasCutOff) {
  const NamedMotion motion = read("truncated.bvh");
  EXPECT_EQ(motion.frames.size(), 1u);
  EXPECT_EQ(the_warning(motion.warnings, "truncated").line, 20);
}

TEST(BvhReader, ReadsAFileThatLacksAClosingBraceAndSaysSo) {
  const NamedMotion motion = read("missing_brace.bvh");
  expect_the_arm(motion);
  EXPECT_TRUE(test::has_warning(motion.warnings, "braces"));
}

TEST(BvhReader, SaysWhatIsWrongWithAFileItCannotRead) {
  EXPECT_EQ(refusal("unknown_channel.bvh").where, "unknown_channel.bvh:9");
  EXPECT_THAT(refusal("unknown_channel.bvh").message, HasSubstr("found 'Wrotation'"));
  EXPECT_THAT(refusal("no_frames.bvh").message, HasSubstr("no frames"));
  EXPECT_THAT(read_bvh("", "empty.bvh").error().text(), HasSubstr("empty.bvh: has no ROOT"));
  EXPECT_THAT(read_bvh("HIERARCHY\nROOT a\n{\n}\n", "a.bvh").error().text(),
              HasSubstr("without MOTION, so it has no frames; export it again"));
  EXPECT_THAT(read_bvh("\x7f"
                       "ELF\n",
                       "a.out")
                  .error()
                  .text(),
              HasSubstr("a.out:1: expected HIERARCHY"));
  EXPECT_THAT(read_bvh("HIERARCHY\nJOINT a\n", "a.bvh").error().text(), HasSubstr("a.bvh:2: expected ROOT"));
  EXPECT_THAT(read_bvh("HIERARCHY\nROOT a\n{\nCHANNELS 1000000000 Xposition\n", "a.bvh").error().text(),
              HasSubstr("from 0 to 6"));
}

TEST(BvhReader, RefusesEveryCutOfAFileOrKeepsItsWholeFrames) {
  const std::string text = fixture_text("arm.bvh");
  for (std::size_t length = 0; length < text.size(); ++length) {
    const auto motions = read_bvh(std::string_view(text).substr(0, length), "cut.bvh");
    EXPECT_TRUE(motions ? motions->front().frames.size() >= 1 : !motions.error().message.empty()) << length;
  }
}

TEST(BvhReader, SurvivesAnyDamage) {
  std::mt19937 random(11);
  const std::string whole = fixture_text("two_roots.bvh");
  for (int i = 0; i < 3000; ++i) {
    const auto motions = read_bvh(test::damaged(whole, random), "damaged.bvh");
    if (!motions) continue;
    for (const NamedMotion& motion : *motions)
      for (const Positions& frame : motion.frames)
        ASSERT_EQ(frame.rows(), static_cast<Eigen::Index>(motion.points.size()));
  }
}

TEST(BvhReader, ReadsSixHundredThousandFramesInTimeThatGrowsWithTheirNumber) {
  const std::string head = fixture_text("arm.bvh");
  const std::string row = "1 2 3 30 20 10 40 50 60\n";
  const auto seconds_for = [&](int frames) {
    std::string text = head;
    text.reserve(head.size() + row.size() * static_cast<std::size_t>(frames));
    for (int i = 0; i < frames; ++i) text += row;
    const auto start = std::chrono::steady_clock::now();
    const auto motions = read_bvh(text, "long.bvh");
    EXPECT_EQ(motions->front().frames.size(), static_cast<std::size_t>(frames + 2));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const double small = seconds_for(60000);
  // Linear would be 10 times as long, quadratic 100 times; the rest is what a busy machine may add.
  EXPECT_LT(seconds_for(600000), 40 * small + 0.5);
}

}  // namespace
}  // namespace abrazo::bvh_reader_test
