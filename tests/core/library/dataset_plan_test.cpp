#include "core/library/takes/dataset_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <climits>
#include <cmath>
#include <fstream>

#include "core/motion/joints/joint_order.hpp"
#include "tests/core/motion/numpy_fixtures.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::dataset_plan_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class DatasetPlan : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("plan_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void touch(const std::string& file) {
    const auto path = folder_ / file;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << "x";
  }
  Manifest plan(const std::string& layout) {
    auto manifest = plan_dataset(layout, folder_, "/models/body.npz");
    EXPECT_TRUE(manifest) << (manifest ? "" : manifest.error().text());
    return manifest ? *manifest : Manifest{};
  }
  std::string refusal(const std::string& layout) {
    const auto manifest = plan_dataset(layout, folder_);
    return manifest ? "planned" : manifest.error().text();
  }
  std::filesystem::path folder_;
};

/// A body as InterHuman's rows have it: 62 joints of which the first 22 are SMPL-X's body, Z up, metres; then
/// turns of 51, six numbers each.
std::string interhuman_rows(const std::vector<Pose>& poses, const std::string& type, bool column_order) {
  constexpr std::uint64_t columns = 62 * 3 + 51 * 6;
  const auto body = OrderedPoints::of(find_joint_order("smplx22").value()).value();
  std::vector<double> values;
  for (const Pose& pose : poses) {
    std::vector<double> row(columns, 0.25);
    const Positions places = body.positions_of(pose);
    for (Eigen::Index j = 0; j < places.rows(); ++j) {
      const auto at = static_cast<std::size_t>(3 * j);
      row[at] = places(j, 0), row[at + 1] = -places(j, 2), row[at + 2] = places(j, 1);
    }
    values.insert(values.end(), row.begin(), row.end());
  }
  return test::NpyBytes{type, column_order, {poses.size(), columns}}.of(values);
}

std::vector<std::string> names(const Manifest& manifest) {
  std::vector<std::string> all;
  for (const Manifest::Take& take : manifest.takes) all.push_back(take.name);
  return all;
}

TEST_F(DatasetPlan, PairsLeadersAndFollowersOfCompas3d) {
  touch("Pair1/Pair1_song1_take1_leader.npz"), touch("Pair1/Pair1_song1_take1_follower.npz");
  touch("annotations/Pair1_song1_take1.txt"), touch("Pair1/Pair1_song2_take1_leader.npz");
  const Manifest manifest = plan("compas3d");
  ASSERT_THAT(names(manifest), ElementsAre("Pair1_Pair1_song1_take1"));
  const Manifest::Take& take = manifest.takes[0];
  EXPECT_EQ(take.a.motion.filename(), "Pair1_song1_take1_leader.npz");
  EXPECT_EQ(take.b.motion.filename(), "Pair1_song1_take1_follower.npz");
  EXPECT_EQ(take.labels.filename(), "Pair1_song1_take1.txt");
  EXPECT_EQ(take.a.body_model, "/models/body.npz");
  EXPECT_EQ(take.a.up_axis, UpAxis::Z);
  ASSERT_EQ(take.roles.size(), 1U);
  EXPECT_EQ(take.roles[0].end, INT_MAX);
  EXPECT_EQ(take.roles[0].active, ActivePerformer::A);
  ASSERT_EQ(manifest.warnings.size(), 1U);
  EXPECT_THAT(manifest.warnings[0], HasSubstr("1 motion files have no partner and were left out: "));
}

TEST_F(DatasetPlan, KnowsRatesAndFoldersOfInterXAndInterHuman) {
  touch("motions/G001T000A000R000/P1.npz"), touch("motions/G001T000A000R000/P2.npz");
  const Manifest interx = plan("interx");
  ASSERT_THAT(names(interx), ElementsAre("motions_G001T000A000R000"));
  EXPECT_EQ(interx.takes[0].fps, 120);
  EXPECT_TRUE(interx.takes[0].roles.empty());
  EXPECT_FALSE(interx.takes[0].a.up_axis) << "found out from the motion";
  touch("person1/7.npy"), touch("person2/7.npy");
  const Manifest interhuman = plan("interhuman");
  ASSERT_THAT(names(interhuman), ElementsAre("7"));
  EXPECT_EQ(interhuman.takes[0].fps, 30);
  EXPECT_EQ(interhuman.takes[0].b.motion, folder_ / "person2/7.npy");
}

TEST_F(DatasetPlan, InterXNeedsAFolderForEachTake) {
  touch("P1.npz"), touch("P2.npz");
  EXPECT_THAT(refusal("interx"), HasSubstr("holds no pair of the dataset interx among 2 files"));
}

TEST_F(DatasetPlan, InterHumanHasTwoPersons) {
  touch("person3/7.npy"), touch("person2/7.npy");
  EXPECT_THAT(refusal("interhuman"), HasSubstr("holds no pair of the dataset interhuman among 2 files"));
}

TEST_F(DatasetPlan, Compas3dNeedsANameBeforeTheRole) {
  touch("Pair1/_leader.npz"), touch("Pair1/_follower.npz");
  EXPECT_THAT(refusal("compas3d"), HasSubstr("holds no pair of the dataset compas3d among 2 files"));
}

