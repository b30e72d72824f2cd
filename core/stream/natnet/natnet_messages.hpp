#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/stream/net/usual_ports.hpp"
#include "core/stream/protocol/byte_reader.hpp"
#include "core/stream/protocol/byte_writer.hpp"

namespace abrazo {

/// First number of a NatNet packet (docs/guide/live/natnet.md).
enum class NatNetMessage : std::uint16_t {
  Connect = 0,
  ServerInfo = 1,
  Request = 2,
  Response = 3,
  RequestModelDef = 4,
  ModelDef = 5,
  RequestFrame = 6,
  Frame = 7,
  MessageString = 8,
  Disconnect = 9,
  KeepAlive = 10,
  DisconnectByTimeout = 11,
  EchoRequest = 12,
  EchoResponse = 13,
  Discovery = 14,
  Unrecognized = 100
};

/// Bit stream version; determines the fields of a packet.
struct NatNetVersion {
  int major = 0, minor = 0;
  std::string text() const { return std::to_string(major) + "." + std::to_string(minor); }
  auto operator<=>(const NatNetVersion&) const = default;
};

inline constexpr NatNetVersion oldest_natnet{3, 0};
/// The newest known version; newer ones are read as this one.
inline constexpr NatNetVersion newest_natnet{4, 2};

/// From this version on every section states its size in bytes.
inline constexpr NatNetVersion natnet_with_section_sizes{4, 1};

/// "3.1" -> 3, 1; none if it is not a version from 3.0 to 4.2.
std::optional<NatNetVersion> parse_natnet_version(std::string_view text);

/// "239.255.42.99" -> host byte order; none if it is not a multicast group.
std::optional<std::uint32_t> parse_natnet_group(std::string_view text);

/// From 224.0.0.0 to 239.255.255.255. @param address  host byte order
constexpr bool is_multicast_group(std::uint32_t address) {
  return address >> 28 == 0xE;
}

struct NatNetServerInfo {
  std::string application;  ///< "Motive"
  int application_version[4]{};
  NatNetVersion version;
  std::uint64_t clock_hz = 0;  ///< of the high-resolution time stamps
  std::uint16_t data_port = natnet_data_port;
  bool multicast = false;
  std::uint32_t group = 0;  ///< IPv4, host byte order

  std::string text() const;  ///< "Motive 3.1.0, NatNet 4.1"
  bool operator==(const NatNetServerInfo&) const = default;
};

/// Reads the payload after the packet's header. Check `reader.failed()` afterwards.
NatNetServerInfo parse_natnet_server_info(ByteReader& reader);
void write_natnet_server_info(ByteWriter& writer, const NatNetServerInfo& info);

/// Header of a packet: type and size of the payload.
struct NatNetHead {
  std::uint16_t id = 0;
  std::uint16_t payload_bytes = 0;
};
inline constexpr std::size_t natnet_head_bytes = 4;
NatNetHead parse_natnet_head(ByteReader& reader);

/// A complete packet. @throws std::invalid_argument if the payload is too long for the header
std::vector<std::uint8_t> natnet_packet(NatNetMessage id, const ByteWriter& payload);
/// A request without contents; servers expect at least the zero byte of an empty string.
std::vector<std::uint8_t> natnet_request(NatNetMessage id, std::string_view text = {});

}  // namespace abrazo
