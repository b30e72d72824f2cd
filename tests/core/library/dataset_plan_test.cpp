#include "core/library/build/dataset_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <climits>
#include <cmath>
#include <fstream>
#include <map>

#include "core/motion/files/clip_file.hpp"
#include "core/motion/joints/joint_order.hpp"
#include "tests/core/library/synthetic_takes.hpp"
#include "tests/core/motion/numpy_fixtures.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::dataset_plan_test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class DatasetPlan : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("plan_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void put(const std::string& file, const std::string& content) {
    const auto path = folder_ / file;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << content;
  }
  /// One of a couple that circles; `take` is what the motion differs in, and remembers who belongs together.
  void dancer(const std::string& file, int take, bool second, int frames, double metres_apart = 0.8) {
    const PairedTake pair = test::circling_take("t", frames, metres_apart, static_cast<unsigned>(take) + 1);
    put(file, clip_file_content(file, std::vector<Clip>{second ? pair.b : pair.a}).value());
    takes_[(folder_ / file).string()] = take;
  }
  Manifest plan(const std::string& dataset, MovesFrom moves = MovesFrom::LabelFiles) {
    auto manifest = plan_dataset({.dataset = dataset, .folder = folder_, .moves = moves});
    EXPECT_TRUE(manifest) << (manifest ? "" : manifest.error().text());
    return manifest ? *manifest : Manifest{};
  }
  std::string refusal(const std::string& dataset) {
    const auto manifest = plan_dataset({.dataset = dataset, .folder = folder_});
    return manifest ? "planned" : manifest.error().text();
  }
  /// Pairs `files` one after the other, each take with a length of its own or all with the same.
  void expect_all_paired(const std::vector<std::string>& files, bool equal_lengths = false) {
    for (std::size_t f = 0; f < files.size(); ++f)
      dancer(files[f], static_cast<int>(f / 2), f % 2 == 1,
             equal_lengths ? 30 : 20 + static_cast<int>(f / 2));
    const Manifest manifest = plan("folder");
    EXPECT_EQ(manifest.takes.size(), files.size() / 2) << testing::PrintToString(manifest.warnings);
    expect_none_paired_wrongly(manifest);
  }
  void expect_none_paired_wrongly(const Manifest& manifest) {
    for (const Manifest::Take& take : manifest.takes)
      EXPECT_EQ(takes_.at(take.a.motion.string()), takes_.at(take.b.motion.string()))
          << take.a.motion << " + " << take.b.motion;
  }
  std::filesystem::path folder_;
  std::map<std::string, int> takes_;
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

TEST_F(DatasetPlan, PairsCharactersOfOneTakeThoughAllTakesHaveOneLength) {
  expect_all_paired(
      {"A1.1 Left + Avoid/1_C0.bvh", "A1.1 Left + Avoid/1_C1.bvh", "A1.1 Left + Avoid/2_C0.bvh",
       "A1.1 Left + Avoid/2_C1.bvh", "A1.2 Right + Avoid/3_C0.bvh", "A1.2 Right + Avoid/3_C1.bvh"},
      true);
}

TEST_F(DatasetPlan, PairsTwoNumberedTakesOfTwoNumberedCharacters) {
  expect_all_paired({"1_C0.bvh", "1_C1.bvh", "2_C0.bvh", "2_C1.bvh"}, true);
}

TEST_F(DatasetPlan, PairsNumberedFoldersWithinNumberedSequences) {
  expect_all_paired({"seq_1/0/motion.bvh", "seq_1/1/motion.bvh", "seq_2/0/motion.bvh", "seq_2/1/motion.bvh"},
                    true);
  EXPECT_THAT(names(plan("folder")), ElementsAre("seq_1_motion", "seq_2_motion"));
}

