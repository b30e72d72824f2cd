#include <gtest/gtest.h>

#include "core/stream/natnet/natnet_frame.hpp"
#include "core/stream/protocol/byte_reader.hpp"
#include "core/stream/protocol/stream_encoder.hpp"
#include "core/stream/send/encoders.hpp"
#include "tests/core/stream/mocap_stream.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::encoder_body_test {
namespace {

/// A sender whose character becomes a taller one, beside one who was that from the start.
class EncoderBody : public testing::TestWithParam<const char*> {
 protected:
  static Body taller() {
    Body body = body_of(test::standing_pose());
    for (double& length : body.bone_lengths) length *= 1.1;
    for (double& length : body.pseudo_lengths) length *= 1.1;
    return body;
  }
  std::unique_ptr<StreamEncoder> encoder(const Body& body) const {
    return std::move(*make_stream_encoder(*parse_stream_uri(GetParam()), body));
  }
  static OutgoingPose pose(double time_s) { return {test::standing_pose(), time_s, true}; }
};

TEST_P(EncoderBody, PosesAfterAChangeOfBonesAreSentAsWithThemFromTheStart) {
  const auto changing = encoder(body_of(test::standing_pose())), always = encoder(taller());
  EXPECT_NE(changing->packets(pose(0)), always->packets(pose(0)));
  changing->set_body(taller());
  changing->packets(pose(1)), always->packets(pose(1));
  EXPECT_EQ(changing->packets(pose(2)), always->packets(pose(2)));
}

INSTANTIATE_TEST_SUITE_P(Protocols, EncoderBody,
                         testing::Values("vmc://127.0.0.1:39539", "natnet://h", "xsens://127.0.0.1:9763"));

TEST(XsensBody, ANewOneIsDescribedWithTheNextPose) {
  const auto encoder = std::move(
      *make_stream_encoder(*parse_stream_uri("xsens://127.0.0.1:9763"), body_of(test::standing_pose())));
  const std::size_t described = encoder->packets({test::standing_pose(), 0, true}).size();
  const std::size_t plain = encoder->packets({test::standing_pose(), 0.1, true}).size();
  ASSERT_LT(plain, described);
  encoder->set_body(body_of(Pose(1.1 * test::standing_pose())));
  EXPECT_EQ(encoder->packets({test::standing_pose(), 0.2, true}).size(), described);
  encoder->restart();
  EXPECT_EQ(encoder->packets({test::standing_pose(), 0.3, true}).size(), described);
}

TEST(NatNetBody, FramesSayThatTheModelChangedAndWhoAsksGetsTheNewOne) {
  const auto changing =
      std::move(*make_stream_encoder(*parse_stream_uri("natnet://h"), body_of(test::standing_pose())));
  const auto says_change = [&](double time_s) {
    const auto packets = changing->packets({test::standing_pose(), time_s, true});
    ByteReader reader(packets.at(0), ByteOrder::Little);
    parse_natnet_head(reader);
    return parse_natnet_frame(reader, {4, 1})->models_changed;
  };
  EXPECT_FALSE(says_change(0));
  changing->set_body(body_of(Pose(1.1 * test::standing_pose())));
  EXPECT_TRUE(says_change(0.1));
  EXPECT_TRUE(says_change(0.2)) << "packets get lost";
  EXPECT_FALSE(says_change(1));
}

}  // namespace
}  // namespace abrazo::encoder_body_test
