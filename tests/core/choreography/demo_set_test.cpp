#include "core/choreography/demo_set.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "core/base/atomic_file.hpp"
#include "core/choreography/fight.hpp"
#include "core/choreography/salsa.hpp"
#include "core/library/takes/manifest.hpp"

namespace abrazo::demo_set_test {
namespace {

namespace fs = std::filesystem;

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

class DemoSet : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              (std::string("abrazo_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    takes_ = generate_salsa({.seed = 6, .minutes = 0.2, .take_seconds = 6});
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path folder_;
  std::vector<PairedTake> takes_;
};

TEST_F(DemoSet, ReadsBackAsItWas) {
  ASSERT_EQ(takes_.size(), 2U);
  const auto path = write_demo_set(takes_, "dance", folder_, {});
  ASSERT_TRUE(path.ok()) << path.error().text();
  const auto manifest = read_manifest(*path);
  ASSERT_TRUE(manifest.ok()) << manifest.error().text();
  EXPECT_EQ(manifest->name, "dance");
  ASSERT_EQ(manifest->takes.size(), takes_.size());
  for (std::size_t t = 0; t < takes_.size(); ++t) {
    std::vector<std::string> warnings;
    const auto take = load_take(manifest->takes[t], warnings);
    ASSERT_TRUE(take.ok()) << take.error().text();
    EXPECT_THAT(warnings, testing::IsEmpty());
    EXPECT_EQ(take->name, takes_[t].name);
    EXPECT_NEAR(take->fps, takes_[t].fps, 1e-3);
    ASSERT_EQ(take->a.poses.size(), takes_[t].a.poses.size());
    double farthest = 0;
    for (std::size_t f = 0; f < take->a.poses.size(); ++f)
      farthest = std::max({farthest, (take->a.poses[f] - takes_[t].a.poses[f]).cwiseAbs().maxCoeff(),
                           (take->b.poses[f] - takes_[t].b.poses[f]).cwiseAbs().maxCoeff()});
    EXPECT_LT(farthest, 1e-5);
    ASSERT_EQ(take->labels.size(), takes_[t].labels.size());
    for (std::size_t i = 0; i < take->labels.size(); ++i) {
      EXPECT_EQ(take->labels[i].start, takes_[t].labels[i].start);
      EXPECT_EQ(take->labels[i].end, takes_[t].labels[i].end);
      EXPECT_EQ(take->labels[i].label, takes_[t].labels[i].label);
    }
    EXPECT_EQ(active_at(*take, 0), ActivePerformer::A);
    EXPECT_EQ(active_at(*take, static_cast<int>(take->a.poses.size()) - 1), ActivePerformer::A);
  }
}

TEST_F(DemoSet, WritesTwoMotionsATakeAndNothingElseBesideLabelsAndManifest) {
  ASSERT_TRUE(write_demo_set(takes_, "dance", folder_, {}).ok());
  EXPECT_EQ(files_in(folder_), 2 * takes_.size() + 2);
}

TEST_F(DemoSet, LeavesNothingBehindWhenCancelled) {
  const auto path = write_demo_set(takes_, "dance", folder_,
                                   [](double fraction, std::string_view) { return fraction < 0.4; });
  ASSERT_FALSE(path.ok());
  EXPECT_EQ(path.error().message, "cancelled");
  EXPECT_EQ(files_in(folder_), 0U);
}

TEST_F(DemoSet, ReadsBackWhoAttacksWhen) {
  takes_ = generate_fight({.seed = 6, .minutes = 0.6});
  takes_.front().roles.front().active = ActivePerformer::Unknown;
  const auto path = write_demo_set(takes_, "fight", folder_, {});
  ASSERT_TRUE(path.ok()) << path.error().text();
  const auto manifest = read_manifest(*path);
  ASSERT_TRUE(manifest.ok()) << manifest.error().text();
  EXPECT_THAT(manifest->warnings, testing::IsEmpty());
  for (std::size_t t = 0; t < takes_.size(); ++t) {
    std::vector<std::string> warnings;
    const auto take = load_take(manifest->takes[t], warnings);
    ASSERT_TRUE(take.ok()) << take.error().text();
    ASSERT_GT(takes_[t].roles.size(), 1U);
    for (int f = 0; f < static_cast<int>(takes_[t].a.poses.size()); ++f)
      ASSERT_EQ(active_at(*take, f), active_at(takes_[t], f)) << take->name << " frame " << f;
    ASSERT_EQ(take->labels.size(), takes_[t].labels.size());
    for (std::size_t i = 0; i < take->labels.size(); ++i) {
      EXPECT_EQ(take->labels[i].label, takes_[t].labels[i].label);
      EXPECT_EQ(take->labels[i].detail, takes_[t].labels[i].detail);
      EXPECT_EQ(take->labels[i].confidence, takes_[t].labels[i].confidence);
    }
  }
}

TEST_F(DemoSet, ARoleThatNeverChangesIsOneLetter) {
  takes_.back().roles.front().active = ActivePerformer::B;
  const auto path = write_demo_set(takes_, "dance", folder_, {});
  ASSERT_TRUE(path.ok());
  const auto text = read_whole_file(*path);
  ASSERT_TRUE(text.ok());
  EXPECT_THAT(*text,
              testing::AllOf(testing::HasSubstr(R"("roles":"a")"), testing::HasSubstr(R"("roles":"b")"),
                             testing::Not(testing::HasSubstr("active"))));
}

TEST_F(DemoSet, FramesOfNobodyStayUnknown) {
  takes_.back().roles = {{3, 9, ActivePerformer::B}};
  const auto path = write_demo_set(takes_, "dance", folder_, {});
  ASSERT_TRUE(path.ok());
  const auto manifest = read_manifest(*path);
  ASSERT_TRUE(manifest.ok()) << manifest.error().text();
  std::vector<std::string> warnings;
  const auto take = load_take(manifest->takes.back(), warnings);
  ASSERT_TRUE(take.ok()) << take.error().text();
  EXPECT_EQ(active_at(*take, 2), ActivePerformer::Unknown);
  EXPECT_EQ(active_at(*take, 3), ActivePerformer::B);
  EXPECT_EQ(active_at(*take, 9), ActivePerformer::Unknown);
}

TEST_F(DemoSet, LeavesNothingBehindWhenRolesOverlap) {
  takes_.back().roles = {{0, 5, ActivePerformer::A}, {4, 9, ActivePerformer::B}};
  const auto path = write_demo_set(takes_, "dance", folder_, {});
  ASSERT_FALSE(path.ok());
  EXPECT_THAT(path.error().text(),
              testing::AllOf(testing::HasSubstr("4 to 9"), testing::HasSubstr(takes_.back().name)));
  EXPECT_EQ(files_in(folder_), 0U);
}

TEST_F(DemoSet, SaysWhichFolderCannotBeMade) {
  ASSERT_TRUE(write_whole_file(folder_, "a file where the folder should be").ok());
  const auto path = write_demo_set(takes_, "dance", folder_, {});
  ASSERT_FALSE(path.ok());
  EXPECT_EQ(path.error().where, folder_.string());
}

}  // namespace
}  // namespace abrazo::demo_set_test
