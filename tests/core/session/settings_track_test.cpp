#include "core/session/frames/settings_track.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/session/run/live_loop.hpp"
#include "core/stream/receive/clip_source.hpp"
#include "tests/support/libraries.hpp"
#include "tests/support/settings.hpp"

namespace abrazo::settings_track_test {
namespace {

using testing::ElementsAre;

/// Frames at 10 Hz, each with the settings of its number.
FrameSnapshot frame(std::uint64_t index, const Settings& settings) {
  FrameSnapshot snapshot;
  snapshot.index = index;
  snapshot.time_s = 0.1 * static_cast<double>(index);
  snapshot.settings = settings;
  return snapshot;
}

Settings with_alpha(double alpha) {
  Settings settings = *preset("paper");
  settings.alpha = alpha;
  return settings;
}

SettingsTrack track_of(const std::vector<double>& alphas) {
  SettingsTrack track;
  for (std::size_t i = 0; i < alphas.size(); ++i) track.append(frame(i, with_alpha(alphas[i])));
  return track;
}

TEST(SettingsTrack, KnowsNothingBeforeTheFirstFrame) {
  const SettingsTrack track;
  EXPECT_TRUE(track.empty());
  EXPECT_EQ(track.at(0), nullptr);
  EXPECT_EQ(track.at_frame(0), nullptr);
  EXPECT_TRUE(track.changes().empty());
}

TEST(SettingsTrack, AFrameUnderOtherSettingsThanTheOneBeforeIsAChange) {
  const SettingsTrack track = track_of({0.5, 0.5, 0.3, 0.3, 1});
  ASSERT_EQ(track.changes().size(), 2U);
  const SettingsChange& first = track.changes()[0];
  EXPECT_EQ(first.frame, 2U);
  EXPECT_DOUBLE_EQ(first.time_s, 0.2);
  EXPECT_EQ(first.before, with_alpha(0.5));
  EXPECT_EQ(first.after, with_alpha(0.3));
  EXPECT_EQ(first.text, "\u03b1 0.5 \u2192 0.3");
  EXPECT_EQ(track.changes()[1].text, "\u03b1 0.3 \u2192 1");
}

/// A new session began with "method paper → intent", which nobody had asked for.
TEST(SettingsTrack, SaysWhyTheMethodChangesWhenTheLibraryWasLearned) {
  Settings by_pose = *preset("responsive"), by_intent = by_pose;
  by_pose.selection = SelectionMethod::Paper;
  SettingsTrack track;
  const auto show = [&track](std::uint64_t index, const Settings& settings, bool is_learning) {
    FrameSnapshot next = frame(index, settings);
    next.is_learning = is_learning;
    track.append(next);
  };
  show(0, by_pose, true);
  show(1, by_intent, false);
  show(20, by_pose, true);  // as for the other role
  show(40, by_pose, false);
  show(41, by_intent, false);
  ASSERT_EQ(track.changes().size(), 3U);
  EXPECT_EQ(track.changes()[0].text, "the library was learned: method paper \u2192 intent");
  EXPECT_EQ(track.changes()[1].text, "the library is being learned: method intent \u2192 paper");
  EXPECT_EQ(track.changes()[2].text, "method paper \u2192 intent") << "asked for";
  for (const SettingsChange& change : track.merged(0))
    EXPECT_EQ(change.reason.empty(), change.frame == 41) << change.text;
}

TEST(SettingsTrack, GivesTheSettingsOfAnyFrame) {
  const std::vector<double> alphas = {0.5, 0.5, 0.3, 0.3, 1};
  const SettingsTrack track = track_of(alphas);
  for (std::size_t i = 0; i < alphas.size(); ++i) {
    EXPECT_EQ(*track.at_frame(i), with_alpha(alphas[i])) << i;
    EXPECT_EQ(*track.at(0.1 * static_cast<double>(i)), with_alpha(alphas[i])) << i;
    EXPECT_EQ(*track.at(0.1 * static_cast<double>(i) + 0.05), with_alpha(alphas[i])) << i;
  }
  EXPECT_EQ(*track.at(-1), with_alpha(0.5));
}

TEST(SettingsTrack, FramesThatWereSeenBeforeCountOnce) {
  SettingsTrack track = track_of({0.5, 0.3});
  track.append(frame(0, with_alpha(0.5)));
  track.append(frame(1, with_alpha(0.3)));
  EXPECT_EQ(track.changes().size(), 1U);
}

TEST(SettingsTrack, WhatIsGivenUpStillTellsTheSettingsOfTheOldestFrame) {
  SettingsTrack track = track_of({0.5, 0.3, 0.2, 0.1});
  track.evict_before(0.25);
  ASSERT_EQ(track.changes().size(), 1U);
  EXPECT_EQ(*track.at(0.25), with_alpha(0.2));
  EXPECT_EQ(*track.at_frame(2), with_alpha(0.2));
  EXPECT_EQ(*track.at_frame(3), with_alpha(0.1));
  track.clear();
  EXPECT_TRUE(track.empty());
}

TEST(SettingsTrack, ADragIsOneChangeInTheLane) {
  SettingsTrack track = track_of({0.5, 0.45, 0.5, 0.35, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.9});
  const auto merged = track.merged(0.35);
  ASSERT_EQ(merged.size(), 2U);
  EXPECT_EQ(merged[0].text, "\u03b1 0.5 \u2192 0.3");
  EXPECT_DOUBLE_EQ(merged[0].time_s, 0.1);
  EXPECT_DOUBLE_EQ(merged[0].until_s, 0.4);
  EXPECT_EQ(merged[1].text, "\u03b1 0.3 \u2192 0.9");
  Settings other = with_alpha(0.9);
  other.morph_steps = 7;
  track.append(frame(12, other));
  EXPECT_EQ(track.merged(0.35).size(), 3U) << "another setting is another change";
}

TEST(SettingsTrack, ADragThatEndsWhereItBeganLeavesNoMarkInTheLane) {
  EXPECT_TRUE(track_of({0.5, 0.6, 0.7, 0.5}).merged(0.5).empty());
}

TEST(ChangeText, NamesSymbolsUnitsAndPresets) {
  const Settings paper = *preset("paper");
  Settings settings = paper;
  settings.foot_lock_speed = 0.3;
  EXPECT_EQ(change_text(paper, settings), "planted below 0 \u2192 0.3 m/s");
  settings.collisions = false;
  EXPECT_EQ(change_text(paper, settings), "planted below 0 \u2192 0.3 m/s, collisions on \u2192 off");
  EXPECT_THAT(changed_settings(paper, settings), ElementsAre("foot-lock-speed", "collisions"));
  EXPECT_EQ(change_text(paper, *preset("responsive")), "preset responsive");
  settings = paper;
  settings.step_rate_hz = 0;
  EXPECT_EQ(change_text(paper, settings), "step rate 15 Hz \u2192 the input's");
  EXPECT_EQ(change_text(settings, paper), "step rate the input's \u2192 15 Hz");
  EXPECT_EQ(change_text(paper, paper), "");
}

struct Session {
  Clip user = test::swinging_take("user", 120, 4).a;
  CommandQueue commands;
  FrameHistory history;
  LatestSlot<FrameSnapshot> latest;
  SettingsTrack track;

