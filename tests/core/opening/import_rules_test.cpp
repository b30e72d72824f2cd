// What a person says of a motion file, kept for files alike, and what a file becomes when it is read so.
#include "core/opening/import_rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/motion/bvh/bvh.hpp"
#include "core/opening/import_preview.hpp"
#include "core/opening/open_files.hpp"
#include "tests/core/opening/opening_files.hpp"

namespace abrazo::import_rules_test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class ImportRules : public ::testing::Test, protected test::TemporaryFolder {
 protected:
  /// A swinging person in some unit, half a metre above the floor: whether that is the floor is a question.
  std::string walk(const std::string& name, double units_per_metre = 1, double above_floor_m = 0.5) {
    PairedTake take = test::swinging_take("t", 40, 1);
    for (Pose& pose : take.a.poses) pose.col(1).array() += above_floor_m;
    std::filesystem::create_directories(std::filesystem::path(file(name)).parent_path());
    std::ofstream(file(name)) << *write_bvh(std::vector<Clip>{take.a}, units_per_metre);
    return file(name);
  }
  std::string layout(const std::string& motion) { return layout_of(*read_motion_points(motion, "")); }
  void remember(const std::string& motion, MotionReading how) {
    how.file = motion;
    const auto kept = remember_import(rule_of(how, layout(motion)), file("rules"));
    ASSERT_TRUE(kept) << kept.error().text();
  }
  Result<Material> opened(const std::string& motion, const std::optional<MotionReading>& said = {}) {
    return open_files({recognised({motion}), {}, "", "", said, file("rules")}, {});
  }
  MotionReading with_unit(double metres) {
    MotionReading how;
    how.metres_per_unit = metres;
    return how;
  }
};

TEST_F(ImportRules, WhatIsSaidReadsBackTheSame) {
  MotionReading said;
  said.up = "z", said.metres_per_unit = 0.0254, said.fps = 29.97, said.floor_m = -0.12;
  said.joint_map = "/maps/mine.json", said.animation = "Samba \"2\"", said.performer = "Anna";
  said.joints = "lafan22", said.body_model = "/body.npz";
  const auto again = parse_reading(reading_json(said), "here");
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(*again, said);
  EXPECT_EQ(reading_json({}), "{}");
  EXPECT_THAT(reading_words(said), HasSubstr("joints by mine.json"));
}

TEST_F(ImportRules, TextThatIsNoReadingNamesWhatWasExpected) {
  for (const auto& [text, why] : {std::pair("{", "is no JSON"),
                                  {"[]", "expected {"},
                                  {R"({"up": 3})", "expected a text for 'up'"},
                                  {R"({"fps": "sixty"})", "expected a number for 'fps'"},
                                  {R"({"axis": "z"})", "expected up, joint_map"}}) {
    const auto reading = parse_reading(text, "rule.json");
    ASSERT_FALSE(reading) << text;
    EXPECT_EQ(reading.error().where, "rule.json");
    EXPECT_THAT(reading.error().message, HasSubstr(why));
  }
}

TEST_F(ImportRules, AreForFilesOfTheSamePointsInTheFolderOrNamedAlike) {
  const std::string first = walk("a/walk_01.bvh");
  remember(first, with_unit(0.5));
  const auto rules = import_rules(file("rules")).rules;
  ASSERT_EQ(rules.size(), 1u);
  const std::string points = layout(first);
  EXPECT_TRUE(rule_for(rules, file("a/run.bvh"), points)) << "the same folder";
  EXPECT_TRUE(rule_for(rules, file("b/walk_7.bvh"), points)) << "named alike";
  EXPECT_FALSE(rule_for(rules, file("b/run.bvh"), points));
  EXPECT_FALSE(rule_for(rules, file("a/walk_02.bvh"), "other points"));
  EXPECT_FALSE(rule_for(rules, first, "")) << "a file of which nothing could be read is like no other";
}

TEST_F(ImportRules, WhatIsSaidAnewTakesThePlaceOfWhatWasSaid) {
  const std::string motion = walk("a/walk_01.bvh");
  remember(motion, with_unit(0.5));
  remember(motion, with_unit(0.25));
  const auto stored = import_rules(file("rules"));
  ASSERT_EQ(stored.rules.size(), 1u);
  EXPECT_EQ(stored.rules.front().how.metres_per_unit, 0.25);
  EXPECT_EQ(stored.rules.front().how.file, "");
  ASSERT_TRUE(forget_import(stored.rules.front().path));
  EXPECT_THAT(import_rules(file("rules")).rules, IsEmpty());
}

TEST_F(ImportRules, AFileThatIsNoRuleIsListedAsDamaged) {
  std::filesystem::create_directories(file("rules"));
  std::ofstream(file("rules/x.json")) << R"({"layout": "a", "folder": 3})";
  const auto stored = import_rules(file("rules"));
  EXPECT_THAT(stored.rules, IsEmpty());
  ASSERT_EQ(stored.damaged.size(), 1u);
  EXPECT_THAT(stored.damaged.front().text(), HasSubstr("expected a text 'folder'"));
}

