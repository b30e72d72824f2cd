#include "core/stream/natnet/natnet_connection.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "core/stream/net/usual_ports.hpp"

namespace abrazo {

namespace {

constexpr double connect_every_s = 1, model_every_s = 0.25, keep_alive_every_s = 1, echo_every_s = 5;
/// After this time without packets the server may be another one, or restarted.
constexpr double reconnect_after_s = 2;
/// Unreadable frames for this time, about six at 60 Hz, indicate another version than stated.
constexpr double doubt_after_s = 0.1;
constexpr double connect_in_doubt_every_s = 0.25;
/// An answer takes milliseconds; later packets are not answers.
constexpr double answer_within_s = 2;
/// Arrivals have the kernel's stamps: an answer may seem to come before its question by this.
constexpr double stamps_differ_s = 0.05;
/// Poses read within it show that the version is right.
constexpr double reading_within_s = 0.5;
constexpr double smoothing = 0.05;

bool is_answer(const std::optional<double>& asked_s, double arrived_s) {
  return asked_s && arrived_s >= *asked_s - stamps_differ_s && arrived_s - *asked_s <= answer_within_s;
}

bool is_due(const std::optional<double>& last, double now_s, double every_s) {
  return !last || now_s - *last >= every_s || now_s < *last;
}

void smooth(double& value, double sample, bool& has_value) {
  value += (has_value ? smoothing : 1.0) * (sample - value);
  has_value = true;
}

}  // namespace

NatNetConnection::NatNetConnection(bool knows_host, std::optional<NatNetVersion> given_version)
    : knows_host_(knows_host), given_version_(given_version) {}

std::optional<NatNetVersion> NatNetConnection::version() const {
  if (given_version_) return given_version_;
  return server_ ? std::optional(server_->version) : std::nullopt;
}

void NatNetConnection::set_server_place(const Endpoint& from) {
  server_place_ = {from.address, natnet_command_port};
}

bool NatNetConnection::expects_server_info(double arrived_s) const {
  return !connect_answered_ && is_answer(connect_s_, arrived_s);
}

std::optional<StreamIssue> NatNetConnection::take_server_info(const NatNetServerInfo& info,
                                                              double arrived_s) {
  const bool says_something_new = server_ != info;
  if (!expects_server_info(arrived_s)) {
    if (!says_something_new) return std::nullopt;
    return StreamIssue{"unasked-answer",
                       "something says unasked that the server is " + info.text() +
                           "; that is not taken. If the server was changed, it is asked after a silence"};
  }
  const bool reads_poses = poses_s_ && arrived_s - *poses_s_ < reading_within_s;
  if (server_ && info.version != server_->version && reads_poses)
    return StreamIssue{"contradiction", "an answer says " + info.text() + ", but frames of " +
                                            server_->text() + " are being read; that is not taken"};
  if (!server_ || is_reconnecting_) want_model_now();
  connect_answered_ = true;
  is_reconnecting_ = is_in_doubt_ = false;
  unreadable_since_s_.reset();
  heard_s_ = arrived_s;
  server_ = info;
  return std::nullopt;
}

bool NatNetConnection::expects_model(double arrived_s) const {
  return wants_model_ && is_answer(model_s_, arrived_s);
}

void NatNetConnection::take_model(double arrived_s) {
  wants_model_ = false;
  heard_s_ = arrived_s;
}

void NatNetConnection::want_model_now() {
  wants_model_ = true;
  model_s_.reset();
}

void NatNetConnection::frame_was_read(bool gave_poses, double arrived_s) {
  heard_s_ = arrived_s;
  unreadable_since_s_.reset();
  if (gave_poses) poses_s_ = arrived_s;
}

void NatNetConnection::frame_was_unreadable(double arrived_s) {
  if (!unreadable_since_s_) unreadable_since_s_ = arrived_s;
  if (arrived_s - *unreadable_since_s_ >= doubt_after_s) doubt_version();
}

void NatNetConnection::take_echo(ByteReader& reader, double arrived_s) {
  const double sent_s = reader.f64("our time stamp");
  const std::uint64_t server_ticks = reader.u64("the server's time stamp");
  if (reader.failed() || !server_ || server_->clock_hz == 0) return;
  if (sent_s != echo_s_) return;  // not the last request
  heard_s_ = arrived_s;
  if (!(sent_s <= arrived_s && arrived_s - sent_s < 1)) return;  // late: no measure of anything
  server_minus_session_s_ =
      static_cast<double>(server_ticks) / static_cast<double>(server_->clock_hz) - (sent_s + arrived_s) / 2;
}

void NatNetConnection::take_stamps(const NatNetStamps& stamps, double arrived_s) {
  if (!server_ || server_->clock_hz == 0) return;
  const auto seconds = [&](std::uint64_t ticks) {
    return static_cast<double>(ticks) / static_cast<double>(server_->clock_hz);
  };
  constexpr double longest_s = 10;  // a longer one is a stamp that was not set
  if (stamps.transmit >= stamps.mid_exposure)
    if (const double delay = seconds(stamps.transmit - stamps.mid_exposure); delay < longest_s)
      smooth(sending_latency_s_, delay, has_sending_latency_);
  if (server_minus_session_s_)
    if (const double delay = arrived_s - (seconds(stamps.transmit) - *server_minus_session_s_);
        std::abs(delay) < longest_s)
      smooth(network_latency_s_, delay, has_network_latency_);
}

void NatNetConnection::request(NatNetMessage id, std::vector<OutgoingDatagram>& out) const {
  const Endpoint to = knows_host_ ? Endpoint{} : server_place_;
  out.push_back({to, natnet_request(id, id == NatNetMessage::Connect ? "Ping" : "")});
}

void NatNetConnection::ask(double now_s, std::vector<OutgoingDatagram>& out) {
  if (!knows_host_ && server_place_.address == 0) return;
  if (server_ && heard_s_ && now_s - *heard_s_ > reconnect_after_s) {
    is_reconnecting_ = true;
    server_minus_session_s_.reset();
  }
  const double every_s = is_in_doubt_ ? connect_in_doubt_every_s : connect_every_s;
  if ((!server_ || is_reconnecting_) && is_due(connect_s_, now_s, every_s)) {
    connect_s_ = now_s;
    connect_answered_ = false;
    request(NatNetMessage::Connect, out);
  }
  if (!server_ && !given_version_) return;
  if (wants_model_ && is_due(model_s_, now_s, model_every_s)) {
    model_s_ = now_s;
    request(NatNetMessage::RequestModelDef, out);
  }
  if (is_due(keep_alive_s_, now_s, keep_alive_every_s)) {
    keep_alive_s_ = now_s;
    request(NatNetMessage::KeepAlive, out);
  }
  if (server_ && server_->clock_hz > 0 && is_due(echo_s_, now_s, echo_every_s)) {
    echo_s_ = now_s;
    ByteWriter payload(ByteOrder::Little);
    payload.f64(now_s);
    out.push_back(
        {knows_host_ ? Endpoint{} : server_place_, natnet_packet(NatNetMessage::EchoRequest, payload)});
  }
}

std::string NatNetConnection::latency() const {
  if (!has_sending_latency_) return {};
  std::array<char, 96> text{};
  if (has_network_latency_)
    std::snprintf(text.data(), text.size(), "from exposure to sending %.1f ms, network %.1f ms",
                  1000 * sending_latency_s_, 1000 * network_latency_s_);
  else
    std::snprintf(text.data(), text.size(), "from exposure to sending %.1f ms", 1000 * sending_latency_s_);
  return text.data();
}

}  // namespace abrazo
