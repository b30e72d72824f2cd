#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>

#include "core/motion/bvh/bvh.hpp"
#include "core/motion/files/import_clip.hpp"
#include "tests/core/motion/motion_fixtures.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/captured_data.hpp"

namespace abrazo::load_motion_test {
namespace {

namespace fs = std::filesystem;
using test::has_warning;
using test::motion_fixture;
using ::testing::HasSubstr;

Result<std::vector<ImportedClip>> load(const fs::path& file, const fs::path& skeleton = {}) {
  return load_motion(file.string(), skeleton.string(), {});
}

ImportedClip the_clip(const fs::path& file, const fs::path& skeleton = {}) {
  Result<std::vector<ImportedClip>> clips = load(file, skeleton);
  if (clips && clips->size() == 1) return clips->front();
  ADD_FAILURE() << (clips ? "not one performer" : clips.error().text());
  return {};
}

class TemporaryFolder {
 public:
  TemporaryFolder()
      : path_(fs::temp_directory_path() / ("abrazo_load_motion_" + std::to_string(::getpid()))) {
    fs::create_directories(path_);
  }
  ~TemporaryFolder() { fs::remove_all(path_); }
  fs::path write(const std::string& name, const std::string& text) const {
    EXPECT_TRUE(write_whole_file(path_ / name, text));
    return path_ / name;
  }

