#include "core/stream/net/udp_socket.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <system_error>
#include <utility>

#include "core/stream/net/port_owner.hpp"

namespace abrazo {

namespace {

/// Some seconds of the fastest stream; the kernel limits the size.
constexpr int receive_buffer_bytes = 4 << 20;
constexpr int ports_to_try = 20;

std::string reason() {
  return std::system_category().message(errno);
}

sockaddr_in to_system(const Endpoint& endpoint) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(endpoint.port);
  address.sin_addr.s_addr = htonl(endpoint.address);
  return address;
}

Endpoint from_system(const sockaddr_in& address) {
  return {ntohl(address.sin_addr.s_addr), ntohs(address.sin_port)};
}

/// The socket interface wants every address as this.
sockaddr* generic(sockaddr_in& address) {
  return static_cast<sockaddr*>(static_cast<void*>(&address));
}

template <typename Value>
bool set_option(int descriptor, int level, int name, const Value& value) {
  return ::setsockopt(descriptor, level, name, &value, sizeof value) == 0;
}

bool bind_to(int descriptor, const Endpoint& local) {
  sockaddr_in address = to_system(local);
  return ::bind(descriptor, generic(address), sizeof address) == 0;
}

/// The next higher free port; nothing when all those tried are taken.
std::optional<std::uint16_t> free_port_after(Endpoint local) {
  for (int i = 0; i < ports_to_try && local.port < 65535; ++i) {
    ++local.port;
    const int probe = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    const bool is_free = probe >= 0 && bind_to(probe, local);
    if (probe >= 0) ::close(probe);
    if (is_free) return local.port;
  }
  return std::nullopt;
}

Error why_not_bound(const Endpoint& local) {
  const int failure = errno;
  const std::string port = std::to_string(local.port);
  if (failure == EADDRINUSE) {
    const auto free = free_port_after(local);
    return Error{
        "port " + port + " is held by " + describe_port_owner(local.port) + "; end it, or take " +
            (free ? "port " + std::to_string(*free) + ", which is free" : std::string("another port")),
        local.text()};
  }
  if (failure == EADDRNOTAVAIL)
    return Error{"no network of this machine has that address; listen on 0.0.0.0:" + port +
                     " (every network) or 127.0.0.1:" + port + " (this machine only)",
                 local.text()};
  if (failure == EACCES)
    return Error{"the system does not let this user take port " + port + "; take one above 1023",
                 local.text()};
  errno = failure;
  return Error{"cannot be listened on: " + reason(), local.text()};
}

double seconds(const timespec& time) {
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double wall_now_s() {
  timespec wall{};
  ::clock_gettime(CLOCK_REALTIME, &wall);
  return seconds(wall);
}

/// Both clocks at one moment, as near as the system lets us.
std::pair<double, double> wall_and_session_s(const SessionClock& clock) {
  constexpr double soon_s = 1e-3;
  constexpr int attempts = 3;
  double wall_s = 0, before_s = clock.now_s(), after_s = before_s;
  for (int i = 0; i < attempts; ++i, before_s = after_s) {
    wall_s = wall_now_s();
    after_s = clock.now_s();
    if (after_s - before_s < soon_s) break;
  }
  return {wall_s, after_s};
}

}  // namespace

Result<std::uint32_t> resolve_host(const std::string& host) {
  addrinfo wanted{};
  wanted.ai_family = AF_INET;
  wanted.ai_socktype = SOCK_DGRAM;
  addrinfo* found = nullptr;
  if (const int failure = ::getaddrinfo(host.c_str(), nullptr, &wanted, &found); failure != 0)
    return Error{"no IPv4 address is known for this name (" + std::string(::gai_strerror(failure)) +
                     "); write the address itself",
                 host};
  sockaddr_in address{};
  std::memcpy(&address, found->ai_addr, std::min<std::size_t>(sizeof address, found->ai_addrlen));
  ::freeaddrinfo(found);
  return from_system(address).address;
}

std::uint32_t address_towards(const Endpoint& peer) {
  // Connecting a UDP socket sends nothing; it only makes the system choose the route.
  const int probe = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (probe < 0) return 0;
  set_option(probe, SOL_SOCKET, SO_BROADCAST, 1);  // or there is no route to a broadcast address
  sockaddr_in address = to_system(peer);
  sockaddr_in own{};
  socklen_t size = sizeof own;
  const bool known = ::connect(probe, generic(address), sizeof address) == 0 &&
                     ::getsockname(probe, generic(own), &size) == 0;
  ::close(probe);
  return known ? from_system(own).address : 0;
}

Result<UdpSocket> UdpSocket::bind(const Endpoint& local, bool shared) {
  UdpSocket socket(::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  const int descriptor = socket.descriptor_;
  if (descriptor < 0) return Error{"no socket is available: " + reason(), local.text()};
  // Without these options the stream still works: smaller buffer, read times, no count of dropped packets.
  set_option(descriptor, SOL_SOCKET, SO_RCVBUF, receive_buffer_bytes);
  set_option(descriptor, SOL_SOCKET, SO_TIMESTAMPNS, 1);
  set_option(descriptor, SOL_SOCKET, SO_RXQ_OVFL, 1);
  set_option(descriptor, SOL_SOCKET, SO_BROADCAST, 1);
  if (shared) {
    set_option(descriptor, SOL_SOCKET, SO_REUSEADDR, 1);
    set_option(descriptor, IPPROTO_IP, IP_MULTICAST_ALL, 0);  // only what this socket has joined
  }
  if (!bind_to(descriptor, local)) return why_not_bound(local);
  return socket;
}

UdpSocket::UdpSocket(UdpSocket&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      last_overflow_(other.last_overflow_),
      overflowed_(other.overflowed_),
      arrivals_(other.arrivals_) {}

UdpSocket& UdpSocket::operator=(UdpSocket&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(last_overflow_, other.last_overflow_);
  std::swap(overflowed_, other.overflowed_);
  std::swap(arrivals_, other.arrivals_);
  return *this;
}

UdpSocket::~UdpSocket() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Status UdpSocket::join(std::uint32_t group, std::uint32_t interface_address) {
  ip_mreq membership{};
  membership.imr_multiaddr.s_addr = htonl(group);
  membership.imr_interface.s_addr = htonl(interface_address);
  if (set_option(descriptor_, IPPROTO_IP, IP_ADD_MEMBERSHIP, membership)) return Done{};
  return Error{
      "the multicast group cannot be joined (" + reason() +
          "); name the network with interface=ADDRESS of this machine, or have the sender use unicast",
      Endpoint{group, local().port}.text()};
}

Status UdpSocket::send_through(std::uint32_t interface_address) {
  in_addr address{};
  address.s_addr = htonl(interface_address);
  if (set_option(descriptor_, IPPROTO_IP, IP_MULTICAST_IF, address)) return Done{};
  return Error{"multicast cannot go out there: " + reason(), Endpoint{interface_address, 0}.text()};
}

void UdpSocket::hear_refusals_of(const Endpoint& peer) {
  // Without it sending works as well, but a refusal is not reported (broadcast, multicast).
  sockaddr_in address = to_system(peer);
  [[maybe_unused]] const int connected = ::connect(descriptor_, generic(address), sizeof address);
}

Endpoint UdpSocket::local() const {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  ::getsockname(descriptor_, generic(address), &size);
  return from_system(address);
}

Result<std::optional<UdpSocket::Received>> UdpSocket::receive(std::span<std::uint8_t> buffer,
                                                              const SessionClock& clock) {
  sockaddr_in from{};
  alignas(cmsghdr) std::array<std::uint8_t, 256> control{};
  iovec place{buffer.data(), buffer.size()};
  msghdr message{};
  message.msg_name = &from;
  message.msg_namelen = sizeof from;
  message.msg_iov = &place;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  const ssize_t size = ::recvmsg(descriptor_, &message, 0);
  if (size < 0) {
    // A refusal is the answer to something sent before; it does not concern what comes in.
    if (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR || errno == ECONNREFUSED)
      return std::optional<Received>();
    return Error{"receiving failed: " + reason(), local().text()};
  }
  Received received{from_system(from), clock.now_s(), static_cast<std::size_t>(size),
                    (message.msg_flags & MSG_TRUNC) != 0};
  for (cmsghdr* part = CMSG_FIRSTHDR(&message); part != nullptr; part = CMSG_NXTHDR(&message, part)) {
    if (part->cmsg_level != SOL_SOCKET) continue;
    if (part->cmsg_type == SO_TIMESTAMPNS) {
      timespec stamp{};
      std::memcpy(&stamp, CMSG_DATA(part), sizeof stamp);
      const auto [wall_s, now_s] = wall_and_session_s(clock);
      received.arrived_s = arrivals_.arrived_s(seconds(stamp), wall_s, now_s);
    } else if (part->cmsg_type == SO_RXQ_OVFL) {
      std::uint32_t total = 0;
      std::memcpy(&total, CMSG_DATA(part), sizeof total);
      overflowed_ += static_cast<std::uint32_t>(total - last_overflow_);  // the kernel's counter may wrap
      last_overflow_ = total;
    }
  }
  return std::optional<Received>(received);
}

Status UdpSocket::send(const Endpoint& to, std::span<const std::uint8_t> bytes) {
  sockaddr_in address = to_system(to);
  const auto hand_over = [&] {
    return ::sendto(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL, generic(address), sizeof address);
  };
  const ssize_t size = hand_over();
  if (size == static_cast<ssize_t>(bytes.size())) return Done{};
  if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == ENOBUFS))
    return Error{"the network does not take packets as fast as they are sent; lower the rate", to.text()};
  if (size < 0 && errno == ECONNREFUSED) {
    // The refusal was of a packet before; this one was not sent yet.
    [[maybe_unused]] const ssize_t again = hand_over();
    return Error{"no program listens there; start the receiver or correct the port", to.text()};
  }
  if (size < 0 && (errno == ENETUNREACH || errno == EHOSTUNREACH))
    return Error{"there is no way to that address; is the network connected?", to.text()};
  if (size < 0 && errno == EMSGSIZE) return Error{"a packet is too large for the network", to.text()};
  return Error{"sending failed: " + reason(), to.text()};
}

bool has_address(std::uint32_t address) {
  const int probe = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const bool is_missing = probe >= 0 && !bind_to(probe, {address, 0}) && errno == EADDRNOTAVAIL;
  if (probe >= 0) ::close(probe);
  return !is_missing;
}

Result<std::optional<UdpSocket>> socket_towards(const Endpoint& peer, const Endpoint& before) {
  const std::uint32_t own = address_towards(peer);
  if (own == 0 || own == before.address) return std::optional<UdpSocket>();
  auto socket = UdpSocket::bind({own, before.port});
  if (!socket && before.port != 0) socket = UdpSocket::bind({own, 0});
  if (!socket) return socket.error();
  return std::optional<UdpSocket>(std::move(*socket));
}

SocketWait::SocketWait() : event_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}

SocketWait::~SocketWait() {
  if (event_ >= 0) ::close(event_);
}

bool SocketWait::wait(std::span<const int> descriptors, int at_most_ms) {
  std::vector<pollfd> watched{{event_, POLLIN, 0}};
  for (const int descriptor : descriptors) watched.push_back({descriptor, POLLIN, 0});
  if (::poll(watched.data(), watched.size(), at_most_ms) <= 0) return false;
  if (watched.front().revents != 0) {
    std::uint64_t calls = 0;
    [[maybe_unused]] const ssize_t read = ::read(event_, &calls, sizeof calls);
  }
  return std::any_of(watched.begin() + 1, watched.end(), [](const pollfd& one) { return one.revents != 0; });
}

void SocketWait::wake() {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(event_, &one, sizeof one);
}

}  // namespace abrazo
