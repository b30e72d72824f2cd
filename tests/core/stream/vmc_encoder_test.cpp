#include "core/stream/vmc/vmc_encoder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/stream/vmc/osc_packet.hpp"
#include "tests/core/stream/vmc_packets.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::vmc_encoder_test {
namespace {

using ::testing::HasSubstr;

std::unique_ptr<StreamEncoder> encoder(const std::string& options = "") {
  return std::move(make_vmc_encoder(*parse_stream_uri("vmc://127.0.0.1:39539" + options),
                                    body_of(test::standing_pose())))
      .value();
}

std::vector<std::string> addresses(const std::vector<std::uint8_t>& packet) {
  std::vector<std::string> words;
  for (const OscElement& element : read_osc(packet).elements)
    if (element.kind == OscElement::Kind::Message) words.push_back(element.address);
  return words;
}

TEST(VmcEncoder, SendsOneBundleThatEndsWithTime) {
  const auto packets = encoder()->packets({test::standing_pose(), 2, true});
  ASSERT_EQ(packets.size(), 1u);
  const auto words = addresses(packets[0]);
  EXPECT_EQ(words[0], "/VMC/Ext/Root/Pos");
  EXPECT_EQ(words[1], "/VMC/Ext/Bone/Pos");
  EXPECT_THAT(std::vector(words.end() - 3, words.end()),
              testing::ElementsAre("/VMC/Ext/Blend/Apply", "/VMC/Ext/OK", "/VMC/Ext/T"));
}

TEST(VmcEncoder, SendsBundlesOfTwelveBonesWhenAsked) {
  const auto packets = encoder("?framing=split")->packets({test::standing_pose(), 2, true});
  ASSERT_EQ(packets.size(), 2u);
  for (const auto& packet : packets) {
    EXPECT_LE(packet.size(), 1500u);
    EXPECT_EQ(read_osc(packet).elements[0].time_tag, osc_immediately);
  }
  EXPECT_EQ(addresses(packets[0]), std::vector<std::string>(12, "/VMC/Ext/Bone/Pos"));
  const auto last = addresses(packets[1]);
  EXPECT_EQ(last.front(), "/VMC/Ext/Root/Pos");
  EXPECT_EQ(last[last.size() - 2], "/VMC/Ext/OK");
  EXPECT_EQ(last.back(), "/VMC/Ext/T");
}

TEST(VmcEncoder, SendsOneBundleThatBeginsWithTimeWhenAsked) {
  const auto packets = encoder("?framing=t-first")->packets({test::standing_pose(), 2, true});
  ASSERT_EQ(packets.size(), 1u);
  const auto words = addresses(packets[0]);
  EXPECT_EQ(words[0], "/VMC/Ext/T");
  EXPECT_EQ(words[1], "/VMC/Ext/OK");
  EXPECT_EQ(words[2], "/VMC/Ext/Root/Pos");
  EXPECT_EQ(words[3], "/VMC/Ext/Bone/Pos");
}

const OscElement& message(const OscPacket& packet, const std::string& address) {
  for (const OscElement& element : packet.elements)
    if (element.address == address) return element;
  throw std::out_of_range(address);
}

std::array<double, 7> transform_of(const OscElement& message) {
  std::array<double, 7> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = message.arguments.at(i + 1).number;
  return numbers;
}

// As Unity composes them: the hips stand at root + turn * hips.
TEST(VmcEncoder, ItsRootHasThePlaceAndHeadingOfTheCharacterAndTheHipsAreRelativeToIt) {
  const Vec3 place(2, 0, -1);
  const double turn_rad = 0.5;  // to the left about the vertical
  const Pose pose = test::moved(test::standing_pose(), turn_rad, place);
  const OscPacket now = read_osc(encoder()->packets({pose, 0, true})[0]),
                  as_before = read_osc(encoder("?root=origin")->packets({pose, 0, true})[0]);
  const OscElement root_message = message(now, "/VMC/Ext/Root/Pos");
  ASSERT_EQ(root_message.arguments.size(), 14u);
  const auto root = transform_of(root_message), hips = transform_of(message(now, "/VMC/Ext/Bone/Pos"));
  const auto old_root = transform_of(message(as_before, "/VMC/Ext/Root/Pos")),
             old_hips = transform_of(message(as_before, "/VMC/Ext/Bone/Pos"));
  EXPECT_EQ(old_root, (std::array<double, 7>{0, 0, 0, 0, 0, 0, 1}));
  EXPECT_NEAR(hips[0], 0, 1e-6);
  EXPECT_NEAR(hips[2], 0, 1e-6);
  EXPECT_NEAR(root[1], 0, 1e-6) << "on the floor";
  const Eigen::Quaterniond turn(root[6], root[3], root[4], root[5]),
      hips_turn(hips[6], hips[3], hips[4], hips[5]),
      old_turn(old_hips[6], old_hips[3], old_hips[4], old_hips[5]);
  EXPECT_NEAR(2 * std::acos(std::min(1.0, std::abs(turn.w()))), turn_rad, 1e-3);
  const Vec3 at = Vec3(root[0], root[1], root[2]) + turn * Vec3(hips[0], hips[1], hips[2]);
  EXPECT_LT((at - Vec3(old_hips[0], old_hips[1], old_hips[2])).norm(), 1e-5);
  EXPECT_LT((turn * hips_turn).angularDistance(old_turn), 1e-3);
}

TEST(VmcEncoder, CountsItsTimeFromTheFirstPose) {
  const auto sender = encoder("?framing=t-first");
  const auto time_of = [&](double at_s) {
    return message(read_osc(sender->packets({test::standing_pose(), at_s, true})[0]), "/VMC/Ext/T")
        .arguments[0]
        .number;
  };
  EXPECT_EQ(time_of(1000.0), 0);
  EXPECT_EQ(time_of(1000.5), 0.5);
  sender->restart();
  EXPECT_EQ(time_of(1001.0), 0);
}

TEST(VmcEncoder, SaysWhetherThePoseIsTracked) {
  for (const bool tracked : {true, false}) {
    const OscPacket packet =
        read_osc(encoder("?framing=t-first")->packets({test::standing_pose(), 0, tracked})[0]);
    const auto& ok = message(packet, "/VMC/Ext/OK").arguments;
    ASSERT_EQ(ok.size(), 4u);  // loaded, calibrated, normal mode, tracking
    EXPECT_EQ(ok[0].number, 1);
    EXPECT_EQ(ok[1].number, 3);
    EXPECT_EQ(ok[2].number, 0);
    EXPECT_EQ(ok[3].number, tracked ? 1 : 0);
  }
}

TEST(VmcEncoder, WritesInUnitysLeftHandedSpace) {
  Pose pose = test::standing_pose();
  pose.col(0).array() += 2;  // two metres to the left
  const OscPacket packet = read_osc(encoder("?framing=t-first")->packets({pose, 0, true})[0]);
  const auto& hips = message(packet, "/VMC/Ext/Bone/Pos").arguments;
  EXPECT_EQ(hips[0].text, "Hips");
  EXPECT_NEAR(message(packet, "/VMC/Ext/Root/Pos").arguments[1].number, -2, 1e-6);
  EXPECT_NEAR(hips[2].number, 0.95, 1e-6);
}

TEST(VmcEncoder, RefusesWhatItCannotSend) {
  const StreamUri uri = *parse_stream_uri("vmc://127.0.0.1:39539?framing=sideways");
  EXPECT_THAT(make_vmc_encoder(uri, body_of(test::standing_pose())).error().message,
              HasSubstr("expected t-last"));
  EXPECT_THAT(
      make_vmc_encoder(*parse_stream_uri("vmc://127.0.0.1:39539?root=feet"), body_of(test::standing_pose()))
          .error()
          .message,
      HasSubstr("expected character"));
  Body unknown = body_of(test::standing_pose());
  unknown.bone_lengths[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(make_vmc_encoder(*parse_stream_uri("vmc://127.0.0.1:39539"), unknown).error().message,
              HasSubstr("body was not measured"));
}

}  // namespace
}  // namespace abrazo::vmc_encoder_test
