#include "core/session/synthesizer_state_bytes.hpp"

#include <algorithm>
#include <bit>

#include "core/session/blob_bytes.hpp"

namespace abrazo {

namespace {

constexpr std::uint8_t format_version = 2;
constexpr std::uint8_t without_history = 1;  ///< was written before there was one

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

// The names stand for the fields: a field that is added to a struct stops these lines from compiling, and is
// then written and read below under a new version.
void write(BlobWriter& out, const FrameMemory& memory) {
  const auto& [frames_since_reset, previous, before_previous, previous_dt_s, previous_query, previous_heading,
               current_pair, has_good_result, locks, transition, history, user_body] = memory;
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
  out.matrix(transition.offset());
  out.matrix(transition.velocity());
  write(out, history);
  write(out, user_body);
}

/// @return whether its history can be one
bool read(BlobReader& in, std::uint8_t version, FrameMemory& memory) {
  memory.frames_since_reset = in.small_integer();
  in.matrix(memory.previous);
  in.matrix(memory.before_previous);
  memory.previous_dt_s = in.real();
  in.matrix(memory.previous_query);
  if (in.flag()) memory.previous_heading = in.real();
  memory.current_pair = in.small_integer();
  memory.has_good_result = in.flag();
  memory.locks = read_locks(in);
  Pose offset, velocity;
  in.matrix(offset);
  in.matrix(velocity);
  memory.transition = Transition(offset, velocity);
  const bool has_history = version == without_history || read(in, memory.history);
  memory.user_body = read_optional_body(in);
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
  out.reserve(26624);
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
  if (version != format_version && version != without_history)
    return Error{"the solver's state is of version " + std::to_string(version) +
                     "; this program reads versions up to " + std::to_string(format_version),
                 {}};
  SynthesizerState state;
  state.user_role = in.byte() == 0 ? UserRole::Active : UserRole::Passive;
  if (!read(in, version, state.memory))
    return Error{"the user's last two seconds in the solver's state are damaged", {}};
  state.user_body = read_optional_body(in);
  if (in.flag()) state.pinned = in.small_integer();
  state.vetoes = read_vetoes(in);
  if (in.flag()) {
    MeantPairs meant;
    meant.label = read_optional_text(in);
    meant.take = read_optional_text(in);
    state.meant = std::move(meant);
  }
  state.unsolved_s = in.real();
  if (!in.is_done()) return Error{"the solver's state does not have the bytes that it should have", {}};
  return state;
}

}  // namespace abrazo
