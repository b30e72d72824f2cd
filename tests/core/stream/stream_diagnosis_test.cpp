#include "core/stream/receive/stream_diagnosis.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

namespace abrazo::stream_diagnosis_test {
namespace {

using testing::AllOf, testing::HasSubstr, testing::IsEmpty, testing::Not;
using Severity = StreamDiagnosis::Severity;

/// A stream with one performer that nothing is wrong with, seen after a minute.
StreamObservation healthy(const std::string& uri = "vmc://0.0.0.0:39539") {
  StreamObservation seen;
  seen.uri = *parse_stream_uri(uri);
  seen.now_s = 60;
  seen.packets = seen.recent_packets = 500;
  seen.last_packet_s = seen.last_frame_s = seen.last_understood_s = 59.99;
  seen.recent_senders = {"10.0.0.1:5000"};
  PerformerObservation ana;
  ana.health.performer = "Ana";
  ana.health.tracked = ana.health.calibrated = true;
  ana.health.rate_hz = 100;
  ana.health.interval_p50_ms = 10;
  ana.health.interval_p95_ms = 12;
  ana.recent_frames = 500;
  ana.last_pose_s = 59.99;
  ana.posture = {true, 1.65, 0.85, 0.0, 0.6, 0.04, 0, 0};
  seen.performers = {ana};
  return seen;
}

std::string texts(const StreamObservation& seen) {
  std::string all;
  for (const StreamDiagnosis& diagnosis : diagnose(seen))
    all += diagnosis.kind + ": " + diagnosis.text + "\n";
  return all;
}

void set_bytes(StreamObservation& seen, std::string_view text, std::size_t size) {
  seen.first_bytes_count = std::min<std::size_t>(16, text.size());
  std::copy_n(text.begin(), seen.first_bytes_count, seen.first_bytes.begin());
  seen.unknown_size = size;
}

TEST(StreamDiagnosis, KnowsOtherProtocolsByHowTheyBegin) {
  const auto guessed = [](std::string_view text) {
    StreamObservation seen;
    set_bytes(seen, text, text.size());
    return protocol_of(seen.first_bytes, seen.first_bytes_count, seen.unknown_size).value_or("none");
  };
  for (const auto& [text, protocol] : {std::pair<std::string_view, std::string>{"MXTP02", "Xsens MVN (MXTP)"},
                                       {"#bundle", "VMC (OSC)"},
                                       {"/VMC/Ext/OK", "VMC (OSC)"},
                                       {"/other", "OSC"},
                                       {"{\"scene\":", "Rokoko (JSON)"},
                                       {"\x04\x22\x4D\x18", "Rokoko (JSON)"},
                                       {"\xDD\xFF", "Noitom (binary BVH)"},
                                       {"\xFF\xDD", "Noitom (binary BVH)"},
                                       {"vrpn: ver. 07.35", "VRPN"},
                                       {"GET / HTTP/1.1", "HTTP"},
                                       {"POST / HTTP/1.1", "HTTP"},
                                       {"HTTP/1.1 400", "HTTP"},
                                       {"GETTING", "none"},
                                       {"hello", "none"}})
    EXPECT_EQ(guessed(text), protocol) << text;
}

TEST(StreamDiagnosis, AHealthyStreamNeedsNoAdvice) {
  EXPECT_EQ(texts(healthy()), "");
}

TEST(StreamDiagnosis, SilenceIsExplainedByWhereItIsListenedTo) {
  StreamObservation seen;
  seen.now_s = 3;
  seen.uri = *parse_stream_uri("vmc://0.0.0.0:39539");
  EXPECT_THAT(texts(seen), AllOf(HasSubstr("no-packets: no packet for 3 s"), HasSubstr("firewall")));
  seen.uri = *parse_stream_uri("vmc://127.0.0.1:39539");
  EXPECT_THAT(texts(seen),
              HasSubstr("listen on 0.0.0.0:39539 (every network) when it runs on another machine"));
  seen.uri = *parse_stream_uri("natnet://10.0.0.9?multicast=239.255.42.99");
  EXPECT_THAT(texts(seen), AllOf(HasSubstr("10.0.0.9 does not answer on port 1510"), HasSubstr("loopback"),
                                 HasSubstr("multicast-silent"), HasSubstr("interface=ADDRESS")));
  seen.now_s = 1.9;
  EXPECT_EQ(texts(seen), "") << "patience";
}

TEST(StreamDiagnosis, AStreamThatStoppedIsAnError) {
  StreamObservation seen = healthy();
  seen.last_packet_s = 57;
  EXPECT_EQ(diagnose(seen).front().kind, "stalled");
  EXPECT_EQ(diagnose(seen).front().severity, Severity::Error);
}

TEST(StreamDiagnosis, AnAddressThatThisMachineLostExplainsTheSilence) {
  StreamObservation seen = healthy("vmc://10.0.0.5:39539");
  seen.last_packet_s = 50;
  seen.lost_address = "10.0.0.5";
  EXPECT_THAT(texts(seen), AllOf(HasSubstr("address-gone: this machine no longer has the address 10.0.0.5"),
                                 HasSubstr("0.0.0.0:39539"), Not(HasSubstr("stalled"))));
  seen.uri = *parse_stream_uri("natnet://10.0.0.9?interface=10.0.0.5");
  EXPECT_THAT(texts(seen), HasSubstr("or leave interface= out"));
}

TEST(StreamDiagnosis, NamesTheProtocolThatComesInstead) {
  StreamObservation seen = healthy();
  seen.performers.clear();
  seen.last_frame_s = seen.last_understood_s = -1;
  seen.recent_unknown = 500;
  set_bytes(seen, "MXTP02", 760);
  EXPECT_THAT(texts(seen), AllOf(HasSubstr("not as VMC"), HasSubstr("4d 58 54 50 30 32 \"MXTP02\""),
                                 HasSubstr("looks like Xsens MVN (MXTP); choose that protocol")));
  set_bytes(seen, std::string_view("\x07\x00\x4C\x01", 4), 336);
  EXPECT_THAT(texts(seen), HasSubstr("looks like NatNet"));
  set_bytes(seen, "{\"scene\":", 3000);
  EXPECT_THAT(texts(seen), HasSubstr("looks like Rokoko"));
  seen.unreadable = "expected an address";
  set_bytes(seen, "hello", 5);
  EXPECT_THAT(texts(seen), AllOf(HasSubstr("\"hello\""), HasSubstr("expected an address")));
  set_bytes(seen, "a\x7f\x1f~ ", 5);
  EXPECT_THAT(texts(seen), HasSubstr("61 7f 1f 7e 20 \"a..~ \"")) << "no control characters in a message";
}

TEST(StreamDiagnosis, TheRightProtocolWithoutBonesSaysWhatToSwitchOn) {
  for (const auto& [uri, advice] : std::vector<std::pair<std::string, std::string>>{
           {"vmc://0.0.0.0", "no model loaded or is not tracking (OK 0)"},
           {"natnet://10.0.0.9", "switch on Skeletons"},
           {"xsens://0.0.0.0", "tick Position + Orientation"}}) {
    StreamObservation seen = healthy(uri);
    seen.performers.clear();
    seen.last_frame_s = -1;
    EXPECT_THAT(texts(seen),
                AllOf(HasSubstr("no-bones"), HasSubstr(advice), Not(HasSubstr("newest problem"))));
    seen.latest_issue.text = "a bone without a name";
    EXPECT_THAT(texts(seen), HasSubstr(". The newest problem: a bone without a name\n"));
    seen.latest_issue = {"missing-bones", "127.0.0.1:5: bones come, but no legs"};
    EXPECT_THAT(texts(seen),
                AllOf(HasSubstr("no-bones: 127.0.0.1:5: bones come, but no legs\n"), Not(HasSubstr(advice))))
        << "the cause is known";
  }
}

/// The advice when one thing is different from a healthy stream.
template <typename Change>
std::string when(Change change, const std::string& uri = "vmc://0.0.0.0:39539") {
  StreamObservation seen = healthy(uri);
  change(seen, seen.performers.front());
  return texts(seen);
}

TEST(StreamDiagnosis, SeesWhatIsWrongWithTheNetwork) {
  using S = StreamObservation;
  using P = PerformerObservation;
  EXPECT_THAT(when([](S& s, P&) { s.recent_senders.emplace_back("10.0.0.2:5"); }),
              HasSubstr("two-senders: 2 senders"));
  EXPECT_THAT(when([](S& s, P&) {
                s.recent_senders = {"10.0.0.2:5", "10.0.0.2:6"};
              }),
              HasSubstr("receive with the option split=port"))
      << "one program that takes a new socket for each packet";
  EXPECT_THAT(when([](S& s, P&) {
                s.uri.scheme = StreamUri::Scheme::NatNet;
                s.recent_senders = {"10.0.0.2:1510", "10.0.0.2:1511"};
              }),
              Not(HasSubstr("two-senders")))
      << "Motive answers from one port and sends from the other";
  EXPECT_THAT(when([](S& s, P&) { s.recent_overflow = 7; }), HasSubstr("kernel-overflow: 7 packets"));
  EXPECT_THAT(when([](S& s, P&) { s.group_failure = "no group"; }), HasSubstr("multicast: no group"));
  EXPECT_THAT(when([](S&, P& p) { p.recent_lost = 10; }), HasSubstr("loss: 2.0 % of the frames are lost"));
  EXPECT_THAT(when([](S&, P& p) { p.recent_lost = 2; }), IsEmpty());
  EXPECT_THAT(when([](S&, P& p) { p.recent_late = 50; }), HasSubstr("late: 10 % of the frames"));
  EXPECT_THAT(when([](S&, P& p) { p.recent_repeated = 50; }), HasSubstr("repeated: 10 %"));
  EXPECT_THAT(when([](S&, P& p) { p.health.interval_p95_ms = 43; }),
              AllOf(HasSubstr("irregular"), HasSubstr("waits 43 ms instead of 10 ms; a delay of 35 ms")));
  EXPECT_THAT(when([](S&, P& p) { p.health.interval_p95_ms = 43, p.health.delay_ms = 40; }), IsEmpty());
  EXPECT_THAT(when([](S&, P& p) { p.health.rate_hz = 12; }), HasSubstr("low-rate: only 12.0 poses a second"));
  EXPECT_THAT(when([](S& s, P&) { s.failure = "socket gone"; }), HasSubstr("failed: socket gone"));
}

TEST(StreamDiagnosis, SeesWhatIsWrongWithTheSender) {
  using S = StreamObservation;
  using P = PerformerObservation;
  EXPECT_THAT(when([](S&, P& p) { p.frozen_s = 3; }),
              HasSubstr("frozen: frames come but the pose has not changed for 3.0 s"));
  EXPECT_THAT(when([](S&, P& p) { p.clock_doubt = SenderClock::Doubt::Stands; }), HasSubstr("frozen-clock"));
  EXPECT_THAT(when([](S&, P& p) { p.clock_doubt = SenderClock::Doubt::Coarse; }), HasSubstr("coarse-clock"));
  EXPECT_THAT(when([](S&, P& p) { p.clock_doubt = SenderClock::Doubt::Jumps; }), HasSubstr("unsteady-clock"));
  EXPECT_THAT(when([](S&, P& p) { p.last_clock_jump_s = 58; }),
              HasSubstr("clock-jump: the sender's clock jumped 2.0 s ago"));
  EXPECT_THAT(when([](S&, P& p) { p.last_clock_jump_s = 40; }), IsEmpty()) << "long ago";
  EXPECT_THAT(when([](S&, P& p) { p.last_restart_s = 57; }), HasSubstr("sender-restarted"));
  EXPECT_THAT(when([](S&, P& p) { p.posture.alternating = 0.9; }),
              HasSubstr("interleaved: the pose jumps to and fro"));
  EXPECT_THAT(when([](S&, P& p) { p.posture.jumps = 0.3; }), HasSubstr("jumps: "));
  EXPECT_THAT(when([](S&, P& p) { p.recent_held_frames = 100; }), HasSubstr("held-joints: in 20 %"));
  EXPECT_THAT(when([](S&, P& p) { p.health.tracked = false, p.last_pose_s = 58, p.why_no_pose = "no root"; }),
              HasSubstr("tracking-lost: tracking is lost for 2.0 s: no root"));
  EXPECT_THAT(
      when([](S&, P& p) { p.health.tracked = false, p.last_pose_s = -1, p.why_no_pose = "lacks Hips"; }),
      HasSubstr("no-pose: frames come without a pose for 60.0 s: lacks Hips"));
}

TEST(StreamDiagnosis, SeesUnitAxisFloorAndRestPose) {
  using S = StreamObservation;
  using P = PerformerObservation;
  const auto tall = [](double height) { return when([&](S&, P& p) { p.posture.bones_height_m = height; }); };
  EXPECT_THAT(tall(170), AllOf(HasSubstr("unit: the body is 170 m tall"), HasSubstr("?unit=cm")));
  EXPECT_THAT(tall(1700), HasSubstr("?unit=mm"));
  EXPECT_THAT(tall(0.017), AllOf(HasSubstr("1.7 cm tall"), HasSubstr("?unit=100")));
  EXPECT_THAT(tall(2.4), IsEmpty()) << "a tall avatar";
  EXPECT_THAT(tall(2.7), HasSubstr("check the scale of the avatar")) << "no unit makes a person of it";
  EXPECT_THAT(when([](S&, P& p) { p.posture.hips_above_feet_m = 0.02, p.posture.hips_before_feet_m = 0.86; }),
              AllOf(HasSubstr("axis: the hips are 0.02 m above the feet"), HasSubstr("add ?up=z")));
  EXPECT_THAT(when([](S&, P& p) { p.posture.hips_above_feet_m = 0.02, p.posture.hips_before_feet_m = 0.4; }),
              AllOf(HasSubstr("lying, or the axes are turned"), Not(HasSubstr("?up=z"))));
  EXPECT_THAT(when([](S&, P& p) { p.posture.hips_above_feet_m = -0.85; }),
              HasSubstr("axis: the hips are -0.85 m"));
  EXPECT_THAT(when([](S&, P& p) { p.posture.head_above_hips_m = -0.4; }), HasSubstr("rest-pose"));
  EXPECT_THAT(when([](S&, P& p) { p.posture.lowest_foot_m = 0.4; }),
              HasSubstr("floor: the feet are at 0.40 m"));
  EXPECT_THAT(when([](S&, P& p) { p.health.calibrated = false; }), HasSubstr("not-calibrated"));
  EXPECT_THAT(when([](S&, P& p) { p.health.calibrated = false; }, "xsens://0.0.0.0"), IsEmpty());
  EXPECT_THAT(when([](S&, P& p) { p.health.calibrated = p.health.tracked = false; }),
              Not(HasSubstr("not-calibrated")))
      << "nobody is there who could stand in the T-pose";
  EXPECT_THAT(when([](S&, P& p) { p.health.calibration_doubts = {"the left arm is bent"}; }),
              HasSubstr("calibration: the T-pose is doubtful: the left arm is bent"));
}

TEST(StreamDiagnosis, PutsTheWorstFirstAndNamesThePerformerAmongSeveral) {
  StreamObservation seen = healthy();
  seen.performers.push_back(seen.performers.front());
  seen.performers[0].health.calibrated = false;
  seen.performers[1].health.performer = "Ben";
  seen.performers[1].posture.hips_above_feet_m = -0.8;
  const auto list = diagnose(seen);
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0].kind, "axis");
  EXPECT_TRUE(list[0].text.starts_with("Ben: "));
  EXPECT_TRUE(list[1].text.starts_with("Ana: "));
}

}  // namespace
}  // namespace abrazo::stream_diagnosis_test
