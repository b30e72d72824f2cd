#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/selection/intent_model.hpp"
#include "core/session/frames/settings_track.hpp"
#include "core/session/run/session_replay.hpp"
#include "core/session/run/solver_control.hpp"
#include "core/synthesis/frames/trace.hpp"
#include "core/synthesis/step/role_views.hpp"
#include "core/synthesis/step/synthesizer_state.hpp"
#include "tests/core/session/recorded_session.hpp"
#include "tests/core/session/refused_memory.hpp"
#include "tests/support/settings.hpp"

namespace abrazo::learned_selection_test {
namespace {

using testing::HasSubstr;

constexpr Duration step_time(1.0 / 60);

constexpr auto by_intent = test::responsive_by_intent;
constexpr auto equation_7 = test::responsive_by_pose;

std::shared_ptr<PartnerSynthesizer> synthesizer_with(const Settings& settings) {
  return std::move(*PartnerSynthesizer::create(test::session_library(), settings));
}

bool becomes_ready(const PartnerSynthesizer& synthesizer, UserRole role = UserRole::Active) {
  for (int i = 0; i < 20000 && !synthesizer.views()->is_intent_ready(role); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return synthesizer.views()->is_intent_ready(role);
}

const Clip& user() {
  static const Clip clip = test::swinging_take("user", 300, 4).a;
  return clip;
}

bool selects_by_intent(const FrameResult& frame) {
  return frame.intent.model && frame.candidates.front().intent;
}

/// Somebody who steers, and the steps between.
struct Steered {
  explicit Steered(const Settings& settings = equation_7()) : control(synthesizer_with(settings)) {}
  const FrameResult& step() {
    changed = control.before_step(static_cast<double>(steps) / 60);
    return control.synthesizer().step(user().poses[steps++ % user().poses.size()], step_time);
  }
  SolverControl control;
  std::size_t steps = 0;
  bool changed = false;
};

TEST(LearnedSelection, EquationSevenSelectsUntilTheLibraryIsLearned) {
  Steered session;
  EXPECT_FALSE(session.control.is_learning());
  session.control.set_settings(by_intent());
  EXPECT_TRUE(session.control.is_learning());
  EXPECT_EQ(session.control.synthesizer().settings().selection, SelectionMethod::Paper);
  EXPECT_FALSE(selects_by_intent(session.control.synthesizer().step(user().poses[0], step_time)));
  ASSERT_TRUE(becomes_ready(session.control.synthesizer()));
  EXPECT_TRUE(selects_by_intent(session.step()));
  EXPECT_TRUE(session.changed) << "the change is told";
  EXPECT_FALSE(session.control.is_learning());
  EXPECT_EQ(session.control.synthesizer().settings(), by_intent());
  session.step();
  EXPECT_FALSE(session.changed);
}

TEST(LearnedSelection, OneThatIsAskedForFromTheStartIsLearnedBesideTheStepsToo) {
  Steered session(by_intent());
  EXPECT_TRUE(session.control.is_learning());
  EXPECT_EQ(session.control.synthesizer().settings().selection, SelectionMethod::Paper);
  ASSERT_TRUE(becomes_ready(session.control.synthesizer()));
  EXPECT_TRUE(selects_by_intent(session.step()));
}

TEST(LearnedSelection, WhatIsSetMeanwhileStays) {
  Steered session;
  session.control.set_settings(by_intent());
  Settings later = by_intent();
  later.neighbours = 7;
  later.leader_weight = 0.75;
  session.control.set_settings(later);
  ASSERT_TRUE(becomes_ready(session.control.synthesizer()));
  session.step();
  EXPECT_EQ(session.control.synthesizer().settings(), later);
}

TEST(LearnedSelection, TakenBackMeanwhileItDoesNotComeAfterAll) {
  Steered session;
  session.control.set_settings(by_intent());
  session.control.set_settings(equation_7());
  EXPECT_FALSE(session.control.is_learning());
  ASSERT_TRUE(becomes_ready(session.control.synthesizer()));
  EXPECT_FALSE(selects_by_intent(session.step()));
  session.control.set_settings(by_intent());
  EXPECT_FALSE(session.control.is_learning()) << "it was learned";
  EXPECT_TRUE(selects_by_intent(session.step()));
}

TEST(LearnedSelection, TheOtherRoleIsLearnedBeforeItIsTaken) {
  Steered session;
  session.control.set_settings(by_intent());
  ASSERT_TRUE(becomes_ready(session.control.synthesizer()));
  session.step();
  ASSERT_TRUE(becomes_ready(session.control.synthesizer(), UserRole::Passive));
  Settings passive = by_intent();
  passive.user_role = UserRole::Passive;
  session.control.set_settings(passive);
  EXPECT_FALSE(session.control.is_learning());
  EXPECT_TRUE(selects_by_intent(session.step()));
  EXPECT_EQ(session.control.synthesizer().settings(), passive);
}

TEST(LearnedSelection, ARoleThatIsTakenAtOnceIsWaitedForBesideTheSteps) {
  Settings passive = by_intent();
  passive.user_role = UserRole::Passive;
  Steered session;
  session.control.set_settings(passive);
  EXPECT_TRUE(session.control.is_learning());
  EXPECT_EQ(session.control.synthesizer().settings().user_role, UserRole::Passive)
      << "the role is not held up";
  ASSERT_TRUE(becomes_ready(session.control.synthesizer(), UserRole::Passive));
  EXPECT_TRUE(selects_by_intent(session.step()));
}

TEST(LearnedSelection, AnotherLibraryIsLearnedAnew) {
  Steered session;
  session.control.set_settings(by_intent());
  ASSERT_TRUE(becomes_ready(session.control.synthesizer()));
  EXPECT_TRUE(selects_by_intent(session.step()));
  const std::shared_ptr<PartnerSynthesizer> other =
      std::move(*PartnerSynthesizer::create(test::small_library(), *preset("paper")));
  session.control.replace(other);
  EXPECT_TRUE(session.control.is_learning());
  EXPECT_FALSE(selects_by_intent(other->step(user().poses[2], step_time)));
  ASSERT_TRUE(becomes_ready(*other));
  EXPECT_TRUE(selects_by_intent(session.step()));
  EXPECT_EQ(other->settings(), by_intent());
}

/// The partner stood still for seconds after a connection whose library had labelled takes.
TEST(LearnedSelection, ALibraryThatIsStillLearnedIsLeftWithoutWaitingForThat) {
  Steered session;
  session.step();
  const std::shared_ptr<PartnerSynthesizer> other =
      std::move(*PartnerSynthesizer::create(test::small_library(), *preset("paper")));
  const std::weak_ptr<const RoleViews> left = session.control.synthesizer().views();
  test::hold_back_memory(20'000);  // it does not end before it gets them
  session.control.set_settings(by_intent());
  session.control.replace(other);
  EXPECT_FALSE(left.expired()) << "it is still learned";
  test::give_memory_again();
  ASSERT_TRUE(becomes_ready(*other));
  EXPECT_TRUE(selects_by_intent(session.step()));
}

TEST(LearnedSelection, ThatCannotBeLearnedSaysWhyOnceAndEquationSevenStays) {
  Steered session;
  session.step();
  test::refuse_memory(20'000);  // no step takes so much at once
  session.control.set_settings(by_intent());
  std::string said;
  for (int i = 0; i < 20000 && said.empty(); ++i) try {
      EXPECT_FALSE(selects_by_intent(session.step()));
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    } catch (const std::exception& failure) {
      said = failure.what();
    }
  test::give_memory_again();
  EXPECT_THAT(said, HasSubstr("Eq. 7 continues to select"));
  EXPECT_THAT(said, HasSubstr("not enough memory"));
  EXPECT_FALSE(session.control.is_learning());
  for (int frame = 0; frame < 5; ++frame) EXPECT_FALSE(selects_by_intent(session.step()));
  Settings other = by_intent();
  other.neighbours = 7;
  session.control.set_settings(other);
  EXPECT_FALSE(session.control.is_learning()) << "another setting asks for nothing new";
  EXPECT_EQ(session.control.synthesizer().settings().neighbours, 7);
  session.control.set_settings(equation_7());
  session.control.set_settings(by_intent());
  EXPECT_TRUE(session.control.is_learning()) << "asked for again it is tried again";
  ASSERT_TRUE(becomes_ready(session.control.synthesizer()));
  EXPECT_TRUE(selects_by_intent(session.step()));
}

TEST(ARoleThereIsNoMemoryFor, IsNotTakenAndStepsGoOn) {
  const auto synthesizer = std::move(
      *PartnerSynthesizer::create(std::make_shared<MotionLibrary>(*test::session_library()), equation_7()));
  synthesizer->step(user().poses[0], step_time);
  Settings passive = equation_7();
  passive.user_role = UserRole::Passive;
  passive.neighbours = 7;
  test::refuse_memory(20'000);  // no step takes so much at once; a library with its roles exchanged does
  EXPECT_THROW(synthesizer->set_settings(passive), std::bad_alloc);
  EXPECT_EQ(synthesizer->settings(), equation_7());
  StepStatus status = StepStatus::Failed;
  EXPECT_NO_THROW(status = synthesizer->step(user().poses[1], step_time).status);
  SynthesizerState state = synthesizer->state();
  state.user_role = UserRole::Passive;
  EXPECT_THROW(synthesizer->restore(state), std::bad_alloc);
  EXPECT_THROW(synthesizer->take_over(state), std::bad_alloc);
  EXPECT_NO_THROW(synthesizer->step(user().poses[2], step_time));
  test::give_memory_again();
  EXPECT_EQ(status, StepStatus::Ok);
  synthesizer->set_settings(passive);
  EXPECT_EQ(synthesizer->step(user().poses[3], step_time).status, StepStatus::Ok);
}

TEST(LearnedSelection, WhatIsSteeredMeanwhileHoldsThoughLearningFailed) {
  Steered session;
  session.step();
  session.control.set_vetoes({{}, {"first"}, {}});
  test::refuse_memory(20'000);
  session.control.set_settings(by_intent());
  std::string said;
  for (int i = 0; i < 20000 && said.empty(); ++i) try {
      session.step();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    } catch (const std::exception& failure) {
      said = failure.what();
    }
  test::give_memory_again();
  ASSERT_THAT(said, HasSubstr("learning the library failed"));
  const FrameResult& result = session.step();
  const int pair = result.candidates.at(static_cast<std::size_t>(result.selected)).pair;
  EXPECT_NE(test::session_library()->take_of(pair).name, "first");
}

TEST(LearnedSelection, AMoveThatIsNotFollowedIsStillIntended) {
  Steered session(by_intent());
  ASSERT_TRUE(becomes_ready(session.control.synthesizer()));
  Settings settings = by_intent();
  settings.meant_weight = 0;  // nobody goes after what is named
  session.control.set_settings(settings);
  const MotionLibrary& library = session.control.synthesizer().library();
  const auto label_of = [&](const FrameResult& result) {
    return std::string(library.label(result.candidates.at(static_cast<std::size_t>(result.selected)).pair));
  };
  const std::string followed = label_of(session.step());
  std::string other;
  for (int pair = 0; pair < library.pair_count() && (other.empty() || other == followed); ++pair)
    other = library.label(pair);
  ASSERT_NE(other, followed);
  IntendedMove move{other, std::nullopt};
  move.until_done = true;
  session.control.intend(move);
  int steps = 0;
  for (; steps < 20; ++steps) {
    const FrameResult& result = session.step();
    ASSERT_TRUE(session.control.decisions()) << "taken back after " << steps << " steps";
    if (label_of(result) == other) break;
    session.control.after_step(result, user().poses[0], steps / 60.0);
  }
  EXPECT_GT(steps, 2);
}

/// A session that is recorded: Eq. 7, then by intent while it learns and afterwards, a passive user, Eq. 7
/// again.
struct RecordedSession : test::TemporaryFolder, test::DrivenSession {
  RecordedSession() : path(file("s.abrazo")) {
    loop = std::make_unique<LiveLoop>(synthesizer, std::make_unique<ClipSource>(user()), commands, history,
                                      latest);
    keeper->recorder = *Recorder::open(path, test::session_facts());
    run_until(0.3);
    commands.push(SetSettings{by_intent()});
    run_until(0.35);
    EXPECT_TRUE(becomes_ready(*synthesizer));
    run_until(1.2);
    commands.push(SetVetoes{{{}, {"first"}, {}}});
    run_until(1.5);
    commands.push(IntendMove{IntendedMove{"turn", std::nullopt}});
    Settings settings = by_intent();
    settings.user_role = UserRole::Passive;
    settings.switch_margin = 0.07;
    commands.push(SetSettings{settings});
    run_until(1.6);
    EXPECT_TRUE(becomes_ready(*synthesizer, UserRole::Passive));
    run_until(2.4);
    commands.push(SetSettings{equation_7()});
    run_until(2.6);
    commands.push(SetSettings{by_intent()});
    run_until(3.2);
    EXPECT_TRUE(keeper->recorder->finish());
  }
  std::shared_ptr<PartnerSynthesizer> synthesizer = synthesizer_with(equation_7());
  std::string path;
};

std::string trace_line(const FrameSnapshot& frame) {
  FrameResult timeless = frame.result;
  timeless.timing = {};
  return trace_frame_line(timeless, *test::session_library(), frame.input_frame, frame.time_s);
}

TEST(LearnedSelection, FramesSayThatTheLibraryIsStillLearned) {
  const RecordedSession session;
  int learning = 0, selected_by_intent = 0;
  for (const FrameSnapshotPtr& frame : session.keeper->frames) {
    const bool reads_intent = frame->settings.selection == SelectionMethod::Intent;
    EXPECT_EQ(selects_by_intent(frame->result), reads_intent) << frame->index;
    EXPECT_FALSE(reads_intent && frame->is_learning) << frame->index;
    if (frame->time_s < 0.3 || (frame->time_s > 2.42 && frame->time_s < 2.6)) {
      EXPECT_FALSE(frame->is_learning) << "Eq. 7 was asked for";
    }
    learning += frame->is_learning;
    selected_by_intent += reads_intent;
  }
  EXPECT_GT(learning, 0);
  EXPECT_GT(selected_by_intent, 100);
}

/// The tick of the timeline says why the method changed, also after the session was closed and opened.
TEST(LearnedSelection, ARecordingKnowsWhichFramesWereSolvedWhileTheLibraryWasLearned) {
  const RecordedSession session;
  const auto file = SessionFile::open(session.path);
  ASSERT_TRUE(file) << file.error().text();
  std::size_t next = 0;
  SettingsTrack live, reopened;
  const auto pass = (*file)->each_frame(-1e9, 1e9, [&](const FrameSnapshot& read) -> Status {
    const FrameSnapshot& solved = *session.keeper->frames.at(next++);
    EXPECT_EQ(read.is_learning, solved.is_learning) << solved.index;
    live.append(solved);
    reopened.append(read);
    return Done{};
  });
  ASSERT_TRUE(pass);
  ASSERT_EQ(live.changes().size(), reopened.changes().size());
  int with_reason = 0;
  for (std::size_t c = 0; c < live.changes().size(); ++c) {
    EXPECT_EQ(reopened.changes()[c].text, live.changes()[c].text);
    with_reason += !reopened.changes()[c].reason.empty();
  }
  EXPECT_GT(with_reason, 0);
}

TEST(LearnedSelection, TheTermsOfEveryCandidateAreRecordedWithTheSameBits) {
  const RecordedSession session;
  const auto file = SessionFile::open(session.path);
  ASSERT_TRUE(file) << file.error().text();
  std::size_t next = 0, with_terms = 0;
  const auto pass = (*file)->each_frame(-1e9, 1e9, [&](const FrameSnapshot& read) -> Status {
    const FrameResult& solved = session.keeper->frames.at(next++)->result;
    EXPECT_EQ(read.settings, session.keeper->frames[next - 1]->settings);
    EXPECT_EQ(read.result.candidates.size(), solved.candidates.size());
    for (std::size_t c = 0; c < solved.candidates.size(); ++c) {
      const Candidate &a = read.result.candidates.at(c), &b = solved.candidates[c];
      EXPECT_EQ(a.pair, b.pair);
      EXPECT_EQ(a.continuation, b.continuation);
      EXPECT_EQ(a.cost.total, b.cost.total);
      EXPECT_EQ(a.intent.has_value(), b.intent.has_value());
      if (!a.intent || !b.intent) continue;
      ++with_terms;
      EXPECT_EQ(a.intent->partner, b.intent->partner);
      EXPECT_EQ(a.intent->leader, b.intent->leader);
      EXPECT_EQ(a.intent->move, b.intent->move);
      EXPECT_EQ(a.intent->meant, b.intent->meant);
      EXPECT_EQ(a.intent->change, b.intent->change);
      EXPECT_EQ(a.intent->total, b.intent->total);
    }
    return Done{};
  });
  ASSERT_TRUE(pass);
  EXPECT_EQ(pass->damaged, 0U) << pass->damage;
  EXPECT_EQ(next, session.keeper->frames.size());
  EXPECT_GT(with_terms, 500U);
}

TEST(LearnedSelection, ASessionIsSolvedAgainToTheSameBits) {
  const RecordedSession session;
  const auto file = SessionFile::open(session.path);
  ASSERT_TRUE(file) << file.error().text();
  for (const auto& [from_s, to_s] : {std::pair{-1e9, 1e9}, std::pair{0.9, 2.0}, std::pair{2.8, 3.1}}) {
    std::size_t frames = 0;
    const auto replay = re_solve_session(
        **file, test::session_library(), from_s, to_s, [&](const FrameSnapshot& frame) -> Status {
          const FrameSnapshot& recorded = *session.keeper->frames.at(frame.index);
          EXPECT_EQ(trace_line(frame), trace_line(recorded)) << "frame " << frame.index;
          EXPECT_EQ(frame.result.intent.belief, recorded.result.intent.belief);
          ++frames;
          return Done{};
        });
    ASSERT_TRUE(replay) << replay.error().text();
    EXPECT_EQ(replay->differ, 0U);
    EXPECT_GT(frames, 15U);
  }
}

}  // namespace
}  // namespace abrazo::learned_selection_test
