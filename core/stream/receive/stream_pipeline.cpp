#include "core/stream/receive/stream_pipeline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>

#include "core/base/atomic_file.hpp"
#include "core/base/text.hpp"

namespace abrazo {

namespace {

constexpr std::size_t most_performers = 16, most_senders = 32, most_issue_kinds = 64;
constexpr double forgotten_after_s = 2;  ///< a silent performer then makes room for another
constexpr double sender_is_recent_s = 2;
constexpr double stalled_after_s = 1;
constexpr double longest_hold_ms = 5000;
constexpr std::string_view sender_changed = "sender-changed";  ///< an issue that is worth a diagnosis

/// Of a packet that could not be read at all, unlike one that had only something odd.
bool is_unreadable(const StreamIssue& issue) {
  constexpr std::array<std::string_view, 5> kinds = {"other-protocol", "not-osc", "truncated", "oversized",
                                                     "decoder-failure"};
  return std::find(kinds.begin(), kinds.end(), issue.kind) != kinds.end();
}

Result<double> metres_per_unit(const StreamUri& uri) {
  const std::string unit = uri.option("unit", "m");
  if (unit == "m") return 1.0;
  if (unit == "cm") return 0.01;
  if (unit == "mm") return 0.001;
  const auto value = parse_number(unit);
  if (value && *value > 0 && std::isfinite(*value)) return *value;
  return Error{"the unit is " + in_quotes(unit) + "; expected m, cm, mm or metres per unit", uri.text};
}

Result<std::optional<JointMap>> joint_map_option(const StreamUri& uri) {
  const std::string name = uri.option("map");
  if (name.empty()) return std::optional<JointMap>();
  std::string known;
  for (const JointMap& map : builtin_joint_maps()) {
    if (map.name == name) return std::optional<JointMap>(map);
    known += (known.empty() ? "" : ", ") + map.name;
  }
  const Result<std::string> text = read_whole_file(name);
  if (!text) return Error{"is no joint map: neither one of " + known + " nor a file that can be read", name};
  Result<JointMap> map = parse_joint_map(*text, name);
  if (!map) return map.error();
  return std::optional<JointMap>(std::move(*map));
}

}  // namespace

Result<PerformerStream::Options> performer_options(const StreamUri& uri, const StreamReceiverOptions& given) {
  PerformerStream::Options options;
  if (const Status allowed = check_stream_options(uri, StreamDirection::Listen); !allowed)
    return allowed.error();
  const auto delay = milliseconds_option(uri, "delay", 1000 * JitterBuffer::longest_delay_s);
  if (!delay) return delay.error();
  const auto hold = milliseconds_option(uri, "hold", longest_hold_ms);
  if (!hold) return hold.error();
  const Result<double> unit = metres_per_unit(uri);
  if (!unit) return unit.error();
  Result<std::optional<JointMap>> map = joint_map_option(uri);
  if (!map) return map.error();
  const std::string up = lower_case(uri.option("up", "y"));
  if (up != "y" && up != "z")
    return Error{"the option 'up' is " + in_quotes(up) + "; expected y or z", uri.text};
  const std::string floor = uri.option("floor", "auto");
  const auto height = parse_number(floor);
  if (floor != "auto" && !(height && std::isfinite(*height)))
    return Error{"the option 'floor' is " + in_quotes(floor) + "; expected metres or auto", uri.text};

  options.delay_s = given.delay_s > 0 ? given.delay_s : delay->value_or(0);
  options.performer_loss_s = given.performer_loss_s;
  options.assembly.joint_map = given.joint_map ? given.joint_map : std::move(*map);
  if (*hold) options.assembly.longest_hold_s = **hold;
  options.assembly.correction.metres_per_unit = *unit;
  // The decoders of NatNet and Xsens convert the axes themselves, because they also convert rotations.
  options.assembly.correction.z_up = up == "z" && uri.scheme == StreamUri::Scheme::Vmc;
  if (height) options.assembly.correction.floor_y_m = *height;
  options.floor_by_calibration = !height.has_value();
  return options;
}

StreamPipeline::StreamPipeline(std::unique_ptr<StreamDecoder> decoder, StreamUri uri,
                               PerformerStream::Options options, double now_s)
    : decoder_(std::move(decoder)), uri_(std::move(uri)), options_(std::move(options)), opened_s_(now_s) {}

void StreamPipeline::take(const Datagram& datagram, double now_s, Output& out, bool truncated) {
  ++counted_.packets;
  counted_.bytes += datagram.bytes.size();
  counted_.last_packet_s = std::max(counted_.last_packet_s, datagram.arrived_s);
  recent_packets_.add(now_s);
  note_sender(datagram.from, now_s);
  Decoded decoded;
  if (truncated) {
    decoded.issues.push_back(
        {"oversized", "a packet was larger than the " + std::to_string(datagram.bytes.size()) +
                          " bytes that can be taken; have the sender make smaller packets"});
  } else {
    try {
      decoder_->take(datagram, decoded);
    } catch (const std::exception& failure) {
      decoded.issues.push_back(
          {"decoder-failure", std::string("a packet could not be read: ") + failure.what()});
    }
  }
  if (!decoded.issues.empty()) ++counted_.packets_with_issues;
  const auto unreadable = std::find_if(decoded.issues.begin(), decoded.issues.end(), is_unreadable);
  if (decoded.frames.empty() && unreadable != decoded.issues.end())
    note_unknown(datagram, unreadable->text, now_s);
  else
    last_understood_s_ = now_s;
  work_off(decoded, now_s, out);
}

void StreamPipeline::pass_time(double now_s, Output& out) {
  Decoded decoded;
  try {
    decoder_->pass_time(now_s, decoded);
  } catch (const std::exception& failure) {
    decoded.issues.push_back({"decoder-failure", failure.what()});
  }
  work_off(decoded, now_s, out);
  for (const auto& stream : streams_) stream->pass_time(now_s);
}

void StreamPipeline::work_off(Decoded& decoded, double now_s, Output& out) {
  for (const StreamIssue& issue : decoded.issues) {
    if (issue.kind == sender_changed)
      note_sender_change(issue.text, now_s);
    else
      note_issue(issue);
    latest_issue_ = issue;
  }
  for (const PerformerFrame& frame : decoded.frames) take_frame(frame, now_s, out);
  for (OutgoingDatagram& reply : decoded.replies) out.replies.push_back(std::move(reply));
}

void StreamPipeline::take_frame(const PerformerFrame& frame, double now_s, Output& out) {
  last_frame_s_ = std::max(last_frame_s_, frame.arrived_s);
  PerformerStream* const stream = stream_of(frame, now_s);
  if (stream == nullptr) return;
  PerformerStream::Outcome outcome = stream->take(frame, now_s);
  if (outcome.issue) note_issue({outcome.issue->kind, stream->name() + ": " + outcome.issue->text});
  if (outcome.pose) out.poses.push_back(std::move(*outcome.pose));
}

PerformerStream* StreamPipeline::find(const std::string& performer) {
  const auto named = [&](auto is_it) -> PerformerStream* {
    const auto found = std::ranges::find_if(streams_, is_it);
    return found == streams_.end() ? nullptr : found->get();
  };
  if (auto* const by_name = named([&](const auto& stream) { return stream->name() == performer; }))
    return by_name;
  return named([&](const auto& stream) { return stream->is_called(performer); });
}

PerformerStream* StreamPipeline::stream_of(const PerformerFrame& frame, double now_s) {
  for (const auto& known : streams_)
    if (known->name() == frame.performer) return known.get();
  if (streams_.size() >= most_performers) {
    // The performer that has been silent longest, preferably one without measurements.
    const auto silent = std::min_element(streams_.begin(), streams_.end(), [](const auto& a, const auto& b) {
      return std::pair(a->body().has_value(), a->last_frame_s()) <
             std::pair(b->body().has_value(), b->last_frame_s());
    });
    if (now_s - (*silent)->last_frame_s() <= forgotten_after_s) {
      note_issue({"too-many-performers", "more than " + std::to_string(most_performers) +
                                             " performers on one port; " + in_quotes(frame.performer) +
                                             " is left out"});
      return nullptr;
    }
    streams_.erase(silent);
  }
  streams_.push_back(std::make_unique<PerformerStream>(frame.performer, options_, now_s));
  return streams_.back().get();
}

void StreamPipeline::note_issue(const StreamIssue& issue) {
  auto found = issues_.find(issue.kind);
  if (found == issues_.end()) {
    if (issues_.size() >= most_issue_kinds) return;
    found = issues_.emplace(issue.kind, IssueCount{issue.kind, 0, {}}).first;
  }
  ++found->second.count;
  found->second.latest = issue.text;
}

void StreamPipeline::note_stranger(const Endpoint& stranger, const std::string& server, double now_s) {
  stranger_ = "only the server " + server + " is accepted; packets of " + address_text(stranger.address) +
              " are left out";
  recent_strangers_.add(now_s);
  note_issue({"stranger", stranger_});
}

void StreamPipeline::note_sender_change(const std::string& text, double now_s) {
  sender_change_ = text;
  last_sender_change_s_ = now_s;
  note_issue({std::string(sender_changed), text});
}

void StreamPipeline::note_sender(const Endpoint& sender, double now_s) {
  if (senders_.size() >= most_senders && !senders_.contains(sender))
    senders_.erase(std::min_element(senders_.begin(), senders_.end(),
                                    [](const auto& a, const auto& b) { return a.second < b.second; }));
  senders_[sender] = now_s;
}

void StreamPipeline::note_unknown(const Datagram& datagram, const std::string& why, double now_s) {
  unreadable_ = why;
  recent_unknown_.add(now_s);
  counted_.first_bytes.fill(0);
  unknown_size_ = datagram.bytes.size();
  first_bytes_count_ = std::min(counted_.first_bytes.size(), datagram.bytes.size());
  std::copy_n(datagram.bytes.begin(), first_bytes_count_, counted_.first_bytes.begin());
}

void StreamPipeline::note_overflow(std::uint64_t total, double now_s) {
  if (total > counted_.overflowed) recent_overflow_.add(now_s, total - counted_.overflowed);
  counted_.overflowed = total;
}

void StreamPipeline::calibrate(const std::string& performer, double over_s, double now_s) {
  decoder_->calibrate(performer);
  for (const auto& stream : streams_)
    if (performer.empty() || stream->is_called(performer)) stream->calibrate(over_s, now_s);
}

void StreamPipeline::set_delay(double delay_s) {
  options_.delay_s = delay_s;
  for (const auto& stream : streams_) stream->set_delay(delay_s);
}

std::vector<std::string> StreamPipeline::performers() const {
  std::vector<std::string> names;
  for (const auto& stream : streams_) names.push_back(stream->name());
  return names;
}

StreamObservation StreamPipeline::observe(double now_s) const {
  StreamObservation seen;
  seen.uri = uri_;
  seen.opened_s = opened_s_;
  seen.now_s = now_s;
  seen.performer_loss_s = options_.performer_loss_s;
  seen.packets = counted_.packets;
  seen.last_packet_s = counted_.last_packet_s;
  seen.last_frame_s = last_frame_s_;
  seen.last_understood_s = last_understood_s_;
  seen.recent_unknown = recent_unknown_.value(now_s);
  seen.recent_packets = recent_packets_.value(now_s);
  seen.first_bytes = counted_.first_bytes;
  seen.first_bytes_count = first_bytes_count_;
  seen.unknown_size = unknown_size_;
  seen.recent_overflow = recent_overflow_.value(now_s);
  if (recent_strangers_.value(now_s) > 0) seen.stranger = stranger_;
  seen.followed = counted_.followed;
  seen.undecided = counted_.undecided;
  seen.sender_change = sender_change_;
  seen.last_sender_change_s = last_sender_change_s_;
  for (const auto& [sender, last_s] : senders_)
    if (now_s - last_s <= sender_is_recent_s) seen.recent_senders.push_back(sender.text());
  seen.failure = failure_;
  seen.group_failure = group_failure_;
  seen.lost_address = lost_address_;
  seen.latest_issue = latest_issue_;
  seen.unreadable = unreadable_;
  for (const auto& stream : streams_) seen.performers.push_back(stream->observe(now_s));
  return seen;
}

StreamHealth StreamPipeline::health(double now_s) const {
  const StreamObservation seen = observe(now_s);
  StreamHealth health = counted_;
  health.uri = uri_.text;
  health.listening = listening_;
  health.taken_s = now_s;
  health.state = !failure_.empty()                                ? StreamHealth::State::Failed
                 : health.last_packet_s < 0                       ? StreamHealth::State::Waiting
                 : now_s - health.last_packet_s > stalled_after_s ? StreamHealth::State::Stalled
                                                                  : StreamHealth::State::Receiving;
  for (const auto& [sender, last_s] : senders_) health.senders.push_back(sender.text());
  for (const PerformerObservation& performer : seen.performers) health.performers.push_back(performer.health);
  for (const auto& [kind, issue] : issues_) health.issues.push_back(issue);
  health.diagnoses = diagnose(seen);
  health.facts = decoder_->facts();
  return health;
}

}  // namespace abrazo
