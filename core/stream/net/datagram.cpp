#include "core/stream/net/datagram.hpp"

namespace abrazo {

std::string address_text(std::uint32_t address) {
  std::string text;
  for (int shift = 24; shift >= 0; shift -= 8)
    text += std::to_string((address >> shift) & 0xFFU) + (shift > 0 ? "." : "");
  return text;
}

std::string Endpoint::text() const {
  return address_text(address) + ":" + std::to_string(port);
}

}  // namespace abrazo