TEST_F(DatasetPlan, PairsP1AndP2AndNotTheTakesOfOneOfThem) {
  expect_all_paired(
      {"take1_p1.bvh", "take1_p2.bvh", "take2_p1.bvh", "take2_p2.bvh", "take3_p1.bvh", "take3_p2.bvh"}, true);
}

TEST_F(DatasetPlan, PairsFoldersOfInterX) {
  expect_all_paired({"m/G001T000/P1.npz", "m/G001T000/P2.npz", "m/G001T001/P1.npz", "m/G001T001/P2.npz"},
                    true);
  EXPECT_THAT(names(plan("interx")), ElementsAre("G001T000", "G001T001"));
}

TEST_F(DatasetPlan, PairsFoldersOfInterHuman) {
  expect_all_paired({"person1/7.npy", "person2/7.npy", "person1/8.npy", "person2/8.npy"}, true);
  EXPECT_THAT(names(plan("folder")), ElementsAre("take_7", "take_8"));
}

TEST_F(DatasetPlan, PairsLettersBeforeNumbersOfTakes) {
  expect_all_paired({"A/take_1.bvh", "B/take_1.bvh", "A/take_2.bvh", "B/take_2.bvh"}, true);
}

TEST_F(DatasetPlan, PairsCharactersWithinLetteredSessions) {
  expect_all_paired({"A/1_C0.bvh", "A/1_C1.bvh", "B/1_C0.bvh", "B/1_C1.bvh"}, true);
}

TEST_F(DatasetPlan, PairsMeAndPartnerWhoAreActiveAndPassive) {
  expect_all_paired({"walk_me.bvh", "walk_partner.bvh", "turn_me.bvh", "turn_partner.bvh"}, true);
  ASSERT_EQ(plan("folder").takes.at(0).roles.size(), 1U);
  EXPECT_EQ(plan("folder").takes.at(0).a.motion.filename(), "turn_me.bvh");
}

TEST_F(DatasetPlan, PairsLeaderAndFollowerWithNumbersOfSubjects) {
  expect_all_paired({"s60_leader_01.bvh", "s61_follower_01.bvh", "s60_leader_02.bvh", "s61_follower_02.bvh"},
                    true);
}

TEST_F(DatasetPlan, PairsFoldersOfActorsAndReactors) {
  expect_all_paired({"actor/x1.bvh", "reactor/x1.bvh", "actor/x2.bvh", "reactor/x2.bvh"}, true);
}

TEST_F(DatasetPlan, PairsSubjectsByTheNumberThatHasFewerValues) {
  expect_all_paired({"60_01.bvh", "61_01.bvh", "60_02.bvh", "61_02.bvh", "60_03.bvh", "61_03.bvh"}, true);
}

TEST_F(DatasetPlan, PairsAFileWithTheOneThatAddsThePartner) {
  expect_all_paired({"one.bvh", "one_partner.bvh", "two.bvh", "two_partner.bvh"});
}

TEST_F(DatasetPlan, WhoIsAloneIsPairedWithNobodyOfAnotherTake) {
  for (const int take : {1, 2, 3, 4}) {
    dancer(std::to_string(take) + "_C0.bvh", take, false, 30);
    if (take != 3) dancer(std::to_string(take) + "_C1.bvh", take, true, 30);
  }
  const Manifest manifest = plan("folder");
  EXPECT_THAT(names(manifest), ElementsAre("take_1", "take_2", "take_4"));
  expect_none_paired_wrongly(manifest);
  EXPECT_THAT(manifest.warnings, ElementsAre(HasSubstr("1 performers have no certain partner and were left "
                                                       "out: 3_C0.bvh")));
}

TEST_F(DatasetPlan, WhoOfThreeIsAPairIsListedAndNotDecided) {
  dancer("t_p1.bvh", 1, false, 30), dancer("t_p2.bvh", 1, true, 30), dancer("t_p3.bvh", 1, true, 30, 1.6);
  EXPECT_THAT(refusal("folder"), HasSubstr("not certain, left out: t_p1.bvh + t_p2.bvh"));
  EXPECT_THAT(refusal("folder"), HasSubstr("another would be as likely"));
}