TEST_F(ImportRules, AFileWithDoubtsIsToBeAskedAboutUntilSomebodySaidSomething) {
  const std::string motion = walk("a/walk_01.bvh");
  const auto unasked = opened(motion);
  ASSERT_TRUE(unasked) << unasked.error().text();
  EXPECT_TRUE(unasked->is_doubtful) << "the floor";
  EXPECT_FALSE(opened(walk("c/plain.bvh", 100, 0))->is_doubtful) << "only centimetres make an adult";
  EXPECT_TRUE(opened(walk("d/giant.bvh", 4, 0))->is_doubtful) << "no unit does";
  EXPECT_FALSE(opened(motion, MotionReading{})->is_doubtful) << "as found, said a person";
  remember(motion, with_unit(1));
  const auto ruled = opened(walk("a/walk_02.bvh"));
  EXPECT_FALSE(ruled->is_doubtful);
  EXPECT_EQ(ruled->reading.metres_per_unit, 1);
  EXPECT_THAT(ruled->warnings, Not(Contains(HasSubstr("guessed"))));
}

TEST_F(ImportRules, ARuleThatDoesNotSuitIsSaidAndTheFileAskedAbout) {
  const std::string motion = walk("a/walk_01.bvh");
  MotionReading how;
  how.joint_map = file("gone.json");
  remember(motion, how);
  const auto material = opened(motion);
  ASSERT_TRUE(material) << material.error().text();
  EXPECT_TRUE(material->is_doubtful);
  EXPECT_THAT(material->warnings, Contains(HasSubstr("does not suit it")));
  EXPECT_THAT(material->warnings, Contains(HasSubstr("gone.json")));
}

TEST_F(ImportRules, ASavedProjectReadsItsMotionAsItWasSaid) {
  MotionReading said = with_unit(0.5);
  said.floor_m = 0.25;
  const auto material = opened(walk("a/walk_01.bvh", 2), said);
  ASSERT_TRUE(material) << material.error().text();
  Project project;
  describe(*material, project);
  const auto again = parse_reading(project.view.at(view_of_reading), "project");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->metres_per_unit, 0.5);
  EXPECT_EQ(again->floor_m, 0.25);
  Project plain;
  describe(*opened(walk("a/walk_02.bvh"), MotionReading{}), plain);
  EXPECT_EQ(plain.view.count(view_of_reading), 0u) << "nothing was said";
}

TEST_F(ImportRules, APreviewFollowsWhatIsSaidWithoutReadingTheFileAgain) {
  MotionReading reading;
  reading.file = walk("a/walk_01.bvh", 100);
  ImportPreview preview;
  const ImportView found = preview.look(reading);
  ASSERT_TRUE(found.is_readable());
  EXPECT_DOUBLE_EQ(found.imported.report.metres_per_unit, 0.01);
  EXPECT_EQ(found.imported.report.joint_points[joints::Head].empty(), false);
  EXPECT_GT(found.moves_m, 0);
  std::filesystem::remove(reading.file);
  reading.metres_per_unit = 0.02, reading.fps = 30;
  const ImportView said = preview.look(reading);
  ASSERT_TRUE(said.is_readable()) << said.trouble->text();
  EXPECT_NEAR(said.imported.report.height_m, 2 * found.imported.report.height_m, 1e-9);
  EXPECT_EQ(said.imported.clip.fps, 30);
  EXPECT_EQ(said.layout, found.layout);
}

TEST_F(ImportRules, APreviewOfAFileNobodyCanReadSaysWhyAndKeepsItsPoints) {
  ImportPreview preview;
  MotionReading reading;
  reading.file = std::string(ABRAZO_FIXTURES) + "/motion/arm.bvh";
  const ImportView unknown = preview.look(reading);
  EXPECT_FALSE(unknown.is_readable());
  ASSERT_TRUE(unknown.trouble);
  EXPECT_TRUE(unknown.unmapped) << "a person can say which point is which joint";
  reading.file = file("none.bvh");
  const ImportView missing = preview.look(reading);
  ASSERT_TRUE(missing.trouble);
  EXPECT_THAT(missing.trouble->text(), HasSubstr("none.bvh"));
  EXPECT_EQ(missing.layout, "");
}

TEST_F(ImportRules, AFloorThatIsSaidIsWhereTheGroundIs) {
  MotionReading reading;
  reading.file = walk("a/walk_01.bvh", 1, 0);
  const double before = read_performer(reading)->clip.poses.front()(joints::Head, 1);
  reading.floor_m = 0.3;
  const auto said = read_performer(reading);
  ASSERT_TRUE(said);
  EXPECT_NEAR(said->clip.poses.front()(joints::Head, 1), before - 0.3, 1e-9);
  EXPECT_DOUBLE_EQ(said->report.floor_shift_m, -0.3);
  reading.floor_m = std::nan("");
  EXPECT_FALSE(read_performer(reading));
}

}  // namespace
}  // namespace abrazo::import_rules_test
