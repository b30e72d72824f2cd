#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <random>
#include <vector>

#include "core/library/build/motion_library_builder.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"
#include "tests/core/synthesis/counted_allocations.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::step_allocation_test {
namespace {

constexpr Duration step_time(1.0 / 60);

std::unique_ptr<PartnerSynthesizer> running(const Settings& settings,
                                            const std::shared_ptr<const MotionLibrary>& library) {
  auto synthesizer = std::move(*PartnerSynthesizer::create(library, settings));
  synthesizer->step(test::standing_pose(), Duration(0));
  return synthesizer;
}

std::unique_ptr<PartnerSynthesizer> running(const Settings& settings) {
  return running(settings, test::small_library());
}

/// Two people who stand in each other's arms.
std::shared_ptr<const MotionLibrary> close_library() {
  std::vector<PairedTake> takes;
  takes.push_back(test::swinging_take("close", 120, 1, 0.35));
  return std::make_shared<const MotionLibrary>(std::move(*build_library("close", std::move(takes), {}, {})));
}

/// Of the steps alone. @param before_step  called with the number of each, uncounted
template <typename BeforeStep>
std::size_t allocations_of_steps(PartnerSynthesizer& synthesizer, const std::vector<Pose>& user,
                                 const BeforeStep& before_step) {
  std::size_t sum = 0;
  for (std::size_t frame = 0; frame < user.size(); ++frame) {
    before_step(frame);
    const std::size_t before = test::allocations();
    synthesizer.step(user[frame], step_time);
    sum += test::allocations() - before;
  }
  return sum;
}

std::size_t allocations_of_steps(PartnerSynthesizer& synthesizer, const std::vector<Pose>& user) {
  return allocations_of_steps(synthesizer, user, [](std::size_t) {});
}

Settings by_intent(UserRole role = UserRole::Active) {
  Settings settings = *preset("responsive");
  settings.selection = SelectionMethod::Intent;
  settings.user_role = role;
  return settings;
}

std::vector<Pose> dancing_user(double scale = 1) {
  std::vector<Pose> poses = test::swinging_take("user", 200, 17).a.poses;
  for (Pose& pose : poses) pose *= scale;
  return poses;
}

TEST(StepAllocation, IsCountedForNewAndForMalloc) {
  const std::size_t before = test::allocations();
  const auto one = std::make_unique<std::vector<int>>(100);
  void* volatile two = std::malloc(100);  // NOLINT(cppcoreguidelines-no-malloc)
  void* volatile aligned = ::operator new(64, std::align_val_t(64));
  EXPECT_EQ(test::allocations() - before, 4U);
  std::free(two);  // NOLINT(cppcoreguidelines-no-malloc)
  ::operator delete(aligned, std::align_val_t(64));
}

TEST(StepAllocation, DoesNotHappenInAnyPresetForAnyRoleAndSize) {
  for (const auto name : preset_names)
    for (const auto role : {UserRole::Active, UserRole::Passive})
      for (const double scale : {1.0, 0.8, 1.2}) {
        Settings settings = *preset(name);
        settings.user_role = role;
        auto synthesizer = running(settings);
        EXPECT_EQ(allocations_of_steps(*synthesizer, dancing_user(scale)), 0U) << name << ' ' << scale;
      }
}

TEST(StepAllocation, DoesNotHappenWhileSettingsChangeUnderEveryStep) {
  auto synthesizer = running(*preset("responsive"));
  Settings settings = synthesizer->settings();
  const auto change = [&](std::size_t frame) {
    const int n = static_cast<int>(frame);
    settings.neighbours = 1 + n % 30;
    settings.continuations = n % 16;
    settings.morph_steps = 1 + n % 20;
    settings.projection_steps = n % 11;
    settings.collisions = n % 3 != 0;
    settings.foot_locks = n % 50 > 10;
    settings.edge_weights = static_cast<EdgeWeights>(n % 3);
    settings.velocity_form = n % 7 < 3 ? VelocityForm::Velocity : VelocityForm::Predicted;
    settings.scale_root_path = n % 100 < 50;
    settings.playback = n % 40 < 30 ? SourcePlayback::Continuous : SourcePlayback::Frames;
    settings.hold_weight = n % 5 == 0 ? 0 : 50;
    settings.selection = n % 9 < 4 ? SelectionMethod::Intent : SelectionMethod::Paper;
    synthesizer->set_settings(settings);
  };
  EXPECT_EQ(allocations_of_steps(*synthesizer, dancing_user(1.1), change), 0U);
}

TEST(StepAllocation, DoesNotHappenOnOtherBodiesNorWhileTheyChange) {
  for (const auto name : preset_names)
    for (const auto role : {UserRole::Active, UserRole::Passive}) {
      Settings settings = *preset(name);
      settings.user_role = role;
      auto synthesizer = running(settings);
      const auto change = [&](std::size_t frame) {
        if (frame == 10) settings.active_body = {.kind = BodyChoice::Kind::User};
        if (frame == 40) settings.passive_body = {.kind = BodyChoice::Kind::Scaled, .scale = 0.3};
        if (frame == 70) settings.active_body = {.kind = BodyChoice::Kind::Scaled, .scale = 3};
        if (frame == 110) settings.active_body = settings.passive_body = {};
        synthesizer->set_settings(settings);
      };
      EXPECT_EQ(allocations_of_steps(*synthesizer, dancing_user(1.1), change), 0U) << name;
    }
}

TEST(StepAllocation, DoesNotHappenForTheMostNeighboursOfAnySetting) {
  auto synthesizer = running(*preset("paper"));
  Settings settings = synthesizer->settings();
  settings.neighbours = 200;
  settings.continuations = 15;
  synthesizer->set_settings(settings);
  EXPECT_EQ(allocations_of_steps(*synthesizer, dancing_user()), 0U);
}

TEST(StepAllocation, DoesNotHappenWithPinsVetoesAndWhatIsMeant) {
  auto synthesizer = running(*preset("paper"));
  const auto change = [&](std::size_t frame) {
    if (frame % 40 == 10) synthesizer->set_vetoes({{}, {}, {frame % 80 == 10 ? "turn" : "open_hold"}});
    if (frame % 40 == 20) synthesizer->set_vetoes({});
    if (frame % 100 == 30) synthesizer->set_intended(IntendedPairs{.label = {}, .take = "second"});
    if (frame % 100 == 60) synthesizer->set_intended({});
    synthesizer->pin_pair(frame % 7 == 0 ? std::optional<int>(static_cast<int>(frame) % 300) : std::nullopt);
  };
  EXPECT_EQ(allocations_of_steps(*synthesizer, dancing_user(), change), 0U);
}

TEST(StepAllocation, DoesNotHappenWhenBodiesCollideAndConstraintsAreLetGo) {
  std::mt19937 random(7);
  std::normal_distribution<double> away(0, 0.4);
  Settings by_equation_7 = *preset("responsive");
  by_equation_7.selection = SelectionMethod::Paper;  // intent leads around what contradicts itself here
  by_equation_7.playback = SourcePlayback::Frames;   // and so does a partner that moves on its own
  by_equation_7.velocity_weight = 0.2;
  by_equation_7.alpha = 0;
  auto synthesizer = running(by_equation_7, close_library());
  std::size_t sum = 0;
  std::size_t contacts = 0;
  std::size_t not_ok = 0;
  const std::vector<Pose> user = dancing_user();
  for (std::size_t frame = 0; frame < user.size(); ++frame) {
    const double turn = std::normal_distribution<double>(0, 1)(random), x = away(random), z = away(random);
    const Pose pose = frame % 3 == 0 ? test::moved(user[frame], turn, Vec3(x, 0, z)) : user[frame];
    const std::size_t before = test::allocations();
    const FrameResult& result = synthesizer->step(pose, step_time);
    sum += test::allocations() - before;
    contacts += result.collisions.size();
    not_ok += result.status != StepStatus::Ok;
  }
  EXPECT_EQ(sum, 0U);
  EXPECT_GT(contacts, 20U) << "the case must collide to test anything";
  EXPECT_GT(not_ok, 0U) << "the case must contradict itself to test anything";
}

TEST(StepAllocation, DoesNotHappenWhenTrackingIsLostAndFound) {
  for (const auto name : preset_names) {
    auto synthesizer = running(*preset(name));
    std::vector<Pose> user = dancing_user();
    for (std::size_t frame = 20; frame < user.size(); frame += 50) {
      user[frame](7, 1) = std::numeric_limits<double>::quiet_NaN();
      user[frame + 1].rowwise() += Eigen::RowVector3d(1000, 0, -1000);
      user[frame + 3].setConstant(std::numeric_limits<double>::infinity());
      user[frame + 4].setZero();
    }
    EXPECT_EQ(allocations_of_steps(*synthesizer, user), 0U) << name;
  }
}

TEST(StepAllocation, DoesNotHappenWithTheSelectionByIntentOnceItHasLearned) {
  for (const auto role : {UserRole::Active, UserRole::Passive})
    for (const double scale : {1.0, 0.8}) {
      auto synthesizer = running(by_intent(role));
      EXPECT_EQ(allocations_of_steps(*synthesizer, dancing_user(scale)), 0U) << scale;
    }
}

TEST(StepAllocation, DoesNotHappenWhileTheWeightsOfIntentChangeUnderEveryStep) {
  for (const auto role : {UserRole::Active, UserRole::Passive}) {
    auto synthesizer = running(by_intent(role));
    const auto change = [&](std::size_t frame) {
      const int n = static_cast<int>(frame);
      Settings settings = by_intent(role);
      settings.selection = n % 25 < 20 ? SelectionMethod::Intent : SelectionMethod::Paper;
      settings.neighbours = n % 11 == 0 ? 200 : 1 + n % 40;
      settings.switch_margin = 0.1 * (n % 6);
      settings.leader_weight = 0.5 * (n % 5);
      settings.move_weight = n % 3;
      settings.meant_weight = 2 - n % 3;
      synthesizer->set_settings(settings);
    };
    EXPECT_EQ(allocations_of_steps(*synthesizer, dancing_user(), change), 0U);
  }
}

TEST(StepAllocation, DoesNotHappenForTheMostNeighboursByIntentWithPinsVetoesAndWhatIsMeant) {
  Settings settings = by_intent();
  settings.neighbours = 200;
  settings.switch_margin = 0;
  auto synthesizer = running(settings);
  const auto change = [&](std::size_t frame) {
    if (frame % 40 == 10) synthesizer->set_vetoes({{}, {}, {frame % 80 == 10 ? "turn" : "open_hold"}});
    if (frame % 40 == 20) synthesizer->set_vetoes({});
    if (frame == 150) synthesizer->set_vetoes({{}, {"first", "second"}, {}});
    if (frame == 155) synthesizer->set_vetoes({});
    if (frame % 100 == 30) synthesizer->set_intended(IntendedPairs{.label = {}, .take = "second"});
    if (frame % 100 == 60) synthesizer->set_intended({});
    synthesizer->pin_pair(frame % 7 == 0 ? std::optional<int>(static_cast<int>(frame) % 300) : std::nullopt);
    if (frame % 90 == 80) synthesizer->reset();
  };
  EXPECT_EQ(allocations_of_steps(*synthesizer, dancing_user(), change), 0U);
}

TEST(StepAllocation, DoesNotHappenWhenTheSelectionByIntentLosesTrackingAndFindsIt) {
  auto synthesizer = running(by_intent());
  std::vector<Pose> user = dancing_user();
  for (std::size_t frame = 20; frame < user.size(); frame += 50) {
    user[frame](7, 1) = std::numeric_limits<double>::quiet_NaN();
    user[frame + 1].rowwise() += Eigen::RowVector3d(1000, 0, -1000);
    user[frame + 3].setConstant(std::numeric_limits<double>::infinity());
    user[frame + 4].setZero();
  }
  EXPECT_EQ(allocations_of_steps(*synthesizer, user), 0U);
}

}  // namespace
}  // namespace abrazo::step_allocation_test