TEST_F(DatasetPlan, SkeletonsAndTablesBesideADatasetAreNoMotionsWithoutAPartner) {
  touch("take/P1.npz"), touch("take/P2.npz"), touch("take/body.asf"), touch("take/markers.csv");
  EXPECT_THAT(plan("interx").warnings, testing::IsEmpty());
  touch("take/P3.bvh");
  EXPECT_THAT(plan("interx").warnings, ElementsAre(HasSubstr("1 motion files have no partner")));
}

TEST_F(DatasetPlan, LooksIntoTwelveFoldersBelowOneAnotherAndNoFarther) {
  std::string folders;
  for (int depth = 0; depth < 12; ++depth) folders += "d/";
  touch(folders + "m_leader.npz"), touch(folders + "m_follower.npz");
  touch(folders + "d/n_leader.npz"), touch(folders + "d/n_follower.npz");
  EXPECT_THAT(names(plan("compas3d")), ElementsAre(testing::EndsWith("_m")));
}

TEST_F(DatasetPlan, PairsOfInterHumanAreReadAsTheirManifestSays) {
  const PairedTake pair = test::swinging_take("dance", 40, 1);
  for (const bool column_order : {false, true}) {
    for (const auto& [person, clip] : {std::pair("person1/7.npy", &pair.a), {"person2/7.npy", &pair.b}}) {
      touch(person);
      std::ofstream(folder_ / person, std::ios::binary) << interhuman_rows(clip->poses, "<f4", column_order);
    }
    std::vector<std::string> warnings;
    const auto take = load_take(plan("interhuman").takes.at(0), warnings);
    ASSERT_TRUE(take) << take.error().text();
    EXPECT_EQ(take->fps, 30);
    ASSERT_EQ(take->b.poses.size(), 40U);
    for (const int joint :
         std::initializer_list<int>{joints::Root, joints::left_hip, joints::right_knee, joints::left_toe_base,
                                    joints::LowerNeck, joints::right_shoulder, joints::left_wrist})
      for (const std::size_t frame : {0U, 39U}) {
        EXPECT_LT((take->a.poses[frame].row(joint) - pair.a.poses[frame].row(joint)).norm(), 1e-6) << joint;
        EXPECT_LT((take->b.poses[frame].row(joint) - pair.b.poses[frame].row(joint)).norm(), 1e-6) << joint;
      }
  }
}

TEST_F(DatasetPlan, RowsThatAreNotInterHumansAreRefusedWithTheReason) {
  touch("person1/7.npy"), touch("person2/7.npy");
  const auto reason = [&](const std::string& bytes) {
    std::ofstream(folder_ / "person1/7.npy", std::ios::binary) << bytes;
    std::vector<std::string> warnings;
    const auto take = load_take(plan("interhuman").takes.at(0), warnings);
    return take ? "was read" : take.error().text();
  };
  const std::string whole = interhuman_rows({test::swinging_take("d", 12, 1).a.poses[0]}, "<f8", false);
  EXPECT_THAT(reason(whole.substr(0, whole.size() - 9)), HasSubstr("cut off"));
  EXPECT_THAT(reason(test::NpyBytes{"<f8", false, {1, 491}}.of(std::vector<double>(491, 0.5))),
              HasSubstr("(1, 491)"));
  std::vector<double> infinite(492, 0.5);
  infinite[7] = HUGE_VAL;
  EXPECT_THAT(reason(test::NpyBytes{"<f8", false, {1, 492}}.of(infinite)),
              HasSubstr("frame 0 (counted from 0) has an infinite position"));
}

TEST_F(DatasetPlan, PairsFilesThatDifferByOneWord) {
  touch("lindy_1_leader.bvh"), touch("lindy_1_follower.bvh"), touch("b/p2/x.fbx"), touch("b/p1/x.fbx");
  EXPECT_THAT(names(plan("folder")), ElementsAre("b_x", "lindy_1"));
  const Manifest remocap = plan("remocap");
  ASSERT_THAT(names(remocap), ElementsAre("lindy_1"));
  EXPECT_EQ(remocap.takes[0].metres_per_unit, 0.001);
}

TEST_F(DatasetPlan, IsAManifestThatReadsBack) {
  touch("m_leader.npz"), touch("m_follower.npz");
  const auto again = parse_manifest(manifest_json(plan("compas3d"), folder_), folder_ / "manifest.json");
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(again->takes[0].a.motion, folder_ / "m_leader.npz");
  EXPECT_EQ(again->takes[0].b.body_model.lexically_normal(), "/models/body.npz");
}

TEST_F(DatasetPlan, SaysWhatWasExpected) {
  touch("a.bvh");
  EXPECT_THAT(refusal("interx"),
              HasSubstr("holds no pair of the dataset interx among 1 files; expected a folder"));
  EXPECT_THAT(refusal("salsa"), HasSubstr("no dataset 'salsa'; expected one of compas3d, interx"));
  EXPECT_THAT(plan_dataset("folder", "/nowhere/at/all").error().text(), HasSubstr("is no folder"));
}

}  // namespace
}  // namespace abrazo::dataset_plan_test
