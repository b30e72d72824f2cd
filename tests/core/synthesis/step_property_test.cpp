#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <tuple>

#include "core/library/build/motion_library_builder.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"
#include "core/synthesis/step/synthesizer_state.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::step_property_test {
namespace {

constexpr double bone_limit = 1e-3;
constexpr double drift_limit_m = 1e-3;
constexpr Duration step_time(1.0 / 60);

using Library = std::shared_ptr<const MotionLibrary>;

/// A take whose every pose went through `change`, as a library.
template <typename Change>
Library changed_library(const std::string& name, int frames, const Change& change,
                        const LibraryBuildOptions& options = {}) {
  PairedTake take = test::swinging_take("only", frames, 3);
  for (Clip* clip : {&take.a, &take.b})
    for (Pose& pose : clip->poses) change(pose);
  std::vector<PairedTake> takes;
  takes.push_back(std::move(take));
  return std::make_shared<const MotionLibrary>(
      std::move(*build_library(name, std::move(takes), options, {})));
}

LibraryBuildOptions every_other_frame() {
  LibraryBuildOptions options;
  options.rate_hz = 30;
  return options;
}

/// Libraries as recordings can be at their worst.
const std::vector<Library>& libraries() {
  static const std::vector<Library> all = {
      test::small_library(),
      changed_library(
          "one pair", 2, [](Pose&) {}, every_other_frame()),
      changed_library("both bodies in one plane", 30, [](Pose& pose) { pose.col(2).setZero(); }),
      changed_library("joints on one another", 30,
                      [](Pose& pose) {
                        using namespace joints;
                        pose.row(LeftHand) = pose.row(LeftWrist);
                        pose.row(RightToes) = pose.row(RightFoot);
                        pose.row(UpperNeck) = pose.row(LowerNeck);
                      }),
      changed_library("a kilometre away", 30,
                      [](Pose& pose) { pose.rowwise() += Eigen::RowVector3d(1000, 0, -1000); }),
  };
  return all;
}

double number(double least, double most) {
  return least + (most - least) * *rc::gen::inRange(0, 1001) / 1000.0;
}

/// Within the ranges that are promised, ends included.
Settings any_settings() {
  Settings settings = *preset(*rc::gen::elementOf(std::vector<std::string_view>{"paper", "responsive"}));
  for (const SettingInfo& info : all_settings()) {
    if (*rc::gen::inRange(0, 3) > 0) continue;
    std::string text;
    if (info.kind == SettingInfo::Kind::Flag) {
      text = *rc::gen::arbitrary<bool>() ? "on" : "off";
    } else if (info.kind == SettingInfo::Kind::Choice) {
      const std::string choices(info.choices);
      const auto bar = choices.find('|');
      text = *rc::gen::arbitrary<bool>() ? choices.substr(0, bar) : choices.substr(choices.rfind('|') + 1);
    } else if (info.kind == SettingInfo::Kind::Body) {
      text = *rc::gen::element("library", "scale:0.3", "scale:0.85", "scale:1.3", "scale:3");
    } else {
      const double share = *rc::gen::element(0.0, 1.0, 0.01, 0.3);
      double value = info.minimum + share * (info.maximum - info.minimum);
      if (info.kind == SettingInfo::Kind::Integer) value = std::floor(value);
      if (info.key == "step-rate") value = 0;
      text = std::to_string(value);
      if (info.kind == SettingInfo::Kind::Integer) text = std::to_string(static_cast<int>(value));
    }
    const Status set = set_setting(settings, info.key, text);
    RC_ASSERT(static_cast<bool>(set) || info.key == "anchor-weight");  // its range ends in small digits
  }
  return settings;
}

enum class Odd { Nothing, Shaken, FarAway, Teleport, OneJointAway, OnOnePoint, InOnePlane, Huge, NotANumber };

/// A user's pose, in most frames as a person's is.
Pose any_pose(std::size_t frame, Odd odd) {
  static const std::vector<Pose> dance = test::swinging_take("user", 400, 17).a.poses;
  std::mt19937 random(static_cast<unsigned>(*rc::gen::inRange(0, 1000)));
  Pose pose = dance[frame % dance.size()];
  const auto joint = *rc::gen::inRange(0, joint_count);
  switch (odd) {
    case Odd::Nothing:
      break;
    case Odd::Shaken:
      pose = test::shaken(pose, number(0, 0.3), random);
      break;
    case Odd::FarAway:
      pose.rowwise() += Eigen::RowVector3d(1e3, 0, -1e3);
      break;
    case Odd::Teleport:
      pose =
          test::moved(pose, number(-std::numbers::pi, std::numbers::pi), {number(-9, 9), 0, number(-9, 9)});
      break;
    case Odd::OneJointAway:
      pose.row(joint) += Eigen::RowVector3d(number(-5, 5), number(-5, 5), number(-5, 5));
      break;
    case Odd::OnOnePoint:
      pose.rowwise() = Eigen::RowVector3d(pose.row(joint)).eval();
      break;
    case Odd::InOnePlane:
      pose.col(*rc::gen::inRange(0, 3)).setConstant(number(0, 1));
      break;
    case Odd::Huge:
      pose *= *rc::gen::element(1e-300, 1e-9, 1e6, 1e150, 1e300);
      break;
    case Odd::NotANumber:
      pose(joint, 1) =
          *rc::gen::element(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                            -std::numeric_limits<double>::infinity());
      break;
  }
  return pose;
}

Odd any_oddity() {
  return *rc::gen::weightedElement<Odd>({{12, Odd::Nothing},
                                         {2, Odd::Shaken},
                                         {1, Odd::FarAway},
                                         {2, Odd::Teleport},
                                         {2, Odd::OneJointAway},
                                         {1, Odd::OnOnePoint},
                                         {1, Odd::InOnePlane},
                                         {1, Odd::Huge},
                                         {1, Odd::NotANumber}});
}

/// Largest relative difference of a bone from what it should be, measured on the joints alone.
double bone_error(const Pose& pose, const Body& body) {
  double largest = 0;
  for (int b = 0; b < bone_count; ++b) {
    const double wanted = body.bone_lengths[static_cast<std::size_t>(b)];
    if (wanted < 1e-6) continue;
    const auto [from, to] = bone(b);
    largest = std::max(largest, std::abs((pose.row(from) - pose.row(to)).norm() - wanted) / wanted);
  }
  return largest;
}

/// @param bodies  of the user's character and the partner
void holds_together(const FrameResult& frame, const std::array<GlidingBody, 2>& bodies, UserRole role,
                    const PairPose* last_good) {
  RC_ASSERT(frame.result.allFinite());
  RC_ASSERT(!frame.morph_steps.empty());
  for (const PairPose& step : frame.morph_steps) RC_ASSERT(step.allFinite());
  RC_ASSERT((frame.morph_steps.back() == frame.result));
  RC_ASSERT(frame.message.empty() == (frame.status == StepStatus::Ok));
  RC_ASSERT(frame.edge_weights.size() == frame.edge_residuals_m.size());
  if (frame.status == StepStatus::Failed) {
    RC_ASSERT((last_good == nullptr || frame.result == *last_good));
    return;
  }
  RC_ASSERT(frame.selected >= 0);
  RC_ASSERT(frame.selected < static_cast<int>(frame.candidates.size()));
  const std::size_t active = role == UserRole::Active ? 0 : 1;
  RC_ASSERT(bone_error(frame.active(), bodies[active].now()) <= bone_limit);
  RC_ASSERT(bone_error(frame.passive(), bodies[1 - active].now()) <= bone_limit);
  RC_ASSERT(frame.residual.bone_length_max <= bone_limit);
  RC_ASSERT(frame.residual.foot_lock_max_m <= drift_limit_m);
  for (const double value : {frame.energy.deformation, frame.energy.velocity, frame.energy.constraint,
                             frame.residual.morph_rms_m, frame.residual.penetration_max_m})
    RC_ASSERT(std::isfinite(value) && value >= 0);
}

/// What a session of a few dozen steps gave.
struct Session {
  std::vector<PairPose> results;
  int solved = 0;
};

struct Step {
  Pose user;
  Duration elapsed;
  std::optional<Settings> change;
  std::optional<int> pin;
  std::optional<Vetoes> vetoes;
};

std::vector<Step> any_steps() {
  std::vector<Step> steps;
  const int count = *rc::gen::inRange(1, 25);
  for (int frame = 0; frame < count; ++frame) {
    Step step;
    step.user = any_pose(static_cast<std::size_t>(frame), any_oddity());
    step.elapsed = Duration(*rc::gen::weightedElement<double>(
        {{12, 1.0 / 60}, {2, 1.0 / 15}, {1, 0.0}, {1, 1e-9}, {1, 0.29}, {1, 10.0}, {1, -1.0}}));
    if (*rc::gen::inRange(0, 6) == 0) step.change = any_settings();
    if (*rc::gen::inRange(0, 6) == 0) step.pin = *rc::gen::inRange(-2, 400);
    if (*rc::gen::inRange(0, 6) == 0)
      step.vetoes =
          *rc::gen::element(Vetoes{}, Vetoes{{0, 7}, {"first"}, {}}, Vetoes{{}, {}, {"turn", "open_hold"}});
    steps.push_back(step);
  }
  return steps;
}

Session run(PartnerSynthesizer& synthesizer, const std::vector<Step>& steps) {
  const auto library = synthesizer.shared_library();
  const UserRole role = synthesizer.settings().user_role;
  Session session;
  std::optional<PairPose> last_good;
  for (const Step& step : steps) {
    if (step.change && step.change->user_role == role) synthesizer.set_settings(*step.change);
    synthesizer.pin_pair(step.pin);
    if (step.vetoes) synthesizer.set_vetoes(*step.vetoes);
    const FrameResult& frame = synthesizer.step(step.user, step.elapsed);
    holds_together(frame, synthesizer.state().memory.shown.bodies, role, last_good ? &*last_good : nullptr);
    const Settings& settings = synthesizer.settings();
    const bool by_intent = settings.selection == SelectionMethod::Intent;
    const bool continues = by_intent || settings.playback == SourcePlayback::Continuous;
    const int most =
        settings.neighbours + std::max(continues ? 1 : 0, by_intent ? 0 : settings.continuations) + 1;
    RC_ASSERT(static_cast<int>(frame.candidates.size()) <= std::min(most, library->pair_count()));
    if (frame.status != StepStatus::Failed) last_good = frame.result, ++session.solved;
    session.results.push_back(frame.result);
  }
  return session;
}

/// One that need not learn its library again; as if it were new. @param which  of several at a time
PartnerSynthesizer& learned_synthesizer(std::size_t library, const Settings& settings, int which = 0) {
  static std::map<std::tuple<std::size_t, UserRole, int>, std::unique_ptr<PartnerSynthesizer>> all;
  auto& synthesizer = all[{library, settings.user_role, which}];
  if (!synthesizer) synthesizer = std::move(*PartnerSynthesizer::create(libraries()[library], settings));
  SynthesizerState fresh;
  fresh.user_role = settings.user_role;
  fresh.vetoes = std::make_shared<const Vetoes>();
  synthesizer->restore(fresh);
  synthesizer->set_settings(settings);
  return *synthesizer;
}

Settings with_intent(Settings settings) {
  return settings.selection = SelectionMethod::Intent, settings;
}

void check(const std::string& what, const std::function<void()>& property) {
  EXPECT_TRUE(rc::check(what, property)) << what;
}

TEST(StepProperty, WhateverComesInEveryFrameIsFiniteKeepsItsBonesAndSaysWhatItIs) {
  check("any session", [] {
    const auto library = *rc::gen::inRange<std::size_t>(0, libraries().size());
    const Session session = run(learned_synthesizer(library, any_settings()), any_steps());
    RC_TAG(session.solved == static_cast<int>(session.results.size()) ? "all solved"
           : session.solved > 0                                       ? "some solved"
                                                                      : "none solved");
  });
}

TEST(StepProperty, TheSameSessionGivesTheSameBits) {
  check("any session twice", [] {
    const auto library = *rc::gen::inRange<std::size_t>(0, libraries().size());
    const Settings settings = any_settings();
    const std::vector<Step> steps = any_steps();
    const auto once = run(learned_synthesizer(library, settings), steps).results;
    auto fresh = std::move(*PartnerSynthesizer::create(libraries()[library], settings));
    RC_ASSERT((run(*fresh, steps).results == once));
  });
}

TEST(StepProperty, AKilometreAwayTheSameHappensThere) {
  check("two places", [] {
    Settings settings = *preset(*rc::gen::elementOf(std::vector<std::string_view>{"paper", "responsive"}));
    settings.selection = SelectionMethod::Paper;  // by intent: IntentSynthesis
    auto* const here = &learned_synthesizer(0, settings, 0);
    auto* const there = &learned_synthesizer(0, settings, 1);
    const Eigen::RowVector3d way(*rc::gen::element(1e3, -1e3), 0, number(-1e3, 1e3));
    const auto start = *rc::gen::inRange<std::size_t>(0, 300);
    for (std::size_t frame = start; frame < start + 5; ++frame) {
      const Pose user = any_pose(frame, Odd::Nothing);
      const FrameResult& one = here->step(user, step_time);
      const FrameResult& other = there->step(user.rowwise() + way, step_time);
      RC_ASSERT(one.status == other.status);
      RC_ASSERT((one.result - (other.result.rowwise() - way)).cwiseAbs().maxCoeff() < 1e-6);
    }
  });
}

TEST(StepProperty, WhateverComesTheSelectionByIntentSelectsSomethingAndSaysWhy) {
  check("any session by intent", [] {
    std::vector<Step> steps = any_steps();
    for (Step& step : steps) {
      if (!step.change) continue;
      step.change = with_intent(*step.change);
      for (double* weight : {&step.change->switch_margin, &step.change->leader_weight,
                             &step.change->move_weight, &step.change->meant_weight})
        if (*rc::gen::arbitrary<bool>()) *weight = *rc::gen::element(0.0, 0.5);
    }
    const auto library = *rc::gen::inRange<std::size_t>(0, libraries().size());
    const Settings start = with_intent(any_settings());
    const auto once = run(learned_synthesizer(library, start), steps).results;
    RC_ASSERT((run(learned_synthesizer(library, start), steps).results == once));
  });
}

TEST(StepProperty, WhatAPersonDoesIsSolvedByIntentInEveryLibrary) {
  for (std::size_t library = 0; library < libraries().size(); ++library) {
    Settings settings = with_intent(*preset("paper"));
    settings.neighbours = library % 2 == 0 ? 200 : 1;
    PartnerSynthesizer& synthesizer = learned_synthesizer(library, settings);
    for (const Pose& user : test::swinging_take("user", 90, 17).a.poses) {
      const FrameResult& result = synthesizer.step(user, step_time);
      ASSERT_NE(result.status, StepStatus::Failed) << libraries()[library]->name() << result.message;
      const Candidate& chosen = result.candidates[static_cast<std::size_t>(result.selected)];
      for (const Candidate& one : result.candidates)
        ASSERT_GE(one.intent->total, chosen.intent.value().total);
    }
  }
}

TEST(StepProperty, WhatAPersonDoesIsSolvedInEveryLibrary) {
  check("a dance", [] {
    const Library& library = libraries()[*rc::gen::inRange<std::size_t>(0, libraries().size())];
    Settings settings = *preset("paper");
    settings.neighbours = *rc::gen::inRange(1, 200);
    auto synthesizer = std::move(*PartnerSynthesizer::create(library, settings));
    const auto start = *rc::gen::inRange<std::size_t>(0, 300);
    for (std::size_t frame = start; frame < start + 20; ++frame) {
      const FrameResult& result = synthesizer->step(any_pose(frame, Odd::Nothing), step_time);
      RC_ASSERT(result.status != StepStatus::Failed);
      RC_ASSERT(static_cast<int>(result.candidates.size()) ==
                std::min(settings.neighbours, library->pair_count()));
    }
  });
}

TEST(StepProperty, ASettingOutOfItsRangeFailsTheFrameByNameUntilItIsMended) {
  check("one setting", [] {
    const std::vector<SettingInfo> all(all_settings().begin(), all_settings().end());
    auto synthesizer = std::move(*PartnerSynthesizer::create(libraries()[0], *preset("paper")));
    const PairPose good = synthesizer->step(test::standing_pose(), Duration(0)).result;
    const double bad = *rc::gen::element(-1.0, -1e300, 1e300, std::numeric_limits<double>::infinity(),
                                         std::numeric_limits<double>::quiet_NaN());
    Settings settings = *preset("paper");
    struct Field {
      std::string_view key;
      double Settings::*member;
    };
    const Field field =
        *rc::gen::elementOf(std::vector<Field>{{"alpha", &Settings::alpha},
                                               {"velocity-weight", &Settings::velocity_weight},
                                               {"morph-weight", &Settings::morph_weight},
                                               {"anchor-weight", &Settings::anchor_weight},
                                               {"foot-lock-speed", &Settings::foot_lock_speed},
                                               {"transition-time", &Settings::transition_time_s},
                                               {"place-rate", &Settings::place_rate},
                                               {"hold-weight", &Settings::hold_weight},
                                               {"switch-margin", &Settings::switch_margin},
                                               {"leader-weight", &Settings::leader_weight},
                                               {"move-weight", &Settings::move_weight},
                                               {"meant-weight", &Settings::meant_weight}});
    settings.*field.member = bad;
    synthesizer->set_settings(settings);
    const FrameResult& refused = synthesizer->step(test::standing_pose(), step_time);
    RC_ASSERT(refused.status == StepStatus::Failed);
    RC_ASSERT(refused.message.find(field.key) != std::string::npos);
    RC_ASSERT((refused.result == good));
    synthesizer->set_settings(*preset("paper"));
    RC_ASSERT(synthesizer->step(test::standing_pose(), step_time).status == StepStatus::Ok);
  });
}

TEST(StepProperty, ACountOfStepsOrNeighboursOutOfItsRangeIsRefusedAtOnce) {
  struct Field {
    std::string_view key;
    int Settings::*member;
  };
  for (const Field& field :
       {Field{"neighbours", &Settings::neighbours}, Field{"morph-steps", &Settings::morph_steps},
        Field{"projection-steps", &Settings::projection_steps},
        Field{"continuations", &Settings::continuations}})
    for (const int count : {-1, 1'000'000'000}) {
      Settings settings = *preset("responsive");
      settings.*field.member = count;
      auto synthesizer = std::move(*PartnerSynthesizer::create(libraries()[0], settings));
      const FrameResult& frame = synthesizer->step(test::standing_pose(), Duration(0));
      EXPECT_EQ(frame.status, StepStatus::Failed);
      EXPECT_NE(frame.message.find(field.key), std::string::npos) << frame.message;
      EXPECT_TRUE(frame.result.allFinite());
    }
}

}  // namespace
}  // namespace abrazo::step_property_test
