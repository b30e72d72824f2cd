#include "core/stream/receive/stream_sockets.hpp"

#include <array>

#include "core/stream/net/usual_ports.hpp"

namespace abrazo {

namespace {

constexpr int packets_at_once = 256;
constexpr std::size_t largest_packet = 65536;  ///< none over IPv4 is larger

}  // namespace

StreamSockets::StreamSockets(UdpSocket main, Endpoint peer, std::uint32_t interface_address,
                             bool follows_network)
    : main_(std::move(main)),
      peer_(peer),
      peer_is_here_(peer.address != 0 && has_address(peer.address)),
      interface_address_(interface_address),
      follows_network_(follows_network),
      wait_(std::make_unique<SocketWait>()),
      buffer_(largest_packet) {}

Result<StreamSockets> StreamSockets::open(const StreamUri& uri) {
  const Result<std::uint32_t> host = resolve_host(uri.host);
  if (!host) return host.error();
  std::uint32_t interface_address = 0;
  if (const std::string name = uri.option("interface"); !name.empty()) {
    const Result<std::uint32_t> address = resolve_host(name);
    if (!address) return address.error();
    interface_address = *address;
  }
  const Endpoint written{*host, uri.port};
  const bool talks_to_server = uri.scheme == StreamUri::Scheme::NatNet && written.address != 0;
  const bool follows_network = talks_to_server && interface_address == 0;
  if (follows_network) interface_address = address_towards(written);
  if (talks_to_server && interface_address == 0)
    return Error{"there is no way to that address; is the network connected?", uri.text};
  Endpoint local = written;
  if (talks_to_server)
    local = Endpoint{interface_address, 0};  // not on the other networks of this machine
  else if (uri.scheme == StreamUri::Scheme::NatNet && local.port == natnet_command_port)
    local.port = natnet_data_port;  // without a server for requests it only waits for frames
  // Who waits for frames without a server shares the port with the group's socket.
  const bool is_shared = uri.scheme == StreamUri::Scheme::NatNet && !talks_to_server;
  Result<UdpSocket> socket = UdpSocket::bind(local, is_shared);
  if (!socket) return socket.error();
  return StreamSockets(std::move(*socket), talks_to_server ? written : Endpoint{}, interface_address,
                       follows_network);
}

bool StreamSockets::wait(int at_most_ms) {
  std::array<int, 2> descriptors{main_.descriptor(), group_socket_ ? group_socket_->descriptor() : -1};
  return wait_->wait(std::span(descriptors).first(group_socket_ ? 2 : 1), at_most_ms);
}

Status StreamSockets::receive(const SessionClock& clock, const Take& take) {
  for (UdpSocket* const socket : {&main_, group_socket_ ? &*group_socket_ : nullptr}) {
    for (int i = 0; socket != nullptr && i < packets_at_once; ++i) {
      const auto received = socket->receive(buffer_, clock);
      if (!received) return received.error();
      if (!*received) break;
      const UdpSocket::Received& packet = **received;
      take(Datagram{packet.from, packet.arrived_s, std::span(buffer_).first(packet.size)},
           is_stranger(packet.from) ? Packet::OfAStranger
           : packet.truncated       ? Packet::Truncated
                                    : Packet::Whole);
    }
  }
  return Done{};
}

/// A server on this machine may answer from any of its addresses.
bool StreamSockets::is_stranger(const Endpoint& from) {
  if (peer_.address == 0 || from.address == peer_.address) return false;
  if (!peer_is_here_) return true;
  if (from.address == own_address_) return false;
  if (from.address == foreign_address_) return true;
  const bool is_own = has_address(from.address);
  (is_own ? own_address_ : foreign_address_) = from.address;
  return !is_own;
}

Status StreamSockets::reply(const OutgoingDatagram& datagram) {
  Endpoint to = datagram.to;
  if (to.address == 0) to.address = peer_.address;
  if (to.port == 0) to.port = peer_.port;
  if (to.address == 0) return Done{};  // no one to answer: the URI names no server
  if (follows_network_)
    if (Status followed = follow_network(); !followed) return followed;
  return main_.send(to, datagram.bytes);
}

/// After a new lease, or in another Wi-Fi, the socket would be at an address that nothing goes out from.
Status StreamSockets::follow_network() {
  auto moved = socket_towards(peer_, main_.local());
  if (!moved) return moved.error();
  if (!*moved) return Done{};
  overflowed_before_ = overflowed();
  main_ = std::move(**moved);
  interface_address_ = main_.local().address;
  group_socket_.reset();
  group_ = {};
  return Done{};
}

Status StreamSockets::join(const Endpoint& group) {
  if (group_ == group) return joined_;
  group_ = group;
  group_socket_.reset();
  // Bound to the group and not to every address: nothing else that is sent to the port comes in.
  Result<UdpSocket> socket = UdpSocket::bind(group, true);
  joined_ = socket ? socket->join(group.address, interface_address_) : Status(socket.error());
  if (joined_) group_socket_.emplace(std::move(*socket));
  return joined_;
}

std::string StreamSockets::server() const {
  return peer_.address == 0 ? std::string() : address_text(peer_.address);
}

std::string StreamSockets::listening() const {
  std::string text = main_.local().text();
  if (group_socket_) text += " and multicast " + group_.text();
  return text;
}

std::string StreamSockets::lost_address() const {
  const Endpoint local = main_.local();
  if (follows_network_ || has_address(local.address)) return {};
  const std::string text = local.text();
  return text.substr(0, text.find(':'));
}

std::uint64_t StreamSockets::overflowed() const {
  return overflowed_before_ + main_.overflowed() + (group_socket_ ? group_socket_->overflowed() : 0);
}

}  // namespace abrazo