TEST_F(DatasetPlan, TwoWhoStandInOneAnotherAreNoCertainPair) {
  dancer("x_A.bvh", 1, false, 30), dancer("x_B.bvh", 2, false, 30);
  EXPECT_THAT(refusal("folder"), HasSubstr("on top of one another"));
}

TEST_F(DatasetPlan, TakesOfOnePersonWithNumbersOrWordsAreNoPairs) {
  dancer("walk_1.bvh", 1, false, 30), dancer("walk_2.bvh", 2, true, 33), dancer("walk_3.bvh", 3, false, 36);
  dancer("punch_left.bvh", 4, false, 40), dancer("punch_right.bvh", 5, true, 40);
  EXPECT_THAT(refusal("folder"), HasSubstr("holds no certain pair among 5 files"));
}

TEST_F(DatasetPlan, ALongerPerformerIsCutToTheShorterWithAWarning) {
  dancer("x_leader.bvh", 1, false, 30), dancer("x_follower.bvh", 1, true, 24);
  const Manifest manifest = plan("folder");
  ASSERT_EQ(manifest.takes.size(), 1U);
  EXPECT_EQ(manifest.takes[0].frames, 24);
  EXPECT_THAT(manifest.warnings, Contains(HasSubstr("one performer has 6 frames more")));
  std::vector<std::string> warnings;
  const auto take = load_take(manifest.takes[0], warnings);
  ASSERT_TRUE(take) << take.error().text();
  EXPECT_EQ(take->a.poses.size(), 24U);
}

TEST_F(DatasetPlan, OfVeryUnequalLengthsOneIsProbablyOfAnotherTake) {
  dancer("x_p1.bvh", 1, false, 80), dancer("x_p2.bvh", 2, true, 30);
  EXPECT_THAT(refusal("folder"), HasSubstr("80 and 30 frames"));
}

TEST_F(DatasetPlan, TakesTheTwoOfOneFile) {
  const PairedTake pair = test::circling_take("t", 30);
  put("C1 A and B walk/1.npz", clip_file_content("1.npz", std::vector<Clip>{pair.a, pair.b}).value());
  put("C1 A and B walk/2.npz", clip_file_content("2.npz", std::vector<Clip>{pair.a, pair.b}).value());
  const Manifest manifest = plan("folder");
  ASSERT_EQ(manifest.takes.size(), 2U);
  EXPECT_EQ(manifest.takes[0].a.motion, manifest.takes[0].b.motion);
}

TEST_F(DatasetPlan, MovesAreCalledLikeFoldersOrTakes) {
  dancer("punch/hit_1_C0.bvh", 1, false, 30), dancer("punch/hit_1_C1.bvh", 1, true, 30);
  dancer("kick/miss_2_C0.bvh", 2, false, 40), dancer("kick/miss_2_C1.bvh", 2, true, 40);
  EXPECT_EQ(plan("folder").takes.at(0).move, "");
  EXPECT_EQ(plan("folder", MovesFrom::Folders).takes.at(0).move, "kick");
  const Manifest by_name = plan("folder", MovesFrom::Names);
  EXPECT_EQ(by_name.takes.at(1).move, "hit");
  std::vector<std::string> warnings;
  const auto take = load_take(by_name.takes.at(1), warnings);
  ASSERT_TRUE(take) << take.error().text();
  EXPECT_THAT(take->labels, ElementsAre(LabelInterval{0, 30, "hit", "", ""}));
}

TEST_F(DatasetPlan, WhereEachPerformerHasAFolderTheMoveIsAboveBoth) {
  dancer("salsa/0/x.bvh", 1, false, 30), dancer("salsa/1/x.bvh", 1, true, 30);
  EXPECT_EQ(plan("folder", MovesFrom::Folders).takes.at(0).move, "salsa");
}

