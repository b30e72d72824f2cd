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

/// Element of a packet as a flat list: begins and ends of bundles, and messages, in order.
struct OscElement {
  enum class Kind { Message, BundleBegin, BundleEnd };
  Kind kind = Kind::Message;
  std::size_t offset = 0;      ///< of its first byte in the packet (for an end: after the last byte)
  std::uint64_t time_tag = 0;  ///< of the begin of a bundle: NTP time, or `osc_immediately`
  std::string address;         ///< of a message: "/VMC/Ext/T"
  std::vector<OscArgument> arguments;
};

inline constexpr std::uint64_t osc_immediately = 1;

/// Invalid OSC in a packet; the affected part is left out.
struct OscIssue {
  std::string kind;        ///< "not-osc", "truncated", "bad-bundle", "bad-message"
  std::size_t offset = 0;  ///< in the packet [bytes]
  std::string text;        ///< found and expected content
};

struct OscPacket {
  std::vector<OscElement> elements;
  std::vector<OscIssue> issues;  ///< at most `most_osc_issues`
};

inline constexpr std::size_t most_osc_issues = 16;
inline constexpr int deepest_osc_bundle = 8;

/// Reads OSC 1.0 from untrusted bytes: never reads beyond them, keeps valid messages before and after an
/// invalid one as far as lengths permit, and closes every opened bundle.
OscPacket read_osc(std::span<const std::uint8_t> bytes);

/// Writes one message, or one bundle with its content (including bundles). Strings must not contain NUL.
/// @throws std::invalid_argument if the list is neither
std::vector<std::uint8_t> write_osc(std::span<const OscElement> elements);

OscElement osc_message(std::string address, std::vector<OscArgument> arguments);
OscElement osc_bundle_begin(std::uint64_t time_tag = osc_immediately);
OscElement osc_bundle_end();

}  // namespace abrazo
