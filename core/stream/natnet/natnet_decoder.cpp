#include "core/stream/natnet/natnet_decoder.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/base/text.hpp"
#include "core/stream/natnet/natnet_connection.hpp"
#include "core/stream/natnet/natnet_performer.hpp"
#include "core/stream/net/usual_ports.hpp"
#include "core/stream/protocol/sender_hold.hpp"

namespace abrazo {

namespace {

constexpr double silence_text_every_s = 5;
/// Bytes left after a frame: its end tag, and additions of later versions. Reading a frame in a wrong version
/// mostly leaves more.
constexpr std::size_t longest_end_bytes = 16;

/// Described at once: a datagram has room for thousands without bones, and each costs time in each frame.
constexpr std::size_t most_skeletons = 64;

/// Values of the options.
struct NatNetOptions {
  NatNetConventions conventions;
  std::optional<NatNetVersion> version;
  std::optional<Endpoint> group;
};

Result<NatNetOptions> parse_natnet_options(const StreamUri& uri) {
  NatNetOptions options;
  const auto wrong = [&](std::string_view key, std::string_view expected) {
    return Error{
        std::string(key) + "=" + uri.option(key) + " is not known; expected " + std::string(expected),
        uri.text};
  };
  if (const std::string given = uri.option("coordinates"); !given.empty()) {
    if (given != "global" && given != "local") return wrong("coordinates", "global or local");
    options.conventions.local_bones = given == "local";
  }
  if (const std::string given = uri.option("up"); !given.empty()) {
    if (given != "y" && given != "z") return wrong("up", "y or z");
    options.conventions.up = given.front();
  }
  if (const std::string given = uri.option("version"); !given.empty()) {
    options.version = parse_natnet_version(given);
    if (!options.version) return wrong("version", "3.0, 3.1, 4.0, 4.1 or 4.2");
  }
  if (const std::string given = uri.option("multicast"); !given.empty()) {
    const auto group = parse_natnet_group(given);
    if (!group) return wrong("multicast", "a group from 224.0.0.0 to 239.255.255.255, usually 239.255.42.99");
    options.group = Endpoint{*group, natnet_data_port};
  }
  return options;
}

class NatNetDecoder : public StreamDecoder {
 public:
  NatNetDecoder(const NatNetOptions& options, bool knows_host)
      : options_(options), knows_host_(knows_host), connection_(knows_host, options.version) {}

  void take(const Datagram& datagram, Decoded& out) override;
  void pass_time(double now_s, Decoded& out) override;
  void calibrate(const std::string& /*performer*/) override {}
  std::optional<Endpoint> wanted_group() const override;
  std::vector<std::string> facts() const override;

 private:
  bool is_from_server(const Datagram& datagram, NatNetMessage id, Decoded& out);
  void take_server_info(ByteReader& reader, double arrived_s, Decoded& out);
  void take_model(ByteReader& reader, double arrived_s, Decoded& out);
  void take_frame(ByteReader& reader, const Datagram& datagram, Decoded& out);
  void give(const NatNetFrame& frame, const Datagram& datagram, Decoded& out);
  bool can_read(const ByteReader& reader, std::string_view what, Decoded& out);
  NatNetPerformer* performer_of(std::int32_t skeleton);

