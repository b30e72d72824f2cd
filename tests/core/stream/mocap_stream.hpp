#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/motion/body/clip.hpp"
#include "core/stream/protocol/stream_decoder.hpp"
#include "core/stream/protocol/stream_encoder.hpp"

namespace abrazo::test {

/// A packet as text writes it: pairs of hexadecimal digits, anything else between them is ignored up to the
/// end of a line that begins a remark with '#'.
std::vector<std::uint8_t> bytes_of(std::string_view hex);

/// A decoder and what came of it.
struct Listener {
  explicit Listener(std::string_view uri);

  void take(std::span<const std::uint8_t> packet, double at_s = 0);
  void pass_time(double now_s) { decoder->pass_time(now_s, out); }
  void forget() { out = {}; }

  bool has_issue(std::string_view kind) const;
  std::string issues() const;
  bool has_fact(std::string_view part) const;
  /// Of the newest frame; not finite when there is no such point.
  Vec3 point(std::string_view name) const;

  std::unique_ptr<StreamDecoder> decoder;
  Decoded out;
};

/// Answers a decoder's requests by an encoder, as the network would. @return the number of requests
std::size_t converse(Listener& listener, StreamEncoder& server, double now_s);

/// Distance of each of the 25 joints from where it was sent [m], by joint: mean and largest over a clip.
struct RoundTrip {
  std::array<double, joint_count> mean{}, largest{};
  std::size_t frames = 0;
  std::string joint_map;
};
RoundTrip round_trip(const Clip& clip, Listener& listener, StreamEncoder& encoder, bool asks);

/// Ten seconds of a generated salsa, its leader.
Clip demo_clip();

/// Packets that differ from one of `good` in one to five bytes, or in length. @return frames that came of
/// them
std::size_t feed_mutations(Listener& listener, const std::vector<std::vector<std::uint8_t>>& good, int count,
                           unsigned seed);

}  // namespace abrazo::test
