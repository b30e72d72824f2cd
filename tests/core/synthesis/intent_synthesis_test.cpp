#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "core/selection/intent_model.hpp"
#include "core/synthesis/frames/trace.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"
#include "core/synthesis/step/role_views.hpp"
#include "core/synthesis/step/synthesizer_state.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"
#include "tests/support/settings.hpp"

namespace abrazo::intent_synthesis_test {
namespace {

using nlohmann::json;
using Synthesizer = std::unique_ptr<PartnerSynthesizer>;

constexpr Duration step_time(1.0 / 60);

constexpr auto by_intent = test::responsive_by_intent;
constexpr auto equation_7 = test::responsive_by_pose;

const std::shared_ptr<const MotionLibrary>& library() {
  static const auto small = test::small_library();
  return small;
}

Synthesizer synthesizer_with(const Settings& settings, const std::vector<std::string>& excluded = {}) {
  return std::move(*PartnerSynthesizer::create(library(), settings, excluded));
}

const PairedTake& first_take() {
  static const PairedTake take = test::swinging_take("first", 180, 1);
  return take;
}

const Clip& stranger() {
  static const Clip clip = test::swinging_take("user", 240, 17).a;
  return clip;
}

const FrameResult& run(PartnerSynthesizer& synthesizer, const Clip& user, std::size_t first,
                       std::size_t end) {
  const FrameResult* last = nullptr;
  for (std::size_t frame = first; frame < end; ++frame)
    last = &synthesizer.step(user.poses[frame], step_time);
  return *last;
}

const Candidate& chosen(const FrameResult& frame) {
  return frame.candidates.at(static_cast<std::size_t>(frame.selected));
}

/// All that a frame says but for how long it took, and what is believed.
std::string content(const FrameResult& frame) {
  FrameResult timeless = frame;
  timeless.timing = {};
  return trace_frame_line(timeless, *library(), 0, 0) +
         std::string(frame.intent.belief.begin(), frame.intent.belief.end());
}

TEST(IntentSynthesis, AUserWhoRepeatsARecordedLeaderGetsTheRecordedPartner) {
  auto synthesizer = synthesizer_with(by_intent());
  synthesizer->set_user_body(library()->usual_active_body().body);
  double off_m = 0;
  int changes = 0;
  for (std::size_t frame = 0; frame < 180; ++frame) {
    const FrameResult& result = synthesizer->step(first_take().a.poses[frame], step_time);
    ASSERT_NE(result.status, StepStatus::Failed) << result.message;
    if (frame < 60) continue;
    // The source may be a frame ahead of the user, and leaves a recording before it stands still at its end.
    if (frame < 178) {
      EXPECT_EQ(library()->take_of(chosen(result).pair).name, "first") << frame;
    }
    off_m += (result.passive() - first_take().b.poses[frame]).rowwise().norm().mean() / 120;
    changes += result.source_changed;
  }
  EXPECT_LT(off_m, 0.02);
  EXPECT_LE(changes, 1);
}

TEST(IntentSynthesis, NothingIsSelectedOrBelievedOfATakeThatIsLeftOut) {
  auto synthesizer = synthesizer_with(by_intent(), {"first"});
  for (std::size_t frame = 0; frame < 180; ++frame) {
    const FrameResult& result = synthesizer->step(first_take().a.poses[frame], step_time);
    ASSERT_NE(result.status, StepStatus::Failed) << result.message;
    for (const Candidate& candidate : result.candidates)
      ASSERT_EQ(library()->take_of(candidate.pair).name, "second");
    for (const BeliefBlock& block : result.intent.model->blocks()) ASSERT_EQ(block.take, 1U);
    ASSERT_EQ(result.intent.belief.size(), result.intent.model->blocks().size());
  }
}

TEST(IntentSynthesis, EqualInputGivesTheSameBits) {
  const auto trace = [] {
    auto synthesizer = synthesizer_with(by_intent());
    std::string lines;
    for (const Pose& pose : stranger().poses) lines += content(synthesizer->step(pose, step_time));
    return lines;
  };
  EXPECT_EQ(trace(), trace());
}

/// Coordinates a kilometre away round by 1e-13 m, which the history turns into 1e-7 here and there; now and
/// then the solver finds another contact for it.
TEST(IntentSynthesis, AKilometreAwayTheSameIsSelected) {
  auto here = synthesizer_with(by_intent()), there = synthesizer_with(by_intent());
  for (const auto& way : {Eigen::RowVector3d(1e3, 0, -1e3), Eigen::RowVector3d(-800, 0, 1e3)})
    for (std::size_t frame = 0; frame < stranger().poses.size(); ++frame) {
      const Duration elapsed = frame == 0 ? Duration(0) : step_time;
      const FrameResult& one = here->step(stranger().poses[frame], elapsed);
      const FrameResult& other = there->step(stranger().poses[frame].rowwise() + way, elapsed);
      ASSERT_EQ(one.candidates.size(), other.candidates.size()) << frame;
      for (std::size_t c = 0; c < one.candidates.size(); ++c) {
        ASSERT_EQ(one.candidates[c].pair, other.candidates[c].pair) << frame;
        ASSERT_NEAR(one.candidates[c].intent->total, other.candidates[c].intent->total, 1e-5) << frame;
      }
      ASSERT_EQ(one.selected, other.selected) << frame;
      ASSERT_LT((one.result - (other.result.rowwise() - way)).cwiseAbs().maxCoeff(), 5e-3) << frame;
    }
}

TEST(IntentSynthesis, RestoredInTheMiddleItGoesOnWithTheSameBits) {
  auto first = synthesizer_with(by_intent()), second = synthesizer_with(by_intent());
  auto forgetful = synthesizer_with(by_intent());
  run(*first, stranger(), 0, 100);
  const SynthesizerState state = first->state();
  run(*second, first_take().a, 0, 30);  // what it did before is nothing to it
  second->restore(state);
  SynthesizerState without_history = state;
  without_history.memory.history.clear();
  forgetful->restore(without_history);
  for (std::size_t frame = 100; frame < 200; ++frame) {
    const Pose& pose = stranger().poses[frame];
    const std::string expected = content(first->step(pose, step_time));
    ASSERT_EQ(content(second->step(pose, step_time)), expected) << frame;
    if (frame == 100) {
      EXPECT_NE(content(forgetful->step(pose, step_time)), expected) << "the history is of the state";
    }
  }
}

TEST(IntentSynthesis, AResetAndALossOfTrackingForgetWhatTheUserDid) {
  const Pose& pose = stranger().poses[150];
  Settings by_frames = by_intent();  // with the other playback the partner goes on from where it is
  by_frames.playback = SourcePlayback::Frames;
  auto fresh = synthesizer_with(by_frames);
  const std::string expected = content(fresh->step(pose, Duration(0)));
  auto synthesizer = synthesizer_with(by_frames);
  run(*synthesizer, stranger(), 0, 100);
  synthesizer->reset();
  EXPECT_EQ(content(synthesizer->step(pose, step_time)), expected);
  run(*synthesizer, stranger(), 0, 100);
  EXPECT_EQ(content(synthesizer->step(pose, Duration(0.31))), expected);
  run(*synthesizer, stranger(), 0, 100);
  EXPECT_NE(content(synthesizer->step(pose, step_time)), expected);
}

TEST(IntentSynthesis, AFrameThatFailsIsNotRemembered) {
  auto synthesizer = synthesizer_with(by_intent());
  run(*synthesizer, stranger(), 0, 50);
  const std::size_t size = synthesizer->state().memory.history.size();
  Pose broken = stranger().poses[50];
  broken(3, 1) = std::numeric_limits<double>::quiet_NaN();
  for (int frame = 0; frame < 6; ++frame) {
    const FrameResult& failed = synthesizer->step(broken, step_time);
    EXPECT_EQ(failed.status, StepStatus::Failed);
    EXPECT_EQ(failed.intent.model, nullptr);
    EXPECT_TRUE(failed.intent.belief.empty());
  }
  EXPECT_EQ(synthesizer->state().memory.history.size(), size);
  EXPECT_EQ(synthesizer->step(stranger().poses[56], step_time).status, StepStatus::Ok);
}

TEST(IntentSynthesis, TheLeadOfTheUserIsThatOfTheFrame) {
  const auto leading = [] {
    auto synthesizer = synthesizer_with(by_intent());
    std::size_t frame = 0;
    while (frame < 200 && synthesizer->step(stranger().poses[frame], step_time).intent.lead_s == 0) ++frame;
    EXPECT_LT(frame, 200U) << "the user must lead to test anything";
    return synthesizer;
  };
  const auto refused = leading();
  EXPECT_EQ(refused->step(Pose::Constant(std::numeric_limits<double>::quiet_NaN()), step_time).intent.lead_s,
            0);
  const auto changed = leading();
  changed->set_settings(equation_7());
  EXPECT_EQ(changed->step(stranger().poses[201], step_time).intent.lead_s, 0) << "Eq. 7 does not know any";
}

TEST(IntentSynthesis, APassiveUserIsUnderstoodByThePassivesMotion) {
  Settings settings = by_intent();
  settings.user_role = UserRole::Passive;
  auto synthesizer = synthesizer_with(settings);
  synthesizer->set_user_body(library()->usual_passive_body().body);
  double off_m = 0;
  for (std::size_t frame = 0; frame < 180; ++frame) {
    const FrameResult& result = synthesizer->step(first_take().b.poses[frame], step_time);
    ASSERT_NE(result.status, StepStatus::Failed) << result.message;
    ASSERT_TRUE(result.intent.model);
    ASSERT_EQ(result.intent.belief.size(), result.intent.model->blocks().size());
    ASSERT_TRUE(result.intent.model->library()->columns().roles_exchanged);
    if (frame < 60) continue;
    // The source may be a frame ahead of the user, and leaves a recording before it stands still at its end.
    if (frame < 178) {
      EXPECT_EQ(library()->take_of(chosen(result).pair).name, "first") << frame;
    }
    off_m += (result.active() - first_take().a.poses[frame]).rowwise().norm().mean() / 120;
  }
  EXPECT_LT(off_m, 0.02);
}

TEST(IntentSynthesis, TheMethodCanChangeInEveryStepAndKnowsWhatTheUserDid) {
  auto always = synthesizer_with(by_intent()), now_and_then = synthesizer_with(equation_7());
  for (std::size_t frame = 0; frame < 200; ++frame) {
    const bool reads_intent = frame % 30 > 20;
    now_and_then->set_settings(reads_intent ? by_intent() : equation_7());
    const FrameResult& expected = always->step(stranger().poses[frame], step_time);
    const FrameResult& result = now_and_then->step(stranger().poses[frame], step_time);
    ASSERT_NE(result.status, StepStatus::Failed);
    for (const Candidate& candidate : result.candidates)
      ASSERT_EQ(candidate.intent.has_value(), reads_intent);
    if (reads_intent) {
      // Sources differ, but not what is believed of what the user did.
      ASSERT_EQ(result.intent.belief, expected.intent.belief) << frame;
      ASSERT_EQ(result.intent.moves, expected.intent.moves) << frame;
    } else {
      ASSERT_EQ(result.intent.model, nullptr);
      ASSERT_TRUE(result.intent.belief.empty());
      ASSERT_TRUE(result.intent.moves.empty());
      ASSERT_EQ(result.intent.continued, -1);
    }
  }
}

TEST(IntentSynthesis, EquationSevenSelectsAsIfThereWereNoOtherMethod) {
  auto paper = synthesizer_with(*preset("paper")), learned = synthesizer_with(by_intent());
  learned->step(stranger().poses[0], Duration(0));
  learned->set_settings(*preset("paper"));
  learned->reset();
  for (std::size_t frame = 0; frame < 100; ++frame)
    ASSERT_EQ(content(learned->step(stranger().poses[frame], step_time)),
              content(paper->step(stranger().poses[frame], step_time)));
}

TEST(IntentSynthesis, APinnedPairIsSelectedAlsoWhenItIsVetoed) {
  auto synthesizer = synthesizer_with(by_intent());
  run(*synthesizer, stranger(), 0, 60);
  const int pinned = library()->find_pair("second", 77, false);
  synthesizer->set_vetoes({{}, {"second"}, {}});
  synthesizer->pin_pair(pinned);
  for (std::size_t frame = 60; frame < 70; ++frame) {
    const FrameResult& result = synthesizer->step(stranger().poses[frame], step_time);
    ASSERT_EQ(chosen(result).pair, pinned);
    const IntentCost& cost = chosen(result).intent.value();
    EXPECT_DOUBLE_EQ(cost.total,
                     cost.partner + cost.leader + cost.move + cost.meant + cost.change + cost.temporal);
    EXPECT_TRUE(
        std::is_sorted(result.candidates.begin(), result.candidates.end(),
                       [](const auto& a, const auto& b) { return a.feature_distance < b.feature_distance; }));
  }
  synthesizer->pin_pair({});
  EXPECT_EQ(library()->take_of(chosen(synthesizer->step(stranger().poses[70], step_time)).pair).name,
            "first");
}

TEST(IntentSynthesis, WithEverythingVetoedAStepFailsAndSaysSo) {
  auto synthesizer = synthesizer_with(by_intent());
  const PairPose held = run(*synthesizer, stranger(), 0, 60).result;
  synthesizer->set_vetoes({{}, {"first", "second"}, {}});
  const FrameResult& failed = synthesizer->step(stranger().poses[60], step_time);
  EXPECT_EQ(failed.status, StepStatus::Failed);
  EXPECT_NE(failed.message.find("every recorded pair is vetoed"), std::string::npos);
  EXPECT_EQ(failed.result, held);
  synthesizer->set_vetoes({});
  EXPECT_EQ(synthesizer->step(stranger().poses[61], step_time).status, StepStatus::Ok);
}

TEST(IntentSynthesis, WhatAPersonNamesIsPreferredNotForced) {
  Settings settings = by_intent();
  settings.meant_weight = 2;
  auto synthesizer = synthesizer_with(settings);
  synthesizer->set_intended(IntendedPairs{{}, "second"});
  const FrameResult& result = run(*synthesizer, first_take().a, 0, 100);
  EXPECT_EQ(library()->take_of(chosen(result).pair).name, "second");
  settings.switch_margin = 0.03;  // as soon as another is a little better
  settings.meant_weight = 0;
  synthesizer->set_settings(settings);
  EXPECT_EQ(library()->take_of(chosen(run(*synthesizer, first_take().a, 100, 140)).pair).name, "first");
}

TEST(IntentSynthesis, TheTraceTellsTheTermsTheMovesAndWhatWouldHaveGoneOn) {
  auto synthesizer = synthesizer_with(by_intent());
  const FrameResult& result = run(*synthesizer, first_take().a, 0, 100);
  const json frame = json::parse(trace_frame_line(result, *library(), 99, 99 / 60.0));
  const auto selected = frame["selected"].get<std::size_t>();
  for (const json& candidate : frame["candidates"]) {
    const json& intent = candidate["intent"];
    double sum = 0;
    for (const char* term : {"partner", "leader", "move", "meant", "change", "temporal"})
      sum += intent[term].get<double>();
    EXPECT_NEAR(intent["total"].get<double>(), sum, 1e-12);
    EXPECT_GE(intent["total"], frame["candidates"][selected]["intent"]["total"]);
    EXPECT_TRUE(candidate["cost"]["total"].is_number());
  }
  const json& moves = frame["intent"]["moves"];
  EXPECT_EQ(moves.size(), 2U);
  EXPECT_NEAR(moves["open_hold"].get<double>() + moves["turn"].get<double>(), 1, 1e-5);
  const json& continued = frame["intent"]["continued"];
  EXPECT_EQ(continued["take"], "first");
  EXPECT_EQ(continued["frame"], static_cast<int>(library()->source(result.intent.continued).frame));
  EXPECT_EQ(continued["swapped"], false);
  synthesizer->reset();
  const json first = json::parse(trace_frame_line(run(*synthesizer, stranger(), 0, 1), *library(), 0, 0));
  EXPECT_TRUE(first["intent"]["continued"].is_null());
  synthesizer->set_settings(*preset("paper"));
  const json by_paper = json::parse(trace_frame_line(run(*synthesizer, stranger(), 1, 2), *library(), 0, 0));
  EXPECT_FALSE(by_paper.contains("intent"));
  EXPECT_FALSE(by_paper["candidates"][0].contains("intent"));
}

TEST(IntentSynthesis, WhatIsLearnedIsSharedAndPreparedBesideTheSteps) {
  auto synthesizer = synthesizer_with(by_intent());
  const RoleViews& views = *synthesizer->views();
  EXPECT_FALSE(views.is_intent_ready(UserRole::Active)) << "nothing is learned before it is needed";
  const auto& learned = views.intent(UserRole::Active);
  EXPECT_TRUE(views.is_intent_ready(UserRole::Active));
  EXPECT_FALSE(views.is_intent_ready(UserRole::Passive));
  EXPECT_EQ(synthesizer->step(stranger().poses[0], Duration(0)).intent.model, learned);
  EXPECT_FALSE(views.intent_trouble(UserRole::Active));
}

TEST(IntentSynthesis, PairsBetweenThoseThatMayBeChangedToAreSelectedWhenNothingElseIsLeft) {
  const Synthesizer synthesizer = synthesizer_with(by_intent());
  const auto& landings = synthesizer->views()->intent(UserRole::Active)->landings();
  Vetoes vetoes;
  vetoes.pairs.insert(landings.begin(), landings.end());
  synthesizer->set_vetoes(vetoes);
  const FrameResult& result = synthesizer->step(first_take().a.poses[60], Duration(0));
  ASSERT_NE(result.status, StepStatus::Failed) << result.message;
  EXPECT_FALSE(vetoes.pairs.contains(result.candidates[static_cast<std::size_t>(result.selected)].pair));
}

}  // namespace
}  // namespace abrazo::intent_synthesis_test
