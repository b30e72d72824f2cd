#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <climits>
#include <fstream>

#include "core/library/takes/manifest.hpp"
#include "core/motion/body/body.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "tests/core/library/synthetic_takes.hpp"

namespace abrazo::load_take_test {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::EndsWith;
using testing::HasSubstr;

/// A folder with a.bvh and b.bvh of 12 frames, both.bvh with both, and short.bvh with 9 frames of B.
class LoadTake : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::path(testing::TempDir()) /
             (std::string("abrazo_take_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder);
    const PairedTake recorded = test::circling_take("t", 12);
    const auto shown = [](Clip clip, const char* name) {
      clip.name = name;
      clip.fps = 60;
      return clip;
    };
    const Clip a = shown(recorded.a, "lead"), b = shown(recorded.b, "follow");
    Clip shorter = b;
    shorter.poses.resize(9);
    write("a.bvh", {a});
    write("b.bvh", {b});
    write("both.bvh", {a, b});
    write("short.bvh", {shorter});
    take.name = "t";
    take.a.motion = folder / "a.bvh";
    take.b.motion = folder / "b.bvh";
    take.metres_per_unit = 1;
  }
  void TearDown() override { fs::remove_all(folder); }

  void write(const char* name, const std::vector<Clip>& clips) const {
    const auto text = write_bvh(clips);
    ASSERT_TRUE(text.ok()) << text.error().text();
    std::ofstream(folder / name) << *text;
  }
  PairedTake loaded() {
    auto result = load_take(take, warnings);
    if (!result) throw std::runtime_error(result.error().text());
    return std::move(*result);
  }
  std::string refusal() {
    const auto result = load_take(take, warnings);
    EXPECT_FALSE(result.ok());
    return result.ok() ? "" : result.error().text();
  }

  fs::path folder;
  Manifest::Take take;
  std::vector<std::string> warnings;
};

TEST_F(LoadTake, ReadsBothPerformers) {
  const PairedTake result = loaded();
  EXPECT_EQ(result.a.poses.size(), 12U);
  EXPECT_EQ(result.b.poses.size(), 12U);
  EXPECT_NEAR(result.fps, 60, 1e-3);
  EXPECT_GT(body_of(result.a.poses[0]).height(), 1.05 * body_of(result.b.poses[0]).height())
      << "a is the larger one";
}

TEST_F(LoadTake, ReadsBothPerformersFromOneFile) {
  const PairedTake apart = loaded();
  take.a.motion = take.b.motion = folder / "both.bvh";
  const PairedTake together = loaded();
  EXPECT_LT((apart.b.poses[5] - together.b.poses[5]).cwiseAbs().maxCoeff(), 1e-4);
}

TEST_F(LoadTake, SaysByHowManyFramesThePerformersDiffer) {
  take.b.motion = folder / "short.bvh";
  EXPECT_THAT(refusal(), HasSubstr("take t: performer a has 12 frames and b 9, 3 fewer"));
}

/// One jumps through the whole take, so that no toe of theirs rests on the floor.
TEST_F(LoadTake, PerformersOfTwoFilesStandOnOneFloor) {
  const auto before = load_take(take, warnings);
  ASSERT_TRUE(before.ok()) << before.error().text();
  for (const char* file : {"a.bvh", "b.bvh"}) {
    const bool jumps = file[0] == 'a';
    Clip clip = jumps ? before->a : before->b;
    for (Pose& pose : clip.poses) pose.col(1).array() += jumps ? 0.30 : 0;
    write(file, {clip});
  }
  const auto after = load_take(take, warnings);
  ASSERT_TRUE(after.ok()) << after.error().text();
  EXPECT_NEAR(after->a.poses[5](0, 1) - before->a.poses[5](0, 1), 0.30, 1e-4);
  EXPECT_NEAR(after->b.poses[5](0, 1), before->b.poses[5](0, 1), 1e-4);
  EXPECT_THAT(warnings, Contains(HasSubstr("off the floor of the other performer; nobody was moved")));
}

/// Head down in most frames: the posture alone leaves open which axis points up.
TEST_F(LoadTake, AnAxisThatOneLeavesOpenIsTheOthers) {
  const PairedTake couple = test::circling_take("t", 12);
  Clip down = couple.a;
  for (Pose& pose : down.poses) {
    pose.col(1) *= -1, pose.col(2) *= -1;
    pose.col(1).array() -= pose.col(1).minCoeff();
  }
  write("a.bvh", {down}), write("b.bvh", {down});
  EXPECT_GT(loaded().a.poses[0](joints::Head, 1), loaded().a.poses[0](0, 1))
      << "taken as -Y, with a question";
  write("b.bvh", {couple.b});
  EXPECT_LT(loaded().a.poses[0](joints::Head, 1), loaded().a.poses[0](0, 1));
}

TEST_F(LoadTake, RefusesAFileThatShowsTwoWhereOneIsMeant) {
  take.b.motion = folder / "both.bvh";
  EXPECT_THAT(refusal(), HasSubstr("both.bvh: shows 2 performers; expected one"));
  take.b.motion = take.a.motion;
  EXPECT_THAT(refusal(), HasSubstr("a.bvh: is named for both performers of take t but shows 1"));
  take.a.index = 0;
  EXPECT_THAT(refusal(), HasSubstr("but shows 1; expected 2")) << "b is still not named";
  take.a.index.reset(), take.b.index = 0;
  EXPECT_THAT(refusal(), HasSubstr("but shows 1; expected 2")) << "a is not named";
}

TEST_F(LoadTake, OneRoleReachesToTheLastFrame) {
  take.roles = {{0, INT_MAX, ActivePerformer::B}};
  const PairedTake result = loaded();
  ASSERT_EQ(result.roles.size(), 1U);
  EXPECT_EQ(result.roles[0].end, 12);
}

TEST_F(LoadTake, WarnsOfRolesAndLabelsBeyondTheEnd) {
  take.roles = {{0, 20, ActivePerformer::B}};
  take.labels = folder / "moves.csv";
  std::ofstream(take.labels) << "t,0,15,turn\n";
  const PairedTake result = loaded();
  EXPECT_EQ(result.labels.size(), 1U);
  EXPECT_THAT(warnings, Contains(HasSubstr("take t: its roles go on to frame 20, it has 12")));
  EXPECT_THAT(warnings, Contains(HasSubstr("take t: its labels go on to frame 15, it has 12")));
}

TEST_F(LoadTake, WarnsOfALabelFileThatDoesNotNameTheTake) {
  take.labels = folder / "moves.csv";
  std::ofstream(take.labels) << "other,0,15,turn\n";
  EXPECT_TRUE(loaded().labels.empty());
  EXPECT_THAT(warnings, Contains(HasSubstr("moves.csv: no labels of take t")));
}

TEST_F(LoadTake, SaysWhereTheManifestGivesWhatAReaderAsksFor) {
  take.a.motion = folder / "lonely.amc";
  std::ofstream(take.a.motion) << ":FULLY-SPECIFIED\n:DEGREES\n1\nroot 0 0 0 0 0 0\n";
  EXPECT_THAT(refusal(), EndsWith("name the .asf (\"skeleton\" of the performer)"));
}

TEST_F(LoadTake, RefusesLabelAndMotionFilesThatAreNotThere) {
  take.labels = folder / "none.csv";
  EXPECT_THAT(refusal(), HasSubstr("none.csv: cannot be opened"));
  take.b.motion = folder / "none.bvh";
  EXPECT_THAT(refusal(), HasSubstr("none.bvh"));
}

}  // namespace
}  // namespace abrazo::load_take_test
