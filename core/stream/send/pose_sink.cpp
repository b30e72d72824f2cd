#include "core/stream/send/pose_sink.hpp"

#include <array>
#include <chrono>
#include <map>
#include <mutex>
#include <optional>

#include "core/stream/net/udp_socket.hpp"
#include "core/stream/net/usual_ports.hpp"
#include "core/stream/send/encoders.hpp"

namespace abrazo {

namespace {

constexpr double asker_is_forgotten_s = 10;  ///< a receiver of frames requests them again about once a second
constexpr std::size_t most_askers = 32;
constexpr int questions_at_once = 16;
constexpr std::size_t largest_question = 2048;

/// Interval of checks for a changed route while sending works (e.g. a new tunnel).
constexpr double between_looks_s = 1;

/// What sends, to whom.
struct Outlet {
  std::optional<UdpSocket> socket;
  std::optional<Endpoint> receiver;  ///< receivers without requests
  /// The socket is bound to this machine's address on the network that routes to the receiver, and accepts
  /// answers only from there; there is no socket without a route.
  bool follows_network = false;
  bool hears_refusals = false;

  /// @return whether the socket changed; an Error if there is none
  Result<bool> follow_network() {
    auto moved = socket_towards(*receiver, socket ? socket->local() : Endpoint{});
    if (!moved) return moved.error();
    if (!*moved) return false;
    socket.emplace(std::move(**moved));
    if (hears_refusals) socket->hear_refusals_of(*receiver);
    return true;
  }
};

class UdpPoseSink : public PoseSink {
 public:
  UdpPoseSink(std::unique_ptr<StreamEncoder> encoder, Outlet outlet, SinkHealth health, bool answers)
      : encoder_(std::move(encoder)),
        outlet_(std::move(outlet)),
        answers_(answers),
        health_(std::move(health)) {}

  void send(const OutgoingPose& pose) override {
    look_at_network();
    if (answers_ && outlet_.socket) answer_askers();
    const auto packets = encoder_->packets(pose);
    std::uint64_t bytes = 0, sent = 0, failures = 0;
    std::string failure;
    for (const auto& packet : packets) {
      for (const Endpoint& to : receivers()) {
        const Status done = hand_over(to, packet);
        if (done) {
          bytes += packet.size();
          ++sent;
        } else {
          ++failures;
          failure = done.error().text();
        }
      }
    }
    const std::scoped_lock lock(mutex_);
    ++health_.frames;
    health_.packets += sent;
    health_.bytes += bytes;
    health_.failures += failures;
    if (failures > 0) health_.latest_failure = failure;
  }

  void set_body(const Body& body) override { encoder_->set_body(body); }

  SinkHealth health() const override {
    const std::scoped_lock lock(mutex_);
    return health_;
  }

 private:
  void look_at_network() {
    if (!outlet_.follows_network || clock_.now_s() - looked_s_ < between_looks_s) return;
    looked_s_ = clock_.now_s();
    if (const auto moved = outlet_.follow_network(); !moved) note_failure(moved.error().text());
  }

  /// From the address that this machine has now: the one before may be gone.
  Status hand_over(const Endpoint& to, std::span<const std::uint8_t> bytes) {
    Status done =
        outlet_.socket
            ? outlet_.socket->send(to, bytes)
            : Status(Error{"there is no way to that address; is the network connected?", to.text()});
    if (done || !outlet_.follows_network) return done;
    const auto moved = outlet_.follow_network();
    if (!moved) return moved.error();
    return *moved ? outlet_.socket->send(to, bytes) : done;
  }

  std::vector<Endpoint> receivers() const {
    std::vector<Endpoint> all;
    if (outlet_.receiver) all.push_back(*outlet_.receiver);
    for (const auto& [asker, asked_s] : askers_) all.push_back(asker);
    return all;
  }