  std::unique_ptr<PartnerSynthesizer> synthesizer(const Settings& settings) const {
    return std::move(*PartnerSynthesizer::create(test::small_library(), settings));
  }

  /// Runs as a session does, with these settings from these times on.
  void run(const std::vector<std::pair<double, Settings>>& asked, double until_s) {
    LiveLoop loop(synthesizer(asked.front().second), std::make_unique<ClipSource>(user), commands, history,
                  latest);
    std::size_t next = 1;
    for (double now_s = 0; now_s < until_s;) {
      for (; next < asked.size() && asked[next].first <= now_s; ++next)
        commands.push(SetSettings{asked[next].second});
      now_s = std::max(loop.turn(now_s), now_s + 1e-6);
    }
    track.append(history.since(0));
  }
};

TEST(SettingsTrack, WithTheInputsSolvesASessionAgainToTheBit) {
  Session session;
  Settings changed = test::responsive_by_pose();
  changed.alpha = 0.8;
  Settings slower = *preset("paper");
  slower.step_rate_hz = 30;
  slower.foot_locks = false;
  session.run(
      {{0, test::responsive_by_pose()}, {0.4, changed}, {0.9, slower}, {1.3, test::responsive_by_pose()}},
      1.9);
  const auto frames = session.history.since(0);
  ASSERT_GT(frames.size(), 80U);
  ASSERT_EQ(session.track.changes().size(), 3U);

  const auto again = session.synthesizer(*session.track.at_frame(0));
  if (const auto body = ClipSource(session.user).body()) again->set_user_body(*body);
  double previous_s = frames.front()->time_s;
  for (const FrameSnapshotPtr& frame : frames) {
    again->set_settings(*session.track.at_frame(frame->index));
    const FrameResult& result = again->step(frame->user, Duration(frame->time_s - previous_s));
    previous_s = frame->time_s;
    ASSERT_EQ(result.result, frame->result.result) << frame->index;
    ASSERT_EQ(result.selected, frame->result.selected) << frame->index;
    ASSERT_EQ(result.candidates.size(), frame->result.candidates.size()) << frame->index;
  }
}

}  // namespace
}  // namespace abrazo::settings_track_test
