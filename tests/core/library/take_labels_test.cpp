#include "core/library/takes/take_labels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/atomic_file.hpp"
#include "core/library/takes/manifest.hpp"
#include "core/library/takes/tier_file.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "tests/core/library/synthetic_takes.hpp"

namespace abrazo::take_labels_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace fs = std::filesystem;

const std::vector<Tier> tiers = {
    {"who", {{0, 0.5, "a"}, {0.5, 0.8, "unknown"}, {0.8, 2, "B "}}, {}, TierKind::Role},
    {"moves",
     {{0, 0.251, "basic"}, {0.251, 0.252, "blink"}, {1, 1.5, "turn", "d", "low"}},
     {},
     TierKind::Move},
    {"note", {}}};

std::string refusal(std::string_view name, TierKind kind) {
  const auto found = tier_for_take(tiers, name, kind, "one", "x.eaf");
  return found ? (*found)->name : found.error().text();
}

TEST(TakeLabels, TheTierIsTheNamedOneOrTheFirstOfItsKind) {
  EXPECT_EQ(refusal("note", TierKind::Move), "note");
  EXPECT_EQ(refusal("", TierKind::Move), "moves");
  EXPECT_EQ(refusal("", TierKind::Role), "who");
  EXPECT_EQ(refusal("nobody", TierKind::Role), "x.eaf: has no tier 'nobody'; it has who, moves, note");
  const std::vector<Tier> notes = {{"x", {}}, {"one", {}}};
  EXPECT_EQ((*tier_for_take(notes, "", TierKind::Move, "one", "x.eaf"))->name, "one")
      << "named like the take";
  EXPECT_THAT(tier_for_take(notes, "", TierKind::Move, "two", "x.eaf").error().text(),
              HasSubstr("it has x, one"));
}

TEST(TakeLabels, KeepEveryFieldAsAnIntervalAndBack) {
  const LabelInterval label{.start = 30, .end = 90, .label = "turn", .detail = "left", .confidence = "low"};
  const TierInterval interval = interval_of(label, 60);
  EXPECT_EQ(interval, (TierInterval{0.5, 1.5, "turn", "left", "low"}));
  EXPECT_EQ(label_over(interval, 30, 90), label);
}

TEST(TakeLabels, AreInFramesAndWhatIsLeftOutIsCounted) {
  std::vector<std::string> warnings;
  const auto labels = labels_of(tiers[1], 60, "x.eaf", warnings);
  ASSERT_EQ(labels.size(), 2u);
  EXPECT_EQ(labels[0].end, 15);
  EXPECT_EQ(labels[1].start, 60);
  EXPECT_EQ(labels[1].end, 90);
  EXPECT_EQ(labels[1].confidence, "low");
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("x.eaf: 1 interval of tier 'moves' left out")));
}

TEST(TakeLabels, WhatBeginsBeforeTheFirstFrameIsCutThereAndCounted) {
  const Tier moves{"m", {{-0.5, 1, "basic"}, {1, 2, "turn"}}}, roles{"r", {{-1, 1, "a"}, {1, 2, "b"}}};
  std::vector<std::string> warnings;
  EXPECT_EQ(labels_of(moves, 60, "x.eaf", warnings)[0].start, 0);
  ASSERT_TRUE(roles_of(roles, 60, "x.eaf", warnings));
  EXPECT_THAT(warnings,
              ElementsAre("x.eaf: 1 interval of tier 'm' begins before the first frame and was cut there",
                          "x.eaf: 1 interval of tier 'r' begins before the first frame and was cut there"));
}

TEST(TakeLabels, RolesSayWhichPerformerIsActive) {
  std::vector<std::string> warnings;
  const auto roles = roles_of(tiers[0], 60, "x.eaf", warnings);
  ASSERT_TRUE(roles);
  ASSERT_EQ(roles->size(), 2u);
  EXPECT_EQ((*roles)[0].active, ActivePerformer::A);
  EXPECT_EQ((*roles)[1].start, 48);
  EXPECT_EQ((*roles)[1].active, ActivePerformer::B);
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_THAT(roles_of(tiers[1], 60, "x.eaf", warnings).error().text(),
              HasSubstr("x.eaf: tier 'moves': 'basic' at 0.000 s is not a role"));
}

// ---- in a manifest ----

class ManifestLabels : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              ("labels_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::create_directories(folder_);
    const PairedTake take = test::circling_take("one", 120);
    for (const auto& [name, clip] : {std::pair{"a.bvh", &take.a}, {"b.bvh", &take.b}}) {
      Clip shown = *clip;
      shown.name = name;
      shown.fps = 60;
      const auto text = write_bvh(std::vector<Clip>{shown});
      ASSERT_TRUE(text) << text.error().text();
      ASSERT_TRUE(write_whole_file(folder_ / name, *text));
    }
    for (const char* name : {"one.eaf", "one.json", "one.csv"})
      ASSERT_TRUE(write_whole_file(folder_ / name, write_tiers(tiers, name, {})->text));
  }
  void TearDown() override { fs::remove_all(folder_); }

  Result<PairedTake> loaded(const std::string& fields) {
    const auto manifest = parse_manifest(
        "{\"takes\":[{\"name\":\"one\",\"a\":{\"motion\":\"a.bvh\"},\"b\":{\"motion\":\"b.bvh\"}," + fields +
            "}]}",
        folder_ / "manifest.json");
    if (!manifest) return manifest.error();
    // Through the writer as well.
    const auto again = parse_manifest(manifest_json(*manifest, folder_), folder_ / "manifest.json");
    if (!again) return again.error();
    return load_take(again->takes.at(0), warnings_);
  }

  fs::path folder_;
  std::vector<std::string> warnings_;
};

TEST_F(ManifestLabels, MayBeOfAnyFormat) {
  for (const char* file : {"one.eaf", "one.json", "one.csv"}) {
    const auto take = loaded(std::string("\"labels\":\"") + file + "\"");
    ASSERT_TRUE(take) << take.error().text();
    ASSERT_EQ(take->labels.size(), 2u) << file;
    EXPECT_EQ(take->labels[1].start, 60);
    EXPECT_EQ(take->labels[1].label, "turn");
    EXPECT_TRUE(take->roles.empty());
  }
}

TEST_F(ManifestLabels, AndRolesMayComeFromTheirTiers) {
  const auto take = loaded("\"labels\":{\"file\":\"one.eaf\",\"tier\":\"who\"},\"roles\":{\"tier\":\"who\"}");
  ASSERT_TRUE(take) << take.error().text();
  EXPECT_EQ(take->labels.at(0).label, "a");
  ASSERT_EQ(take->roles.size(), 2u);
  EXPECT_EQ(take->roles[1].start, 48);
  const auto other = loaded("\"roles\":{\"tier\":\"who\",\"file\":\"one.json\"}");
  ASSERT_TRUE(other) << other.error().text();
  EXPECT_EQ(other->roles.size(), 2u);
}

TEST_F(ManifestLabels, ThatAreNotThereAreNamed) {
  EXPECT_THAT(loaded("\"labels\":{\"file\":\"one.eaf\",\"tier\":\"x\"}").error().text(),
              HasSubstr("one.eaf: has no tier 'x'; it has who, moves, note"));
  EXPECT_THAT(loaded("\"roles\":{\"tier\":\"who\"}").error().text(),
              HasSubstr("takes[0].roles: names a tier but no file"));
  EXPECT_THAT(loaded("\"labels\":\"two.eaf\"").error().text(), HasSubstr("two.eaf"));
}

}  // namespace
}  // namespace abrazo::take_labels_test