  NatNetOptions options_;
  bool knows_host_;
  SenderHold server_;  ///< if the host is unknown: the assumed server
  NatNetConnection connection_;
  std::optional<NatNetModel> model_;
  std::vector<NatNetPerformer> performers_;
  std::optional<StreamIssue> old_server_;  ///< why its frames cannot be read
  NatNetFrame newest_;                     ///< without its bodies: for the facts
  std::optional<double> frame_s_, told_s_, first_s_;
};

void NatNetDecoder::take(const Datagram& datagram, Decoded& out) {
  ByteReader reader(datagram.bytes, ByteOrder::Little);
  const NatNetHead head = parse_natnet_head(reader);
  if (reader.failed()) {
    out.issues.push_back({"truncated", reader.failure()});
    return;
  }
  const auto id = static_cast<NatNetMessage>(head.id);
  const bool is_known =
      head.id <= static_cast<std::uint16_t>(NatNetMessage::Discovery) || id == NatNetMessage::Unrecognized;
  if (!is_known) {
    out.issues.push_back({"other-protocol", "no NatNet packet: it begins with the number " +
                                                std::to_string(head.id) + ", and messages have 0 to 14"});
    return;
  }
  if (reader.left() < head.payload_bytes) {
    out.issues.push_back({"truncated", "the packet announces " + std::to_string(head.payload_bytes) +
                                           " bytes behind its head, but has " +
                                           std::to_string(reader.left())});
    return;
  }
  if (!is_from_server(datagram, id, out)) return;
  switch (id) {
    case NatNetMessage::ServerInfo:
      return take_server_info(reader, datagram.arrived_s, out);
    case NatNetMessage::ModelDef:
      return take_model(reader, datagram.arrived_s, out);
    case NatNetMessage::Frame:
      return take_frame(reader, datagram, out);
    case NatNetMessage::EchoResponse:
      return connection_.take_echo(reader, datagram.arrived_s);
    case NatNetMessage::Unrecognized:
      out.issues.push_back({"unrecognized", "the server did not understand a request of ours"});
      return;
    default:
      return;  // answers to what others asked
  }
}

/// If the URI names a host, only its packets arrive here. Otherwise the first machine that sends frames is
/// the server; another one replaces it after a while without readable frames.
bool NatNetDecoder::is_from_server(const Datagram& datagram, NatNetMessage id, Decoded& out) {
  if (knows_host_ || (id != NatNetMessage::Frame && server_.is_holder(datagram.from))) return true;
  if (id != NatNetMessage::Frame) return false;  // no request yet, or to another machine
  const std::optional<std::uint32_t> before = server_.address();
  switch (server_.claim(datagram.from, datagram.arrived_s)) {
    case SenderHold::Answer::Refused:
      out.issues.push_back({"other-sender", "frames of " + address_text(datagram.from.address) +
                                                " are left out: those of " + address_text(*before) +
                                                " came first. To hear the other, name it as the host"});
      return false;
    case SenderHold::Answer::NewHolder:
      connection_ = NatNetConnection(knows_host_, options_.version);
      old_server_.reset();
      connection_.set_server_place(datagram.from);
      model_.reset();
      performers_.clear();
      if (before)
        out.issues.push_back({"sender-changed", address_text(datagram.from.address) +
                                                    " is used as the server now, because no frame of " +
                                                    address_text(*before) + " could be read for a while"});
      return true;
    case SenderHold::Answer::Holder:
      break;
  }
  return true;
}

void NatNetDecoder::take_server_info(ByteReader& reader, double arrived_s, Decoded& out) {
  const NatNetServerInfo info = parse_natnet_server_info(reader);
  if (reader.failed()) {
    out.issues.push_back({"truncated", reader.failure()});
    return;
  }
  const bool was_asked = connection_.expects_server_info(arrived_s);
  if (was_asked && info.version < oldest_natnet) {
    old_server_ = {"old-version",
                   info.text() + " is spoken there; 3.0 or later can be read. Use Motive 2.0 or later"};
    out.issues.push_back(*old_server_);
    return;
  }
  if (was_asked && info.multicast && info.group != 0 && !is_multicast_group(info.group)) {
    out.issues.push_back({"no-group", "the server names " + address_text(info.group) +
                                          " as its multicast group; expected 224.0.0.0 to 239.255.255.255. "
                                          "Set the group in Motive, or choose Unicast there"});
    return;
  }
  old_server_.reset();
  const auto before = connection_.version();
  if (auto wrong = connection_.take_server_info(info, arrived_s)) out.issues.push_back(std::move(*wrong));
  if (connection_.version() != before) model_.reset();
}

/// Whether the version that decides the fields is known.
bool NatNetDecoder::can_read(const ByteReader& reader, std::string_view what, Decoded& out) {
  if (reader.failed() || connection_.version()) return !reader.failed();
  if (old_server_)
    out.issues.push_back(*old_server_);
  else
    out.issues.push_back({"no-version", std::string(what) +
                                            " arrived before the server's version; the version is requested. "
                                            "If its command port is closed, give version=3.1 or the like"});
  return false;
}

void NatNetDecoder::take_model(ByteReader& reader, double arrived_s, Decoded& out) {
  if (!can_read(reader, "a model description", out)) return;
  if (!connection_.expects_model(arrived_s)) {
    out.issues.push_back({"unasked-answer", "an unsolicited model description arrived; it is ignored"});
    return;
  }
  Result<NatNetModel> parsed = parse_natnet_model(reader, *connection_.version());
  if (!parsed) {
    connection_.doubt_version();
    out.issues.push_back({"truncated", parsed.error().text()});
    return;
  }
  NatNetModel model = std::move(*parsed);
  if (model.skeletons.empty() && !model.unread.empty()) connection_.doubt_version();
  for (const std::string& unread : model.unread)
    out.issues.push_back({"unread-description", "model description: " + unread});
  connection_.take_model(arrived_s);
  if (model.skeletons.size() > most_skeletons) {
    out.issues.push_back({"too-many-performers",
                          "the server describes " + std::to_string(model.skeletons.size()) +
                              " skeletons; the first " + std::to_string(most_skeletons) + " are taken"});
    model.skeletons.resize(most_skeletons);
  }
  performers_.clear();
  std::set<std::string> names;
  for (const NatNetSkeleton& skeleton : model.skeletons) {
    std::string name = skeleton.name.empty() ? "skeleton " + std::to_string(skeleton.id) : skeleton.name;
    if (!names.insert(name).second) name += " (" + std::to_string(skeleton.id) + ")";
    performers_.emplace_back(skeleton, name, options_.conventions);
  }
  if (model.skeletons.empty())
    out.issues.push_back(
        {"no-skeleton", "the server describes " + std::to_string(model.rigid_bodies.size()) +
                            " rigid bodies and no skeleton. In Motive create a skeleton, and tick "
                            "Skeletons in the streaming settings"});
  model_ = std::move(model);
}

NatNetPerformer* NatNetDecoder::performer_of(std::int32_t skeleton) {
  const auto found = std::find_if(performers_.begin(), performers_.end(),
                                  [&](const NatNetPerformer& p) { return p.id() == skeleton; });
  return found == performers_.end() ? nullptr : &*found;
}

void NatNetDecoder::take_frame(ByteReader& reader, const Datagram& datagram, Decoded& out) {
  frame_s_ = datagram.arrived_s;
  if (!can_read(reader, "a frame", out)) return;
  Result<NatNetFrame> parsed = parse_natnet_frame(reader, *connection_.version());
  if (!parsed) {
    connection_.frame_was_unreadable(datagram.arrived_s);
    out.issues.push_back({"truncated", parsed.error().text()});
    return;
  }
  NatNetFrame frame = std::move(*parsed);
  const bool is_whole = frame.unread.empty() && reader.left() <= longest_end_bytes;
  const std::size_t given_before = out.frames.size();
  for (const std::string& unread : frame.unread)
    out.issues.push_back({"unread-section", "frame " + std::to_string(frame.number) + ": " + unread});
  if (frame.models_changed) connection_.want_model();
  if (frame.stamps) connection_.take_stamps(*frame.stamps, datagram.arrived_s);
  if (model_) {
    give(frame, datagram, out);
  } else {
    connection_.want_model();
    out.issues.push_back({"no-model",
                          "a frame arrived before the description of the skeletons, which is "
                          "requested at its command port"});
  }
  const bool gave_poses = out.frames.size() > given_before;
  if (gave_poses || is_whole) {
    connection_.frame_was_read(gave_poses, datagram.arrived_s);
    server_.sent_something_useful(datagram.arrived_s);
  } else {
    connection_.frame_was_unreadable(datagram.arrived_s);
  }
  frame.bodies.clear();
  newest_ = std::move(frame);
}

void NatNetDecoder::give(const NatNetFrame& frame, const Datagram& datagram, Decoded& out) {
  const bool has_time = frame.time_s && std::isfinite(*frame.time_s);
  if (frame.time_s && !has_time)
    out.issues.push_back({"not-finite", "frame " + std::to_string(frame.number) +
                                            ": its time stamp is not a number; it is taken as it came"});
  if (frame.skeletons.empty() && performers_.empty())
    out.issues.push_back(
        {"no-skeleton", "frames with " + std::to_string(frame.bodies.size()) +
                            " rigid bodies and no skeleton. In Motive create a skeleton, and tick Skeletons "
                            "in the streaming settings"});
  // However often a frame names a skeleton, described or not, it is worked on once.
  std::set<const NatNetPerformer*> done;
  bool was_unknown = false, was_repeated = false;
  for (const NatNetSkeletonFrame& skeleton : frame.skeletons) {
    NatNetPerformer* performer = performer_of(skeleton.id);
    if (!performer || !performer->has_bones_of(skeleton)) {
      connection_.want_model();
      if (std::exchange(was_unknown, true)) continue;
      out.issues.push_back({"unknown-skeleton", "the skeleton with the number " +
                                                    std::to_string(skeleton.id) + " and " +
                                                    std::to_string(skeleton.bones.size()) +
                                                    " bones is not the one described; the description is "
                                                    "requested again"});
      continue;
    }
    if (!done.insert(performer).second) {
      if (!std::exchange(was_repeated, true))
        out.issues.push_back({"repeated-skeleton", "frame " + std::to_string(frame.number) + " has " +
                                                       in_quotes(performer->name()) +
                                                       " more than once; the first is taken"});
      continue;
    }
    std::optional<Positions> positions = performer->positions(skeleton, out.issues);
    if (!positions) continue;  // not tracked
    PerformerFrame given;
    given.performer = performer->name();
    given.points = performer->points();
    given.positions = std::move(*positions);
    given.counter = frame.number;
    if (has_time) given.sender_time_s = frame.time_s;
    given.first_arrived_s = given.arrived_s = datagram.arrived_s;
    out.frames.push_back(std::move(given));
  }
}

void NatNetDecoder::pass_time(double now_s, Decoded& out) {
  connection_.ask(now_s, out.replies);
  if (!first_s_) first_s_ = now_s;
  const bool is_silent = connection_.server() && now_s - frame_s_.value_or(*first_s_) > 2;
  if (!is_silent || now_s - told_s_.value_or(*first_s_) < silence_text_every_s) return;
  told_s_ = now_s;
  out.issues.push_back(
      {"no-frames", connection_.server()->text() +
                        " answers but sends no frames: tick Broadcast Frame Data (Motive 3: Enable) in the "
                        "streaming settings, go live or play a take, and see that the local interface "
                        "there is not loopback" +
                        (wanted_group() ? "; frames are multicast, which Wi-Fi and containers often do "
                                          "not pass on: set the transmission type to Unicast"
                                        : "")});
}

std::optional<Endpoint> NatNetDecoder::wanted_group() const {
  const auto& server = connection_.server();
  if (options_.group) {
    Endpoint group = *options_.group;
    if (server) group.port = server->data_port;
    return group;
  }
  if (!server || !server->multicast || server->group == 0) return std::nullopt;
  return Endpoint{server->group, server->data_port};
}

std::vector<std::string> NatNetDecoder::facts() const {
  std::vector<std::string> facts;
  if (connection_.server()) {
    facts.push_back(connection_.server()->text());
    if (connection_.server()->version > newest_natnet)
      facts.push_back("that is newer than " + newest_natnet.text() + ", as which it is read");
  }
  if (!options_.group)
    if (const auto group = wanted_group())
      facts.push_back("frames come to the multicast group " + group->text() + ", as the server says");
  for (const NatNetPerformer& performer : performers_) facts.push_back(performer.fact());
  if (model_ && !model_->rigid_bodies.empty())
    facts.push_back(std::to_string(model_->rigid_bodies.size()) + " rigid bodies beside the skeletons");
  if (newest_.labelled_markers + newest_.unlabelled_markers > 0)
    facts.push_back(std::to_string(newest_.labelled_markers) + " labelled markers (" +
                    std::to_string(newest_.occluded_markers) + " occluded), " +
                    std::to_string(newest_.unlabelled_markers) + " unlabelled");
  if (const std::string latency = connection_.latency(); !latency.empty()) facts.push_back(latency);
  return facts;
}

}  // namespace

Result<std::unique_ptr<StreamDecoder>> make_natnet_decoder(const StreamUri& uri) {
  Result<NatNetOptions> options = parse_natnet_options(uri);
  if (!options) return options.error();
  const bool knows_host = !uri.host.empty() && uri.host != "0.0.0.0";
  return std::unique_ptr<StreamDecoder>(std::make_unique<NatNetDecoder>(*options, knows_host));
}

}  // namespace abrazo
