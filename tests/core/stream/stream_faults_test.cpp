#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "core/stream/protocol/stream_encoder.hpp"
#include "core/stream/receive/decoders.hpp"
#include "core/stream/receive/pose_reader.hpp"
#include "core/stream/receive/stream_pipeline.hpp"
#include "core/stream/send/encoders.hpp"
#include "tests/support/bodies.hpp"

// What goes wrong between a sender and us, each with the diagnosis it gives. The bytes are those of the
// encoders, so that a fault is all that is wrong with them.
namespace abrazo::stream_faults_test {
namespace {

using testing::AllOf, testing::AnyOf, testing::Contains, testing::HasSubstr, testing::IsEmpty, testing::Not;

constexpr double rate_hz = 100;

/// Somebody who swings to and fro.
Pose swinging(double time_s) {
  Pose pose =
      test::moved(test::standing_pose(), 0.3 * std::sin(2 * time_s), Vec3(0.2 * std::sin(time_s), 0, 0));
  return pose;
}

struct Packet {
  double arrives_s = 0;
  std::vector<std::uint8_t> bytes;
  Endpoint from = {0x0A000001, 5000};
  bool cut_by_socket = false;
};

std::unique_ptr<StreamEncoder> encoder_of(const std::string& uri) {
  auto encoder = make_stream_encoder(*parse_stream_uri(uri), body_of(test::standing_pose()));
  if (!encoder) throw std::runtime_error(encoder.error().text());
  return std::move(*encoder);
}

/// What a sender sends from `from_s` for `seconds`. @param own_s  its clock then
void append_frames(std::vector<Packet>& packets, StreamEncoder& encoder, double from_s, double seconds,
                   double own_s, double hz = rate_hz) {
  for (int i = 0; i < std::lround(seconds * hz); ++i)
    for (auto& bytes : encoder.packets({swinging(own_s + i / hz), own_s + i / hz, true}))
      packets.push_back({from_s + i / hz, std::move(bytes)});
}

std::vector<Packet> frames(const std::string& uri, double seconds = 5) {
  std::vector<Packet> packets;
  append_frames(packets, *encoder_of(uri), 0, seconds, 0);
  return packets;
}

/// Where the packets go, read 200 times a second.
class Line {
 public:
  explicit Line(const std::string& uri)
      : pipeline_(std::move(*make_stream_decoder(*parse_stream_uri(uri))), *parse_stream_uri(uri),
                  *performer_options(*parse_stream_uri(uri), {}), 0) {}

  void run(std::vector<Packet> packets, double until_s = -1) {
    std::stable_sort(packets.begin(), packets.end(),
                     [](const Packet& a, const Packet& b) { return a.arrives_s < b.arrives_s; });
    for (const Packet& packet : packets) {
      pass_time_until(packet.arrives_s);
      pipeline_.take({packet.from, packet.arrives_s, packet.bytes}, packet.arrives_s, output_,
                     packet.cut_by_socket);
      read();
    }
    pass_time_until(until_s);
  }

  StreamHealth health() const { return pipeline_.health(now_s_); }
  std::vector<std::string> kinds() const {
    std::vector<std::string> all;
    for (const StreamDiagnosis& diagnosis : health().diagnoses)
      if (diagnosis.kind != "not-calibrated") all.push_back(diagnosis.kind);
    return all;
  }
  std::string advice(const std::string& kind) const {
    std::string others = "no '" + kind + "' among";
    for (const StreamDiagnosis& diagnosis : health().diagnoses) {
      if (diagnosis.kind == kind) return diagnosis.text;
      others += " " + diagnosis.kind;
    }
    return others;
  }
  std::uint64_t issues(const std::string& kind) const {
    for (const IssueCount& issue : health().issues)
      if (issue.kind == kind) return issue.count;
    return 0;
  }
  PerformerHealth performer() const { return health().performers.at(0); }

  std::vector<SourcePose> given;

