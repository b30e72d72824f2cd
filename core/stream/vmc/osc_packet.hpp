#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace abrazo {

/// One argument of an OSC message, by its type tag.
struct OscArgument {
  char type = 'f';  ///< i h f d: `number`; T F: `number` is 1 or 0; s S: `text`; others carry no value here
  double number = 0;
  std::string text;

  static OscArgument of(float value) { return {'f', static_cast<double>(value), {}}; }
  static OscArgument of(std::int32_t value) { return {'i', static_cast<double>(value), {}}; }
  static OscArgument of(std::string value) { return {'s', 0, std::move(value)}; }
  bool operator==(const OscArgument&) const = default;
};

/// A packet is read as a flat list: where bundles begin and end, and the messages between, in their order.
struct OscElement {
  enum class Kind { Message, BundleBegin, BundleEnd };
  Kind kind = Kind::Message;
  std::size_t offset = 0;      ///< in the packet, of its first byte (of an end: behind the last)
  std::uint64_t time_tag = 0;  ///< of a bundle that begins: NTP time, or `osc_immediately`
  std::string address;         ///< of a message: "/VMC/Ext/T"
  std::vector<OscArgument> arguments;
};

inline constexpr std::uint64_t osc_immediately = 1;

/// Something in a packet that is not OSC; what it concerns is left out.
struct OscIssue {
  std::string kind;        ///< "not-osc", "truncated", "bad-bundle", "bad-message"
  std::size_t offset = 0;  ///< in the packet [bytes]
  std::string text;        ///< what was found there and what was expected
};

struct OscPacket {
  std::vector<OscElement> elements;
  std::vector<OscIssue> issues;  ///< at most `most_osc_issues`, however bad the packet
};

inline constexpr std::size_t most_osc_issues = 16;
inline constexpr int deepest_osc_bundle = 8;

/// Reads OSC 1.0. Bytes may be anything: never reads beyond them, keeps every good message in front of and
/// behind a bad one as far as lengths tell where that is, and closes every bundle it opened.
OscPacket read_osc(std::span<const std::uint8_t> bytes);

/// One message, or one bundle with what is in it (bundles too). Strings must not hold NUL.
/// @throws std::invalid_argument when the list is neither
std::vector<std::uint8_t> write_osc(std::span<const OscElement> elements);

OscElement osc_message(std::string address, std::vector<OscArgument> arguments);
OscElement osc_bundle_begin(std::uint64_t time_tag = osc_immediately);
OscElement osc_bundle_end();

}  // namespace abrazo
