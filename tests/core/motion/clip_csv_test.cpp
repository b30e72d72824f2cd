#include "core/motion/tables/clip_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/text.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::clip_csv_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(ClipCsv, WritesOneRowPerFrameThatReadsBackToTheSameNumbers) {
  const Clip clip{
      "someone", 60.0, {test::standing_pose(), test::moved(test::standing_pose(), 0.1, Vec3(0.1, 0, 0))}};
  const std::string text = write_clip_csv(std::vector<Clip>{clip}).value();
  EXPECT_THAT(text, StartsWith("frame,time,root_x,root_y,root_z,lhipjoint_x,"));
  const auto lines = split_lines(text);
  ASSERT_EQ(lines.size(), 3u);
  for (std::size_t f = 0; f < 2; ++f) {
    const auto fields = split_fields(lines[f + 1], ',');
    ASSERT_EQ(fields.size(), 2u + 75u);
    EXPECT_EQ(parse_number(fields[0]), static_cast<double>(f));
    EXPECT_EQ(parse_number(fields[1]), static_cast<double>(f) / 60.0);
    for (std::size_t v = 0; v < 75; ++v)
      EXPECT_EQ(parse_number(fields[2 + v]), clip.poses[f](static_cast<int>(v / 3), static_cast<int>(v % 3)));
  }
}

TEST(ClipCsv, NamesTheColumnsOfSeveralClipsByTheirClip) {
  const std::vector<Clip> clips = {{"active", 60.0, {test::standing_pose()}},
                                   {"passive", 60.0, {test::standing_pose()}}};
  EXPECT_THAT(write_clip_csv(clips).value(), HasSubstr(",active.rhand_z,passive.root_x,"));
}

TEST(ClipCsv, RefusesClipsOfDifferentLengths) {
  const std::vector<Clip> clips = {{"a", 60.0, {test::standing_pose()}}, {"b", 60.0, {}}};
  EXPECT_FALSE(write_clip_csv(clips));
  EXPECT_FALSE(write_clip_csv({}));
}

}  // namespace
}  // namespace abrazo::clip_csv_test
