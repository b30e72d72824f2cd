#include "core/synthesis/step/role_views.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <numeric>
#include <thread>

#include "core/library/store/motion_library_file.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::role_views_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr std::uint64_t plenty = std::uint64_t{1} << 40;
std::uint64_t memory_left = plenty;

std::vector<int> all_pairs(const MotionLibrary& library) {
  std::vector<int> pairs(static_cast<std::size_t>(library.pair_count()));
  std::iota(pairs.begin(), pairs.end(), 0);
  return pairs;
}

/// A library in memory, and the same mapped.
class RoleViewsTest : public testing::Test {
 protected:
  void SetUp() override {
    memory_left = plenty;
    folder = fs::path(testing::TempDir()) /
             (std::string("abrazo_roles_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
    fs::create_directories(folder);
    in_memory = test::small_library();
    ASSERT_TRUE(write_library(*in_memory, folder / "l.h5").ok());
    auto read = read_library(folder / "l.h5", LibraryReading{.largest_in_memory_bytes = 0});
    ASSERT_TRUE(read.ok()) << read.error().text();
    mapped = std::make_shared<const MotionLibrary>(std::move(*read));
  }
  void TearDown() override { fs::remove_all(folder); }

  static std::shared_ptr<const RoleViews> views_of(const std::shared_ptr<const MotionLibrary>& library) {
    return std::make_shared<const RoleViews>(
        library, all_pairs(*library), +[] { return memory_left; });
  }
  static bool becomes_ready(const RoleViews& views, UserRole role) {
    for (int i = 0; i < 20000 && !views.is_ready(role); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return views.is_ready(role);
  }
  static std::optional<Error> trouble_of(const RoleViews& views, UserRole role) {
    std::optional<Error> trouble;
    for (int i = 0; i < 20000 && !(trouble = views.trouble(role)); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return trouble;
  }

  fs::path folder;
  std::shared_ptr<const MotionLibrary> in_memory, mapped;
};

TEST_F(RoleViewsTest, OnlyThePassiveUsersOfAMappedLibraryIsCostly) {
  for (const UserRole role : {UserRole::Active, UserRole::Passive})
    EXPECT_FALSE(views_of(in_memory)->is_costly(role));
  EXPECT_FALSE(views_of(mapped)->is_costly(UserRole::Active));
  EXPECT_TRUE(views_of(mapped)->is_costly(UserRole::Passive));
}

TEST_F(RoleViewsTest, PreparedOnesAreThereWithoutAWait) {
  for (const auto& library : {in_memory, mapped}) {
    const auto views = views_of(library);
    EXPECT_FALSE(views->is_ready(UserRole::Passive));
    views->prepare(UserRole::Passive);
    views->prepare(UserRole::Passive);
    ASSERT_TRUE(becomes_ready(*views, UserRole::Passive));
    EXPECT_FALSE(views->trouble(UserRole::Passive));
    const RoleViews::View& view = views->of(UserRole::Passive);
    EXPECT_EQ(view.library->pose(5), with_roles_exchanged(*in_memory).pose(5));
    EXPECT_FALSE(view.library->is_mapped());
  }
}

TEST_F(RoleViewsTest, GoneWhileOneIsPreparedIsWaitedFor) {
  for (int i = 0; i < 20; ++i) {
    const auto views = views_of(in_memory);
    views->prepare(UserRole::Passive);
    views->prepare(UserRole::Active);
  }
}

TEST_F(RoleViewsTest, WhatMemoryDoesNotHoldIsNotBegunAndSaysWhy) {
  const auto views = views_of(mapped);
  memory_left = 300'000'000 - 1;  // 256 MiB are spared, so 31.5 MB are left for it
  EXPECT_NO_THROW(views->of(UserRole::Active));
  EXPECT_NO_THROW(views_of(in_memory)->of(UserRole::Passive)) << "it is in memory already";
  memory_left = 200'000'000;
  EXPECT_THROW(views->of(UserRole::Passive), std::runtime_error);
  views->prepare(UserRole::Passive);
  const auto trouble = trouble_of(*views, UserRole::Passive);
  ASSERT_TRUE(trouble);
  EXPECT_THAT(trouble->message,
              testing::AllOf(HasSubstr("in memory, and 0.2 GB are left"), HasSubstr("close other programs")));
  EXPECT_FALSE(views->trouble(UserRole::Passive)) << "said once";
  memory_left = plenty;
  views->prepare(UserRole::Passive);
  EXPECT_TRUE(becomes_ready(*views, UserRole::Passive)) << "asked again when there is room";
}

TEST_F(RoleViewsTest, OfADamagedLibraryTheExchangedOneSaysSoToo) {
  fs::resize_file(folder / "l.h5", 4096);
  const auto views = views_of(mapped);
  const auto damage = views->of(UserRole::Passive).library->damage();
  ASSERT_TRUE(damage);
  EXPECT_THAT(damage->text(), HasSubstr("was cut short while in use"));
}

TEST_F(RoleViewsTest, AreOneForAllWhoSolveWithTheSamePairsOfALibrary) {
  const auto first = std::move(*PartnerSynthesizer::create(in_memory, *preset("paper")));
  const auto second = std::move(*PartnerSynthesizer::create(in_memory, *preset("responsive")));
  EXPECT_EQ(first->views(), second->views());
  first->views()->intent(UserRole::Active);
  EXPECT_TRUE(second->views()->is_intent_ready(UserRole::Active)) << "learned once";

  const auto without =
      std::move(*PartnerSynthesizer::create(in_memory, *preset("paper"), {in_memory->takes().front().name}));
  EXPECT_NE(without->views(), first->views()) << "other pairs may be selected";
  EXPECT_FALSE(without->views()->is_intent_ready(UserRole::Active));
  const auto elsewhere = std::move(*PartnerSynthesizer::create(mapped, *preset("paper")));
  EXPECT_NE(elsewhere->views(), first->views()) << "another library, if an equal one";
}

TEST_F(RoleViewsTest, AreNotKeptForNobody) {
  std::weak_ptr<const RoleViews> views;
  {
    const auto synthesizer = std::move(*PartnerSynthesizer::create(in_memory, *preset("paper")));
    views = synthesizer->views();
  }
  EXPECT_TRUE(views.expired());
}

}  // namespace
}  // namespace abrazo::role_views_test
