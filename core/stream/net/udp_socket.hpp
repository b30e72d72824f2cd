#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/base/session_clock.hpp"
#include "core/stream/net/arrival_clock.hpp"
#include "core/stream/net/datagram.hpp"

namespace abrazo {

/// The IPv4 address of a name or of "192.168.1.7". May wait for the name server.
Result<std::uint32_t> resolve_host(const std::string& host);

/// This machine's own address on the network that packets to `peer` go through; 0 when there is no way to it.
std::uint32_t address_towards(const Endpoint& peer);

/// An IPv4 UDP socket that never waits. Used by one thread.
class UdpSocket {
 public:
  /// @param local   address 0 = every interface, port 0 = any that is free
  /// @param shared  other programs may have the port as well (multicast)
  /// @return an Error that says who holds the port and which one is free
  static Result<UdpSocket> bind(const Endpoint& local, bool shared = false);
  UdpSocket(UdpSocket&& other) noexcept;
  UdpSocket& operator=(UdpSocket&& other) noexcept;
  ~UdpSocket();

  /// @param interface_address  0 = the one the system routes the group through
  Status join(std::uint32_t group, std::uint32_t interface_address);
  /// Multicast goes out through it; 0 = as the system routes.
  Status send_through(std::uint32_t interface_address);

  /// From now on `send` reports if no program listens there; nothing is received but from there.
  void hear_refusals_of(const Endpoint& peer);

  Endpoint local() const;

  struct Received {
    Endpoint from;
    double arrived_s = 0;    ///< session clock, by the kernel's stamp
    std::size_t size = 0;    ///< of what was kept
    bool truncated = false;  ///< the packet was larger than the buffer
  };
  /// The next packet, if there is one. @return nothing when there is none, an Error when the socket is broken
  Result<std::optional<Received>> receive(std::span<std::uint8_t> buffer, const SessionClock& clock);

  /// Hands a packet to the network or fails immediately. @return why it was not taken
  Status send(const Endpoint& to, std::span<const std::uint8_t> bytes);

  /// Packets that the kernel dropped because the buffer was full, since the socket was bound.
  std::uint64_t overflowed() const { return overflowed_; }
  int descriptor() const { return descriptor_; }

 private:
  explicit UdpSocket(int descriptor) : descriptor_(descriptor) {}
  int descriptor_ = -1;
  std::uint32_t last_overflow_ = 0;
  std::uint64_t overflowed_ = 0;
  ArrivalClock arrivals_;
};

/// Whether a network of this machine has the address; 0 stands for every one.
bool has_address(std::uint32_t address);

/// Of whoever talks to a peer: a socket at this machine's address on the network that leads there now, and on
/// no other network; at the port it had where that is free.
/// @param before  where its socket is; none yet: address 0
/// @return nothing when that is still right, or no network leads there
Result<std::optional<UdpSocket>> socket_towards(const Endpoint& peer, const Endpoint& before);

/// Sleeps until one of some sockets has a packet, or until it is woken.
class SocketWait {
 public:
  SocketWait();
  ~SocketWait();
  SocketWait(const SocketWait&) = delete;
  SocketWait& operator=(const SocketWait&) = delete;

  /// @return whether there is something to receive
  bool wait(std::span<const int> descriptors, int at_most_ms);
  /// From any thread; the next `wait` returns immediately.
  void wake();

 private:
  int event_ = -1;
};

}  // namespace abrazo
