#include "tests/core/stream/plain_stream.hpp"

#include <cstring>

#include "core/motion/body/joint_set.hpp"

namespace abrazo::test {

namespace {

constexpr std::string_view magic = "PLAIN";

std::shared_ptr<const std::vector<std::string>> joint_points() {
  static const auto points =
      std::make_shared<const std::vector<std::string>>(joint_names.begin(), joint_names.end());
  return points;
}

template <typename Value>
void put(std::vector<std::uint8_t>& bytes, const Value& value) {
  std::uint8_t raw[sizeof(Value)];
  std::memcpy(raw, &value, sizeof raw);
  bytes.insert(bytes.end(), raw, raw + sizeof raw);
}

template <typename Value>
Value taken(std::span<const std::uint8_t>& bytes) {
  Value value;
  std::memcpy(&value, bytes.data(), sizeof value);
  bytes = bytes.subspan(sizeof value);
  return value;
}

}  // namespace

std::vector<std::uint8_t> plain_packet(const PlainFrame& frame) {
  std::vector<std::uint8_t> bytes(magic.begin(), magic.end());
  put(bytes, static_cast<std::uint8_t>(frame.performer.size()));
  bytes.insert(bytes.end(), frame.performer.begin(), frame.performer.end());
  put(bytes, static_cast<std::uint8_t>((frame.counter ? 1 : 0) + (frame.time_s ? 2 : 0)));
  put(bytes, frame.counter.value_or(0));
  put(bytes, frame.time_s.value_or(0));
  for (int i = 0; i < frame.pose.size(); ++i) put(bytes, frame.pose.data()[i]);
  return bytes;
}

PerformerFrame performer_frame(const PlainFrame& frame, double arrived_s) {
  return {frame.performer, {}, joint_points(), frame.pose, frame.counter, frame.time_s, arrived_s, arrived_s};
}

void PlainDecoder::take(const Datagram& datagram, Decoded& out) {
  std::span<const std::uint8_t> bytes = datagram.bytes;
  if (bytes.size() < magic.size() + 1 || std::memcmp(bytes.data(), magic.data(), magic.size()) != 0) {
    out.issues.push_back({"other-protocol", "does not begin with PLAIN"});
    return;
  }
  bytes = bytes.subspan(magic.size());
  PlainFrame frame;
  const auto length = taken<std::uint8_t>(bytes);
  if (bytes.size() != length + 1U + 16U + sizeof(double) * 3 * joint_count) {
    out.issues.push_back({"truncated", "is not as long as a plain frame"});
    return;
  }
  frame.performer.assign(bytes.begin(), bytes.begin() + length);
  bytes = bytes.subspan(length);
  const auto flags = taken<std::uint8_t>(bytes);
  const auto counter = taken<std::int64_t>(bytes);
  const auto time_s = taken<double>(bytes);
  if ((flags & 1U) != 0) frame.counter = counter;
  if ((flags & 2U) != 0) frame.time_s = time_s;
  for (int i = 0; i < frame.pose.size(); ++i) frame.pose.data()[i] = taken<double>(bytes);
  out.frames.push_back(performer_frame(frame, datagram.arrived_s));
}

void PlainDecoder::pass_time(double /*now_s*/, Decoded& /*out*/) {}

}  // namespace abrazo::test
