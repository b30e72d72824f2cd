#include "core/stream/natnet/natnet_frame.hpp"

#include <gtest/gtest.h>

#include "tests/core/stream/mocap_stream.hpp"

namespace abrazo::natnet_frame_test {
namespace {

/// One rigid body and one skeleton of one bone, byte by byte as section 5.2 says; the sizes of sections stand
/// where SIZE marks them and only from 4.1 on.
constexpr const char* body_7 = R"(
  07 00 00 00                                      # number 7
  00 00 80 3F  00 00 00 40  00 00 40 40            # position 1, 2, 3
  00 00 00 00  00 00 00 00  00 00 00 00  00 00 80 3F  # rotation x, y, z, w: none
  0A D7 23 3C                                      # marker error 0.01
  01 00)";                    // flags: tracked
constexpr const char* bone_2_of_5 = R"(
  02 00 05 00                                      # bone 2 of skeleton 5
  00 00 00 3F  00 00 80 3F  00 00 00 BF            # position 0.5, 1, -0.5
  00 00 80 3F  00 00 00 00  00 00 00 00  00 00 00 00  # half a turn about x
  00 00 00 00
  00 00)";                    // not tracked
constexpr const char* labelled_marker = R"(
  01 00 02 00                                      # marker 1 of model 2
  00 00 80 3F  00 00 80 3F  00 00 80 3F            # position
  0A D7 A3 3C                                      # size 0.02
  0B 00                                            # flags: occluded, point cloud solved, has a model
  00 00 00 00)";              // residual
constexpr const char* times = R"(
  01 00 00 00  02 00 00 00                         # time code, sub-frame
  00 00 00 00 00 00 F8 3F                          # time stamp 1.5 s
  E8 03 00 00 00 00 00 00                          # mid exposure 1000
  D0 07 00 00 00 00 00 00                          # received 2000
  B8 0B 00 00 00 00 00 00)";  // transmit 3000

std::string frame_3_0() {
  return std::string("2A 00 00 00") +                                    // frame 42
         "01 00 00 00  61 6C 6C 00  01 00 00 00" +                       // a marker set "all" of one marker
         "00 00 80 3F 00 00 80 3F 00 00 80 3F" +                         //
         "01 00 00 00  00 00 80 3F 00 00 80 3F 00 00 80 3F" +            // an unlabelled marker
         "01 00 00 00" + body_7 + "\n" +                                 // rigid bodies
         "01 00 00 00  05 00 00 00  01 00 00 00" + bone_2_of_5 + "\n" +  // a skeleton with the number 5
         "01 00 00 00" + labelled_marker + "\n" +                        // labelled markers
         // a force plate with the number 9: two channels of one and no samples; a device without channels
         "01 00 00 00  09 00 00 00  02 00 00 00  01 00 00 00 00 00 80 3F  00 00 00 00" +
         "01 00 00 00  0A 00 00 00  00 00 00 00" + times + "\n" +
         "03 00" +       // flags: recording, models changed
         "00 00 00 00";  // end tag
}

std::string frame_4_1() {
  return std::string("2A 00 00 00") + "00 00 00 00  00 00 00 00" +  // no marker sets in 0 bytes
         "00 00 00 00  00 00 00 00" +                               // no unlabelled markers
         "01 00 00 00  26 00 00 00" + body_7 + "\n" +               // a body in 38 bytes
         "01 00 00 00  30 00 00 00  05 00 00 00  01 00 00 00" + bone_2_of_5 + "\n" +  // 48 bytes, of which 2
         "EE EE" +                                                                    // are unknown
         "00 00 00 00  00 00 00 00" +                                                 // no assets
         "01 00 00 00  1A 00 00 00" + labelled_marker + "\n" + "00 00 00 00  00 00 00 00" +
         "00 00 00 00  00 00 00 00" +                 // neither plates nor devices
         times + "\n" + "05 00 00 00  06 00 00 00" +  // precision time: seconds, fraction
         "02 00" + "00 00 00 00";
}

Result<NatNetFrame> parse(const std::string& hex, NatNetVersion version) {
  const auto bytes = test::bytes_of(hex);
  ByteReader reader(bytes, ByteOrder::Little);
  return parse_natnet_frame(reader, version);
}

