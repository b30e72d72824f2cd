#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace abrazo {

/// "192.168.1.7" of an IPv4 address in host byte order.
std::string address_text(std::uint32_t address);

/// An IPv4 address and port.
struct Endpoint {
  std::uint32_t address = 0;  ///< host byte order; 0 = any
  std::uint16_t port = 0;

  std::string text() const;                           ///< "192.168.1.7:39539"
  auto operator<=>(const Endpoint&) const = default;  // NOLINT(modernize-use-nullptr): the check errs
};

/// A received UDP packet.
struct Datagram {
  Endpoint from;
  double arrived_s = 0;  ///< session clock; from the kernel's stamp if available
  std::span<const std::uint8_t> bytes;
};

/// A UDP packet to send.
struct OutgoingDatagram {
  Endpoint to;
  std::vector<std::uint8_t> bytes;
};

}  // namespace abrazo
