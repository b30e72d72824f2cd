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

/// This machine's address on the network that routes to `peer`; 0 if there is no route.
std::uint32_t address_towards(const Endpoint& peer);

/// A non-blocking IPv4 UDP socket. Used by one thread.
class UdpSocket {
 public:
  /// @param local address 0 = every interface, port 0 = any free port
  /// @param shared other programs may use the port too (multicast)
  /// @return an Error that names the holder of the port and a free port
  static Result<UdpSocket> bind(const Endpoint& local, bool shared = false);
  UdpSocket(UdpSocket&& other) noexcept;
  UdpSocket& operator=(UdpSocket&& other) noexcept;
  ~UdpSocket();

  /// @param interface_address 0 = chosen by the system's routing
  Status join(std::uint32_t group, std::uint32_t interface_address);
  /// Sets the interface for outgoing multicast; 0 = chosen by the system's routing.
  Status send_through(std::uint32_t interface_address);

  /// Connects the socket: `send` then reports if no program listens there, and only packets from there are
  /// received.
  void hear_refusals_of(const Endpoint& peer);

  Endpoint local() const;

  struct Received {
    Endpoint from;
    double arrived_s = 0;    ///< session clock, from the kernel's stamp
    std::size_t size = 0;    ///< bytes received
    bool truncated = false;  ///< the packet was larger than the buffer
  };
  /// Receives the next packet. @return none if there is none, an Error if the socket failed
  Result<std::optional<Received>> receive(std::span<std::uint8_t> buffer, const SessionClock& clock);

  /// Sends a packet or fails immediately. An Error says why it was not accepted
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

/// Whether an interface of this machine has the address; 0 = any address.
bool has_address(std::uint32_t address);

/// For a connection to a peer: a socket bound to this machine's address on the network that now routes there;
/// at its previous port if that is free.
/// @param before present binding; address 0 = none yet
/// @return none if the binding is still right, or there is no route
Result<std::optional<UdpSocket>> socket_towards(const Endpoint& peer, const Endpoint& before);

/// Sleeps until one of several sockets has a packet, or until woken.
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