 private:
  void pass_time_until(double until_s) {
    while (now_s_ + 0.005 < until_s) {
      now_s_ += 0.005;
      pipeline_.pass_time(now_s_, output_);
      read();
    }
    now_s_ = std::max(now_s_, until_s);
  }
  void read() {
    if (const auto pose = reader_.poll(pipeline_, now_s_)) {
      EXPECT_TRUE(pose->pose.allFinite());
      if (!given.empty()) {
        EXPECT_GT(pose->time_s, given.back().time_s);
      }
      given.push_back(*pose);
    }
  }

  double now_s_ = 0;
  StreamPipeline pipeline_;
  PoseReader reader_{""};
  StreamPipeline::Output output_;
};

const std::string vmc = "vmc://0.0.0.0:39539", xsens = "xsens://0.0.0.0:9763";

std::size_t breaks(const Line& line) {
  return static_cast<std::size_t>(std::count_if(line.given.begin(), line.given.end(),
                                                [](const SourcePose& pose) { return pose.discontinuous; }));
}

/// Per protocol: where to send, where to listen.
class EveryProtocol : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(StreamFaults, EveryProtocol, testing::Values(vmc, xsens), [](const auto& protocol) {
  return protocol.param.substr(0, protocol.param.find(':'));
});

TEST_P(EveryProtocol, WithoutFaultsHasNothingToSay) {
  Line line(GetParam());
  line.run(frames(GetParam()));
  EXPECT_THAT(line.kinds(), IsEmpty());
  EXPECT_GE(line.given.size(), 495U);
  EXPECT_EQ(breaks(line), 1U);
  EXPECT_NEAR(line.performer().rate_hz, rate_hz, 1);
  EXPECT_EQ(line.performer().lost, 0U);
}

TEST_P(EveryProtocol, ASenderThatStopsIsNoticedAndTakenUpAgain) {
  Line line(GetParam());
  auto encoder = encoder_of(GetParam());
  std::vector<Packet> packets;
  append_frames(packets, *encoder, 0, 2, 0);
  line.run(packets, 5);
  EXPECT_THAT(line.advice("stalled"), HasSubstr("no packet for 3.0 s"));
  EXPECT_FALSE(line.performer().tracked);
  packets.clear();
  append_frames(packets, *encoder, 5, 1, 5);
  line.run(packets);
  EXPECT_THAT(line.kinds(), IsEmpty());
  EXPECT_EQ(breaks(line), 2U);
  EXPECT_EQ(line.performer().interruptions, 1U);
}

TEST_P(EveryProtocol, ASenderThatBeginsAnewIsFollowed) {
  Line line(GetParam());
  auto encoder = encoder_of(GetParam());
  std::vector<Packet> packets;
  append_frames(packets, *encoder, 0, 3, 0);
  encoder->restart();
  append_frames(packets, *encoder, 3, 3, 0);
  line.run(packets);
  EXPECT_THAT(line.advice("sender-restarted"), HasSubstr("the sender restarted"));
  EXPECT_EQ(line.performer().restarts, 1U);
  EXPECT_EQ(breaks(line), 2U);
  EXPECT_GE(line.given.size(), 590U) << "two or three frames for being sure";
  EXPECT_LE(line.performer().late, 3U);
}

TEST_P(EveryProtocol, BurstsAskForADelay) {
  Line line(GetParam());
  auto packets = frames(GetParam());
  for (Packet& packet : packets) packet.arrives_s = 0.05 * std::ceil(packet.arrives_s / 0.05 - 1e-9);
  line.run(packets);
  EXPECT_THAT(line.advice("irregular"), AllOf(HasSubstr("in bursts"), HasSubstr("a delay of 50 ms")));

  Line delayed(GetParam() + "?delay=60");
  delayed.run(packets, 5.2);
  EXPECT_THAT(delayed.kinds(), Not(Contains("irregular")));
  EXPECT_GE(delayed.given.size(), 480U);
}

TEST_P(EveryProtocol, AnotherProtocolIsNamedWithItsFirstBytes) {
  const bool is_vmc = GetParam() == vmc;
  Line line(GetParam());
  line.run(frames(is_vmc ? xsens : vmc));
  const std::string text = line.advice("other-protocol");
  EXPECT_THAT(text, HasSubstr(is_vmc ? "4d 58 54 50 30 32" : "\"#bundle."));
  EXPECT_THAT(text, HasSubstr(is_vmc ? "looks like Xsens MVN" : "looks like VMC"));
  EXPECT_TRUE(line.given.empty());
}

TEST_P(EveryProtocol, TruncatedPacketsAreCountedAndSaid) {
  Line line(GetParam());
  auto packets = frames(GetParam());
  for (std::size_t i = 0; i < packets.size(); i += 3)
    packets[i].bytes.resize(packets[i].bytes.size() * 2 / 3 | 1U);
  line.run(packets);
  EXPECT_GT(line.issues("truncated"), 100U);
  EXPECT_THAT(line.advice("unreadable-packets"), HasSubstr("% of the packets cannot be read. The newest: "));
  EXPECT_GT(line.given.size(), 150U);
}

TEST_P(EveryProtocol, OversizedPacketsAreCountedAndSaid) {
  Line line(GetParam());
  auto packets = frames(GetParam());
  for (std::size_t i = 0; i < packets.size(); i += 4) packets[i].cut_by_socket = true;
  line.run(packets);
  EXPECT_EQ(line.issues("oversized"), (packets.size() + 3) / 4);
  EXPECT_THAT(line.advice("unreadable-packets"), HasSubstr("have the sender make smaller packets"));
}

TEST_P(EveryProtocol, NoBytesStopIt) {
  Line line(GetParam());
  auto packets = frames(GetParam());
  std::mt19937 random(5);
  for (Packet& packet : packets) {
    if (random() % 3 != 0) continue;
    for (int i = 0; i < 8; ++i)
      packet.bytes[random() % packet.bytes.size()] = static_cast<std::uint8_t>(random());
    if (random() % 5 == 0) packet.bytes.resize(random() % (packet.bytes.size() + 1));
  }
  line.run(packets);
  EXPECT_GT(line.health().packets_with_issues, 0U);
  EXPECT_FALSE(line.given.empty());
}

TEST(StreamFaults, LossIsCountedByTheSendersCounter) {
  Line line(xsens);
  auto packets = frames(xsens);
  std::erase_if(packets, [&, i = 0](const Packet&) mutable { return ++i % 10 == 5; });
  line.run(packets);
  EXPECT_NEAR(static_cast<double>(line.performer().lost), 50, 2);
  EXPECT_THAT(line.advice("loss"),
              AllOf(HasSubstr("% of the frames are lost on the way"), HasSubstr("cable")));
}

TEST(StreamFaults, ReorderedFramesAreLateUnlessThereIsADelay) {
  auto packets = frames(xsens);
  // Every fourth frame overtakes the one before.
  for (std::size_t i = 3; i < packets.size(); i += 4) packets[i - 1].arrives_s += 0.015;
  Line line(xsens);
  line.run(packets);
  EXPECT_NEAR(static_cast<double>(line.performer().late), 125, 5);
  EXPECT_EQ(line.performer().lost, 0U);
  EXPECT_THAT(line.advice("late"), HasSubstr("come after a newer one and are left out; a delay of"));

  Line delayed(xsens + "?delay=30");
  delayed.run(packets, 5.1);
  EXPECT_EQ(delayed.performer().late, 0U);
  EXPECT_NEAR(static_cast<double>(delayed.performer().reordered), 125, 5);
  EXPECT_THAT(delayed.kinds(), Not(Contains("late")));
  EXPECT_EQ(delayed.given.size(), 500U);
}

TEST(StreamFaults, DuplicatesAreLeftOutAndSaid) {
  auto packets = frames(xsens);
  const std::size_t sent = packets.size();
  for (std::size_t i = 0; i < sent; i += 2) {
    packets.push_back(packets[i]);
    packets.back().arrives_s += 0.003;
  }
  Line line(xsens);
  line.run(packets);
  EXPECT_NEAR(static_cast<double>(line.performer().repeated), 250, 2);
  EXPECT_THAT(line.advice("repeated"), HasSubstr("come twice"));
  EXPECT_NEAR(static_cast<double>(line.given.size()), 500, 2);
}

TEST(StreamFaults, TwoVmcSendersOnOnePortAreTwoPerformers) {
  auto packets = frames(vmc);
  auto others = frames(vmc);
  for (Packet& packet : others) {
    packet.from.port = 5001;
    packet.arrives_s += 0.004;
  }
  packets.insert(packets.end(), others.begin(), others.end());
  Line line(vmc);
  line.run(packets);
  EXPECT_EQ(line.health().performers.size(), 2U);
  EXPECT_THAT(line.advice("two-senders"),
              AllOf(HasSubstr("2 senders send to this port (10.0.0.1:5000, 10.0.0.1:5001)"),
                    HasSubstr("choose who plays the user (now 10.0.0.1:5000)")));
  EXPECT_EQ(breaks(line), 1U) << "one of them is followed";
}

TEST(StreamFaults, ManyShortLivedSendersDoNotLockOutTheOneThatStays) {
  std::vector<Packet> packets;
  for (std::uint16_t port = 0; port < 20; ++port) {
    const std::size_t first = packets.size();
    append_frames(packets, *encoder_of("vmc://127.0.0.1:39539?framing=t-first"), 0.01 * port, 0.03, 0);
    for (std::size_t i = first; i < packets.size(); ++i)
      packets[i].from.port = static_cast<std::uint16_t>(6000 + port);
  }
  append_frames(packets, *encoder_of("vmc://127.0.0.1:39539?framing=t-first"), 1, 4, 0);
  Line line("vmc://0.0.0.0:39539");
  line.run(std::move(packets), 5.1);
  const StreamHealth health = line.health();
  const auto real = std::find_if(health.performers.begin(), health.performers.end(),
                                 [](const PerformerHealth& performer) { return performer.frames > 100; });
  ASSERT_NE(real, health.performers.end());
  EXPECT_GT(real->frames, 250u) << "from two seconds after the last of the others on";
}

TEST(StreamFaults, TheXsensSenderThatCameFirstKeepsItsCharacterNumberAndTheOtherIsSaid) {
  auto packets = frames(xsens);
  std::vector<Packet> others;
  append_frames(others, *encoder_of(xsens), 0, 5, 40);
  for (Packet& packet : others) {
    packet.from.address += 1;
    packet.arrives_s += 0.004;
  }
  packets.insert(packets.end(), others.begin(), others.end());
  Line line(xsens);
  line.run(packets);
  EXPECT_THAT(line.advice("two-senders"), HasSubstr("end one, or give it another port"));
  EXPECT_EQ(line.performer().frames, 500U) << "of the first alone";
  EXPECT_EQ(line.performer().restarts + line.performer().late, 0U);
  EXPECT_EQ(breaks(line), 1U);
  EXPECT_GE(line.issues("other-sender"), 500U);
}

TEST(StreamFaults, AnXsensCharacterOfAnotherMachineIsHeardAfterASilenceAndItIsSaid) {
  auto packets = frames(xsens, 2);
  std::vector<Packet> others;
  append_frames(others, *encoder_of(xsens), 1, 4, 40);
  for (Packet& packet : others) packet.from.address += 1;
  packets.insert(packets.end(), others.begin(), others.end());
  Line line(xsens);
  line.run(packets);
  EXPECT_EQ(line.issues("sender-changed"), 2U)
      << "the number is another machine's; somebody else is followed";
  EXPECT_THAT(line.advice("sender-changed"),
              HasSubstr("is followed now, since Abrazo stopped sending poses"));
  ASSERT_EQ(line.health().performers.size(), 2U) << "not under the name that the first one sent";
  EXPECT_NEAR(static_cast<double>(line.health().performers[0].frames), 200, 2);
  EXPECT_NEAR(static_cast<double>(line.health().performers[1].frames), 200, 5);
}

TEST(StreamFaults, ManyVmcSendersForgetNobodyWhoSendsPoses) {
  auto packets = frames(vmc, 4);
  // From half a second on forty addresses send poses too, each now and then.
  for (std::uint16_t other = 0; other < 40; ++other) {
    std::vector<Packet> some;
    append_frames(some, *encoder_of(vmc), 0.5 + 0.002 * other, 3, 0, 10);
    for (Packet& packet : some) packet.from.port = static_cast<std::uint16_t>(7000 + other);
    packets.insert(packets.end(), some.begin(), some.end());
  }
  Line line(vmc);
  line.run(packets);
  EXPECT_EQ(line.performer().performer, "10.0.0.1:5000");
  EXPECT_NEAR(static_cast<double>(line.performer().frames), 400, 2);
  EXPECT_EQ(breaks(line), 1U) << "followed throughout";
  EXPECT_GT(line.issues("many-senders"), 0U);
}

TEST(StreamFaults, ASenderThatIsFollowedInPlaceOfAnotherIsSaid) {
  auto packets = frames(vmc, 2);
  std::vector<Packet> others;
  append_frames(others, *encoder_of(vmc), 2.5, 3, 40);
  for (Packet& packet : others) packet.from.address += 1;
  packets.insert(packets.end(), others.begin(), others.end());
  Line line(vmc);
  line.run(packets);
  EXPECT_THAT(line.advice("sender-changed"),
              HasSubstr("10.0.0.2:5000 is followed now, since 10.0.0.1:5000 stopped sending poses"));
}

/// Sets the 4-byte number at `at` to not-a-number, big-endian.
void make_nan(std::vector<std::uint8_t>& bytes, std::size_t at) {
  constexpr std::uint8_t nan[] = {0x7F, 0xC0, 0x00, 0x00};
  std::copy(std::begin(nan), std::end(nan), bytes.begin() + static_cast<std::ptrdiff_t>(at));
}

TEST(StreamFaults, NotANumberInASegmentIsHeldAndSaid) {
  auto packets = frames(xsens);
  constexpr std::size_t head = 24, segment = 32;
  for (std::size_t i = 50; i < packets.size(); i += 2)
    if (packets[i].bytes.size() == head + 23 * segment)
      make_nan(packets[i].bytes, head + 10 * segment + 4);  // right hand's x
  Line line(xsens);
  line.run(packets);
  EXPECT_GT(line.performer().held_joints, 200U);
  EXPECT_THAT(line.advice("held-joints"), HasSubstr("not tracked and held"));
  EXPECT_GE(line.given.size(), 495U);
  EXPECT_EQ(line.performer().interruptions, 0U);
}

TEST(StreamFaults, NotANumberInThePelvisLosesTracking) {
  auto packets = frames(xsens);
  for (std::size_t i = 250; i < packets.size(); ++i)
    if (packets[i].bytes.size() > 760 - 1) make_nan(packets[i].bytes, 24 + 8);
  Line line(xsens);
  line.run(packets);
  EXPECT_THAT(line.advice("tracking-lost"), HasSubstr("the root (hips) is not tracked"));
  EXPECT_LE(line.given.size(), 260U);
}

TEST(StreamFaults, NotANumberInABoneOfVmcIsCountedAndNeverPassed) {
  auto packets = frames(vmc);
  for (Packet& packet : packets) {
    if (packet.arrives_s < 0.5) continue;
    const std::string text(packet.bytes.begin(), packet.bytes.end());
    // Address padded to 20 bytes, types ",sfffffff" to 12, "LeftHand" to 12, then the numbers.
    if (const auto at = text.find("LeftHand"); at != std::string::npos) make_nan(packet.bytes, at + 12);
  }
  Line line(vmc);
  line.run(packets);
  EXPECT_GT(line.issues("not-finite"), 100U);
  EXPECT_GE(line.given.size(), 490U);
}

TEST(StreamFaults, WrongTypesAreCountedAndTheRestIsRead) {
  auto packets = frames(vmc);
  for (Packet& packet : packets) {
    if (packet.arrives_s < 0.5) continue;
    const std::string text(packet.bytes.begin(), packet.bytes.end());
    const auto bone = text.find("LeftHand");
    if (bone == std::string::npos) continue;
    const auto types = text.rfind(",sfffffff", bone);
    if (types != std::string::npos) packet.bytes[types + 2] = 'T';  // a truth value has no bytes
  }
  Line line(vmc);
  line.run(packets);
  EXPECT_GT(line.health().packets_with_issues, 400U);
  EXPECT_GE(line.given.size(), 490U);
}

TEST(StreamFaults, AClockSetForwardsIsFollowedAndSaid) {
  for (const std::string& protocol : {vmc, xsens}) {
    auto encoder = encoder_of(protocol);
    std::vector<Packet> packets;
    append_frames(packets, *encoder, 0, 3, 0);
    append_frames(packets, *encoder, 3, 3, 3600);
    Line line(protocol);
    line.run(packets);
    EXPECT_EQ(line.performer().clock_jumps, 1U) << protocol;
    EXPECT_THAT(line.advice("clock-jump"), HasSubstr("clock jumped 3.0 s ago"));
    EXPECT_EQ(breaks(line), 2U);
    EXPECT_GE(line.given.size(), 590U);
    EXPECT_NEAR(line.given.back().time_s, 6, 0.05) << "times of the session stay those of the session";
  }
}

TEST(StreamFaults, AFrozenSenderIsSaid) {
  Line line(vmc);
  auto packets = frames(vmc, 1);
  auto encoder = encoder_of(vmc);
  for (int i = 0; i < 300; ++i)
    for (auto& bytes : encoder->packets({swinging(1), 1 + i / rate_hz, true}))
      packets.push_back({1 + i / rate_hz, std::move(bytes)});
  line.run(packets);
  EXPECT_THAT(line.advice("frozen"), HasSubstr("the pose has not changed for"));
}

TEST(StreamFaults, ALowRateIsSaid) {
  std::vector<Packet> packets;
  append_frames(packets, *encoder_of(xsens), 0, 5, 0, 12);
  Line line(xsens);
  line.run(packets);
  EXPECT_THAT(line.advice("low-rate"), HasSubstr("only 12.0 poses a second"));
}

TEST(StreamFaults, AFrameASecondIsALowRateAllTheTimeAndNotASilence) {
  std::vector<Packet> packets;
  append_frames(packets, *encoder_of(xsens), 0, 12, 0, 1);
  Line line(xsens);
  line.run(packets, 3.5);
  for (const double until_s : {11.1, 11.5, 11.95}) {
    line.run({}, until_s);
    EXPECT_THAT(line.advice("low-rate"), HasSubstr("only 1.0 poses a second")) << until_s;
  }
  line.run({}, 14.5);
  EXPECT_THAT(line.kinds(), Not(Contains("low-rate"))) << "has stopped";
}

TEST(StreamFaults, WhatIsNoPersonIsCounted) {
  std::vector<Packet> packets;
  append_frames(packets, *encoder_of(vmc), 0, 2, 0);
  Line line("vmc://0.0.0.0:39539?unit=100");  // as if the sender's metres were hectometres
  line.run(packets);
  EXPECT_NEAR(static_cast<double>(line.issues("not-a-person")), 200, 2);
  EXPECT_EQ(line.performer().unusable, 0U) << "whoever answers it decides";
}

TEST(StreamFaults, NothingAtAllIsSaidAfterTwoSeconds) {
  Line line(vmc);
  line.run({}, 1.5);
  EXPECT_THAT(line.kinds(), IsEmpty());
  line.run({}, 2.5);
  EXPECT_THAT(line.advice("no-packets"), AllOf(HasSubstr("firewall"), HasSubstr("39539")));
}

}  // namespace
}  // namespace abrazo::stream_faults_test
