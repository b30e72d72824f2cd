#include "core/stream/natnet/natnet_messages.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/base/text.hpp"

namespace abrazo {

namespace {

constexpr std::size_t application_name_bytes = 256;

}  // namespace

std::optional<NatNetVersion> parse_natnet_version(std::string_view text) {
  const auto parts = split_fields(text, '.');
  if (parts.size() != 2) return std::nullopt;
  const auto major = parse_integer(parts[0]);
  const auto minor = parse_integer(parts[1]);
  if (!major || !minor || *major < 0 || *major > 255 || *minor < 0 || *minor > 255) return std::nullopt;
  const NatNetVersion version{static_cast<int>(*major), static_cast<int>(*minor)};
  if (version < oldest_natnet || version > newest_natnet) return std::nullopt;
  return version;
}

std::string NatNetServerInfo::text() const {
  std::string text = application.empty() ? "unnamed server" : application;
  for (int i = 0; i < 3; ++i) text += (i == 0 ? " " : ".") + std::to_string(application_version[i]);
  return text + ", NatNet " + version.text();
}

std::optional<std::uint32_t> parse_natnet_group(std::string_view text) {
  std::uint32_t address = 0;
  const auto parts = split_fields(text, '.');
  if (parts.size() != 4) return std::nullopt;
  for (const std::string_view part : parts) {
    const auto number = parse_integer(part);
    if (!number || *number < 0 || *number > 255) return std::nullopt;
    address = address << 8 | static_cast<std::uint32_t>(*number);
  }
  return is_multicast_group(address) ? std::optional(address) : std::nullopt;
}

NatNetServerInfo parse_natnet_server_info(ByteReader& reader) {
  NatNetServerInfo info;
  const std::string name = reader.characters(application_name_bytes, "the application's name");
  for (const char c : name.substr(0, name.find('\0')))  // shown to people: no control characters
    info.application += static_cast<unsigned char>(c) < ' ' ? '?' : c;
  for (int& number : info.application_version) number = reader.u8("the application's version");
  info.version.major = reader.u8("the NatNet version");
  info.version.minor = reader.u8("the NatNet version");
  reader.skip(2, "the NatNet version");
  // Servers before 3.0 end here, and some of 3.0 or later too; the defaults apply then.
  if (reader.failed() || reader.left() < 15) return info;
  info.clock_hz = reader.u64("the clock's rate");
  info.data_port = reader.u16("the data port");
  info.multicast = reader.u8("the multicast flag") != 0;
  for (int i = 0; i < 4; ++i) info.group = info.group << 8 | reader.u8("the multicast group");
  return info;
}

void write_natnet_server_info(ByteWriter& writer, const NatNetServerInfo& info) {
  const auto byte = [](int number) { return static_cast<std::uint8_t>(number); };
  const std::string name = info.application.substr(0, application_name_bytes - 1);
  writer.characters(name);
  writer.zeros(application_name_bytes - name.size());
  for (const int number : info.application_version) writer.u8(byte(number));
  writer.u8(byte(info.version.major));
  writer.u8(byte(info.version.minor));
  writer.zeros(2);
  writer.u64(info.clock_hz);
  writer.u16(info.data_port);
  writer.u8(info.multicast ? 1 : 0);
  for (int i = 3; i >= 0; --i) writer.u8(static_cast<std::uint8_t>(info.group >> (8 * i)));
}

NatNetHead parse_natnet_head(ByteReader& reader) {
  NatNetHead head;
  head.id = reader.u16("the message's number");
  head.payload_bytes = reader.u16("the payload's size");
  return head;
}

std::vector<std::uint8_t> natnet_packet(NatNetMessage id, const ByteWriter& payload) {
  if (payload.size() > 0xFFFF) throw std::invalid_argument("natnet_packet: the payload has over 65535 bytes");
  ByteWriter packet(ByteOrder::Little);
  packet.u16(static_cast<std::uint16_t>(id));
  packet.u16(static_cast<std::uint16_t>(payload.size()));
  std::vector<std::uint8_t> bytes = packet.take();
  bytes.insert(bytes.end(), payload.bytes().begin(), payload.bytes().end());
  return bytes;
}

std::vector<std::uint8_t> natnet_request(NatNetMessage id, std::string_view text) {
  ByteWriter payload(ByteOrder::Little);
  payload.c_string(text);
  return natnet_packet(id, payload);
}

}  // namespace abrazo