TEST_F(DatasetPlan, NamesTakesLikeTheLabelFile) {
  dancer("a/7_C0.bvh", 1, false, 30), dancer("a/7_C1.bvh", 1, true, 30);
  put("labels.csv", "take,start_frame,end_frame,label\npunch_7,0,30,punch\n");
  const auto manifest = plan_dataset({.folder = folder_, .labels = folder_ / "labels.csv"});
  ASSERT_TRUE(manifest) << manifest.error().text();
  EXPECT_EQ(manifest->takes.at(0).name, "punch_7");
  EXPECT_EQ(manifest->takes.at(0).labels, folder_ / "labels.csv");
}

TEST_F(DatasetPlan, LabelsBesideATakeAreItsLabels) {
  dancer("d/song1_leader.bvh", 1, false, 30), dancer("d/song1_follower.bvh", 1, true, 30);
  put("annotations/song1.txt", "x");
  EXPECT_EQ(plan("folder").takes.at(0).labels, folder_ / "annotations/song1.txt");
}

TEST_F(DatasetPlan, SkeletonsAndTablesBesideADatasetAreNoMotionsWithoutAPartner) {
  dancer("take/P1.bvh", 1, false, 30), dancer("take/P2.bvh", 1, true, 30);
  put("take/body.asf", "x"), put("take/list.csv", "x");
  EXPECT_THAT(plan("folder").warnings, IsEmpty());
  put("take/P3.bvh", "x");
  EXPECT_THAT(plan("folder").warnings,
              ElementsAre(HasSubstr("1 files cannot be read and were left out: take/P3.bvh. "
                                    "The first: ")));
}

TEST_F(DatasetPlan, LooksIntoTwelveFoldersBelowOneAnotherAndNoFarther) {
  std::string folders;
  for (int depth = 0; depth < 12; ++depth) folders += "d/";
  dancer(folders + "m_leader.bvh", 1, false, 30), dancer(folders + "m_follower.bvh", 1, true, 30);
  dancer(folders + "d/n_leader.bvh", 2, false, 40), dancer(folders + "d/n_follower.bvh", 2, true, 40);
  EXPECT_THAT(names(plan("folder")), ElementsAre("m"));
}

TEST_F(DatasetPlan, PairsOfInterHumanAreReadAsTheirManifestSays) {
  const PairedTake pair = test::swinging_take("dance", 40, 1);
  for (const bool column_order : {false, true}) {
    for (const auto& [person, clip] : {std::pair("person1/7.npy", &pair.a), {"person2/7.npy", &pair.b}}) {
      put(person, interhuman_rows(clip->poses, "<f4", column_order));
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
  const auto reason = [&](const std::string& bytes) {
    put("person1/7.npy", bytes), put("person2/7.npy", bytes);
    return refusal("interhuman");
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

TEST_F(DatasetPlan, IsAManifestThatReadsBack) {
  dancer("m/m_leader.bvh", 1, false, 30), dancer("m/m_follower.bvh", 1, true, 30);
  const auto again =
      parse_manifest(manifest_json(plan("folder", MovesFrom::Folders), folder_), folder_ / "manifest.json");
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(again->takes[0].a.motion, folder_ / "m/m_leader.bvh");
  EXPECT_EQ(again->takes[0].move, "m");
}

TEST_F(DatasetPlan, SaysWhatWasExpected) {
  dancer("a.bvh", 1, false, 30);
  EXPECT_THAT(refusal("folder"), HasSubstr("holds no certain pair among 1 files; expected two motion files"));
  EXPECT_THAT(refusal("salsa"), HasSubstr("no dataset 'salsa'; expected one of folder, compas3d, interx"));
  EXPECT_THAT(plan_dataset({.folder = "/nowhere/at/all"}).error().text(), HasSubstr("is no folder"));
}

}  // namespace
}  // namespace abrazo::dataset_plan_test
