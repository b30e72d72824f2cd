#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/stream/net/udp_socket.hpp"
#include "core/stream/protocol/stream_uri.hpp"

namespace abrazo {

/// The sockets of a received stream: one that also sends requests, and one for a multicast group if there is
/// one. Used by one thread, except `wake`.
class StreamSockets {
 public:
  /// VMC and Xsens listen at the URI; NatNet connects to the server at the URI from any port on the network
  /// that routes to it, and follows changes of that network. An Error if there is no route.
  static Result<StreamSockets> open(const StreamUri& uri);

  /// Sleeps until a packet arrives or the time is over. @return whether one arrived
  bool wait(int at_most_ms);
  void wake() { wait_->wake(); }

  enum class Packet {
    Whole,
    Truncated,    ///< larger than the buffer
    OfAStranger,  ///< from another machine than the named server
  };
  using Take = std::function<void(const Datagram&, Packet)>;
  /// Passes on the received packets, at most some hundreds. @return an Error if a socket failed
  Status receive(const SessionClock& clock, const Take& take);
  /// Address or port 0 means the URI's. If this machine's address on the route changed, the socket is
  /// replaced, and joined groups are left.
  Status reply(const OutgoingDatagram& datagram);
  /// Joins on the network that routes to the sender. No effect if that was tried already.
  Status join(const Endpoint& group);

  /// The only accepted server, "192.168.1.5"; empty if all senders are accepted.
  std::string server() const;
  std::string listening() const;
  /// The listening address if this machine no longer has it and nothing arrives; or empty.
  std::string lost_address() const;
  Endpoint local() const { return main_.local(); }
  std::uint64_t overflowed() const;

 private:
  StreamSockets(UdpSocket main, Endpoint peer, std::uint32_t interface_address, bool follows_network);
  Status follow_network();
  bool is_stranger(const Endpoint& from);

  UdpSocket main_;
  std::optional<UdpSocket> group_socket_;
  Endpoint peer_, group_;
  bool peer_is_here_;                                    ///< on this machine
  std::uint32_t own_address_ = 0, foreign_address_ = 0;  ///< results of the last look-up
  Status joined_ = Done{};
  std::uint32_t interface_address_;
  bool follows_network_;  ///< to the peer; false if an interface was named
  std::uint64_t overflowed_before_ = 0;
  std::unique_ptr<SocketWait> wait_;
  std::vector<std::uint8_t> buffer_;
};

}  // namespace abrazo