void expect_body_and_bone(const NatNetFrame& frame) {
  EXPECT_EQ(frame.number, 42);
  ASSERT_EQ(frame.bodies.size(), 1u);
  EXPECT_EQ(frame.bodies[0].id, 7);
  EXPECT_EQ(frame.bodies[0].position, Vec3(1, 2, 3));
  EXPECT_EQ(frame.bodies[0].rotation.w(), 1);
  EXPECT_FLOAT_EQ(frame.bodies[0].error_m, 0.01F);
  EXPECT_TRUE(frame.bodies[0].tracked);
  ASSERT_EQ(frame.skeletons.size(), 1u);
  EXPECT_EQ(frame.skeletons[0].id, 5);
  ASSERT_EQ(frame.skeletons[0].bones.size(), 1u);
  EXPECT_EQ(frame.skeletons[0].bones[0].id & 0xFFFF, 2);
  EXPECT_EQ(frame.skeletons[0].bones[0].position, Vec3(0.5, 1, -0.5));
  EXPECT_EQ(frame.skeletons[0].bones[0].rotation.x(), 1);
  EXPECT_FALSE(frame.skeletons[0].bones[0].tracked);
  EXPECT_EQ(frame.time_s, 1.5);
  ASSERT_TRUE(frame.stamps);
  EXPECT_EQ(frame.stamps->mid_exposure, 1000u);
  EXPECT_EQ(frame.stamps->received, 2000u);
  EXPECT_EQ(frame.stamps->transmit, 3000u);
  EXPECT_TRUE(frame.models_changed);
}

TEST(NatNetFrame, OfVersion30IsReadFieldByField) {
  const auto frame = parse(frame_3_0(), {3, 0});
  ASSERT_TRUE(frame) << frame.error().text();
  expect_body_and_bone(*frame);
  EXPECT_TRUE(frame->recording);
  EXPECT_EQ(frame->marker_sets, 1u);
  EXPECT_EQ(frame->unlabelled_markers, 1u);
  EXPECT_EQ(frame->labelled_markers, 1u);
  EXPECT_EQ(frame->occluded_markers, 1u);
  EXPECT_EQ(frame->force_plates, 1u);
  EXPECT_EQ(frame->devices, 1u);
  EXPECT_TRUE(frame->unread.empty());
}

TEST(NatNetFrame, LaidOutAsARealOneOfMotive21HasTheSizeOfOne) {
  // A capture of NatNet 3.0 that is known to have 336 bytes: 5 unlabelled markers, a body, 6 labelled
  // markers.
  ByteWriter payload(ByteOrder::Little);
  payload.i32(162734);
  payload.i32(0);
  payload.i32(5);
  for (int marker = 0; marker < 5; ++marker) payload.vec3(Vec3(0.127, 1.505, -0.886));
  for (const std::uint8_t byte : test::bytes_of("01 00 00 00" + std::string(body_7))) payload.u8(byte);
  payload.i32(0);
  payload.i32(6);
  for (int marker = 0; marker < 6; ++marker)
    for (const std::uint8_t byte : test::bytes_of(labelled_marker)) payload.u8(byte);
  payload.i32(0);
  payload.i32(0);
  for (const std::uint8_t byte : test::bytes_of(std::string(times) + "\n 00 00  00 00 00 00"))
    payload.u8(byte);
  const auto packet = natnet_packet(NatNetMessage::Frame, payload);
  EXPECT_EQ(packet.size(), 336u);
  ByteReader reader(packet, ByteOrder::Little);
  parse_natnet_head(reader);
  const auto frame = parse_natnet_frame(reader, {3, 0});
  ASSERT_TRUE(frame) << frame.error().text();
  EXPECT_EQ(frame->number, 162734);
  EXPECT_EQ(frame->unlabelled_markers, 5u);
  EXPECT_EQ(frame->labelled_markers, 6u);
  EXPECT_EQ(frame->time_s, 1.5);
  EXPECT_EQ(reader.left(), 4u) << "the end tag";
}

TEST(NatNetFrame, OfVersion41HasSizesOfSectionsAndPrecisionTime) {
  const auto frame = parse(frame_4_1(), {4, 1});
  ASSERT_TRUE(frame) << frame.error().text();
  expect_body_and_bone(*frame);
  EXPECT_FALSE(frame->recording);
  EXPECT_EQ(frame->occluded_markers, 1u);
  EXPECT_TRUE(frame->unread.empty());
}

TEST(NatNetFrame, ReadWithTheWrongVersionIsAnErrorOrAnotherFrameButNeverThrows) {
  (void)parse(frame_4_1(), {3, 0});
  (void)parse(frame_3_0(), {4, 1});
}

