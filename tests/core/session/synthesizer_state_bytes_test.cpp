#include "core/session/file/synthesizer_state_bytes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <functional>

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

/// The first byte that a change of the state changes.
std::ptrdiff_t place_of(const SynthesizerState& state, const std::function<void(SynthesizerState&)>& change) {
  SynthesizerState changed = state;
  change(changed);
  const auto bytes = synthesizer_state_bytes(state), others = synthesizer_state_bytes(changed);
  return std::mismatch(bytes.begin(), bytes.end(), others.begin()).first - bytes.begin();
}

// Bytes in a state: the desired place with a flag and its speed follow the recorded speed.
constexpr std::ptrdiff_t desired = 1 + 6 * sizeof(double);
constexpr std::ptrdiff_t recorded_speed = 3 * sizeof(double) + desired;

/// The first byte of the recorded speed.
std::ptrdiff_t place_of_recorded_speed(const SynthesizerState& state) {
  return place_of(state, [](auto& s) {
    PartnerPlace& place = s.memory.motion.place;
    Vec3 other = place.recorded_speed();
    other.x() = std::bit_cast<double>(~std::bit_cast<std::uint64_t>(other.x()));
    place = PartnerPlace(place.at(), place.speed(), place.turning(), other, place.desired(),
                         place.desired_speed());
  });
}

TEST(SynthesizerStateBytes, OfTheVersionWithoutADesiredPlaceHaveAllElse) {
  const SynthesizerState state = used_state();
  ASSERT_TRUE(state.memory.motion.place.desired());
  ASSERT_GT(state.memory.motion.place.desired_speed().norm(), 0);
  auto old = synthesizer_state_bytes(state);
  const auto end = old.begin() + place_of_recorded_speed(state) + recorded_speed;
  old.erase(end - desired, end);
  old[0] = 7;
  const auto read = parse_synthesizer_state(old);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_FALSE(read->memory.motion.place.desired());
  EXPECT_EQ(read->memory.motion.place.desired_speed(), Vec3::Zero());
  EXPECT_EQ(read->memory.motion.place.recorded_speed(), state.memory.motion.place.recorded_speed());
  EXPECT_EQ(read->memory.motion.since_change_s, state.memory.motion.since_change_s);
  EXPECT_EQ(read->pinned, 12);
}

/// As written before the recorded speed of the partner's place was filtered.
std::vector<std::uint8_t> bytes_without_recorded_speed(const SynthesizerState& state) {
  const auto begin = place_of_recorded_speed(state);
  auto bytes = synthesizer_state_bytes(state);
  bytes.erase(bytes.begin() + begin, bytes.begin() + begin + recorded_speed);
  return bytes;
}

TEST(SynthesizerStateBytes, OfTheVersionWithoutARecordedSpeedAreCarriedOnAtTheirOwn) {
  const SynthesizerState state = used_state();
  ASSERT_GT(state.memory.motion.place.recorded_speed().norm(), 0);
  auto old = bytes_without_recorded_speed(state);
  old[0] = 6;
  const auto read = parse_synthesizer_state(old);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->memory.motion.place.recorded_speed(), state.memory.motion.place.speed());
  EXPECT_EQ(read->memory.motion.place.turning(), state.memory.motion.place.turning());
  EXPECT_EQ(read->memory.motion.since_change_s, state.memory.motion.since_change_s);
  EXPECT_EQ(read->pinned, 12);
}

/// As written while bodies were always the library's.
std::vector<std::uint8_t> bytes_without_bodies(const SynthesizerState& state) {
  const auto begin = place_of(state, [](auto& s) {
    double& length = s.memory.shown.bodies[0].from.bone_lengths[0];
    length = std::bit_cast<double>(~std::bit_cast<std::uint64_t>(length));
  });
  constexpr std::ptrdiff_t body = (bone_count + pseudo_bones.size() + 1) * sizeof(double);
  constexpr std::ptrdiff_t gliding = 2 * body + sizeof(double) + 2;
  auto bytes = bytes_without_recorded_speed(state);
  bytes.erase(bytes.begin() + begin - recorded_speed,
              bytes.begin() + begin - recorded_speed + 2 * gliding + 1);
  return bytes;
}

