#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/stream/protocol/stream_health.hpp"

namespace abrazo::widgets {

/// What a person calls a stream: "VMC from 192.168.1.20", "VMC from this machine", "NatNet (Motive)
/// at 10.0.0.9", with the performer where packets bear names: "Ana, Xsens MVN from 10.0.0.4". Before the
/// first packet it has no sender. The local port is no part of it.
/// @param performer  whose poses are meant; empty = the stream as a whole
std::string stream_name(const StreamHealth& health, const std::string& performer = {});

/// State of a stream; each has a sign, a word and a colour.
enum class StreamMark { Off, Waiting, Good, Warning, Bad };

/// The state of a connection as a word and a line.
struct StreamHeadline {
  StreamMark mark = StreamMark::Off;
  std::string word;    ///< "receiving"
  std::string detail;  ///< "VMC from 192.168.1.20, on every network (0.0.0.0:39539)"
};
/// @param health null = not connected
StreamHeadline headline_of(const StreamHealth* health);

/// A number with its name; the number of decimals is constant, so that the text does not jump.
struct StreamFigure {
  std::string name, value;
  bool is_odd = false;  ///< higher than expected
  std::string help;
};
/// Figures of a performer, two per line.
std::vector<StreamFigure> figures_of(const PerformerHealth& performer);
/// "unity map · head at 1.62 m · calibrated"; a calibration in another pose is "doubtful" until the next.
std::string body_line(const PerformerHealth& performer);
/// "estimated: lowerneck, upperneck"; empty if all are sent.
std::string estimated_line(const PerformerHealth& performer);
/// Packets and bytes of the stream.
std::vector<StreamFigure> traffic_of(const StreamHealth& health);

/// "12 345 678"
std::string count_text(std::uint64_t count);
/// "17 bytes", "1.2 kB", "34.5 MB"
std::string byte_count_text(std::uint64_t bytes);
/// "56 4d 43 00  VMC."
std::string dump_text(std::span<const std::uint8_t> bytes);
/// Whether the stream has packets of an unknown protocol, with their `first_bytes`.
bool has_unknown_packets(const StreamHealth& health);

/// The whole health as text, for the clipboard or a support request.
std::string report_of(const StreamHealth& health);

}  // namespace abrazo::widgets
