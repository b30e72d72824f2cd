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

/// One UDP packet as it came.
struct Datagram {
  Endpoint from;
  double arrived_s = 0;  ///< session clock; the kernel's stamp where it gives one
  std::span<const std::uint8_t> bytes;
};

/// One to be sent.
struct OutgoingDatagram {
  Endpoint to;
  std::vector<std::uint8_t> bytes;
};

}  // namespace abrazo
