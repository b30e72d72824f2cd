#include "tests/core/stream/mocap_stream.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <random>

#include "core/choreography/salsa.hpp"
#include "core/motion/joints/joint_map.hpp"
#include "core/stream/receive/decoders.hpp"

namespace abrazo::test {

std::vector<std::uint8_t> bytes_of(std::string_view hex) {
  std::vector<std::uint8_t> bytes;
  int high = -1;
  bool is_remark = false;
  for (const char c : hex) {
    is_remark = (is_remark || c == '#') && c != '\n';
    if (is_remark || std::isxdigit(static_cast<unsigned char>(c)) == 0) continue;
    const int digit = c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10;
    if (high >= 0) bytes.push_back(static_cast<std::uint8_t>(16 * high + digit));
    high = high < 0 ? digit : -1;
  }
  EXPECT_LT(high, 0) << "an odd number of digits";
  return bytes;
}

Listener::Listener(std::string_view uri) {
  const auto parsed = parse_stream_uri(uri);
  if (!parsed) throw std::invalid_argument(parsed.error().text());
  auto made = make_stream_decoder(*parsed);
  if (!made) throw std::invalid_argument(made.error().text());
  decoder = std::move(*made);
}

void Listener::take(std::span<const std::uint8_t> packet, double at_s) {
  decoder->take({{0x7F000001, 1510}, at_s, packet}, out);
}

bool Listener::has_issue(std::string_view kind) const {
  return std::any_of(out.issues.begin(), out.issues.end(),
                     [&](const StreamIssue& issue) { return issue.kind == kind; });
}

std::string Listener::issues() const {
  std::string text;
  for (const StreamIssue& issue : out.issues) text += issue.kind + ": " + issue.text + "\n";
  return text;
}

bool Listener::has_fact(std::string_view part) const {
  const auto facts = decoder->facts();
  return std::any_of(facts.begin(), facts.end(),
                     [&](const std::string& fact) { return fact.find(part) != std::string::npos; });
}

Vec3 Listener::point(std::string_view name) const {
  const Vec3 none = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  if (out.frames.empty()) return none;
  const PerformerFrame& frame = out.frames.back();
  const auto found = std::find(frame.points->begin(), frame.points->end(), name);
  return found == frame.points->end() ? none : Vec3(frame.positions.row(found - frame.points->begin()));
}

std::size_t converse(Listener& listener, StreamEncoder& server, double now_s) {
  std::size_t requests = 0;
  for (bool asked = true; asked;) {
    listener.pass_time(now_s);
    const auto questions = std::exchange(listener.out.replies, {});
    asked = !questions.empty();
    for (const OutgoingDatagram& question : questions) {
      std::vector<OutgoingDatagram> answers;
      server.answer({{0x7F000001, 50000}, now_s, question.bytes}, answers);
      for (const OutgoingDatagram& answer : answers) listener.take(answer.bytes, now_s);
      ++requests;
    }
  }
  return requests;
}

RoundTrip round_trip(const Clip& clip, Listener& listener, StreamEncoder& encoder, bool asks) {
  RoundTrip result;
  std::optional<JointBinding> binding;
  for (std::size_t f = 0; f < clip.poses.size(); ++f) {
    const double time_s = static_cast<double>(f) / clip.fps;
    if (asks) converse(listener, encoder, time_s);
    listener.forget();
    for (const auto& packet : encoder.packets({clip.poses[f], time_s, true})) listener.take(packet, time_s);
    EXPECT_EQ(listener.out.frames.size(), 1u) << "frame " << f << "\n" << listener.issues();
    if (listener.out.frames.size() != 1) return result;
    const PerformerFrame& frame = listener.out.frames[0];
    if (!binding)
      for (const JointMap& map : builtin_joint_maps()) {
        binding = bind_joints(map, *frame.points);
        result.joint_map = map.name;
        if (binding->missing.empty()) break;
      }
    const Pose back = binding->joints_of(frame.positions);
    for (std::size_t j = 0; j < joint_count; ++j) {
      const auto row = static_cast<Eigen::Index>(j);
      const double error = (back.row(row) - clip.poses[f].row(row)).norm();
      result.mean[j] += error / static_cast<double>(clip.poses.size());
      // A value that is not finite must not pass for a small one.
      result.largest[j] = error <= result.largest[j] ? result.largest[j] : error;
    }
    ++result.frames;
  }
  return result;
}

Clip demo_clip() {
  ChoreographyOptions options;
  options.minutes = 0.2;
  return generate_salsa(options).front().a;
}

std::size_t feed_mutations(Listener& listener, const std::vector<std::vector<std::uint8_t>>& good, int count,
                           unsigned seed) {
  std::mt19937 random(seed);
  std::size_t frames = 0;
  std::vector<std::uint8_t> packet;
  for (int i = 0; i < count; ++i) {
    packet = good[random() % good.size()];
    const std::size_t changes = 1 + random() % 5;
    for (std::size_t c = 0; c < changes; ++c) {
      // Heads and counts stand in front; there a change does most.
      const std::size_t range = random() % 2 == 0 ? packet.size() : std::min<std::size_t>(packet.size(), 64);
      static constexpr std::array<std::uint8_t, 4> telling = {0x00, 0x7F, 0x80, 0xFF};
      packet[random() % range] =
          random() % 2 == 0 ? telling[random() % 4] : static_cast<std::uint8_t>(random());
    }
    if (random() % 4 == 0) packet.resize(random() % (packet.size() + 1));
    listener.take(packet, 0.001 * i);
    if (i % 50 == 0) listener.pass_time(0.001 * i);
    frames += listener.out.frames.size();
    for (const StreamIssue& issue : listener.out.issues) EXPECT_FALSE(issue.text.empty()) << issue.kind;
    listener.forget();
  }
  return frames;
}

}  // namespace abrazo::test