 private:
  fs::path path_;
};

TEST(LoadMotion, ReadsLafanInCentimetresAndReportsTheRestPose) {
  const ImportedClip result = the_clip(motion_fixture("lafan_rest_first.bvh"));
  EXPECT_EQ(result.clip.name, "lafan_rest_first");
  EXPECT_EQ(result.report.joint_map, "lafan");
  EXPECT_DOUBLE_EQ(result.report.metres_per_unit, 0.01);
  EXPECT_NEAR(result.report.height_m, 1.72, 0.02);
  EXPECT_TRUE(has_warning(result.report.warnings, "first-frame"));
  ASSERT_EQ(result.clip.poses.size(), 5u);
  const Pose& rest = result.clip.poses[0];
  EXPECT_NEAR(rest(joints::left_hand, 0), 0.78, 1e-9);
  EXPECT_NEAR(rest(joints::left_wrist, 0), 0.70, 1e-9);
  EXPECT_NEAR(rest(joints::right_toe_tip, 2), 0.20, 1e-9);
}

TEST(LoadMotion, ReadsTheSamePersonInMetresAndInInchesWithZUp) {
  const ImportedClip metres = the_clip(motion_fixture("lafan_metres.bvh"));
  const ImportedClip inches = the_clip(motion_fixture("mixamo_z_up_inches.bvh"));
  EXPECT_DOUBLE_EQ(metres.report.metres_per_unit, 1.0);
  EXPECT_DOUBLE_EQ(inches.report.metres_per_unit, 0.0254);
  EXPECT_EQ(inches.report.up_axis, UpAxis::Z);
  EXPECT_EQ(inches.report.joint_map, "mixamo");
  ASSERT_EQ(metres.clip.poses.size(), inches.clip.poses.size());
  for (std::size_t f = 0; f < metres.clip.poses.size(); ++f)
    EXPECT_LT((metres.clip.poses[f] - inches.clip.poses[f]).cwiseAbs().maxCoeff(),
              1e-5);  // six digits in the files
}

TEST(LoadMotion, LiftsAPersonOutOfTheFloor) {
  const ImportedClip result = the_clip(motion_fixture("sunken_floor.bvh"));
  EXPECT_NEAR(result.report.floor_y_m, -0.98, 1e-9);
  EXPECT_NEAR(result.clip.poses[0](joints::left_toe_base, 1), 0.04, 1e-9);
}

TEST(LoadMotion, MovesPerformersOfOneFileTogether) {
  std::vector<Clip> clips(2);
  clips[0].name = "a";
  clips[1].name = "b";
  clips[0].poses.assign(3, test::moved(test::standing_pose(), 0, Vec3(0, 0.50, 0)));
  clips[1].poses.assign(3, test::moved(test::standing_pose(), 3, Vec3(0, 0.30, 1)));
  const TemporaryFolder folder;
  const auto loaded = load(folder.write("pair.bvh", write_bvh(clips).value()));
  ASSERT_TRUE(loaded) << loaded.error().text();
  ASSERT_EQ(loaded->size(), 2u);
  EXPECT_EQ((*loaded)[0].clip.name, "a");
  EXPECT_EQ((*loaded)[1].clip.name, "b");
  EXPECT_NEAR((*loaded)[0].report.floor_shift_m, -0.30, 1e-5);
  EXPECT_EQ((*loaded)[1].report.floor_shift_m, (*loaded)[0].report.floor_shift_m);
  EXPECT_TRUE(has_warning((*loaded)[1].report.warnings, "floor"));
  EXPECT_NEAR((*loaded)[1].clip.poses[0](0, 1) - (*loaded)[0].clip.poses[0](0, 1), -0.20, 1e-5);
}

TEST(LoadMotion, WhoIsInTheAirAllAlongStaysThereWhereTheOtherStands) {
  std::vector<Clip> clips(2);
  clips[0].name = "a", clips[1].name = "b";
  clips[0].poses.assign(3, test::moved(test::standing_pose(), 0, Vec3(0, 0.30, 0)));
  clips[1].poses.assign(3, test::moved(test::standing_pose(), 3, Vec3(0, 0, 1)));
  const TemporaryFolder folder;
  const auto loaded = load(folder.write("pair.bvh", write_bvh(clips).value()));
  ASSERT_TRUE(loaded) << loaded.error().text();
  EXPECT_NEAR((*loaded)[0].clip.poses[0](0, 1) - (*loaded)[1].clip.poses[0](0, 1), 0.30, 1e-5);
  EXPECT_EQ((*loaded)[0].report.floor_shift_m, 0);
  EXPECT_TRUE(has_warning((*loaded)[0].report.warnings, "floor"));
  EXPECT_FALSE(has_warning((*loaded)[1].report.warnings, "floor"));
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
  return text;
}

/// The fixture's person, whose feet are 14 cm to the ball and 6 cm to the toes' tip.
TEST(LoadMotion, AFootOfTwoPartsIsFoundWhateverTheyAreCalled) {
  const TemporaryFolder folder;
  const std::string text = test::fixture_text("lafan_metres.bvh");
  const ImportedClip known = the_clip(motion_fixture("lafan_metres.bvh"));
  for (const char* name : {"Toes", "ForeFoot", "toe1-1.l"}) {
    const ImportedClip found =
        the_clip(folder.write("foot.bvh", replaced(text, "JOINT LeftToe", "JOINT Left" + std::string(name))));
    for (const int joint : std::initializer_list<int>{joints::left_toe_base, joints::left_toe_tip})
      EXPECT_LT((found.clip.poses[2].row(joint) - known.clip.poses[2].row(joint)).norm(), 1e-9) << name;
  }
}

/// "LeftForeFoot" straight below the ankle, its End Site ahead: the ball is on the way along both.
TEST(LoadMotion, AFootAroundTheCornerHasItsBallAlongTheChain) {
  const TemporaryFolder folder;
  std::string text = replaced(test::fixture_text("lafan_metres.bvh"), "JOINT LeftToe", "JOINT LeftForeFoot");
  text = replaced(text, "OFFSET 0 -0.06 0.13", "OFFSET 0 -0.04 0");
  text = replaced(text, "OFFSET 0 0 0.06", "OFFSET 0 0 0.22");
  const Pose pose = the_clip(folder.write("foot.bvh", text)).clip.poses[0];
  const auto length = [&](int a, int b) { return (pose.row(a) - pose.row(b)).norm(); };
  EXPECT_NEAR(length(joints::left_toe_base, joints::left_toe_tip), 0.3 * 0.26, 1e-6);
  EXPECT_NEAR(length(joints::left_ankle, joints::left_toe_tip), std::hypot(0.04, 0.22), 1e-6);
}

TEST(LoadMotion, EndSitesOfNoLengthAreAbsentAndTheirJointsInferred) {
  const TemporaryFolder folder;
  std::string text = test::fixture_text("lafan_metres.bvh");
  for (auto end = text.find("End Site"); end != std::string::npos; end = text.find("End Site", end + 8)) {
    const auto offset = text.find("OFFSET", end);
    text.replace(offset, text.find('\n', offset) - offset, "OFFSET 0.000 0.0 0");
  }
  const ImportedClip found = the_clip(folder.write("ends.bvh", text));
  EXPECT_THAT(found.report.inferred_joints,
              testing::IsSupersetOf({int(joints::left_toe_tip), int(joints::right_toe_tip), int(joints::Head),
                                     int(joints::left_hand), int(joints::right_hand)}));
  const Pose& pose = found.clip.poses[0];
  const auto length = [&](int a, int b) { return (pose.row(a) - pose.row(b)).norm(); };
  EXPECT_NEAR(length(joints::Head, joints::UpperNeck), 1.2 * length(joints::UpperNeck, joints::LowerNeck),
              1e-6);
  EXPECT_NEAR(length(joints::left_toe_tip, joints::left_toe_base),
              0.35 * length(joints::left_toe_base, joints::left_ankle), 1e-6);
}

/// What Abrazo writes has CMU's names with each node where its bone ends. Some writers put the nodes where
/// the bones start.
TEST(LoadMotion, NodesAtTheStartsOfBonesAreToldByTheHips) {
  const Pose pose = test::standing_pose();
  std::string text = "HIERARCHY\n";
  std::size_t channels = 0;
  const auto node = [&](const auto& self, int joint, const std::string& name) -> void {
    const auto start = [&](int of) -> Vec3 {
      if (of <= 0) return Vec3::Zero();
      return (pose.row(joint_parents[static_cast<std::size_t>(of)]) - pose.row(0)).transpose();
    };
    const int above = joint_parents[static_cast<std::size_t>(joint)];
    const Vec3 offset = start(joint) - start(above);
    text += (joint == 0 ? "ROOT " : "JOINT ") + name + "\n{\nOFFSET " + std::to_string(offset.x()) + " " +
            std::to_string(offset.y()) + " " + std::to_string(offset.z()) + "\n";
    text += joint == 0 ? "CHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation\n"
                       : "CHANNELS 3 Zrotation Yrotation Xrotation\n";
    channels += joint == 0 ? 6 : 3;
    bool leaf = true;
    for (int child = 1; child < joint_count; ++child)
      if (joint_parents[static_cast<std::size_t>(child)] == joint)
        leaf = false, self(self, child, std::string(joint_names[static_cast<std::size_t>(child)]));
    if (leaf) {
      const Vec3 end = (pose.row(joint) - pose.row(above)).transpose();
      text += "End Site\n{\nOFFSET " + std::to_string(end.x()) + " " + std::to_string(end.y()) + " " +
              std::to_string(end.z()) + "\n}\n";
    }
    text += "}\n";
  };
  node(node, 0, "root");
  text += "MOTION\nFrames: 1\nFrame Time: 0.0333333\n";
  text += "0 " + std::to_string(pose(0, 1)) + " 0";
  for (std::size_t c = 3; c < channels; ++c) text += " 0";
  // The 25 joints have no lower arm's twist and fingers, which files of this kind have.
  text = replaced(replaced(text, "JOINT lwrist", "JOINT lradius"), "JOINT rwrist", "JOINT rradius");
  const TemporaryFolder folder;
  const ImportedClip found = the_clip(folder.write("starts.bvh", text + "\n"));
  EXPECT_EQ(found.report.joint_map, "cmu-bone-starts");
  for (const int joint : std::initializer_list<int>{
           joints::left_hip, joints::left_knee, joints::right_ankle, joints::left_toe_base,
           joints::left_toe_tip, joints::UpperNeck, joints::Head, joints::left_shoulder, joints::right_elbow})
    EXPECT_LT((found.clip.poses[0].row(joint) - pose.row(joint)).norm(), 1e-4) << joint;
}

TEST(LoadMotion, APointerOfGitLfsIsNoFileInAnyFormat) {
  const TemporaryFolder folder;
  for (const char* name :
       {"a.bvh", "a.amc", "a.c3d", "a.trc", "a.csv", "a.glb", "a.fbx", "a.dae", "a.npy", "a.npz"}) {
    const auto loaded =
        load(folder.write(name, "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n"));
    ASSERT_FALSE(loaded) << name;
    EXPECT_THAT(loaded.error().text(),
                HasSubstr("is a Git LFS pointer in place of the file: run git lfs pull"));
  }
}

/// A table with a person's joints under a name/// A table with a person's joints under a name, and more
/// points.
std::string table_with(const std::string& person, const std::vector<std::string>& others) {
  std::vector<std::string> points;
  for (const std::string_view joint : joint_names) points.push_back(person + ":" + std::string(joint));
  points.insert(points.end(), others.begin(), others.end());
  std::string text = "time";
  for (const std::string& point : points) text += "," + point + "_x," + point + "_y," + point + "_z";
  for (int f = 0; f < 4; ++f) {
    text += "\n" + std::to_string(f / 60.0);
    for (std::size_t p = 0; p < points.size(); ++p)
      for (int axis = 0; axis < 3; ++axis)
        text += "," + std::to_string(p < joint_count ? test::standing_pose()(static_cast<int>(p), axis)
                                                     : 0.1 * static_cast<double>(p));
  }
  return text + "\n";
}

std::vector<std::string> box(const std::string& name) {
  std::vector<std::string> points;
  for (int corner = 1; corner <= 8; ++corner) points.push_back(name + ":corner" + std::to_string(corner));
  return points;
}

TEST(LoadMotion, LeavesOutABoxThatWasCapturedWithAPerson) {
  const TemporaryFolder folder;
  const auto loaded = load(folder.write("session.csv", table_with("Anna", box("Box"))));
  ASSERT_TRUE(loaded) << loaded.error().text();
  ASSERT_EQ(loaded->size(), 1u);
  EXPECT_EQ(loaded->front().clip.name, "Anna");
  EXPECT_THAT(test::the_warning(loaded->front().report.warnings, "left-out").detail,
              HasSubstr("1 of 2 in the file cannot be read as performers and were left out: Box (8 points)"));
}

TEST(LoadMotion, WhereNobodyCanBeReadSaysWhoIsThere) {
  const TemporaryFolder folder;
  std::string text = table_with("Anna", box("Box"));
  for (auto at = text.find("Anna:root"); at != std::string::npos; at = text.find("Anna:root"))
    text.replace(at, 9, "Anna:rood");
  const auto loaded = load(folder.write("session.csv", text));
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().message, HasSubstr("the closest, 'cmu', lacks root (root)"));
  EXPECT_THAT(loaded.error().message, HasSubstr("The file holds Anna with 25 points, Box with 8 points"));
}

TEST(LoadMotion, RefusesAnAnimationWhereAFileHoldsOne) {
  ImportOptions options;
  options.animation = "walk";
  const auto loaded = load_motion(motion_fixture("lafan_metres.bvh").string(), "", options);
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().message,
              HasSubstr("a BVH file holds one motion without a name; leave out the animation 'walk'"));
}

