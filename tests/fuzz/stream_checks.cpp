#include "tests/fuzz/stream_checks.hpp"

#include <algorithm>

#include "core/stream/receive/decoders.hpp"
#include "core/stream/receive/pose_reader.hpp"
#include "core/stream/receive/stream_pipeline.hpp"

namespace abrazo::fuzz {

namespace {

constexpr std::size_t most_performers = 256;

void expect_sound(const StreamPipeline::Output& out) {
  for (const ReceivedPose& received : out.poses)
    expect(received.pose.pose.allFinite(), "a received pose is not finite");
  for (const OutgoingDatagram& reply : out.replies)
    expect(reply.bytes.size() < 65'508, "a reply that is too long");
}

}  // namespace

void receive(std::string_view uri_text, Bytes bytes) {
  const auto uri = parse_stream_uri(uri_text);
  auto decoder = make_stream_decoder(*uri);
  const auto options = performer_options(*uri, {});
  double now_s = 1;
  StreamPipeline pipeline(std::move(*decoder), *uri, *options, now_s);
  PoseReader reader("");
  std::size_t packets = 0;
  each_packet(bytes, [&](Bytes packet, double elapsed_s) {
    now_s += elapsed_s;
    StreamPipeline::Output out;
    const auto port = static_cast<std::uint16_t>(50'000 + (packets % 8 == 7 ? 1 : 0));
    pipeline.take({{0x7f000001, port}, now_s, packet}, now_s, out);
    if (++packets % 4 == 0) pipeline.pass_time(now_s += 0.01, out);
    if (packets == 3) pipeline.calibrate("", 0.02, now_s);
    expect_sound(out);
    if (const auto pose = reader.poll(pipeline, now_s))
      expect(pose->pose.allFinite(), "a pose that is not finite");
  });
  StreamPipeline::Output out;
  pipeline.pass_time(now_s + 1, out);
  expect_sound(out);
  (void)pipeline.health(now_s + 1);
  (void)pipeline.observe(now_s + 1);
  expect(pipeline.performers().size() <= most_performers, "more performers than anybody can look at");
}

}  // namespace abrazo::fuzz