TEST(SynthesizerStateBytes, OfTheVersionBeforeBodiesCouldBeChosenHaveTheLibrarys) {
  const SynthesizerState state = used_state();
  auto old = bytes_without_bodies(state);
  old[0] = 5;
  const auto read = parse_synthesizer_state(old);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_FALSE(read->memory.shown.is_fitted);
  EXPECT_EQ(read->memory.previous, state.memory.previous);
  EXPECT_EQ(read->pinned, 12);
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

TEST(SynthesizerStateBytes, OfTheVersionBeforeThePartnerHadAMotionAreReadWithoutOne) {
  const SynthesizerState state = used_state();
  const auto begin = place_of(state, [](auto& s) { s.memory.motion.playhead.pair ^= 1; });
  const auto end = place_of(state, [](auto& s) { s.memory.partner_is_shown ^= true; });
  const auto measured = place_of(state, [](auto& s) {
    s.memory.user = UserMeasure(s.memory.user.body(), !s.memory.user.is_given(), s.memory.user.seen_s(),
                                s.memory.user.seen());
  });
  auto old = bytes_without_bodies(state);
  old.erase(old.begin() + measured - recorded_speed,
            old.begin() + measured - recorded_speed + 13);  // given, seconds, poses
  old.erase(old.begin() + begin, old.begin() + end - recorded_speed + 1);
  old.insert(old.begin() + begin, 2 * sizeof(Pose), 0);
  old[0] = 2;
  const auto read = parse_synthesizer_state(old);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->memory.motion.playhead.pair, -1);
  EXPECT_TRUE(read->memory.partner_is_shown);
  EXPECT_EQ(read->memory.previous, state.memory.previous);
  EXPECT_EQ(read->memory.history.size(), state.memory.history.size());
  auto solver = std::move(*PartnerSynthesizer::create(test::session_library(), *preset("responsive")));
  solver->restore(*read);
  EXPECT_NE(solver->step(test::swinging_take("user", 2, 4).a.poses[0], Duration(1.0 / 60)).status,
            StepStatus::Failed);
}

TEST(SynthesizerStateBytes, OfTheVersionWhosePlaceWasTheRootsGoOnFromWhatIsShown) {
  const SynthesizerState state = used_state();
  const auto begin = place_of(state, [](auto& s) { s.memory.motion.playhead.pair ^= 1; });
  const auto end = place_of(state, [](auto& s) { s.memory.partner_is_shown ^= true; });
  auto old = bytes_without_bodies(state);
  old.erase(old.begin() + begin, old.begin() + end - recorded_speed);
  // Two more poses of the adaptation; no lead of the feet and its speed, pace of holds and steady hands.
  const auto size = static_cast<std::size_t>(end - recorded_speed - begin) + 2 * sizeof(Pose) -
                    (4 * 3 + 4 + 2 * 9) * sizeof(double) - 2;
  old.insert(old.begin() + begin, size, 0);
  old[0] = 3;
  const auto read = parse_synthesizer_state(old);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->memory.motion.playhead.pair, -1);
  EXPECT_EQ(read->memory.partner_is_shown, state.memory.partner_is_shown);
  EXPECT_EQ(read->memory.user.seen(), state.memory.user.seen());
  EXPECT_EQ(read->unsolved_s, state.unsolved_s);
  auto solver = std::move(*PartnerSynthesizer::create(test::session_library(), *preset("responsive")));
  solver->restore(*read);
  EXPECT_NE(solver->step(test::swinging_take("user", 2, 4).a.poses[0], Duration(1.0 / 60)).status,
            StepStatus::Failed);
}

TEST(SynthesizerStateBytes, OfTheVersionWithoutSteadyHandsHaveAllElse) {
  const SynthesizerState state = used_state();
  const auto pace = place_of(state, [](auto& s) {
    auto holds = s.memory.motion.holds.pairs();
    // Every byte of the number is another one, so that the first that differs is where it begins.
    holds[0].ramp_pace = std::bit_cast<double>(~std::bit_cast<std::uint64_t>(holds[0].ramp_pace));
    s.memory.motion.holds =
        HandHolds(holds, s.memory.motion.holds.arms(), s.memory.motion.holds.user_hands());
  });
  const auto end = place_of(state, [](auto& s) { s.memory.partner_is_shown ^= true; });
  constexpr std::size_t hold = 2 + 17 * sizeof(double), hands = 2 * (1 + 9 * sizeof(double));
  auto old = bytes_without_bodies(state);
  const std::ptrdiff_t hands_end = end - recorded_speed;
  old.erase(old.begin() + hands_end - static_cast<std::ptrdiff_t>(hands), old.begin() + hands_end);
  for (std::size_t p = 4; p-- > 0;) {
    const std::ptrdiff_t at = pace - recorded_speed + static_cast<std::ptrdiff_t>(p * hold);
    old.erase(old.begin() + at, old.begin() + at + static_cast<std::ptrdiff_t>(sizeof(double)));
  }
  old[0] = 4;
  const auto read = parse_synthesizer_state(old);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->memory.motion.playhead.pair, state.memory.motion.playhead.pair);
  EXPECT_EQ(read->memory.motion.holds.pairs()[3].asked_speed,
            state.memory.motion.holds.pairs()[3].asked_speed);
  EXPECT_FALSE(read->memory.motion.holds.user_hands()[0].is_seen);
  EXPECT_EQ(read->unsolved_s, state.unsolved_s);
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