TEST(LoadMotion, FindsTheSkeletonBesideAnAmcByName) {
  const TemporaryFolder folder;
  folder.write("other.asf", "not read");
  folder.write("leg.asf", test::fixture_text("leg.asf"));
  const auto found = load(folder.write("leg_07_b.amc", test::fixture_text("leg.amc")));
  ASSERT_FALSE(found);  // a leg is not a person, but it was read
  EXPECT_THAT(found.error().message, HasSubstr("no joint map fits"));
  const auto lost = load(folder.write("arm_01.amc", test::fixture_text("leg.amc")));
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().hint, Hint::NameSkeleton);
}

TEST(LoadMotion, SaysWhatItCannotOpen) {
  EXPECT_THAT(load("absent.bvh").error().text(), HasSubstr("absent.bvh: cannot be opened"));
  EXPECT_THAT(load(motion_fixture("leg.asf")).error().message, HasSubstr("is a skeleton without motion"));
  EXPECT_THAT(load(ABRAZO_FIXTURES).error().message, HasSubstr("is a folder"));
  const TemporaryFolder folder;
  EXPECT_THAT(load(folder.write("dance.mp3", "x")).error().message, HasSubstr("expected one of BVH"));
  EXPECT_THAT(load(motion_fixture("nan.bvh")).error().where, HasSubstr("nan.bvh:20"));
}

TEST(LoadMotion, ReadsACapturedTake) {
  ABRAZO_REQUIRE_CAPTURED_DATA(data);
  const ImportedClip leader = the_clip(data / "cmu_salsa" / "60_01.amc");
  EXPECT_EQ(leader.clip.poses.size(), 2242u);
  EXPECT_EQ(leader.report.joint_map, "cmu");
  EXPECT_NEAR(leader.report.metres_per_unit, 0.0564444, 1e-7);
  EXPECT_NEAR(leader.report.floor_y_m, 0.04, 0.01);
  EXPECT_EQ(leader.report.floor_shift_m, 0.0);
  EXPECT_TRUE(leader.report.fps_guessed);
  EXPECT_FALSE(has_warning(leader.report.warnings, "height"));
  EXPECT_FALSE(has_warning(leader.report.warnings, "first-frame"));
}

}  // namespace
}  // namespace abrazo::load_motion_test
