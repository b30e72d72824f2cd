#include "core/stream/xsens/xsens_decoder.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "core/stream/receive/stream_pipeline.hpp"
#include "core/stream/xsens/xsens_character.hpp"
#include "core/stream/xsens/xsens_encoder.hpp"
#include "core/stream/xsens/xsens_packet.hpp"
#include "tests/core/stream/mocap_stream.hpp"

namespace abrazo::xsens_decoder_test {
namespace {

using Eigen::Quaterniond;
using test::Listener;

/// Rest pose of MVN's: x forward, y left, z up [m]; pelvis at 1 m.
std::array<Vec3, xsens_segment_count> rest_origins() {
  std::array<Vec3, xsens_segment_count> origins;
  origins[0] = Vec3(0, 0, 1);
  for (std::size_t s = 1; s < origins.size(); ++s) {
    const std::string name(xsens_segment_names[s]);
    const double side = name.starts_with("Left") ? 1 : name.starts_with("Right") ? -1 : 0;
    const bool is_leg = name.find("Leg") != std::string::npos;
    Vec3 offset(0, side * 0.2, 0);
    if (side == 0) offset = Vec3(0, 0, 0.12);
    if (is_leg || name.find("Foot") != std::string::npos)
      offset = name.find("UpperLeg") != std::string::npos ? Vec3(0, side * 0.1, 0) : Vec3(0, 0, -0.42);
    if (name.find("Toe") != std::string::npos) offset = Vec3(0.15, 0, -0.1);
    origins[s] = origins[static_cast<std::size_t>(xsens_parents[s])] + offset;
  }
  return origins;
}

struct Sample {
  std::vector<XsensSegment> segments;
  XsensHeader header;
};

/// The rest pose turned about the vertical, as type 02 has it.
Sample sample(std::uint32_t number, double yaw = 0, double scale = 1) {
  Sample made;
  const Quaterniond turn(Eigen::AngleAxisd(yaw, Vec3::UnitZ()));
  const auto origins = rest_origins();
  for (std::size_t s = 0; s < origins.size(); ++s)
    made.segments.push_back({static_cast<int>(s + 1), scale * (turn * origins[s]), turn});
  made.header.type = 2;
  made.header.sample = number;
  made.header.is_last = true;
  made.header.time_ms = 10 * number;
  return made;
}

std::vector<std::uint8_t> packet(XsensHeader header, const std::vector<XsensSegment>& segments) {
  ByteWriter payload(ByteOrder::Big);
  for (const XsensSegment& segment : segments) write_xsens_segment(payload, segment);
  header.items = static_cast<int>(segments.size());
  header.payload_bytes = payload.size();
  ByteWriter writer(ByteOrder::Big);
  write_xsens_header(writer, header);
  auto bytes = writer.take();
  bytes.insert(bytes.end(), payload.bytes().begin(), payload.bytes().end());
  return bytes;
}

std::vector<std::uint8_t> packet(const Sample& made) {
  return packet(made.header, made.segments);
}

/// Any content behind a header of the type.
std::vector<std::uint8_t> packet_of(int type, const ByteWriter& payload, int character = 0) {
  XsensHeader header;
  header.type = type;
  header.character = character;
  header.is_last = true;
  header.payload_bytes = payload.size();
  ByteWriter writer(ByteOrder::Big);
  write_xsens_header(writer, header);
  auto bytes = writer.take();
  bytes.insert(bytes.end(), payload.bytes().begin(), payload.bytes().end());
  return bytes;
}

/// What MVN's (x, y, z) is with y up and z forward.
Vec3 y_up(const Vec3& v) {
  return {v.y(), v.z(), v.x()};
}

TEST(XsensHeader, IsReadByteByByte) {
  const auto bytes = test::bytes_of(
      "4D 58 54 50 30 32"        // MXTP02
      " 00 01 00 02  81  17"     // sample 65538, second datagram and the last, 23 items
      " 00 00 03 E8  01"         // 1000 ms, character 1
      " 17 02 28  00 00  00 00"  // 23 segments, 2 props, 40 finger segments, reserved, size
  );
  ByteReader reader(bytes, ByteOrder::Big);
  const auto header = parse_xsens_header(reader);
  ASSERT_TRUE(header);
  EXPECT_EQ(header->type, 2);
  EXPECT_EQ(header->sample, 65538u);
  EXPECT_EQ(header->datagram, 1);
  EXPECT_TRUE(header->is_last);
  EXPECT_EQ(header->items, 23);
  EXPECT_EQ(header->time_ms, 1000u);
  EXPECT_EQ(header->character, 1);
  EXPECT_EQ(header->props, 2);
  EXPECT_EQ(header->finger_segments, 40);
  ByteWriter writer(ByteOrder::Big);
  write_xsens_header(writer, *header);
  EXPECT_EQ(writer.bytes(), bytes);
}

TEST(XsensHeader, BeginsWithMxtpAndTwoDigits) {
  const std::string rest = " 00 01 00 02  81  17  00 00 03 E8  01  17 02 28  00 00  00 00";
  for (const char* id : {"4D 58 54 51 30 32", "4D 58 54 50 30 3A", "4D 58 54 50 2F 32"}) {
    const auto bytes = test::bytes_of(id + rest);
    ByteReader reader(bytes, ByteOrder::Big);
    const auto header = parse_xsens_header(reader);
    ASSERT_FALSE(header) << id;
    EXPECT_NE(header.error().text().find("no packet of Xsens MVN"), std::string::npos);
  }
}

TEST(XsensPose, AFullBodyHas760BytesAndIsTurnedToYUp) {
  Listener listener("xsens://0.0.0.0:9763");
  const double yaw = std::numbers::pi / 6;
  const auto bytes = packet(sample(5, yaw));
  EXPECT_EQ(bytes.size(), 760u);
  listener.take(bytes, 2.5);
  ASSERT_EQ(listener.out.frames.size(), 1u) << listener.issues();
  const PerformerFrame& frame = listener.out.frames[0];
  EXPECT_EQ(frame.performer, "character 1");
  EXPECT_EQ(frame.counter, 5);
  EXPECT_EQ(frame.sender_time_s, 0.05);
  EXPECT_EQ(frame.arrived_s, 2.5);
  const Quaterniond turn(Eigen::AngleAxisd(yaw, Vec3::UnitZ()));
  const auto origins = rest_origins();
  for (std::size_t s = 0; s < origins.size(); ++s)
    EXPECT_NEAR((listener.point(xsens_segment_names[s]) - y_up(turn * origins[s])).norm(), 0, 1e-6);
  // The left hand, beside the body at +x, goes on by 0.56 of the forearm's 0.2 m.
  const Vec3 finger_tips = y_up(turn * (origins[14] + Vec3(0, 0.112, 0)));
  EXPECT_NEAR((listener.point("LeftHand_End") - finger_tips).norm(), 0, 1e-6);
  EXPECT_GT(listener.point("LeftHand").x(), 0.5) << "who faces +z has the left hand at +x";
  EXPECT_TRUE(listener.has_fact("positions in m (found"));
  EXPECT_TRUE(listener.has_fact("Z up"));
}

TEST(XsensPose, CentimetresAreFoundFromTheBodyWhateverItsHeight) {
  for (const double height_cm : {100.0, 5.0}) {  // standing, lying on the floor
    Sample made = sample(1, 0, 100);
    for (XsensSegment& segment : made.segments) segment.position.z() += height_cm - 100;
    Listener listener("xsens://0.0.0.0:9763");
    listener.take(packet(made));
    EXPECT_NEAR(listener.point("Pelvis").y(), height_cm / 100, 1e-6);
    EXPECT_TRUE(listener.has_fact("positions in cm"));
  }
  Listener given("xsens://0.0.0.0:9763?units=m");
  given.take(packet(sample(1, 0, 100)));
  EXPECT_NEAR(given.point("Pelvis").y(), 100, 1e-4);
}

TEST(XsensPose, YUpIsFoundFromTheRestPose) {
  Sample made = sample(1, 0.3);
  for (XsensSegment& segment : made.segments) {
    segment.position = y_up(segment.position);
    segment.rotation->vec() = y_up(segment.rotation->vec());
  }
  Listener z_listener("xsens://0.0.0.0:9763"), y_listener("xsens://0.0.0.0:9763");
  z_listener.take(packet(sample(1, 0.3)));
  y_listener.take(packet(made));
  for (const char* name : {"Pelvis", "Head", "LeftHand_End", "RightToe_End"})
    EXPECT_NEAR((z_listener.point(name) - y_listener.point(name)).norm(), 0, 1e-6) << name;
  EXPECT_TRUE(y_listener.has_fact("Y up"));
}

TEST(XsensPose, EulerAnglesGiveSegmentsWithoutEnds) {
  ByteWriter payload(ByteOrder::Big);
  const auto origins = rest_origins();
  for (std::size_t s = 0; s < origins.size(); ++s) {
    payload.i32(static_cast<int>(s + 1));
    payload.vec3(y_up(origins[s]));
    payload.vec3(Vec3(10, 20, 30));
  }
  XsensHeader header;
  header.type = 1;
  header.items = xsens_segment_count;
  header.payload_bytes = payload.size();
  EXPECT_EQ(payload.size(), 23u * 28);
  ByteWriter writer(ByteOrder::Big);
  write_xsens_header(writer, header);
  auto bytes = writer.take();
  bytes.insert(bytes.end(), payload.bytes().begin(), payload.bytes().end());
  Listener listener("xsens://0.0.0.0:9763");
  listener.take(bytes);
  ASSERT_EQ(listener.out.frames.size(), 1u) << listener.issues();
  EXPECT_EQ(listener.out.frames[0].points->size(), 23u);
  EXPECT_NEAR((listener.point("Head") - y_up(origins[6])).norm(), 0, 1e-6);
  EXPECT_TRUE(listener.has_fact("estimated"));
}

TEST(XsensPose, UnitysTypeIsRelativeLeftHandedAndInItsOwnOrder) {
  // Number of each segment in type 05, by its number in type 02.
  const std::array<int, 23> unity_number = {1,  10, 11, 12, 13, 22, 23, 18, 19, 20, 21, 14,
                                            15, 16, 17, 2,  3,  4,  5,  6,  7,  8,  9};
  const auto origins = rest_origins();
  const Quaterniond turn(Eigen::AngleAxisd(0.7, Vec3::UnitY()));  // of the whole body, right-handed, y up
  std::vector<XsensSegment> segments;
  for (std::size_t s = 0; s < origins.size(); ++s) {
    Vec3 place = y_up(origins[s]);
    if (s > 0) place -= y_up(origins[static_cast<std::size_t>(xsens_parents[s])]);
    const Quaterniond q = s == 0 ? turn : Quaterniond::Identity();
    place.x() = -place.x();  // to the left hand
    segments.push_back({unity_number[s], place, Quaterniond(q.w(), q.x(), -q.y(), -q.z())});
  }
  XsensHeader header;
  header.type = 5;
  Listener listener("xsens://0.0.0.0:9763");
  listener.take(packet(header, segments));
  ASSERT_EQ(listener.out.frames.size(), 1u) << listener.issues();
  for (std::size_t s = 0; s < origins.size(); ++s)
    EXPECT_NEAR((listener.point(xsens_segment_names[s]) - turn * y_up(origins[s])).norm(), 0, 1e-5)
        << xsens_segment_names[s];
  for (std::size_t s = 1; s < segments.size(); ++s) segments[s].position.setZero();
  listener.forget();
  header.sample = 1;
  listener.take(packet(header, segments));
  EXPECT_TRUE(listener.has_issue("no-offsets"));
}

TEST(XsensAssembly, ASampleInTwoDatagramsIsOneFrameInAnyOrder) {
  for (const bool reversed : {false, true}) {
    Sample made = sample(9);
    XsensHeader first = made.header, second = made.header;
    first.is_last = false;
    second.datagram = 1;
    const std::vector<XsensSegment> upper(made.segments.begin(), made.segments.begin() + 12);
    const std::vector<XsensSegment> lower(made.segments.begin() + 12, made.segments.end());
    Listener listener("xsens://0.0.0.0:9763");
    listener.take(reversed ? packet(second, lower) : packet(first, upper), 1.0);
    EXPECT_TRUE(listener.out.frames.empty());
    listener.take(reversed ? packet(first, upper) : packet(second, lower), 1.002);
    ASSERT_EQ(listener.out.frames.size(), 1u);
    EXPECT_EQ(listener.out.frames[0].first_arrived_s, 1.0);
    EXPECT_EQ(listener.out.frames[0].arrived_s, 1.002);
    Listener at_once("xsens://0.0.0.0:9763");
    at_once.take(packet(made), 1.0);
    ASSERT_EQ(at_once.out.frames.size(), 1u);
    EXPECT_EQ(listener.out.frames[0].positions, at_once.out.frames[0].positions);
  }
}

TEST(XsensAssembly, TheBodyDoesNotWaitForItsFingers) {
  Sample made = sample(9);
  made.header.is_last = false;
  made.header.finger_segments = 40;
  XsensHeader second = made.header;
  second.datagram = 1;
  second.is_last = true;
  std::vector<XsensSegment> fingers;
  for (int n = 24; n < 64; ++n) fingers.push_back({n, Vec3::Zero(), Quaterniond::Identity()});
  Listener listener("xsens://0.0.0.0:9763");
  listener.take(packet(made));
  listener.take(packet(second, fingers));
  EXPECT_EQ(listener.out.frames.size(), 1u);
  EXPECT_TRUE(listener.out.issues.empty()) << listener.issues();
  EXPECT_TRUE(listener.has_fact("40 finger segments"));
}

TEST(XsensAssembly, SamplesThatStayIncompleteAreCounted) {
  Listener listener("xsens://0.0.0.0:9763");
  for (std::uint32_t number = 0; number < 8; ++number) {
    Sample made = sample(number);
    made.segments.resize(12);
    listener.take(packet(made));
  }
  EXPECT_TRUE(listener.out.frames.empty());
  EXPECT_NE(listener.issues().find("of sample 0 only 12 of 23 segments arrived"), std::string::npos)
      << listener.issues();
}

TEST(XsensCharacters, AreOnePerformerEachAndTakeTheirNameFromMetaData) {
  Listener listener("xsens://0.0.0.0:9763");
  for (const bool with_length : {true, false}) {  // senders differ
    ByteWriter meta(ByteOrder::Big);
    const std::string tags =
        "xmid:00B41234\nname:" + std::string(with_length ? "Ana" : "Ben") + "\ncolor:FF0000\n";
    if (with_length) meta.i32(static_cast<int>(tags.size()));
    meta.characters(tags);
    listener.take(packet_of(12, meta, with_length ? 0 : 1));
  }
  for (int character = 0; character < 3; ++character) {
    Sample made = sample(1);
    made.header.character = character;
    listener.take(packet(made));
  }
  ASSERT_EQ(listener.out.frames.size(), 3u);
  EXPECT_EQ(listener.out.frames[0].performer, "Ana");
  EXPECT_EQ(listener.out.frames[1].performer, "Ben");
  EXPECT_EQ(listener.out.frames[2].performer, "character 3");
}

TEST(XsensCharacters, ANameThatComesLaterDoesNotMakeAnotherPerformer) {
  Listener listener("xsens://0.0.0.0:9763");
  listener.take(packet(sample(1)));
  ByteWriter meta(ByteOrder::Big);
  write_xsens_meta(meta, {"Ana"});
  listener.take(packet_of(12, meta));
  listener.take(packet(sample(2)));
  EXPECT_EQ(listener.out.frames.back().performer, "character 1");
  EXPECT_EQ(listener.out.frames.back().also_called, "Ana");
  EXPECT_TRUE(listener.has_fact("character 1 (Ana)"));
}

TEST(XsensCharacters, WhoeverIsWantedByANameThatComesLaterIsFollowed) {
  const StreamUri uri = *parse_stream_uri("xsens://0.0.0.0:9763?performer=Ana");
  StreamPipeline pipeline(std::move(*make_xsens_decoder(uri)), uri, *performer_options(uri, {}), 0);
  StreamPipeline::Output output;
  const auto take = [&](const std::vector<std::uint8_t>& bytes, double at_s) {
    pipeline.take(Datagram{{}, at_s, bytes}, at_s, output);
  };
  take(packet(sample(1)), 0.01);
  EXPECT_EQ(pipeline.find("Ana"), nullptr);
  ByteWriter meta(ByteOrder::Big);
  write_xsens_meta(meta, {"Ana"});
  take(packet_of(12, meta), 0.015);
  take(packet(sample(2)), 0.02);
  ASSERT_NE(pipeline.find("Ana"), nullptr);
  EXPECT_EQ(pipeline.find("Ana"), pipeline.find("character 1"));
}

TEST(XsensScale, GivesTheEndsOfLimbs) {
  Listener listener("xsens://0.0.0.0:9763");
  ByteWriter scale(ByteOrder::Big);
  write_xsens_scale(scale,
                    {{}, {{15, 2, "pLeftTopOfHand", Vec3(0, 0.19, 0)}, {7, 1, "jC1Head", Vec3(0, 0, 9)}}});
  listener.take(packet_of(13, scale));
  listener.take(packet(sample(1)));
  EXPECT_NEAR((listener.point("LeftHand_End") - listener.point("LeftHand") - Vec3(0.19, 0, 0)).norm(), 0,
              1e-6);
  EXPECT_NEAR((listener.point("Head_End") - listener.point("Head") - Vec3(0, 0.24, 0)).norm(), 0, 1e-6)
      << "no point of the head was told: twice the neck's 0.12 m";
  EXPECT_TRUE(listener.has_fact("scaling data"));
}

TEST(XsensCounter, CountsStepsOfAThinnedStreamByOne) {
  SampleSteps steps;
  EXPECT_EQ(steps.number_of(100), 100);
  EXPECT_EQ(steps.number_of(104), 101);
  EXPECT_EQ(steps.number_of(108), 102);
  EXPECT_EQ(steps.number_of(116), 104) << "one lost";
  EXPECT_EQ(steps.number_of(116), 104) << "twice";
  EXPECT_EQ(steps.number_of(112), 103) << "late";
  EXPECT_EQ(steps.number_of(120), 105);
  EXPECT_EQ(steps.number_of(50000), 50000) << "another recording";
}

TEST(XsensCounter, RunsOverTheEndOf32Bits) {
  SampleSteps steps;
  steps.number_of(0xFFFFFFFE);
  EXPECT_EQ(steps.number_of(0xFFFFFFFF), 4294967295);
  EXPECT_EQ(steps.number_of(0), 4294967296);
}

TEST(XsensIssues, SayWhatIsWrongAndWhatToTick) {
  Listener listener("xsens://0.0.0.0:9763");
  listener.take(test::bytes_of("23 62 75 6E 64 6C 65 00"));
  EXPECT_TRUE(listener.has_issue("other-protocol"));
  auto cut = packet(sample(1));
  cut.resize(700);
  listener.forget();
  listener.take(cut);
  EXPECT_NE(listener.issues().find("announces 736 bytes, but 676 follow"), std::string::npos)
      << listener.issues();
  Sample bad = sample(2);
  bad.segments[6].position.x() = std::numeric_limits<double>::quiet_NaN();
  listener.take(packet(bad));
  EXPECT_TRUE(listener.has_issue("not-finite"));
  EXPECT_FALSE(listener.point("Head").allFinite());
  EXPECT_TRUE(listener.point("Neck").allFinite());
  listener.forget();
  Listener joint_angles("xsens://0.0.0.0:9763");
  ByteWriter angles(ByteOrder::Big);
  angles.zeros(20);
  joint_angles.take(packet_of(20, angles), 1.0);
  joint_angles.pass_time(1.1);
  EXPECT_TRUE(joint_angles.has_issue("no-poses"));
  EXPECT_TRUE(joint_angles.has_fact("20 (1)"));
}

TEST(XsensIssues, TwoPoseTypesAtOnceAreNotTwoStreams) {
  Listener listener("xsens://0.0.0.0:9763");
  Sample other = sample(1);
  other.header.type = 5;
  listener.take(packet(sample(1)), 0.0);
  listener.take(packet(other), 0.001);
  EXPECT_EQ(listener.out.frames.size(), 1u);
  EXPECT_TRUE(listener.has_issue("other-pose-type"));
  listener.take(packet(other), 5.0);
  EXPECT_EQ(listener.out.frames.size(), 2u) << "the better one has ended";
}

TEST(XsensIssues, OptionsThatAreNoneAreErrors) {
  for (const char* text : {"xsens://h?units=inch", "xsens://h?up=x"})
    EXPECT_FALSE(make_xsens_decoder(*parse_stream_uri(text))) << text;
  for (const char* character : {"300", "256", "-1", "ana"})
    EXPECT_FALSE(
        make_xsens_encoder(*parse_stream_uri(std::string("xsens://h?character=") + character), Body{}))
        << character;
  StreamUri uri = *parse_stream_uri("natnet://h");
  uri.options["units"] = "cm";
  EXPECT_TRUE(make_xsens_decoder(uri));
}

}  // namespace
}  // namespace abrazo::xsens_decoder_test
