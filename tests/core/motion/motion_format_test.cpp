#include "core/motion/joints/motion_format.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/motion/files/format_recognition.hpp"
#include "core/motion/files/import_clip.hpp"
#include "tests/core/motion/c3d_bytes.hpp"
#include "tests/core/motion/motion_fixtures.hpp"

namespace abrazo::motion_format_test {
namespace {

using ::testing::HasSubstr;

TEST(MotionFormat, IsKnownByTheNameInAnyCase) {
  EXPECT_EQ(format_of_name("a/Walk.C3D"), MotionFormat::C3d);
  EXPECT_EQ(format_of_name("dancer.vrm"), MotionFormat::Gltf);
  EXPECT_EQ(format_of_name("noextension"), std::nullopt);
  EXPECT_EQ(format_of_name("video.mp4"), std::nullopt);
  EXPECT_EQ(name_of(MotionFormat::Collada), "Collada");
}

TEST(MotionFormat, IsKnownByTheContentWhateverTheName) {
  EXPECT_EQ(format_of_content(test::fixture_text("arm.bvh")), MotionFormat::Bvh);
  EXPECT_EQ(format_of_content(test::fixture_text("leg.asf")), MotionFormat::Asf);
  EXPECT_EQ(format_of_content(test::fixture_text("leg.amc")), MotionFormat::Amc);
  EXPECT_EQ(format_of_content("PathFileType\t4\t(X/Y/Z)\tx.trc\n"), MotionFormat::Trc);
  EXPECT_EQ(format_of_content("time,a_x,a_y,a_z\n"), MotionFormat::PointCsv);
  EXPECT_EQ(format_of_content("glTF\x02"), MotionFormat::Gltf);
  EXPECT_EQ(format_of_content("Kaydara FBX Binary  "), MotionFormat::Fbx);
  test::C3dBytesWriter writer;
  writer.labels = {"A"}, writer.frames = {{{1, 2, 3}}};
  EXPECT_EQ(format_of_content(writer.bytes()), MotionFormat::C3d);
  EXPECT_EQ(format_of_content("take,start_frame,end_frame,label\n"), std::nullopt);
}

TEST(MotionFormat, NamesFilesOfOtherProgramsAndSaysWhatToDo) {
  EXPECT_THAT(foreign_kind("#usda 1.0", "dance.usda"), HasSubstr("is a USD file; open it in Blender"));
  EXPECT_EQ(foreign_kind(std::string_view("PK\x03\x04zip"), "poses.npz"), "")
      << "its reader says what is wrong";
  EXPECT_THAT(foreign_kind(std::string_view("PK\x03\x04zip"), "takes.zip"), HasSubstr("unpack it first"));
  EXPECT_THAT(foreign_kind("BLENDER-v304", "dance.blend"), HasSubstr("Blender file"));
  EXPECT_THAT(foreign_kind("whatever", "walk.tak"), HasSubstr("open it in Motive"));
  EXPECT_EQ(foreign_kind("whatever", "walk.xyz"), "");
}

TEST(MotionFormat, ReadsAFileUnderAWrongNameAndSaysSo) {
  const auto folder = std::filesystem::temp_directory_path() / "abrazo_wrong_name";
  std::filesystem::create_directories(folder);
  const auto file = folder / "really_a_bvh.trc";
  ASSERT_TRUE(write_whole_file(file, test::fixture_text("lafan_metres.bvh")));
  const auto clips = load_motion(file.string(), "", {});
  ASSERT_TRUE(clips) << clips.error().text();
  EXPECT_THAT(test::the_warning(clips->front().report.warnings, "format").detail, HasSubstr("holds BVH"));
  std::filesystem::remove_all(folder);
}

TEST(MotionFormat, GivesFileDialogsEveryExtension) {
  EXPECT_THAT(motion_file_patterns(true), HasSubstr("*.asf"));
  for (const MotionFormatInfo& info : motion_formats())
    if (info.format != MotionFormat::Asf) {
      EXPECT_THAT(motion_file_patterns(false), HasSubstr(std::string(info.extensions.substr(0, 4))));
    }
}

}  // namespace
}  // namespace abrazo::motion_format_test
