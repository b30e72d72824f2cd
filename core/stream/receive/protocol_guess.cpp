#include <algorithm>
#include <string_view>

#include "core/stream/receive/stream_diagnosis.hpp"

namespace abrazo {

namespace {

bool begins_with(std::string_view text, std::string_view beginning) {
  return text.substr(0, beginning.size()) == beginning;
}

/// u16 id, u16 size of what follows, little-endian.
bool looks_like_natnet(const std::array<std::uint8_t, 16>& bytes, std::size_t packet_size) {
  const std::size_t id = bytes[0] + 256U * bytes[1];
  const std::size_t payload = bytes[2] + 256U * bytes[3];
  return packet_size >= 4 && (id <= 14 || id == 100) && payload + 4 == packet_size;
}

}  // namespace

std::optional<std::string> protocol_of(const std::array<std::uint8_t, 16>& first_bytes, std::size_t count,
                                       std::size_t packet_size) {
  std::string text;
  for (std::size_t i = 0; i < std::min(count, first_bytes.size()); ++i)
    text += static_cast<char>(first_bytes[i]);
  if (begins_with(text, "MXTP")) return "Xsens MVN (MXTP)";
  if (begins_with(text, "#bundle") || begins_with(text, "/VMC")) return "VMC (OSC)";
  if (begins_with(text, "/")) return "OSC";
  if (begins_with(text, "{") || begins_with(text, "\x04\x22\x4D\x18")) return "Rokoko (JSON)";
  if (begins_with(text, "\xFF\xDD") || begins_with(text, "\xDD\xFF")) return "Noitom (binary BVH)";
  if (begins_with(text, "vrpn")) return "VRPN";
  if (begins_with(text, "GET ") || begins_with(text, "POST") || begins_with(text, "HTTP")) return "HTTP";
  if (looks_like_natnet(first_bytes, packet_size)) return "NatNet";
  return std::nullopt;
}

}  // namespace abrazo
