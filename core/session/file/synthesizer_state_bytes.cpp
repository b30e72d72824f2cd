#include "core/session/file/synthesizer_state_bytes.hpp"

#include <algorithm>
#include <bit>

#include "core/session/file/blob_bytes.hpp"

namespace abrazo {

namespace {

constexpr std::uint8_t format_version = 1;

void write(BlobWriter& out, const Body& body) {
  const auto& [bone_lengths, pseudo_lengths, toe_rest_height] = body;
  out.reals(bone_lengths);
  out.reals(pseudo_lengths);
  out.real(toe_rest_height);
}

Body read_body(BlobReader& in) {
  Body body;
  in.reals(body.bone_lengths);
  in.reals(body.pseudo_lengths);
  body.toe_rest_height = in.real();
  return body;
}

void write(BlobWriter& out, const std::optional<Body>& body) {
  out.flag(body.has_value());
  if (body) write(out, *body);
}

std::optional<Body> read_optional_body(BlobReader& in) {
  if (!in.flag()) return std::nullopt;
  return read_body(in);
}

void write(BlobWriter& out, const std::optional<std::string>& text) {
  out.flag(text.has_value());
  if (text) out.text(*text);
}

std::optional<std::string> read_optional_text(BlobReader& in) {
  if (!in.flag()) return std::nullopt;
  return in.text();
}

void write(BlobWriter& out, const FootLocks& locks) {
  for (const FootLocks::Foot& foot : locks.feet()) {
    out.flag(foot.was_landed);
    out.flag(foot.locked);
    out.matrix(foot.ankle);
    out.matrix(foot.toe_base);
  }
  for (const bool released : locks.passive_released()) out.flag(released);
}

FootLocks read_locks(BlobReader& in) {
  std::array<FootLocks::Foot, 4> feet;
  for (FootLocks::Foot& foot : feet) {
    foot.was_landed = in.flag();
    foot.locked = in.flag();
    in.matrix(foot.ankle);
    in.matrix(foot.toe_base);
  }
  std::array<bool, 2> released{};
  for (bool& one : released) one = in.flag();
  return {feet, released};
}

void write(BlobWriter& out, const MotionHistory::Kept& kept) {
  out.number(std::bit_cast<std::uint32_t>(kept.since_s));
  for (const float x : kept.positions) out.number(std::bit_cast<std::uint32_t>(x));
}

MotionHistory::Kept read_kept(BlobReader& in) {
  MotionHistory::Kept kept;
  kept.since_s = std::bit_cast<float>(in.number<std::uint32_t>());
  for (float& x : kept.positions) x = std::bit_cast<float>(in.number<std::uint32_t>());
  return kept;
}

void write(BlobWriter& out, const MotionHistory& history) {
  out.byte(static_cast<std::uint8_t>(history.size()));
  if (history.is_empty()) return;
  out.matrix(history.origin());
  out.matrix(history.root().position);
  out.real(history.root().heading_rad);
  for (std::size_t i = 0; i < history.size(); ++i) write(out, history.kept(i));
  write(out, history.newest());
}

/// @return whether it can be a history
bool read(BlobReader& in, MotionHistory& history) {
  const std::size_t size = in.byte();
  if (size == 0) return true;
  if (size > MotionHistory::most_samples) return false;
  Vec3 origin;
  RootFrame root;
  in.matrix(origin);
  in.matrix(root.position);
  root.heading_rad = in.real();
  std::vector<MotionHistory::Kept> kept(size);
  for (MotionHistory::Kept& one : kept) one = read_kept(in);
  const MotionHistory::Kept newest = read_kept(in);
  return history.restore(origin, root, kept, newest);
}

void write(BlobWriter& out, const Transition& transition) {
  for (const Vec3& turn : transition.turns()) out.matrix(turn);
  for (const Vec3& rate : transition.rates()) out.matrix(rate);
  for (const double value :
       {transition.height(), transition.climb(), transition.elapsed_s(), transition.duration_s()})
    out.real(value);
}

Transition read_transition(BlobReader& in) {
  Transition::Turns turns, rates;
  for (Vec3& turn : turns) in.matrix(turn);
  for (Vec3& rate : rates) in.matrix(rate);
  const double height = in.real(), climb = in.real(), elapsed_s = in.real(), duration_s = in.real();
  return {turns, rates, height, climb, elapsed_s, duration_s};
}

/// Calls `flag` and `real` and `point` with the fields of a foot in order, for writing and reading.
void each_field(auto& foot, const auto& flag, const auto& real, const auto& point) {
  auto& [planted, steps, waits_for_lift, anchor, slip, offset, rate, since_s, fades_s, lead, lead_speed, lift,
         lift_speed, free, shown, is_known] = foot;
  for (auto* one : {&planted, &steps, &waits_for_lift, &is_known}) flag(*one);
  for (auto* one : {&anchor, &slip, &offset, &rate, &lead, &lead_speed, &free, &shown}) point(*one);
  for (auto* one : {&since_s, &fades_s, &lift, &lift_speed}) real(*one);
}

/// The same of two hands.
void each_field_of_hold(auto& hold, const auto& flag, const auto& real, const auto& point) {
  auto& [recorded, out_of_reach, ramp, ramp_pace, offset, lag, lag_speed, asked, asked_speed] = hold;
  flag(recorded);
  flag(out_of_reach);
  real(ramp);
  for (auto* one : {&offset, &lag, &lag_speed, &asked, &asked_speed}) point(*one);
  real(ramp_pace);
}

/// The same of a hand of the user.
void each_field_of_hand(auto& hand, const auto& flag, const auto& point) {
  auto& [is_seen, at, speed, last_off] = hand;
  flag(is_seen);
  for (auto* one : {&at, &speed, &last_off}) point(*one);
}

void write(BlobWriter& out, const PartnerMotion& motion) {
  const auto& [playhead, moved_by, place, since_change_s, transition, adaptation, plants, holds] = motion;
  out.small_integer(playhead.pair);
  out.real(playhead.fraction);
  out.real(playhead.rate);
  out.byte(moved_by);
  out.matrix(place.at().position);
  out.real(place.at().heading_rad);
  out.matrix(place.speed());
  out.real(place.turning());
  out.matrix(place.recorded_speed());
  out.flag(place.desired().has_value());
  if (place.desired()) out.matrix(*place.desired());
  out.matrix(place.desired_speed());
  out.real(since_change_s);
  write(out, transition);
  for (const Pose* one : {&adaptation.offset(), &adaptation.speed()}) out.matrix(*one);
  const auto flag = [&](bool value) { out.flag(value); };
  const auto real = [&](double value) { out.real(value); };
  const auto point = [&](const Vec3& value) { out.matrix(value); };
  for (const FootPlants::Foot& foot : plants.feet()) each_field(foot, flag, real, point);
  for (const HandHolds::Pair& hold : holds.pairs()) each_field_of_hold(hold, flag, real, point);
  for (const HandHolds::Arm& arm : holds.arms()) {
    out.flag(arm.reaches);
    out.matrix(arm.along);
    out.matrix(arm.side);
  }
  for (const SteadyHand& hand : holds.user_hands()) each_field_of_hand(hand, flag, point);
}

PartnerMotion read_motion(BlobReader& in) {
  PartnerMotion motion;
  motion.playhead.pair = in.small_integer();
  motion.playhead.fraction = in.real();
  motion.playhead.rate = in.real();
  motion.moved_by = in.byte();
  RootFrame at;
  in.matrix(at.position);
  at.heading_rad = in.real();
  Vec3 speed, recorded_speed, desired_speed;
  in.matrix(speed);
  const double turning = in.real();
  in.matrix(recorded_speed);
  std::optional<Vec3> desired;
  if (in.flag()) in.matrix(desired.emplace());
  in.matrix(desired_speed);
  motion.place = PartnerPlace(at, speed, turning, recorded_speed, desired, desired_speed);
  motion.since_change_s = in.real();
  motion.transition = read_transition(in);
  Pose offset, offset_speed;
  for (Pose* one : {&offset, &offset_speed}) in.matrix(*one);
  motion.adaptation = Adaptation(offset, offset_speed);
  const auto flag = [&](bool& value) { value = in.flag(); };
  const auto real = [&](double& value) { value = in.real(); };
  const auto point = [&](Vec3& value) { in.matrix(value); };
  FootPlants::Feet feet;
  for (FootPlants::Foot& foot : feet) each_field(foot, flag, real, point);
  motion.plants = FootPlants(feet);
  HandHolds::Pairs holds;
  for (HandHolds::Pair& hold : holds) each_field_of_hold(hold, flag, real, point);
  HandHolds::Arms arms;
  for (HandHolds::Arm& arm : arms) {
    arm.reaches = in.flag();
    in.matrix(arm.along);
    in.matrix(arm.side);
  }
  HandHolds::UserHands user_hands;
  for (SteadyHand& hand : user_hands) each_field_of_hand(hand, flag, point);
  motion.holds = HandHolds(holds, arms, user_hands);
  return motion;
}

void write(BlobWriter& out, const UserMeasure& user) {
  write(out, user.body());
  out.flag(user.is_given());
  out.real(user.seen_s());
  out.small_integer(user.seen());
}

UserMeasure read_user(BlobReader& in) {
  const auto body = read_optional_body(in);
  const bool is_given = in.flag();
  const double seen_s = in.real();
  return {body, is_given, seen_s, in.small_integer()};
}

void write(BlobWriter& out, const GlidingBody& body) {
  const auto& [from, goal, since_s, of_user, is_known] = body;
  write(out, from);
  write(out, goal);
  out.real(since_s);
  out.flag(of_user);
  out.flag(is_known);
}

GlidingBody read_gliding_body(BlobReader& in) {
  GlidingBody body;
  body.from = read_body(in);
  body.goal = read_body(in);
  body.since_s = in.real();
  body.of_user = in.flag();
  body.is_known = in.flag();
  return body;
}

void write(BlobWriter& out, const ShownMemory& shown) {
  const auto& [bodies, is_fitted, leaves_s, change, difference, shift, feet, foot_offsets] = shown;
  for (const GlidingBody& body : bodies) write(out, body);
  out.flag(is_fitted);
  if (!is_fitted) return;  // the rest is then determined anew
  out.real(leaves_s);
  out.matrix(change);
  out.matrix(difference);
  out.matrix(shift);
  for (const auto* of_feet : {&feet, &foot_offsets})
    for (const Vec3& foot : *of_feet) out.matrix(foot);
}

ShownMemory read_shown(BlobReader& in) {
  ShownMemory shown;
  for (GlidingBody& body : shown.bodies) body = read_gliding_body(in);
  shown.is_fitted = in.flag();
  if (!shown.is_fitted) return shown;
  shown.leaves_s = in.real();
  in.matrix(shown.change);
  in.matrix(shown.difference);
  in.matrix(shown.shift);
  for (auto* of_feet : {&shown.feet, &shown.foot_offsets})
    for (Vec3& foot : *of_feet) in.matrix(foot);
  return shown;
}

// The names bind all fields: a field added to a struct breaks the compilation here, and must then be written
// and read below under a new version.
void write(BlobWriter& out, const FrameMemory& memory) {
  const auto& [frames_since_reset, previous, before_previous, previous_dt_s, previous_query, previous_heading,
               current_pair, has_good_result, locks, motion, partner_is_shown, history, user, shown] = memory;
  out.small_integer(frames_since_reset);
  out.matrix(previous);
  out.matrix(before_previous);
  out.real(previous_dt_s);
  out.matrix(previous_query);
  out.flag(previous_heading.has_value());
  if (previous_heading) out.real(*previous_heading);
  out.small_integer(current_pair);
  out.flag(has_good_result);
  write(out, locks);
  write(out, motion);
  out.flag(partner_is_shown);
  write(out, history);
  write(out, user);
  write(out, shown);
}

/// @return whether its history can be one
bool read(BlobReader& in, FrameMemory& memory) {
  memory.frames_since_reset = in.small_integer();
  in.matrix(memory.previous);
  in.matrix(memory.before_previous);
  memory.previous_dt_s = in.real();
  in.matrix(memory.previous_query);
  if (in.flag()) memory.previous_heading = in.real();
  memory.current_pair = in.small_integer();
  memory.has_good_result = in.flag();
  memory.locks = read_locks(in);
  memory.motion = read_motion(in);
  memory.partner_is_shown = in.flag();
  const bool has_history = read(in, memory.history);
  memory.user = read_user(in);
  memory.shown = read_shown(in);
  return has_history;
}

void write(BlobWriter& out, const Vetoes& vetoes) {
  const auto& [pairs, takes, labels] = vetoes;
  out.number(static_cast<std::uint32_t>(pairs.size()));
  for (const int pair : pairs) out.small_integer(pair);
  for (const auto* names : {&takes, &labels}) {
    out.number(static_cast<std::uint32_t>(names->size()));
    for (const std::string& name : *names) out.text(name);
  }
}

std::shared_ptr<const Vetoes> read_vetoes(BlobReader& in) {
  auto vetoes = std::make_shared<Vetoes>();
  // A count that the bytes cannot hold ends when they do.
  for (auto left = in.number<std::uint32_t>(); left > 0 && in.left() > 0; --left)
    vetoes->pairs.insert(in.small_integer());
  for (auto* names : {&vetoes->takes, &vetoes->labels})
    for (auto left = in.number<std::uint32_t>(); left > 0 && in.left() > 0; --left) names->insert(in.text());
  return vetoes;
}

}  // namespace

std::vector<std::uint8_t> synthesizer_state_bytes(const SynthesizerState& state) {
  const auto& [user_role, memory, user_body, pinned, vetoes, meant, unsolved_s] = state;
  BlobWriter out;
  out.reserve(30208);
  out.byte(format_version);
  out.byte(user_role == UserRole::Passive ? 1 : 0);
  write(out, memory);
  write(out, user_body);
  out.flag(pinned.has_value());
  if (pinned) out.small_integer(*pinned);
  write(out, vetoes ? *vetoes : Vetoes{});
  out.flag(meant.has_value());
  if (meant) {
    const auto& [label, take] = *meant;
    write(out, label);
    write(out, take);
  }
  out.real(unsolved_s);
  return out.take();
}

Result<SynthesizerState> parse_synthesizer_state(std::span<const std::uint8_t> bytes) {
  BlobReader in(bytes);
  const std::uint8_t version = in.byte();
  if (version != format_version)
    return Error{"the solver's state is of version " + std::to_string(version) +
                     "; this program reads version " + std::to_string(format_version),
                 {}};
  SynthesizerState state;
  state.user_role = in.byte() == 0 ? UserRole::Active : UserRole::Passive;
  if (!read(in, state.memory))
    return Error{"the user's last two seconds in the solver's state are damaged", {}};
  state.user_body = read_optional_body(in);
  if (in.flag()) state.pinned = in.small_integer();
  state.vetoes = read_vetoes(in);
  if (in.flag()) {
    IntendedPairs meant;
    meant.label = read_optional_text(in);
    meant.take = read_optional_text(in);
    state.meant = std::move(meant);
  }
  state.unsolved_s = in.real();
  if (!in.is_done()) return Error{"the solver's state does not have the bytes that it should have", {}};
  return state;
}

}  // namespace abrazo
