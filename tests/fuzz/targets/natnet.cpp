#include "core/motion/body/body.hpp"
#include "core/stream/natnet/natnet_frame.hpp"
#include "core/stream/natnet/natnet_model.hpp"
#include "core/stream/protocol/stream_encoder.hpp"
#include "core/stream/send/encoders.hpp"
#include "tests/fuzz/stream_checks.hpp"
#include "tests/support/bodies.hpp"

namespace fuzz = abrazo::fuzz;

namespace {

/// What a server makes of questions.
void ask(fuzz::Bytes bytes) {
  const auto uri = abrazo::parse_stream_uri("natnet://127.0.0.1");
  static const abrazo::Body body = abrazo::body_of(abrazo::test::standing_pose());
  const auto encoder = abrazo::make_stream_encoder(*uri, body);
  double now_s = 1;
  fuzz::each_packet(bytes, [&](fuzz::Bytes packet, double elapsed_s) {
    std::vector<abrazo::OutgoingDatagram> answers;
    (void)(*encoder)->answer({{0x7f000001, 50'000}, now_s += elapsed_s, packet}, answers);
    fuzz::expect(answers.size() < 16, "one question and many answers");
  });
}

}  // namespace

/// Every packet as a frame and as a model of every version of the bit stream, then all of them as a stream,
/// whose version its own packets say, and as questions to a server.
ABRAZO_FUZZ_TARGET(natnet)(fuzz::Bytes bytes) {
  fuzz::each_packet(bytes, [](fuzz::Bytes packet, double) {
    if (packet.size() < abrazo::natnet_head_bytes) return;
    const fuzz::Bytes payload = packet.subspan(abrazo::natnet_head_bytes);
    for (const abrazo::NatNetVersion version :
         {abrazo::NatNetVersion{3, 0}, {3, 1}, {4, 0}, {4, 1}, {4, 2}}) {
      abrazo::ByteReader frame(payload, abrazo::ByteOrder::Little, abrazo::natnet_head_bytes);
      (void)fuzz::accepted(abrazo::parse_natnet_frame(frame, version));
      abrazo::ByteReader model(payload, abrazo::ByteOrder::Little, abrazo::natnet_head_bytes);
      (void)fuzz::accepted(abrazo::parse_natnet_model(model, version));
    }
  });
  ask(bytes);
  fuzz::receive("natnet://127.0.0.1", bytes);
}
