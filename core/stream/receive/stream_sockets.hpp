#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/stream/net/udp_socket.hpp"
#include "core/stream/protocol/stream_uri.hpp"

namespace abrazo {

/// The sockets of a stream that is received: the one that also talks to the sender, and one for a multicast
/// group where there is one. Used by one thread, but for `wake`.
class StreamSockets {
 public:
  /// VMC and Xsens listen where the URI says; NatNet talks to the server there from any port of the network
  /// that leads to it, also when that becomes another. An Error when no network does.
  static Result<StreamSockets> open(const StreamUri& uri);

  /// Sleeps until a packet came, at most so long. @return whether one came
  bool wait(int at_most_ms);
  void wake() { wait_->wake(); }

  enum class Packet {
    Whole,
    Truncated,    ///< larger than what can be taken
    OfAStranger,  ///< a server was named, and this is from another machine
  };
  using Take = std::function<void(const Datagram&, Packet)>;
  /// Hands over what has come, at most some hundreds of packets. @return an Error when a socket is broken
  Status receive(const SessionClock& clock, const Take& take);
  /// An address or port of 0 stands for the URI's. The machine may have another address on the way there than
  /// before: then the socket is another one, and no group is joined any more.
  Status reply(const OutgoingDatagram& datagram);
  /// Joins on the network that the sender is reached through. Nothing happens when that was tried already.
  Status join(const Endpoint& group);

  /// The server that alone is heard, "192.168.1.5"; empty when everybody is.
  std::string server() const;
  std::string listening() const;
  /// The address that is listened at when this machine has it no longer, and nothing comes in; or empty.
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
  std::uint32_t own_address_ = 0, foreign_address_ = 0;  ///< of this machine or not: looked up last
  Status joined_ = Done{};
  std::uint32_t interface_address_;
  bool follows_network_;  ///< to the peer; not when an interface was named
  std::uint64_t overflowed_before_ = 0;
  std::unique_ptr<SocketWait> wait_;
  std::vector<std::uint8_t> buffer_;
};

}  // namespace abrazo
