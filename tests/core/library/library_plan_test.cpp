#include "core/library/build/library_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <climits>
#include <fstream>

#include "core/library/build/motion_library_builder.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "tests/core/library/synthetic_takes.hpp"

namespace abrazo::library_plan_test {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using Kind = PlanRemark::Kind;

/// A folder of its own with BVH files of circling couples.
class Plan : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::path(testing::TempDir()) /
             (std::string("abrazo_plan_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  /// One performer of a couple, in some unit, without the frames before `cut`.
  void write(const std::string& file, int frames, bool follower, double units_per_metre = 1, int cut = 0) {
    const PairedTake take = test::circling_take("t", frames);
    Clip clip = follower ? take.b : take.a;
    clip.poses.erase(clip.poses.begin(), clip.poses.begin() + cut);
    std::ofstream(folder / file) << *write_bvh(std::vector<Clip>{clip}, units_per_metre);
    survey(file);
  }
  void survey(const std::string& file) {
    for (PlannedPerformer& performer : survey_motion({.motion = folder / file}, std::nullopt))
      plan.performers.push_back(std::move(performer));
  }
  std::string first_obstacle() const {
    const auto remarks = remarks_on(plan);
    return !remarks.empty() && remarks.front().kind == Kind::Obstacle ? remarks.front().whole() : "";
  }
  std::vector<std::string> warnings() const {
    std::vector<std::string> texts;
    for (const PlanRemark& remark : remarks_on(plan))
      if (remark.kind != Kind::Obstacle) texts.push_back(remark.whole());
    return texts;
  }
  fs::path folder;
  LibraryPlan plan;
};

TEST_F(Plan, OfACoupleBuildsALibraryFromItsManifest) {
  write("x_follower.bvh", 20, true);
  write("x_leader.bvh", 20, false);
  pair_up(plan);
  EXPECT_EQ(first_obstacle(), "");
  const Manifest manifest = manifest_of(plan);
  ASSERT_EQ(manifest.takes.size(), 1U);
  EXPECT_EQ(manifest.takes[0].name, "x");
  EXPECT_EQ(manifest.takes[0].a.motion.filename(), "x_leader.bvh") << "who leads stands first";
  ASSERT_EQ(manifest.takes[0].roles.size(), 1U);
  EXPECT_EQ(manifest.takes[0].roles[0].active, ActivePerformer::A);
  std::vector<std::string> read;
  const auto library = build_library(manifest, {}, {}, read);
  ASSERT_TRUE(library.ok()) << library.error().text();
  EXPECT_EQ(library->pair_count(), 20);
}

TEST_F(Plan, SavedAsAManifestReadsBackTheSame) {
  write("x_A.bvh", 20, false, 100);
  write("x_B.bvh", 24, true, 39.37);
  pair_up(plan);
  plan.performers[1].source.start = 2;
  plan.name = "mine";
  const Manifest told = manifest_of(plan);
  const auto read = parse_manifest(manifest_json(told, folder), folder / "mine.json");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_THAT(read->warnings, IsEmpty());
  EXPECT_EQ(read->name, "mine");
  const Manifest::Take &before = told.takes[0], &after = read->takes[0];
  EXPECT_EQ(after.name, before.name);
  EXPECT_EQ(after.fps, before.fps);
  EXPECT_EQ(after.frames, before.frames);
  EXPECT_EQ(after.frames, 20);
  EXPECT_EQ(after.a.motion, before.a.motion);
  EXPECT_EQ(after.a.metres_per_unit, 0.01);
  EXPECT_EQ(after.b.metres_per_unit, 0.0254);
  EXPECT_EQ(after.b.start, 2);
  EXPECT_EQ(after.b.up_axis, UpAxis::Y);
  EXPECT_EQ(after.b.joint_map, "cmu");
  EXPECT_TRUE(after.roles.empty()) << "either may be active";
  EXPECT_NE(manifest_json(told, folder).find("\"x_A.bvh\""), std::string::npos) << "relative to its folder";
}

TEST_F(Plan, AMapThatWasFoundFromTheFileIsNotNamed) {
  write("x_A.bvh", 20, false), write("x_B.bvh", 20, true);
  pair_up(plan);
  plan.performers[0].report.joint_map = "skeleton";
  const Manifest manifest = manifest_of(plan);
  EXPECT_EQ(manifest.takes.at(0).a.joint_map, "");
  EXPECT_EQ(manifest.takes.at(0).b.joint_map, "cmu");
}

/// Y points down, as in the space of a camera: the manifest must say so, or the library is upside down.
TEST_F(Plan, KeepsAnAxisThatPointsDown) {
  for (const bool follower : {false, true}) {
    const PairedTake take = test::circling_take("t", 20);
    Clip clip = follower ? take.b : take.a;
    for (Pose& pose : clip.poses) turn_from_y_up(pose, UpAxis::MinusY);
    std::ofstream(folder / (follower ? "x_follower.bvh" : "x_leader.bvh"))
        << *write_bvh(std::vector<Clip>{clip});
    survey(follower ? "x_follower.bvh" : "x_leader.bvh");
  }
  pair_up(plan);
  const auto read = parse_manifest(manifest_json(manifest_of(plan), folder), folder / "mine.json");
  ASSERT_TRUE(read.ok()) << read.error().text();
  ASSERT_EQ(read->takes.size(), 1U);
  std::vector<std::string> warned;
  const auto library = build_library(*read, {}, {}, warned);
  ASSERT_TRUE(library.ok()) << library.error().text();
  EXPECT_EQ(read->takes[0].a.up_axis, UpAxis::MinusY);
  EXPECT_EQ(read->takes[0].b.up_axis, UpAxis::MinusY);
  const auto take = load_take(read->takes[0], warned);
  ASSERT_TRUE(take.ok()) << take.error().text();
  for (const Clip* clip : {&take->a, &take->b})
    EXPECT_GT(clip->poses[0](joints::Head, 1), 1.2) << "metres above the floor";
}

TEST_F(Plan, UsesTheFramesThatBothHave) {
  write("x_A.bvh", 20, false);
  write("x_B.bvh", 20, true, 1, 3);  // began three frames later
  pair_up(plan);
  EXPECT_EQ(used_frames(plan, 0), 17);
  EXPECT_EQ(used_frames(plan, 1), 17) << "also of the partner of the first";
  EXPECT_THAT(warnings(), Contains(HasSubstr("3 frames more; the first 17 of both are used")));
  plan.performers[0].source.start = 3;
  EXPECT_THAT(warnings(), testing::Not(Contains(HasSubstr("frames more"))));
  std::vector<std::string> read;
  const auto library = build_library(manifest_of(plan), {}, {}, read);
  ASSERT_TRUE(library.ok()) << library.error().text();
  const PairedTake recorded = test::circling_take("t", 20);
  const Pose together = to_normalized(recorded.b.poses[3], root_frame(recorded.a.poses[3]));
  EXPECT_LT((library->pose(0).bottomRows<joint_count>() - together).cwiseAbs().maxCoeff(), 1e-4)
      << "the frames that were captured together";
}

TEST_F(Plan, AFileThatCannotBeReadIsLeftOutUntilItIsWanted) {
  write("x_A.bvh", 20, false);
  write("x_B.bvh", 20, true);
  std::ofstream(folder / "broken.bvh") << "HIERARCHY\nROOT";
  survey("broken.bvh");
  pair_up(plan);
  EXPECT_EQ(first_obstacle(), "");
  EXPECT_THAT(warnings(), Contains(HasSubstr("broken.bvh:")));
  set_take(plan, 2, "x");
  EXPECT_THAT(first_obstacle(), HasSubstr("broken.bvh:"));
}

TEST_F(Plan, SaysWhatStandsInTheWay) {
  EXPECT_THAT(first_obstacle(), HasSubstr("no motion yet"));
  write("x_A.bvh", 20, false);
  EXPECT_THAT(first_obstacle(), HasSubstr("no take yet"));
  set_take(plan, 0, "x");
  EXPECT_THAT(first_obstacle(), HasSubstr("take x: has 1 performer; a take has two"));
  write("x_B.bvh", 20, true);
  set_take(plan, 1, "x");
  EXPECT_EQ(first_obstacle(), "");
  plan.performers[0].source.start = 19;
  EXPECT_THAT(first_obstacle(), HasSubstr("fewer than 2 frames"));
  plan.performers[0].source.start = 0;
  plan.performers[1].report.fps = 120;
  EXPECT_THAT(first_obstacle(), HasSubstr("60 and 120 frames per second"));
  EXPECT_THROW(manifest_of(plan), std::invalid_argument);
}

TEST_F(Plan, WarnsOfABodyThatIsNoBody) {
  write("x_A.bvh", 20, false);
  plan.performers[0] = survey_motion({.motion = folder / "x_A.bvh", .metres_per_unit = 0.01}, {})[0];
  set_take(plan, 0, "x");
  EXPECT_THAT(warnings(), Contains(HasSubstr("would stand 0.02")));
}

TEST_F(Plan, AsksWhoLeadsOnceForAllTakes) {
  for (const char* take : {"x", "y"})
    for (const bool follower : {false, true})
      write(std::string(take) + (follower ? "_B.bvh" : "_A.bvh"), 20, follower);
  pair_up(plan);
  std::vector<std::string> questions;
  for (const PlanRemark& remark : brought_together(remarks_on(plan)))
    if (remark.kind == Kind::Question) questions.push_back(remark.whole());
  EXPECT_EQ(questions.size(), 3U) << "the units of two bodies in four files, and the roles of two takes";
  EXPECT_THAT(questions, Contains(HasSubstr("take x and 1 more: nothing says who leads")));
  set_role(plan, 0, PlannedRole::Leads), set_role(plan, 2, PlannedRole::Leads);
  EXPECT_THAT(warnings(), testing::Not(Contains(HasSubstr("who leads"))));
}

TEST_F(Plan, OnePerformersRoleSettlesTheOthers) {
  write("x_A.bvh", 20, false);
  write("x_B.bvh", 20, true);
  pair_up(plan);
  set_role(plan, 1, PlannedRole::Leads);
  EXPECT_EQ(plan.performers[0].role, PlannedRole::Follows);
  EXPECT_EQ(manifest_of(plan).takes[0].roles[0].active, ActivePerformer::B);
  set_role(plan, 0, PlannedRole::Either);
  EXPECT_EQ(plan.performers[1].role, PlannedRole::Either);
}

TEST_F(Plan, FilesAddedLaterLeaveTakesInUseAlone) {
  write("x_A.bvh", 20, false);
  write("x_B.bvh", 20, true);
  pair_up(plan);
  set_take(plan, 0, "mine"), set_take(plan, 1, "mine");
  write("y_A.bvh", 30, false);
  write("y_B.bvh", 30, true);
  pair_up(plan);
  EXPECT_EQ(plan.performers[0].take, "mine");
  EXPECT_FALSE(plan.performers[0].guess);
  EXPECT_EQ(plan.performers[2].take, "y");
  EXPECT_TRUE(plan.performers[2].guess);
}

TEST_F(Plan, TakesAreNamedLikeTheirLabels) {
  write("60_01.bvh", 20, false);
  write("61_01.bvh", 20, true);
  pair_up(plan);
  plan.labels = folder / "moves.csv";
  plan.labelled_takes =
      takes_in_labels("take,start_frame,end_frame,label\nsalsa_01,0,9,turn\nsalsa_02,0,9,walk\n");
  EXPECT_THAT(warnings(), Contains(HasSubstr("moves.csv has no labels of it, but of salsa_01, salsa_02")));
  name_like_labels(plan);
  EXPECT_EQ(plan.performers[0].take, "salsa_01");
  EXPECT_THAT(warnings(), testing::Not(Contains(HasSubstr("has no labels"))));
  EXPECT_EQ(manifest_of(plan).takes[0].labels, folder / "moves.csv");
}

TEST_F(Plan, BothPerformersOfOneFileKeepTheirPlaces) {
  const PairedTake take = test::circling_take("t", 20);
  std::ofstream(folder / "both.bvh") << *write_bvh(std::vector<Clip>{take.a, take.b});
  survey("both.bvh");
  ASSERT_EQ(plan.performers.size(), 2U);
  pair_up(plan);
  set_role(plan, 1, PlannedRole::Leads);
  const Manifest manifest = manifest_of(plan);
  EXPECT_EQ(manifest.takes[0].a.index, 0);
  EXPECT_EQ(manifest.takes[0].b.index, 1);
  std::vector<std::string> read;
  ASSERT_TRUE(build_library(manifest, {}, {}, read).ok());
}

}  // namespace
}  // namespace abrazo::library_plan_test
