#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/stream/protocol/stream_decoder.hpp"

namespace abrazo::test {

/// A frame of the simplest protocol there could be, so that tests of what comes after decoding depend on
/// none.
struct PlainFrame {
  std::string performer = "Ana";
  std::optional<std::int64_t> counter;
  std::optional<double> time_s;
  Pose pose = Pose::Zero();
};

std::vector<std::uint8_t> plain_packet(const PlainFrame& frame);

/// Reads them. What does not begin with "PLAIN" is an issue "other-protocol".
class PlainDecoder : public StreamDecoder {
 public:
  void take(const Datagram& datagram, Decoded& out) override;
  void pass_time(double now_s, Decoded& out) override;
  void calibrate(const std::string& performer) override { calibrated = performer; }
  std::vector<std::string> facts() const override { return {"plain"}; }

  std::optional<std::string> calibrated;
};

/// The frame that a decoder would give.
PerformerFrame performer_frame(const PlainFrame& frame, double arrived_s);

}  // namespace abrazo::test