TEST(NatNetFrame, MayEndBeforeItsTimesAsSomeProgramsWriteIt) {
  std::string short_frame = frame_4_1();
  short_frame.resize(short_frame.find("01 00 00 00  02 00 00 00"));
  const auto frame = parse(short_frame, {4, 1});
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->skeletons.size(), 1u);
  EXPECT_FALSE(frame->time_s);
}

TEST(NatNetFrame, HasItsFlagsAlsoWithoutThePrecisionTime) {
  std::string frame_text = frame_4_1();
  const std::string precision = "05 00 00 00  06 00 00 00";
  frame_text.erase(frame_text.find(precision), precision.size());
  const auto frame = parse(frame_text, {4, 1});
  ASSERT_TRUE(frame);
  EXPECT_TRUE(frame->models_changed);
}

TEST(NatNetFrame, ASectionThatLiesAboutItsSizeCostsOnlyItself) {
  std::string frame_text = frame_4_1();
  const std::string markers = "01 00 00 00  1A 00 00 00";
  frame_text.replace(frame_text.find(markers), markers.size(),
                     "09 00 00 00  1A 00 00 00");  // nine in 26 bytes
  const auto frame = parse(frame_text, {4, 1});
  ASSERT_TRUE(frame) << frame.error().text();
  expect_body_and_bone(*frame);
  EXPECT_EQ(frame->labelled_markers, 0u);
  ASSERT_EQ(frame->unread.size(), 1u);
  EXPECT_NE(frame->unread[0].find("9 labelled markers do not fit into the section's 26 bytes"),
            std::string::npos)
      << frame->unread[0];
}

TEST(NatNetFrame, ACountThatCannotBeIsNamedWithItsPlace) {
  const auto frame = parse("2A 00 00 00  00 00 00 00  00 00 00 00  FF FF FF 7F", {3, 0});
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().text(),
            "frame: at byte 16: 2147483647 rigid bodies cannot follow, 0 bytes are left");
}

TEST(NatNetFrame, CutAnywhereIsAnErrorUpToTheSkeletonsAndAFrameBehindThem) {
  const auto bytes = test::bytes_of(frame_3_0());
  // number 4, marker set 24, unlabelled 16, body 42, skeleton 50
  constexpr std::size_t end_of_skeletons = 4 + 24 + 16 + 42 + 50;
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const std::vector<std::uint8_t> cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
    ByteReader reader(cut, ByteOrder::Little);
    EXPECT_EQ(parse_natnet_frame(reader, {3, 0}).ok(), length >= end_of_skeletons) << length;
  }
}

TEST(NatNetFrame, WhatIsWrittenIsReadAgainInEveryVersion) {
  const auto frame = parse(frame_3_0(), {3, 0});
  ASSERT_TRUE(frame);
  for (const NatNetVersion version : {NatNetVersion{3, 0}, {3, 1}, {4, 0}, {4, 1}, {4, 2}}) {
    ByteWriter writer(ByteOrder::Little);
    write_natnet_frame(writer, *frame, version);
    ByteReader reader(writer.bytes(), ByteOrder::Little);
    const auto again = parse_natnet_frame(reader, version);
    ASSERT_TRUE(again) << version.text();
    expect_body_and_bone(*again);
  }
}

TEST(NatNetFrame, AssetsWithBodiesAndMarkersLeaveWhatFollowsInItsPlace) {
  std::string frame_text = frame_4_1();
  const std::string labelled = "01 00 00 00  1A 00 00 00";
  const std::string none = "00 00 00 00  00 00 00 00";
  const std::size_t assets = frame_text.rfind(none, frame_text.find(labelled));
  // Number, one body of 38 bytes, one marker of 26 bytes: 76 bytes each.
  const std::string asset =
      std::string("03 00 00 00  01 00 00 00") + body_7 + "\n  01 00 00 00" + labelled_marker + "\n";
  frame_text.replace(assets, none.size(), "02 00 00 00  98 00 00 00" + asset + asset);
  const auto frame = parse(frame_text, {4, 1});
  ASSERT_TRUE(frame) << frame.error().text();
  expect_body_and_bone(*frame);
  EXPECT_EQ(frame->assets, 2u);
  EXPECT_EQ(frame->labelled_markers, 1u);
  EXPECT_TRUE(frame->unread.empty());
}

}  // namespace
}  // namespace abrazo::natnet_frame_test