  void answer_askers() {
    std::array<std::uint8_t, largest_question> buffer;
    for (int i = 0; i < questions_at_once; ++i) {
      const auto received = outlet_.socket->receive(buffer, clock_);
      if (!received || !*received) break;
      const UdpSocket::Received& question = **received;
      std::vector<OutgoingDatagram> answers;
      const Datagram datagram{question.from, question.arrived_s, std::span(buffer).first(question.size)};
      const bool wants_frames = !question.truncated && encoder_->answer(datagram, answers);
      if (wants_frames && (askers_.contains(question.from) || askers_.size() < most_askers))
        askers_[question.from] = question.arrived_s;
      for (const OutgoingDatagram& answer : answers)
        if (const Status sent = hand_over(answer.to, answer.bytes); !sent) note_failure(sent.error().text());
    }
    std::erase_if(askers_, [now_s = clock_.now_s()](const auto& asker) {
      return now_s - asker.second > asker_is_forgotten_s;
    });
  }

  void note_failure(const std::string& text) {
    const std::scoped_lock lock(mutex_);
    ++health_.failures;
    health_.latest_failure = text;
  }

  std::unique_ptr<StreamEncoder> encoder_;
  Outlet outlet_;
  bool answers_;
  SessionClock clock_;
  double looked_s_ = 0;                ///< whether the route is the same
  std::map<Endpoint, double> askers_;  ///< when each asked last
  mutable std::mutex mutex_;
  SinkHealth health_;  ///< guarded by `mutex_`
};

/// A NatNet server: listens for clients on the URI's port; frames go to them, and to the group if there is
/// one.
Result<Outlet> open_server(const StreamUri& uri, std::uint32_t host) {
  Result<UdpSocket> socket = UdpSocket::bind({host, uri.port});
  if (!socket) return socket.error();
  Outlet server;
  server.socket.emplace(std::move(*socket));
  const std::string group = uri.option("multicast");
  if (group.empty()) return server;
  const Result<std::uint32_t> address = resolve_host(group);
  if (!address) return address.error();
  const std::string network = uri.option("interface");
  const Result<std::uint32_t> through = network.empty() ? Result<std::uint32_t>(host) : resolve_host(network);
  if (!through) return through.error();
  if (*through != 0)
    if (const Status chosen = server.socket->send_through(*through); !chosen) return chosen.error();
  server.receiver = Endpoint{*address, natnet_data_port};
  return server;
}

/// For receivers without requests. The network may come up later.
Result<Outlet> open_towards(const StreamUri& uri, std::uint32_t host) {
  Outlet outlet;
  outlet.receiver = Endpoint{host, uri.port};
  outlet.follows_network = true;
  outlet.hears_refusals = uri.scheme != StreamUri::Scheme::NatNet;
  if (const auto opened = outlet.follow_network(); !opened) return opened.error();
  return outlet;
}

}  // namespace

Result<std::unique_ptr<PoseSink>> PoseSink::open(const StreamUri& uri, const Body& body,
                                                 std::string character) {
  if (const Status allowed = check_stream_options(uri, StreamDirection::Send); !allowed)
    return allowed.error();
  Result<std::unique_ptr<StreamEncoder>> encoder = make_stream_encoder(uri, body);
  if (!encoder) return encoder.error();
  const Result<std::uint32_t> host = resolve_host(uri.host);
  if (!host) return host.error();
  const bool is_server = uri.scheme == StreamUri::Scheme::NatNet && has_address(*host);
  if (!is_server && (*host == 0 || uri.port == 0))
    return Error{"the receiver is missing: write the receiver's address and port", uri.text};
  Result<Outlet> outlet = is_server ? open_server(uri, *host) : open_towards(uri, *host);
  if (!outlet) return outlet.error();
  SinkHealth health;
  health.uri = uri.text;
  health.character = std::move(character);
  return std::unique_ptr<PoseSink>(std::make_unique<UdpPoseSink>(
      std::move(*encoder), std::move(*outlet), std::move(health), uri.scheme == StreamUri::Scheme::NatNet));
}

}  // namespace abrazo
