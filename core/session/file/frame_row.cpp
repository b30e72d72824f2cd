#include "core/session/file/frame_row.hpp"

#include <cmath>
#include <limits>
#include <type_traits>

#include "core/session/file/blob_bytes.hpp"
#include "core/session/file/synthesizer_state_bytes.hpp"

namespace abrazo {

namespace {

constexpr std::size_t pose_size = joint_count * 3 * sizeof(double);
constexpr std::size_t candidate_size = 48;
// Bits of a candidate's flags.
constexpr int continues = 1;
constexpr int has_intent = 2;    ///< its terms follow those of Eq. 7
constexpr int has_temporal = 4;  ///< one of them is `temporal`
constexpr std::size_t contact_size = 20;

FrameRow::Blob candidate_bytes(const std::vector<Candidate>& candidates) {
  BlobWriter out;
  out.reserve(candidates.size() * candidate_size);
  for (const Candidate& candidate : candidates) {
    out.small_integer(candidate.pair);
    out.small_integer((candidate.continuation ? continues : 0) |
                      (candidate.intent ? has_intent | has_temporal : 0));
    out.real(candidate.feature_distance);
    out.real(candidate.cost.pose);
    out.real(candidate.cost.temporal_active);
    out.real(candidate.cost.temporal_passive);
    out.real(candidate.cost.total);
    if (const auto& intent = candidate.intent)
      for (const double term :
           {intent->partner, intent->leader, intent->move, intent->meant, intent->change, intent->temporal})
        out.real(term);
  }
  return out.take();
}

/// @return false when the bytes do not end with a candidate
bool read_candidates(const FrameRow::Blob& bytes, std::vector<Candidate>& candidates) {
  BlobReader in(bytes);
  candidates.reserve(bytes.size() / candidate_size);
  while (in.left() >= candidate_size) {
    Candidate& candidate = candidates.emplace_back();
    candidate.pair = in.small_integer();
    const int flags = in.small_integer();
    candidate.continuation = (flags & continues) != 0;
    candidate.feature_distance = in.real();
    candidate.cost.pose = in.real();
    candidate.cost.temporal_active = in.real();
    candidate.cost.temporal_passive = in.real();
    candidate.cost.total = in.real();
    if (!(flags & has_intent)) continue;
    IntentCost& intent = candidate.intent.emplace();
    for (double* term : {&intent.partner, &intent.leader, &intent.move, &intent.meant, &intent.change}) {
      *term = in.real();
      intent.total += *term;
    }
    if (!(flags & has_temporal)) continue;
    intent.temporal = in.real();
    intent.total += intent.temporal;
  }
  return in.is_done();
}

FrameRow::Blob contact_bytes(const std::vector<CapsuleContact>& contacts) {
  BlobWriter out;
  for (const CapsuleContact& contact : contacts) {
    for (const int vertex : {contact.a[0], contact.a[1], contact.b[0], contact.b[1]})
      out.byte(static_cast<std::uint8_t>(vertex));
    out.real(contact.depth_m);
    out.real(contact.allowed_depth_m);
  }
  return out.take();
}

Result<std::vector<CapsuleContact>> read_contacts(const FrameRow::Blob& bytes) {
  BlobReader in(bytes);
  std::vector<CapsuleContact> contacts(bytes.size() / contact_size);
  for (CapsuleContact& contact : contacts) {
    for (int* vertex : {&contact.a[0], &contact.a[1], &contact.b[0], &contact.b[1]}) {
      *vertex = in.byte();
      if (*vertex >= pair_vertex_count) return Error{"a contact is of a joint that does not exist", {}};
    }
    contact.depth_m = in.real();
    contact.allowed_depth_m = in.real();
  }
  return contacts;
}

FrameRow::Blob root_bytes(const RootFrame& root) {
  BlobWriter out;
  out.matrix(root.position);
  out.real(root.heading_rad);
  return out.take();
}

std::int64_t lock_bits(const std::vector<FootLock>& locks) {
  std::int64_t bits = 0;
  for (const FootLock& lock : locks) bits |= 1 << ((lock.active_body ? 0 : 2) + (lock.left ? 0 : 1));
  return bits;
}

std::vector<FootLock> read_locks(std::int64_t bits) {
  std::vector<FootLock> locks;
  for (int bit = 0; bit < 4; ++bit)
    if (bits & (1 << bit)) locks.push_back({bit < 2, bit % 2 == 0});
  return locks;
}

constexpr std::array<std::string_view, 3> status_names = {"ok", "relaxed", "failed"};

FrameRow::Time in_file(double session_s, double offset_s) {
  return session_s < 0 ? FrameRow::Time() : FrameRow::Time(session_s + offset_s);
}

/// Binds, reads or sums up one value by its type.
struct Binder {
  SessionStatement& statement;
  int at = 0;
  template <typename T>
  void operator()(const char*, const char*, const T& value) {
    if constexpr (std::is_same_v<T, FrameRow::Blob>) {
      if (value.empty())
        statement.bind_null(at);
      else
        statement.bind(at, std::span<const std::uint8_t>(value));
    } else if constexpr (std::is_same_v<T, std::string>) {
      if (value.empty())
        statement.bind_null(at);
      else
        statement.bind(at, std::string_view(value));
    } else if constexpr (requires { value.has_value(); }) {
      if (value)
        statement.bind(at, *value);
      else
        statement.bind_null(at);
    } else {
      statement.bind(at, value);
    }
    ++at;
  }
};

struct Fetcher {
  const SessionStatement& statement;
  int at = 0;
  void take(bool& value) const { value = statement.integer(at) != 0; }
  void take(std::int64_t& value) const { value = statement.integer(at); }
  // What is not a number cannot be kept otherwise than as NULL.
  void take(double& value) const {
    value = statement.is_null(at) ? std::numeric_limits<double>::quiet_NaN() : statement.real(at);
  }
  template <typename T>
  void operator()(const char*, const char*, T& value) {
    if constexpr (std::is_same_v<T, FrameRow::Blob>) {
      const auto bytes = statement.blob(at);
      value.assign(bytes.begin(), bytes.end());
    } else if constexpr (std::is_same_v<T, std::string>) {
      value = statement.text(at);
    } else if constexpr (requires { value.has_value(); }) {
      if (!statement.is_null(at)) take(value.emplace());
    } else {
      take(value);
    }
    ++at;
  }
};

struct Summer {
  Checksum sum;
  void take(bool value) { sum.add(std::uint64_t{value}); }
  void take(std::int64_t value) { sum.add(static_cast<std::uint64_t>(value)); }
  void take(double value) {
    sum.add(std::isnan(value) ? std::uint64_t{1} : std::bit_cast<std::uint64_t>(value == 0 ? 0.0 : value));
  }
  template <typename T>
  void operator()(const char*, const char*, const T& value) {
    if constexpr (std::is_same_v<T, FrameRow::Blob>) {
      sum.add(std::span<const std::uint8_t>(value));
    } else if constexpr (std::is_same_v<T, std::string>) {
      sum.add(std::string_view(value));
    } else if constexpr (requires { value.has_value(); }) {
      if (value) take(*value);
    } else {
      take(value);
    }
  }
};

std::int64_t checksum_of(const FrameRow& row) {
  Summer summer;
  FrameRow::each(row, summer);
  return summer.sum.value();
}

}  // namespace

std::vector<std::uint8_t> pose_bytes(const Pose& pose) {
  BlobWriter out;
  out.reserve(pose_size);
  out.matrix(pose);
  return out.take();
}

bool read_pose(std::span<const std::uint8_t> bytes, Pose& pose) {
  BlobReader in(bytes);
  in.matrix(pose);
  return in.is_done();
}

FrameRow row_of(const FrameSnapshot& frame, std::uint64_t file_index, double offset_s) {
  const FrameResult& result = frame.result;
  FrameRow row;
  row.frame = static_cast<std::int64_t>(file_index);
  row.time_s = frame.time_s + offset_s;
  row.elapsed_s = frame.elapsed_s;
  row.input_frame = frame.input_frame;
  row.user = pose_bytes(frame.user);
  row.query = pose_bytes(result.query_world);
  row.query_root = root_bytes(result.query_root);
  row.active = pose_bytes(result.active());
  row.passive = pose_bytes(result.passive());
  row.candidates = candidate_bytes(result.candidates);
  row.collisions = contact_bytes(result.collisions);
  if (frame.before) row.state = synthesizer_state_bytes(*frame.before);
  row.selected = result.selected;
  if (result.selected >= 0 && static_cast<std::size_t>(result.selected) < result.candidates.size())
    row.pair = result.candidates[static_cast<std::size_t>(result.selected)].pair;
  row.source_changed = result.source_changed;
  row.status = status_names[static_cast<std::size_t>(result.status)];
  row.message = result.message;
  row.energy = result.energy;
  row.residual = result.residual;
  row.foot_locks = lock_bits(result.foot_locks);
  row.timing = result.timing;
  row.arrived_s = in_file(frame.times.arrived_s, offset_s);
  row.assembled_s = in_file(frame.times.assembled_s, offset_s);
  row.taken_s = in_file(frame.times.taken_s, offset_s);
  row.solved_s = in_file(frame.times.solved_s, offset_s);
  row.sent_s = in_file(frame.times.sent_s, offset_s);
  row.input_rate_hz = frame.input_rate_hz;
  row.dropped_inputs = static_cast<std::int64_t>(frame.dropped_inputs);
  return row;
}

Result<std::shared_ptr<FrameSnapshot>> frame_of(const FrameRow& row) {
  auto frame = std::make_shared<FrameSnapshot>();
  FrameResult& result = frame->result;
  frame->index = static_cast<std::uint64_t>(row.frame);
  const Error broken{"frame " + std::to_string(row.frame) + " is damaged", {}};
  Pose active, passive;
  if (!read_pose(row.user, frame->user) || !read_pose(row.query, result.query_world) ||
      !read_pose(row.active, active) || !read_pose(row.passive, passive))
    return broken;
  result.result << active, passive;
  BlobReader root(row.query_root);
  root.matrix(result.query_root.position);
  result.query_root.heading_rad = root.real();
  if (!root.is_done() || !read_candidates(row.candidates, result.candidates) ||
      row.collisions.size() % contact_size)
    return broken;
  result.query_normalized = to_normalized(result.query_world, result.query_root);
  result.features = pose_features(result.query_normalized);
  auto contacts = read_contacts(row.collisions);
  if (!contacts || row.selected >= static_cast<std::int64_t>(result.candidates.size()) || row.selected < -1)
    return broken;
  result.collisions = std::move(*contacts);
  result.selected = static_cast<int>(row.selected);
  if (!row.state.empty()) {
    auto state = parse_synthesizer_state(row.state);
    if (!state) return Error{broken.message + ": " + state.error().message, {}};
    frame->before = std::make_shared<const SynthesizerState>(std::move(*state));
  }
  std::size_t status = 0;
  while (status < status_names.size() && status_names[status] != row.status) ++status;
  if (status == status_names.size()) return broken;
  result.status = static_cast<StepStatus>(status);
  result.message = row.message;
  result.source_changed = row.source_changed;
  result.energy = row.energy;
  result.residual = row.residual;
  result.foot_locks = read_locks(row.foot_locks);
  result.timing = row.timing;
  frame->time_s = row.time_s;
  frame->elapsed_s = row.elapsed_s;
  frame->input_frame = row.input_frame;
  frame->times = {row.arrived_s.value_or(-1), row.assembled_s.value_or(-1), row.taken_s.value_or(-1),
                  row.solved_s.value_or(-1), row.sent_s.value_or(-1)};
  frame->input_rate_hz = row.input_rate_hz;
  frame->dropped_inputs = static_cast<std::uint64_t>(row.dropped_inputs);
  return frame;
}

const std::string& frame_columns() {
  static const std::string names = [] {
    std::string list;
    const FrameRow row;
    FrameRow::each(row, [&](const char* name, const char*, const auto&) {
      list += (list.empty() ? "" : ", ") + std::string(name);
    });
    return list;
  }();
  return names;
}

std::string frame_column_definitions() {
  std::string list;
  const FrameRow row;
  FrameRow::each(row, [&](const char* name, const char* type, const auto&) {
    list += std::string("  ") + name + " " + type + ",\n";
  });
  return list + "  checksum INTEGER NOT NULL";
}

std::string frame_insert() {
  std::string places;
  const FrameRow row;
  FrameRow::each(row, [&](const char*, const char*, const auto&) { places += "?, "; });
  return "INSERT INTO frames (" + frame_columns() + ", checksum) VALUES (" + places + "?)";
}

void bind_row(SessionStatement& statement, const FrameRow& row) {
  Binder binder{statement};
  FrameRow::each(row, binder);
  statement.bind(binder.at, checksum_of(row));
}

Result<FrameRow> read_row(const SessionStatement& statement) {
  FrameRow row;
  Fetcher fetcher{statement};
  FrameRow::each(row, fetcher);
  if (statement.integer(fetcher.at) != checksum_of(row))
    return Error{
        "frame " + std::to_string(row.frame) + " is damaged: its checksum is not that of its content", {}};
  return row;
}

}  // namespace abrazo
