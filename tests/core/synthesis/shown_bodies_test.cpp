#include "core/synthesis/bodies/shown_bodies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "core/base/statistics.hpp"
#include "core/choreography/salsa.hpp"
#include "core/metrics/posture.hpp"
#include "core/motion/body/body_choice.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/synthesis/edit/constraints.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"
#include "core/synthesis/step/synthesizer_state.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::shown_bodies_test {
namespace {

using ::testing::HasSubstr;

constexpr Duration step_time(1.0 / 60);

std::vector<Pose> dancing_user(double scale = 1) {
  std::vector<Pose> poses = test::swinging_take("user", 300, 17).a.poses;
  for (Pose& pose : poses) pose *= scale;
  return poses;
}

Settings with_bodies(const char* active, const char* passive, std::string_view name = "responsive") {
  Settings settings = *preset(name);
  settings.selection = SelectionMethod::Paper;  // nothing to learn: the tests are about bodies
  EXPECT_TRUE(set_setting(settings, "active-body", active));
  EXPECT_TRUE(set_setting(settings, "passive-body", passive));
  return settings;
}

std::unique_ptr<PartnerSynthesizer> synthesizer_of(const Settings& settings) {
  return std::move(*PartnerSynthesizer::create(test::small_library(), settings));
}

/// Both characters, step by step. @param before_step called with the number of each
std::vector<FrameResult> danced(PartnerSynthesizer& synthesizer, const std::vector<Pose>& user,
                                const std::function<void(std::size_t)>& before_step = {}) {
  std::vector<FrameResult> frames;
  for (std::size_t f = 0; f < user.size(); ++f) {
    if (before_step) before_step(f);
    frames.push_back(synthesizer.step(user[f], f == 0 ? Duration(0) : step_time));
  }
  return frames;
}

double bone_difference(const Pose& pose, const Body& body) {
  return largest_length_difference(body_of(pose), body);
}

double farthest_step(const std::vector<FrameResult>& frames) {
  double farthest = 0;
  for (std::size_t f = 1; f < frames.size(); ++f)
    farthest = std::max(farthest, (frames[f].result - frames[f - 1].result).rowwise().norm().maxCoeff());
  return farthest;
}

TEST(ShownBodies, TheUsersOwnBodyIsShownInTheUsersOwnPose) {
  for (const double scale : {0.85, 1.0, 1.15})
    for (const auto name : preset_names) {
      const std::vector<Pose> user = dancing_user(scale);
      auto synthesizer = synthesizer_of(with_bodies("user", "library", name));
      synthesizer->set_user_body(body_of(user));
      std::vector<double> apart_m;
      for (const FrameResult& frame : danced(*synthesizer, user)) {
        ASSERT_NE(frame.status, StepStatus::Failed) << frame.message;
        const auto& own = user[apart_m.size()];
        EXPECT_LT(bone_difference(frame.active(), body_of(own)), 1e-3);
        apart_m.push_back((frame.active() - own).rowwise().norm().mean());
      }
      EXPECT_LT(mean(apart_m), 0.01) << scale << ' ' << name;
    }
}

TEST(ShownBodies, BothCharactersHaveTheLengthsOfTheirBodies) {
  for (const auto name : preset_names) {
    auto synthesizer = synthesizer_of(with_bodies("scale:1.2", "scale:0.8", name));
    const Body active = scaled_body(test::small_library()->usual_active_body().body, 1.2);
    const Body passive = scaled_body(test::small_library()->usual_passive_body().body, 0.8);
    for (const FrameResult& frame : danced(*synthesizer, dancing_user())) {
      EXPECT_LT(bone_difference(frame.active(), active), 1e-3) << name;
      EXPECT_LT(bone_difference(frame.passive(), passive), 1e-3) << name;
      EXPECT_LT(frame.residual.bone_length_max, 1e-3);
    }
  }
}

TEST(ShownBodies, APassiveUserIsShownOnThePassiveBody) {
  Settings settings = with_bodies("library", "scale:0.8");
  settings.user_role = UserRole::Passive;
  auto synthesizer = synthesizer_of(settings);
  const Body passive = scaled_body(test::small_library()->usual_passive_body().body, 0.8);
  for (const FrameResult& frame : danced(*synthesizer, dancing_user()))
    EXPECT_LT(bone_difference(frame.passive(), passive), 1e-3);
}

TEST(ShownBodies, ABodyThatChangesWhileDancingGlidesAndComesBackToTheSolvedPairToTheBit) {
  const std::vector<Pose> user = dancing_user();
  auto usual = synthesizer_of(with_bodies("library", "library"));
  auto changing = synthesizer_of(with_bodies("library", "library"));
  const auto plain = danced(*usual, user);
  const auto shown = danced(*changing, user, [&](std::size_t frame) {
    if (frame == 20) changing->set_settings(with_bodies("scale:1.2", "scale:0.9"));
    if (frame == 150) changing->set_settings(with_bodies("library", "library"));
  });
  for (std::size_t f = 0; f < 20; ++f) EXPECT_EQ(shown[f].result, plain[f].result) << f;
  EXPECT_GT((shown[140].result - plain[140].result).cwiseAbs().maxCoeff(), 0.05);
  for (std::size_t f = 275; f < user.size(); ++f) EXPECT_EQ(shown[f].result, plain[f].result) << f;
  // 20 % of a height of 1.7 m in 1.5 s, beside what the dance itself moves.
  EXPECT_LT(farthest_step(shown), farthest_step(plain) + 0.02);
}

TEST(ShownBodies, AnotherSynthesizerContinuesFromTheStateToTheBit) {
  const std::vector<Pose> user = dancing_user();
  auto first = synthesizer_of(with_bodies("library", "library"));
  auto second = synthesizer_of(with_bodies("scale:1.2", "library"));
  for (std::size_t f = 0; f < 60; ++f) {
    if (f == 30) first->set_settings(with_bodies("scale:1.2", "library"));
    first->step(user[f], f == 0 ? Duration(0) : step_time);
  }
  second->restore(first->state());
  for (std::size_t f = 60; f < 120; ++f) {
    const PairPose one = first->step(user[f], step_time).result;
    EXPECT_EQ(one, second->step(user[f], step_time).result) << f;
  }
}

TEST(ShownBodies, AFailedFrameHoldsTheShownPose) {
  const std::vector<Pose> user = dancing_user();
  auto synthesizer = synthesizer_of(with_bodies("scale:1.2", "library"));
  for (std::size_t f = 0; f < 30; ++f) synthesizer->step(user[f], f == 0 ? Duration(0) : step_time);
  const PairPose last = synthesizer->step(user[30], step_time).result;
  Pose broken = user[31];
  broken(4, 1) = std::numeric_limits<double>::quiet_NaN();
  const FrameResult& held = synthesizer->step(broken, step_time);
  EXPECT_EQ(held.status, StepStatus::Failed);
  EXPECT_LT((held.result - last).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(ShownBodies, AChildWithAGiantHasRightBonesAndIsRelaxedOnlyWithAReason) {
  for (const auto& [active, passive] :
       {std::pair{"scale:0.3", "scale:3"}, std::pair{"scale:3", "scale:0.3"}}) {
    auto synthesizer = synthesizer_of(with_bodies(active, passive));
    for (const FrameResult& frame : danced(*synthesizer, dancing_user())) {
      ASSERT_TRUE(frame.result.allFinite());
      EXPECT_LT(frame.residual.bone_length_max, 1e-3);
      EXPECT_TRUE(frame.status != StepStatus::Relaxed || !frame.message.empty());
    }
  }
}

TEST(ShownBodies, AHoldThatTheseBodiesCannotKeepIsSaidToBeTheNearestPose) {
  ChoreographyOptions options;
  options.minutes = 0.2;
  const PairedTake take = generate_salsa(options).front();
  const Body active = body_of(take.a.poses), passive = body_of(take.b.poses);
  CapsuleRadii radii{};
  radii.fill(0.04);
  ShownBodies bodies;
  ShownMemory memory;
  memory.bodies[0].follow(scaled_body(active, 0.3), false, 0, true);
  memory.bodies[1].follow(scaled_body(passive, 3), false, 0, true);
  int nearest = 0;
  for (std::size_t f = 120; f < 240; ++f) {
    PairPose pair;
    pair << take.a.poses[f], take.b.poses[f];
    const auto edges = tetrahedralize(pair).edges;
    const Pose user = 0.3 * take.a.poses[f];
    const PairFit::Outcome& shown = bodies.fit({.edges = edges,
                                                .solved = pair,
                                                .user = user,
                                                .path = 0.3,
                                                .recorded = {&active, &passive},
                                                .radii = {&radii, &radii},
                                                .holds = {},
                                                .elapsed_s = f > 120 ? step_time.count() : 0,
                                                .continues = f > 120},
                                               memory);
    ASSERT_TRUE(shown.pose.allFinite());
    EXPECT_LT(shown.bone_error, 1e-3);
    if (bodies.shortfall().empty()) continue;
    ++nearest;
    EXPECT_THAT(std::string(bodies.shortfall()), HasSubstr("nearest pose: the"));
  }
  EXPECT_GT(nearest, 0);
}

TEST(ShownBodies, AFileThatWasNotReadIsRefusedAndOneThatWasReadIsWorn) {
  Settings settings = with_bodies("tall.bvh", "library");
  auto synthesizer = synthesizer_of(settings);
  const FrameResult& refused = synthesizer->step(dancing_user().front(), Duration(0));
  EXPECT_EQ(refused.status, StepStatus::Failed);
  EXPECT_THAT(refused.message, HasSubstr("was not measured"));

  settings.active_body.measured = scaled_body(test::small_library()->usual_active_body().body, 1.1);
  synthesizer->set_settings(settings);
  const FrameResult& worn = synthesizer->step(dancing_user().front(), Duration(0));
  EXPECT_LT(bone_difference(worn.active(), *settings.active_body.measured), 1e-3);
}

/// Two people who hold one another by a hand; the partner's feet stand.
struct Holding {
  PairPose pair = test::facing_pair(0.7);
  std::vector<MeshEdge> edges = tetrahedralize(pair).edges;
  Body active = body_of(Pose(pair.topRows<joint_count>()));
  Body passive = body_of(Pose(pair.bottomRows<joint_count>()));
  CapsuleRadii radii{};
  std::vector<HandHold> holds;

  Holding() {
    radii.fill(0.04);
    const Vec3 offset = pair.row(joint_count + joints::right_hand) - pair.row(joints::left_hand);
    holds.push_back({true, false, 1, offset});
  }

  PairPose shown(double active_scale, double passive_scale, ShownBodies& bodies, int frames = 60) const {
    ShownMemory memory;
    memory.bodies[0].follow(scaled_body(active, active_scale), false, 0, true);
    memory.bodies[1].follow(scaled_body(passive, passive_scale), false, 0, true);
    const Pose user = active_scale * pair.topRows<joint_count>();
    PairPose last;
    for (int f = 0; f < frames; ++f)
      last = bodies
                 .fit({.edges = edges,
                       .solved = pair,
                       .user = user,
                       .path = active_scale,
                       .recorded = {&active, &passive},
                       .radii = {&radii, &radii},
                       .holds = holds,
                       .elapsed_s = f > 0 ? step_time.count() : 0,
                       .continues = f > 0},
                      memory)
                 .pose;
    return last;
  }
};

TEST(ShownBodies, HowMuchIsLeftOfAReturnDependsOnItsTimeNotOnTheNumberOfFrames) {
  const auto left_after = [](int frames, double elapsed_s) {
    ShownMemory memory;
    memory.difference.setOnes();
    PairPose shown;
    for (int f = 0; f < frames; ++f) shown = returning_to(PairPose::Zero(), elapsed_s, memory);
    return shown(0, 0);
  };
  const double left = left_after(1, 0.12);
  EXPECT_GT(left, 0.01);
  EXPECT_LT(left, 0.99);
  EXPECT_NEAR(left_after(2, 0.06), left, 1e-12);
  EXPECT_NEAR(left_after(12, 0.01), left, 1e-12);
}

TEST(ShownBodies, HandsThatHoldOneAnotherStayWhereTheyAreToOneAnother) {
  const Holding two;
  for (const auto& [active, passive] : {std::pair{0.85, 0.85}, std::pair{1.15, 1.0}, std::pair{0.85, 1.15}}) {
    ShownBodies bodies;
    const PairPose shown = two.shown(active, passive, bodies);
    const Vec3 offset =
        (shown.row(joint_count + joints::right_hand) - shown.row(joints::left_hand)).transpose();
    EXPECT_LT((offset - two.holds.front().offset).norm(), 0.01) << active << ' ' << passive;
    EXPECT_EQ(bodies.shortfall(), "");
  }
}

TEST(ShownBodies, BothStandUprightWhateverTheSizes) {
  const Holding two;
  for (const auto& [active, passive] :
       {std::pair{0.85, 1.0}, std::pair{1.15, 1.0}, std::pair{0.85, 1.15}, std::pair{1.15, 0.85}}) {
    ShownBodies bodies;
    const PairPose shown = two.shown(active, passive, bodies);
    for (const int first : {0, joint_count}) {
      const PostureChange change =
          posture_change(shown.middleRows<joint_count>(first), two.pair.middleRows<joint_count>(first),
                         first == 0 ? active : passive);
      EXPECT_NEAR(change.pelvis, 1, 0.03) << active << ' ' << passive << ' ' << first;
      EXPECT_NEAR(change.knee_deg, 0, 5) << active << ' ' << passive << ' ' << first;
      EXPECT_NEAR(change.trunk_deg, 0, 3) << active << ' ' << passive << ' ' << first;
    }
  }
}

TEST(ShownBodies, FeetStandOnTheFloorWhateverTheSizes) {
  const Holding two;
  for (const auto& [active, passive] : {std::pair{0.7, 1.3}, std::pair{1.3, 0.7}}) {
    ShownBodies bodies;
    const PairPose shown = two.shown(active, passive, bodies);
    for (const int foot : {joints::left_toe_base, joints::right_toe_base}) {
      EXPECT_NEAR(shown(foot, 1), active * two.pair(foot, 1), 0.005);
      EXPECT_NEAR(shown(joint_count + foot, 1), passive * two.pair(joint_count + foot, 1), 0.005);
    }
  }
}

TEST(ShownBodies, AFootChangesItsPlaceOnlyAsItMoves) {
  const Holding two;
  ShownBodies bodies;
  const PairPose early = two.shown(1.3, 0.85, bodies, 5);
  const PairPose late = two.shown(1.3, 0.85, bodies, 120);
  for (const int foot : {joints::left_toe_base, joints::right_toe_base})
    EXPECT_LT((early.row(joint_count + foot) - late.row(joint_count + foot)).norm(), 0.01);
}

}  // namespace
}  // namespace abrazo::shown_bodies_test
