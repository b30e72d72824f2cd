#include "core/stream/pose_sink.hpp"

#include <array>
#include <chrono>
#include <map>
#include <mutex>
#include <optional>

#include "core/stream/udp_socket.hpp"

namespace abrazo {

namespace {

constexpr std::uint16_t natnet_data_port = 1511;
constexpr double asker_is_forgotten_s = 10;  ///< who receives frames asks again about once a second
constexpr std::size_t most_askers = 32;
constexpr int questions_at_once = 16;
constexpr std::size_t largest_question = 2048;

/// Whether packets to the address come to this machine.
bool is_own_address(std::uint32_t address) {
  return address == 0 || UdpSocket::bind({address, 0}).ok();
}

class UdpPoseSink : public PoseSink {
 public:
  UdpPoseSink(std::unique_ptr<StreamEncoder> encoder, UdpSocket socket, std::optional<Endpoint> receiver,
              SinkHealth health, bool answers)
      : encoder_(std::move(encoder)),
        socket_(std::move(socket)),
        receiver_(receiver),
        answers_(answers),
        health_(std::move(health)) {}

  void send(const OutgoingPose& pose) override {
    if (answers_) answer_askers();
    const auto packets = encoder_->packets(pose);
    std::uint64_t bytes = 0, sent = 0, failures = 0;
    std::string failure;
    for (const auto& packet : packets) {
      for (const Endpoint& to : receivers()) {
        const Status done = socket_.send(to, packet);
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

  SinkHealth health() const override {
    const std::scoped_lock lock(mutex_);
    return health_;
  }

 private:
  std::vector<Endpoint> receivers() const {
    std::vector<Endpoint> all;
    if (receiver_) all.push_back(*receiver_);
    for (const auto& [asker, asked_s] : askers_) all.push_back(asker);
    return all;
  }

  void answer_askers() {
    std::array<std::uint8_t, largest_question> buffer;
    for (int i = 0; i < questions_at_once; ++i) {
      const auto received = socket_.receive(buffer, clock_);
      if (!received || !*received) break;
      const UdpSocket::Received& question = **received;
      std::vector<OutgoingDatagram> answers;
      const Datagram datagram{question.from, question.arrived_s, std::span(buffer).first(question.size)};
      const bool wants_frames = !question.truncated && encoder_->answer(datagram, answers);
      if (wants_frames && (askers_.contains(question.from) || askers_.size() < most_askers))
        askers_[question.from] = question.arrived_s;
      for (const OutgoingDatagram& answer : answers)
        if (const Status sent = socket_.send(answer.to, answer.bytes); !sent)
          note_failure(sent.error().text());
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
  UdpSocket socket_;
  std::optional<Endpoint> receiver_;  ///< who gets frames without asking
  bool answers_;
  SessionClock clock_;
  std::map<Endpoint, double> askers_;  ///< when each asked last
  mutable std::mutex mutex_;
  SinkHealth health_;  ///< guarded by `mutex_`
};

/// A NatNet server: listens for askers on the URI's port of this machine; frames go to them, and to the group
/// where there is one.
Result<UdpSocket> open_server(const StreamUri& uri, std::uint32_t host, std::optional<Endpoint>& receiver) {
  Result<UdpSocket> socket = UdpSocket::bind({host, uri.port});
  if (!socket) return socket.error();
  const std::string group = uri.option("multicast");
  if (group.empty()) return socket;
  const Result<std::uint32_t> address = resolve_host(group);
  if (!address) return address.error();
  const std::string network = uri.option("interface");
  const Result<std::uint32_t> through = network.empty() ? Result<std::uint32_t>(host) : resolve_host(network);
  if (!through) return through.error();
  if (*through != 0)
    if (const Status chosen = socket->send_through(*through); !chosen) return chosen.error();
  receiver = Endpoint{*address, natnet_data_port};
  return socket;
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
  const bool is_server = uri.scheme == StreamUri::Scheme::NatNet && is_own_address(*host);
  if (!is_server && (*host == 0 || uri.port == 0))
    return Error{"it is not said who receives: write the receiver's address and port", uri.text};
  std::optional<Endpoint> receiver;
  // Answers are taken from the network that leads to the receiver alone.
  Result<UdpSocket> socket = is_server ? open_server(uri, *host, receiver)
                                       : UdpSocket::bind({address_towards({*host, uri.port}), 0});
  if (!socket) return socket.error();
  if (!is_server) {
    receiver = Endpoint{*host, uri.port};
    if (uri.scheme != StreamUri::Scheme::NatNet) socket->hear_refusals_of(*receiver);
  }
  SinkHealth health;
  health.uri = uri.text;
  health.character = std::move(character);
  return std::unique_ptr<PoseSink>(std::make_unique<UdpPoseSink>(std::move(*encoder), std::move(*socket),
                                                                 receiver, std::move(health),
                                                                 uri.scheme == StreamUri::Scheme::NatNet));
}

}  // namespace abrazo
