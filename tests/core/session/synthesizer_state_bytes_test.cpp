#include "core/session/file/synthesizer_state_bytes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>

#include "core/session/file/decisions_json.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"
#include "tests/core/session/recorded_session.hpp"

namespace abrazo::synthesizer_state_bytes_test {
namespace {

/// A state in the middle of a session: locks, a transition, a heading.
SynthesizerState used_state() {
  auto synthesizer = std::move(*PartnerSynthesizer::create(test::session_library(), *preset("responsive")));
  synthesizer->set_vetoes({{3, 7}, {"nobody"}, {"turn", ""}});
  const Clip clip = test::swinging_take("user", 90, 4).a;
  for (const Pose& pose : clip.poses) synthesizer->step(pose, Duration(1.0 / 60));
  SynthesizerState state = synthesizer->state();
  state.pinned = 12;
  state.meant = IntendedPairs{"turn", std::nullopt};
  state.unsolved_s = 0.1 + 0.2;
  return state;
}

TEST(SynthesizerStateBytes, ReadBackToTheSameBits) {
  const SynthesizerState state = used_state();
  const auto bytes = synthesizer_state_bytes(state);
  const auto read = parse_synthesizer_state(bytes);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(synthesizer_state_bytes(*read), bytes);
  EXPECT_EQ(read->memory.previous, state.memory.previous);
  EXPECT_EQ(read->memory.previous_heading, state.memory.previous_heading);
  EXPECT_EQ(read->memory.motion.playhead, state.memory.motion.playhead);
  EXPECT_EQ(read->memory.motion.adaptation.offset(), state.memory.motion.adaptation.offset());
  for (const std::size_t hand : {0U, 1U}) {
    EXPECT_TRUE(state.memory.motion.holds.user_hands()[hand].is_seen);
    EXPECT_TRUE(read->memory.motion.holds.user_hands()[hand].is_seen);
  }
  EXPECT_EQ(read->memory.locks.feet()[0].ankle, state.memory.locks.feet()[0].ankle);
  EXPECT_EQ(read->memory.user.body()->bone_lengths, state.memory.user.body()->bone_lengths);
  EXPECT_EQ(*read->vetoes, *state.vetoes);
  EXPECT_EQ(read->meant, state.meant);
  EXPECT_EQ(read->pinned, 12);
  EXPECT_EQ(read->unsolved_s, 0.1 + 0.2);
}

TEST(SynthesizerStateBytes, ASolverGoesOnFromThemAsIfNothingHadBeen) {
  auto first = std::move(*PartnerSynthesizer::create(test::session_library(), *preset("responsive")));
  auto second = std::move(*PartnerSynthesizer::create(test::session_library(), *preset("responsive")));
  const Clip clip = test::swinging_take("user", 120, 4).a;
  for (int i = 0; i < 60; ++i) first->step(clip.poses[static_cast<std::size_t>(i)], Duration(1.0 / 60));
  second->restore(*parse_synthesizer_state(synthesizer_state_bytes(first->state())));
  for (std::size_t i = 60; i < 120; ++i) {
    const PairPose expected = first->step(clip.poses[i], Duration(1.0 / 60)).result;
    ASSERT_EQ(second->step(clip.poses[i], Duration(1.0 / 60)).result, expected) << i;
  }
}

/// Where the number of kept poses is: what is before it does not depend on the history.
std::size_t place_of_history(const SynthesizerState& state) {
  SynthesizerState without = state;
  without.memory.history.clear();
  const auto bytes = synthesizer_state_bytes(state), shorter = synthesizer_state_bytes(without);
  return static_cast<std::size_t>(std::mismatch(shorter.begin(), shorter.end(), bytes.begin()).first -
                                  shorter.begin());
}

TEST(SynthesizerStateBytes, HoldTheUsersLastTwoSeconds) {
  const SynthesizerState state = used_state();
  const MotionHistory& history = state.memory.history;
  ASSERT_GT(history.size(), 40U);
  const auto read = parse_synthesizer_state(synthesizer_state_bytes(state));
  ASSERT_TRUE(read) << read.error().text();
  ASSERT_EQ(read->memory.history.size(), history.size());
  for (const double lag_s : {0.0, 0.1, 1.0, 2.0}) {
    MotionHistory::Sample written, back;
    history.sample(lag_s, written);
    read->memory.history.sample(lag_s, back);
    EXPECT_EQ(back, written) << lag_s;
  }
}

TEST(SynthesizerStateBytes, ASolverThatShowsOtherBodiesGoesOnFromThem) {
  Settings settings = *preset("responsive");
  settings.active_body = {.kind = BodyChoice::Kind::Scaled, .scale = 1.2};
  auto first = std::move(*PartnerSynthesizer::create(test::session_library(), settings));
  auto second = std::move(*PartnerSynthesizer::create(test::session_library(), settings));
  const Clip clip = test::swinging_take("user", 120, 4).a;
  for (int i = 0; i < 60; ++i) first->step(clip.poses[static_cast<std::size_t>(i)], Duration(1.0 / 60));
  const auto bytes = synthesizer_state_bytes(first->state());
  const auto read = parse_synthesizer_state(bytes);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_TRUE(read->memory.shown.is_fitted);
  EXPECT_EQ(synthesizer_state_bytes(*read), bytes);
  second->restore(*read);
  for (std::size_t i = 60; i < 120; ++i) {
    const PairPose expected = first->step(clip.poses[i], Duration(1.0 / 60)).result;
    ASSERT_EQ(second->step(clip.poses[i], Duration(1.0 / 60)).result, expected) << i;
  }
}

TEST(SynthesizerStateBytes, ADamagedHistoryIsRefused) {
  const SynthesizerState state = used_state();
  const auto bytes = synthesizer_state_bytes(state);
  const std::size_t history = place_of_history(state);
  constexpr std::size_t frames = 1 + 7 * sizeof(double);  // number of poses, origin, root, heading
  const auto with = [&](std::size_t at, std::initializer_list<std::uint8_t> written) {
    auto damaged = bytes;
    std::copy(written.begin(), written.end(), damaged.begin() + static_cast<std::ptrdiff_t>(history + at));
    return parse_synthesizer_state(damaged);
  };
  ASSERT_TRUE(with(0, {static_cast<std::uint8_t>(state.memory.history.size())}));
  for (const auto& [what, read] :
       {std::pair{"more poses than there can be", with(0, {0xff})},
        std::pair{"an origin that is no place", with(1, {0, 0, 0, 0, 0, 0, 0xf0, 0x7f})},
        std::pair{"time that runs backwards", with(frames, {0, 0, 0x80, 0xbf})},
        std::pair{"a joint nowhere", with(frames + 4, {0, 0, 0xc0, 0x7f})},
        std::pair{"a joint at infinity", with(frames + 304 * 20 + 60, {0, 0, 0x80, 0x7f})}}) {
    ASSERT_FALSE(read) << what;
    EXPECT_THAT(read.error().message, testing::HasSubstr("last two seconds")) << what;
  }
}

TEST(SynthesizerStateBytes, ThatAreCutShortTooLongOrOfAnotherVersionAreRefused) {
  const auto bytes = synthesizer_state_bytes(used_state());
  for (std::size_t size = 0; size < bytes.size(); size += 23)
    EXPECT_FALSE(parse_synthesizer_state(std::span(bytes).first(size))) << size;
  auto longer = bytes;
  longer.push_back(0);
  EXPECT_FALSE(parse_synthesizer_state(longer));
  auto newer = bytes;
  newer[0] = 99;
  EXPECT_THAT(parse_synthesizer_state(newer).error().message, testing::HasSubstr("version 99"));
}

TEST(SynthesizerStateBytes, ImpossibleCountsEndWithTheBytes) {
  auto bytes = synthesizer_state_bytes(used_state());
  const std::size_t history = place_of_history(used_state());
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    if (at > history + 400 && at + 1500 < bytes.size()) continue;  // one pose after the other
    auto changed = bytes;
    changed[at] = 0xff;
    (void)parse_synthesizer_state(changed);  // neither crashes nor takes all the memory
  }
}

TEST(DecisionsJson, ReadsBackWhatWasDecided) {
  Decisions decisions;
  decisions.pinned = 7;
  decisions.vetoes = {{1, 2}, {"a \"take\""}, {"", "turn"}};
  decisions.meant = IntendedMove{"turn", "salsa_01", 12.5, true};
  decisions.role_control = RoleControl::Leader;
  const auto read = parse_decisions(decisions_json(decisions), "test");
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, decisions);
  EXPECT_EQ(*parse_decisions(decisions_json({}), "test"), Decisions{});
  EXPECT_FALSE(parse_decisions("[]", "test"));
  EXPECT_FALSE(parse_decisions("{\"role_control\":\"dice\"}", "test"));
}

}  // namespace
}  // namespace abrazo::synthesizer_state_bytes_test
