#include "core/stream/natnet/natnet_decoder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <set>

#include "core/motion/joints/joint_map.hpp"
#include "core/stream/natnet/natnet_encoder.hpp"
#include "core/stream/natnet/natnet_frame.hpp"
#include "core/stream/natnet/natnet_model.hpp"
#include "tests/core/stream/mocap_stream.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::natnet_decoder_test {
namespace {

using Eigen::Quaterniond;
using test::Listener;

std::vector<std::uint8_t> server_info(NatNetVersion version, bool multicast = false) {
  NatNetServerInfo info;
  info.application = "Motive";
  info.application_version[0] = 3;
  info.application_version[1] = 1;
  info.version = version;
  info.clock_hz = 1000;
  info.data_port = 1515;
  info.multicast = multicast;
  info.group = 0xEFFF2A63;  // 239.255.42.99
  ByteWriter writer(ByteOrder::Little);
  write_natnet_server_info(writer, info);
  return natnet_packet(NatNetMessage::ServerInfo, writer);
}

std::vector<std::uint8_t> model_packet(const std::vector<NatNetSkeleton>& skeletons, NatNetVersion version) {
  NatNetModel model;
  model.skeletons = skeletons;
  ByteWriter writer(ByteOrder::Little);
  write_natnet_model(writer, model, version);
  return natnet_packet(NatNetMessage::ModelDef, writer);
}

std::vector<std::uint8_t> frame_packet(const NatNetFrame& frame, NatNetVersion version) {
  ByteWriter writer(ByteOrder::Little);
  write_natnet_frame(writer, frame, version);
  return natnet_packet(NatNetMessage::Frame, writer);
}

/// Hip at 1 m, chest 0.5 m above, head 0.3 m above that; a left arm of two bones and a hand.
NatNetSkeleton skeleton(const std::string& name, std::int32_t id) {
  return {name,
          id,
          {{"Hip", 1, 0, Vec3::Zero()},
           {"Chest", 2, 1, Vec3(0, 0.5, 0)},
           {"Head", 3, 2, Vec3(0, 0.3, 0)},
           {"LFArm", 4, 2, Vec3(0.2, 0.2, 0)},
           {"LHand", 5, 4, Vec3(0.25, 0, 0)}}};
}

const Vec3 hip_world(3, 1, 2);

/// That skeleton with the hip turned about y, the rest in the rest pose.
NatNetSkeletonFrame posed(const NatNetSkeleton& of, bool local, double yaw = 0.5) {
  NatNetSkeletonFrame frame{of.id, {}};
  std::vector<Vec3> places;
  const Quaterniond turn(Eigen::AngleAxisd(yaw, Vec3::UnitY()));
  for (const NatNetBone& bone : of.bones) {
    const auto parent = static_cast<std::size_t>(bone.parent - 1);
    places.push_back(bone.parent == 0 ? hip_world : Vec3(places[parent] + turn * bone.offset));
    NatNetBody body;
    body.id = of.id << 16 | bone.id;
    body.position = local && bone.parent > 0 ? bone.offset : places.back();
    body.rotation = local && bone.parent > 0 ? Quaterniond::Identity() : turn;
    body.tracked = true;
    frame.bones.push_back(body);
  }
  return frame;
}

/// To a server set to Z up: what Motive streams then.
NatNetSkeletonFrame z_up(NatNetSkeletonFrame frame) {
  const auto turned = [](const Vec3& v) { return Vec3(v.x(), -v.z(), v.y()); };
  for (NatNetBody& body : frame.bones) {
    body.position = turned(body.position);
    body.rotation.vec() = turned(body.rotation.vec());
  }
  return frame;
}

NatNetFrame frame_of(const std::vector<NatNetSkeletonFrame>& skeletons, std::int32_t number = 1) {
  NatNetFrame frame;
  frame.number = number;
  frame.skeletons = skeletons;
  frame.time_s = 12.5;
  frame.stamps = NatNetStamps{1000, 1003, 1005};
  return frame;
}

constexpr NatNetVersion v41{4, 1};

/// A listener that knows a server with these skeletons.
Listener connected(const std::vector<NatNetSkeleton>& skeletons, std::string_view uri = "natnet://10.0.0.5",
                   NatNetVersion version = v41) {
  Listener listener(uri);
  listener.pass_time(0);
  listener.take(server_info(version));
  listener.pass_time(0);
  listener.take(model_packet(skeletons, version));
  listener.forget();
  return listener;
}

std::vector<NatNetMessage> requests(const Listener& listener) {
  std::vector<NatNetMessage> ids;
  for (const OutgoingDatagram& reply : listener.out.replies) {
    EXPECT_EQ(reply.to, Endpoint{}) << "the URI's host and port";
    ids.push_back(static_cast<NatNetMessage>(reply.bytes.at(0)));
  }
  return ids;
}

TEST(NatNetConversation, ConnectsAsksForTheModelAndKeepsAlive) {
  Listener listener("natnet://10.0.0.5");
  listener.pass_time(0);
  ASSERT_EQ(requests(listener), std::vector{NatNetMessage::Connect});
  EXPECT_EQ(listener.out.replies[0].bytes, test::bytes_of("00 00 05 00 50 69 6E 67 00"));  // "Ping"
  listener.forget();
  listener.pass_time(0.5);
  EXPECT_TRUE(requests(listener).empty()) << "once a second";
  listener.take(server_info(v41), 0.6);
  listener.pass_time(0.61);
  EXPECT_EQ(requests(listener), (std::vector{NatNetMessage::RequestModelDef, NatNetMessage::KeepAlive,
                                             NatNetMessage::EchoRequest}));
  listener.take(model_packet({skeleton("Ana", 1)}, v41), 0.7);
  listener.forget();
  for (int i = 0; i < 300; ++i) {  // three seconds with frames
    listener.take(frame_packet(frame_of({posed(skeleton("Ana", 1), false)}, i), v41), 0.7 + 0.01 * i);
    listener.pass_time(0.7 + 0.01 * i);
  }
  const auto asked = requests(listener);
  EXPECT_EQ(std::count(asked.begin(), asked.end(), NatNetMessage::KeepAlive), 3);
  EXPECT_EQ(std::count(asked.begin(), asked.end(), NatNetMessage::RequestModelDef), 0);
  EXPECT_EQ(listener.out.frames.size(), 300u);
  EXPECT_TRUE(listener.has_fact("Motive 3.1.0, NatNet 4.1"));
  EXPECT_TRUE(listener.has_fact("from exposure to sending 5.0 ms"));
}

TEST(NatNetConversation, ListeningEverywhereAsksWhomItHears) {
  Listener listener("natnet://0.0.0.0?multicast=239.255.42.99");
  ASSERT_TRUE(listener.decoder->wanted_group());
  EXPECT_EQ(*listener.decoder->wanted_group(), (Endpoint{0xEFFF2A63, 1511}));
  listener.pass_time(0);
  EXPECT_TRUE(listener.out.replies.empty());
  listener.take(frame_packet(frame_of({}), v41), 0.1);
  EXPECT_TRUE(listener.has_issue("no-version")) << listener.issues();
  listener.pass_time(0.2);
  ASSERT_EQ(listener.out.replies.size(), 1u);
  EXPECT_EQ(listener.out.replies[0].to, (Endpoint{0x7F000001, 1510}));
}

TEST(NatNetConversation, JoinsTheGroupThatTheServerNames) {
  Listener listener("natnet://10.0.0.5");
  EXPECT_FALSE(listener.decoder->wanted_group());
  listener.pass_time(0);
  listener.take(server_info(v41, true));
  ASSERT_TRUE(listener.decoder->wanted_group());
  EXPECT_EQ(*listener.decoder->wanted_group(), (Endpoint{0xEFFF2A63, 1515}));
}

TEST(NatNetConversation, FramesBeforeTheModelAreCountedAndTheModelIsAskedForAgain) {
  Listener listener("natnet://10.0.0.5");
  listener.pass_time(0);
  listener.take(server_info(v41));
  listener.pass_time(0);
  listener.forget();
  listener.take(frame_packet(frame_of({posed(skeleton("Ana", 1), false)}), v41), 0.1);
  EXPECT_TRUE(listener.has_issue("no-model"));
  EXPECT_TRUE(listener.out.frames.empty());
  listener.pass_time(0.6);
  EXPECT_EQ(requests(listener), std::vector{NatNetMessage::RequestModelDef});
}

TEST(NatNetConversation, ATimeThatIsNotANumberIsCountedAndTheFrameIsTakenWithoutIt) {
  Listener listener = connected({skeleton("Ana", 1)});
  NatNetFrame frame = frame_of({posed(skeleton("Ana", 1), false)});
  frame.time_s = std::numeric_limits<double>::quiet_NaN();
  listener.forget();
  listener.take(frame_packet(frame, v41), 0.1);
  EXPECT_TRUE(listener.has_issue("not-finite")) << listener.issues();
  ASSERT_EQ(listener.out.frames.size(), 1u);
  EXPECT_FALSE(listener.out.frames[0].sender_time_s);
}

TEST(NatNetConversation, ChangedModelsAreAskedForAndAnUnknownSkeletonSaysSo) {
  Listener listener = connected({skeleton("Ana", 1)});
  listener.pass_time(0);
  listener.forget();
  NatNetFrame frame = frame_of({posed(skeleton("Ana", 1), false), posed(skeleton("Ben", 2), false)});
  listener.take(frame_packet(frame, v41), 1);
  EXPECT_EQ(listener.out.frames.size(), 1u);
  EXPECT_TRUE(listener.has_issue("unknown-skeleton"));
  listener.pass_time(1);
  EXPECT_NE(std::ranges::count(requests(listener), NatNetMessage::RequestModelDef), 0);
  listener.take(model_packet({skeleton("Ana", 1), skeleton("Ben", 2)}, v41), 1.1);
  listener.forget();
  frame.models_changed = true;
  listener.take(frame_packet(frame, v41), 1.2);
  ASSERT_EQ(listener.out.frames.size(), 2u);
  EXPECT_EQ(listener.out.frames[0].performer, "Ana");
  EXPECT_EQ(listener.out.frames[1].performer, "Ben");
  listener.pass_time(2);
  EXPECT_NE(std::ranges::count(requests(listener), NatNetMessage::RequestModelDef), 0);
}

TEST(NatNetConversation, AfterASilenceItConnectsAnewAndAsksForTheModel) {
  Listener listener = connected({skeleton("Ana", 1)});
  listener.take(frame_packet(frame_of({posed(skeleton("Ana", 1), false)}), v41), 0);
  listener.pass_time(0);
  listener.forget();
  listener.pass_time(2.5);
  EXPECT_NE(std::ranges::count(requests(listener), NatNetMessage::Connect), 0);
  EXPECT_EQ(std::ranges::count(requests(listener), NatNetMessage::RequestModelDef), 0);
  listener.take(server_info({3, 1}), 2.6);
  listener.forget();
  listener.pass_time(3.2);
  EXPECT_NE(std::ranges::count(requests(listener), NatNetMessage::RequestModelDef), 0);
}

// ---- somebody else ----

/// What a program anywhere may send to end or bend a stream: another version, another group.
std::vector<std::uint8_t> forged_info(NatNetVersion version) {
  NatNetServerInfo info;
  info.application = "Forged";
  info.version = version;
  info.multicast = true;
  info.group = 0xE0000042;  // 224.0.0.66
  ByteWriter writer(ByteOrder::Little);
  write_natnet_server_info(writer, info);
  return natnet_packet(NatNetMessage::ServerInfo, writer);
}

TEST(NatNetTakeover, AServerInfoThatNobodyAskedForChangesNothing) {
  Listener listener = connected({skeleton("Ana", 1)});
  for (int i = 0; i < 60; ++i) {
    const double now_s = i / 60.0;
    listener.take(forged_info({3, 0}), now_s);
    listener.take(frame_packet(frame_of({posed(skeleton("Ana", 1), false)}, i), v41), now_s);
    listener.pass_time(now_s);
  }
  EXPECT_EQ(listener.out.frames.size(), 60u) << listener.issues();
  EXPECT_TRUE(listener.has_issue("unasked-answer"));
  EXPECT_FALSE(listener.decoder->wanted_group()) << "only the server names a group";
  EXPECT_TRUE(listener.has_fact("Motive 3.1.0, NatNet 4.1"));
}

TEST(NatNetTakeover, AModelThatNobodyAskedForChangesNothing) {
  Listener listener = connected({skeleton("Ana", 1)});
  listener.take(model_packet({skeleton("Eve", 1)}, v41), 0.1);
  listener.take(frame_packet(frame_of({posed(skeleton("Ana", 1), false)}), v41), 0.2);
  ASSERT_EQ(listener.out.frames.size(), 1u);
  EXPECT_EQ(listener.out.frames[0].performer, "Ana");
  EXPECT_TRUE(listener.has_issue("unasked-answer"));
}

TEST(NatNetTakeover, AnAnswerThatTheFramesContradictIsNotTaken) {
  Listener listener = connected({skeleton("Ana", 1)});
  listener.pass_time(2.5);  // silence: asked again
  for (int i = 0; i < 10; ++i)
    listener.take(frame_packet(frame_of({posed(skeleton("Ana", 1), false)}, i), v41), 2.6 + 0.01 * i);
  listener.take(forged_info({3, 0}), 2.75);
  EXPECT_TRUE(listener.has_issue("contradiction")) << listener.issues();
  listener.forget();
  listener.take(frame_packet(frame_of({posed(skeleton("Ana", 1), false)}, 11), v41), 2.8);
  EXPECT_EQ(listener.out.frames.size(), 1u);
}

TEST(NatNetTakeover, AfterAForgedAnswerFramesAreBackWithinHalfASecondOfTheServersOwn) {
  Listener listener("natnet://10.0.0.5");
  listener.pass_time(0);
  listener.take(forged_info({3, 0}), 0.001);  // before the server's
  listener.pass_time(0.001);
  std::optional<double> back_s;
  for (int i = 1; i < 60 && !back_s; ++i) {  // a server that answers whatever it is asked
    const double now_s = i / 60.0;
    listener.take(frame_packet(frame_of({posed(skeleton("Ana", 1), false)}, i), v41), now_s);
    if (!listener.out.frames.empty()) back_s = now_s;
    listener.forget();
    listener.pass_time(now_s);
    for (const NatNetMessage request : requests(listener)) {
      if (request == NatNetMessage::Connect) listener.take(server_info(v41), now_s + 0.001);
      if (request == NatNetMessage::RequestModelDef)
        listener.take(model_packet({skeleton("Ana", 1)}, v41), now_s + 0.001);
    }
  }
  ASSERT_TRUE(back_s);
  EXPECT_LE(*back_s, 0.5);
}

TEST(NatNetTakeover, TheGroupThatTheServerNamesIsToldAndMustBeOne) {
  Listener listener("natnet://10.0.0.5");
  listener.pass_time(0);
  listener.take(server_info(v41, true));
  EXPECT_TRUE(listener.has_fact("multicast group 239.255.42.99:1515, as the server says"));

  NatNetServerInfo info;
  info.version = v41;
  info.multicast = true;
  info.group = 0x0A000009;  // 10.0.0.9
  ByteWriter writer(ByteOrder::Little);
  write_natnet_server_info(writer, info);
  Listener other("natnet://10.0.0.5");
  other.pass_time(0);
  other.take(natnet_packet(NatNetMessage::ServerInfo, writer));
  EXPECT_FALSE(other.decoder->wanted_group());
  EXPECT_NE(other.issues().find("names 10.0.0.9 as its multicast group"), std::string::npos);
}

TEST(NatNetTakeover, WithoutAHostTheMachineThatSentFramesFirstIsHeardUntilItFallsSilent) {
  const Endpoint server{0x0A000001, 1511}, other{0x0A000002, 1511};
  Listener listener("natnet://0.0.0.0?version=4.1");
  const auto frame = [&](const Endpoint& from, double at_s) {
    const auto bytes =
        frame_packet(frame_of({posed(skeleton("Ana", 1), false)}, static_cast<int>(100 * at_s)), v41);
    listener.decoder->take({from, at_s, bytes}, listener.out);
  };
  const auto describe = [&](const Endpoint& by, double at_s) {
    listener.pass_time(at_s);
    const auto bytes = model_packet({skeleton("Ana", 1)}, v41);
    listener.decoder->take({by, at_s, bytes}, listener.out);
  };
  frame(server, 0);
  describe(server, 0.01);
  listener.forget();
  for (int i = 1; i <= 100; ++i) {
    frame(server, 0.02 * i);
    frame(other, 0.02 * i + 0.001);
  }
  EXPECT_EQ(listener.out.frames.size(), 100u) << "of the server alone";
  EXPECT_NE(listener.issues().find("frames of 10.0.0.2 are left out: those of 10.0.0.1 came first"),
            std::string::npos);
  frame(other, 3.2);
  describe(other, 3.21);
  listener.forget();
  frame(other, 3.3);
  EXPECT_EQ(listener.out.frames.size(), 1u);
  frame(server, 3.31);
  EXPECT_EQ(listener.out.frames.size(), 1u) << "came back too late";
}

TEST(NatNetConversation, SaysWhatToTickWhenNoFramesCome) {
  Listener listener = connected({skeleton("Ana", 1)});
  for (double now = 0; now < 10; now += 0.5) {
    listener.take(server_info(v41), now);
    listener.pass_time(now);
  }
  EXPECT_TRUE(listener.has_issue("no-frames"));
  EXPECT_NE(listener.issues().find("Broadcast Frame Data"), std::string::npos);
}

TEST(NatNetSkeleton, WorldAndLocalBonesGiveTheSamePointsAndAreTold) {
  const NatNetSkeleton ana = skeleton("Ana", 1);
  const Quaterniond turn(Eigen::AngleAxisd(0.5, Vec3::UnitY()));
  for (const bool local : {false, true}) {
    Listener listener = connected({ana});
    listener.take(frame_packet(frame_of({posed(ana, local)}, 77), v41), 4.5);
    ASSERT_EQ(listener.out.frames.size(), 1u);
    const PerformerFrame& frame = listener.out.frames[0];
    EXPECT_EQ(frame.counter, 77);
    EXPECT_EQ(frame.sender_time_s, 12.5);
    EXPECT_EQ(frame.arrived_s, 4.5);
    const Vec3 elbow = hip_world + turn * Vec3(0.2, 0.7, 0), wrist = elbow + turn * Vec3(0.25, 0, 0);
    EXPECT_NEAR((listener.point("Head") - hip_world - Vec3(0, 0.8, 0)).norm(), 0, 1e-6) << local;
    EXPECT_NEAR((listener.point("LHand") - wrist).norm(), 0, 1e-6) << local;
    // The hand goes on as the forearm does in the rest pose, by 0.56 of its length.
    EXPECT_NEAR((listener.point("LHand_End") - wrist - turn * Vec3(0.56 * 0.25, 0, 0)).norm(), 0, 1e-6);
    EXPECT_TRUE(
        listener.has_fact(local ? "coordinates of the parent bone (found" : "world coordinates (found"));
  }
}

TEST(NatNetSkeleton, LocalBonesAreRecognisedWithoutOffsetsToo) {
  NatNetSkeleton ana = skeleton("Ana", 1);
  const NatNetSkeletonFrame world = posed(ana, false), local = posed(ana, true);
  for (NatNetBone& bone : ana.bones) bone.offset.setZero();
  for (const bool is_local : {false, true}) {
    Listener listener = connected({ana});
    listener.take(frame_packet(frame_of({is_local ? local : world}), v41));
    EXPECT_NEAR((listener.point("Head") - hip_world - Vec3(0, 0.8, 0)).norm(), 0, 1e-6) << is_local;
  }
}

TEST(NatNetSkeleton, ZUpIsFoundFromTheRestPoseAlsoOfSomebodyLyingDown) {
  const NatNetSkeleton ana = skeleton("Ana", 1);
  for (const bool local : {false, true})
    for (const bool lies : {false, true}) {
      NatNetSkeletonFrame frame = posed(ana, local, 0);
      const Quaterniond down(Eigen::AngleAxisd(lies ? std::numbers::pi / 2 : 0, Vec3::UnitX()));
      for (std::size_t b = 0; b < frame.bones.size(); ++b) {
        if (local && b > 0) break;
        frame.bones[b].position = hip_world + down * (frame.bones[b].position - hip_world);
        frame.bones[b].rotation = down * frame.bones[b].rotation;
      }
      Listener y_listener = connected({ana}), z_listener = connected({ana});
      y_listener.take(frame_packet(frame_of({frame}), v41));
      z_listener.take(frame_packet(frame_of({z_up(frame)}), v41));
      for (const char* name : {"Hip", "Head", "LHand", "LHand_End"})
        EXPECT_NEAR((y_listener.point(name) - z_listener.point(name)).norm(), 0, 1e-6)
            << name << local << lies;
      EXPECT_TRUE(y_listener.has_fact("Y up (found"));
      EXPECT_TRUE(z_listener.has_fact("Z up (found"));
    }
}

TEST(NatNetSkeleton, OptionsDecideOverTheData) {
  const NatNetSkeleton ana = skeleton("Ana", 1);
  Listener listener = connected({ana}, "natnet://h?coordinates=local&up=z");
  listener.take(frame_packet(frame_of({posed(ana, true, 0)}), v41));
  EXPECT_NEAR((listener.point("Hip") - Vec3(3, 2, -1)).norm(), 0, 1e-6);
  EXPECT_TRUE(listener.has_fact("(as set)"));
  for (const char* wrong : {"natnet://h?coordinates=both", "natnet://h?up=x", "natnet://h?version=9.9",
                            "natnet://h?multicast=10.0.0.1"}) {
    const auto uri = parse_stream_uri(wrong);
    ASSERT_TRUE(uri);
    EXPECT_FALSE(make_natnet_decoder(*uri)) << wrong;
  }
}

TEST(NatNetSkeleton, BonesThatAreNotTrackedAreNotFinite) {
  const NatNetSkeleton ana = skeleton("Ana", 1);
  Listener listener = connected({ana});
  NatNetSkeletonFrame frame = posed(ana, false);
  frame.bones[4].tracked = false;
  listener.take(frame_packet(frame_of({frame}), v41));
  EXPECT_FALSE(listener.point("LHand").allFinite());
  EXPECT_FALSE(listener.point("LHand_End").allFinite());
  EXPECT_TRUE(listener.point("LFArm").allFinite());
  listener.forget();
  for (NatNetBody& bone : frame.bones) bone.tracked = false;
  listener.take(frame_packet(frame_of({frame}), v41));
  EXPECT_TRUE(listener.out.frames.empty()) << "nothing of the performer is tracked";
}

TEST(NatNetSkeleton, FlagsThatAreNeverSetSayNothing) {
  const NatNetSkeleton ana = skeleton("Ana", 1);
  Listener listener = connected({ana});
  NatNetSkeletonFrame frame = posed(ana, false);
  for (NatNetBody& bone : frame.bones) bone.tracked = false;
  listener.take(frame_packet(frame_of({frame}), v41));
  EXPECT_TRUE(listener.point("LHand").allFinite());
  EXPECT_TRUE(listener.has_fact("no tracking flags"));
}

TEST(NatNetSkeleton, AMissingSkeletonGivesNoFrameForItsPerformer) {
  Listener listener = connected({skeleton("Ana", 1), skeleton("Ben", 2)});
  listener.take(frame_packet(frame_of({posed(skeleton("Ben", 2), false)}), v41));
  ASSERT_EQ(listener.out.frames.size(), 1u);
  EXPECT_EQ(listener.out.frames[0].performer, "Ben");
}

TEST(NatNetSkeleton, RigidBodiesAloneSayWhatToTick) {
  Listener listener = connected({});
  NatNetFrame frame = frame_of({});
  frame.bodies.resize(3);
  listener.take(frame_packet(frame, v41));
  EXPECT_TRUE(listener.has_issue("no-skeleton"));
  EXPECT_NE(listener.issues().find("3 rigid bodies and no skeleton"), std::string::npos) << listener.issues();
}

TEST(NatNetSkeleton, NotFinitePositionsAreCountedAndLeftOut) {
  const NatNetSkeleton ana = skeleton("Ana", 1);
  Listener listener = connected({ana});
  NatNetSkeletonFrame frame = posed(ana, false);
  frame.bones[2].position.x() = std::numeric_limits<double>::infinity();
  listener.take(frame_packet(frame_of({frame}), v41));
  EXPECT_TRUE(listener.has_issue("not-finite"));
  EXPECT_FALSE(listener.point("Head").allFinite());
}

TEST(NatNetModelDescription, IsReadInEveryVersionWithMarkersAndRestRotations) {
  // A rigid body "B" (number 2) with one marker, then the skeleton "S" with the bone "S_Hip".
  const std::string marker = "01 00 00 00  00 00 80 3F 00 00 80 3F 00 00 80 3F  00 00 00 00";
  const std::string body = "42 00  02 00 00 00  FF FF FF FF  00 00 00 00 00 00 00 00 00 00 00 00";
  const std::string bone = "53 5F 48 69 70 00  01 00 00 00  00 00 00 00  00 00 00 00 00 00 80 3F 00 00 00 00";
  const std::string rotation = "00 00 00 00 00 00 00 00 00 00 00 00 00 00 80 3F";
  const std::string two = "02 00 00 00", skeleton_head = "53 00  03 00 00 00  01 00 00 00",
                    none = "00 00 00 00";
  const auto read = [](const std::string& hex, NatNetVersion version) {
    const auto bytes = test::bytes_of(hex);
    ByteReader reader(bytes, ByteOrder::Little);
    return parse_natnet_model(reader, version);
  };
  const std::string v3 = two + "01 00 00 00" + body + marker + "02 00 00 00" + skeleton_head + bone + none;
  const std::string v4 =
      two + "01 00 00 00" + body + marker + "4D 00" + "02 00 00 00" + skeleton_head + bone + none;
  // 22 + 20 + 2 and 10 + 26 + 4 bytes
  const std::string v41_text = two + "01 00 00 00 2C 00 00 00" + body + marker + "4D 00" +
                               "02 00 00 00 28 00 00 00" + skeleton_head + bone + none;
  const std::string v42 = two + "01 00 00 00 3C 00 00 00" + body + rotation + marker + "4D 00" +
                          "02 00 00 00 38 00 00 00" + skeleton_head + bone + rotation + none;
  for (const auto& [hex, version] : {std::pair{v3, NatNetVersion{3, 0}},
                                     {v4, NatNetVersion{4, 0}},
                                     {v41_text, NatNetVersion{4, 1}},
                                     {v42, NatNetVersion{4, 2}}}) {
    const auto model = read(hex, version);
    ASSERT_TRUE(model) << version.text() << model.error().text();
    EXPECT_TRUE(model->unread.empty()) << version.text() << model->unread[0];
    EXPECT_EQ(model->rigid_bodies, std::vector<std::string>{"B"});
    ASSERT_EQ(model->skeletons.size(), 1u) << version.text();
    EXPECT_EQ(model->skeletons[0].id, 3);
    EXPECT_EQ(model->skeletons[0].bones[0].name, "Hip") << "without the skeleton's name";
    EXPECT_EQ(model->skeletons[0].bones[0].offset, Vec3(0, 1, 0));
  }
}

TEST(NatNetModelDescription, AnUnknownKindCostsOnlyItselfWhereSizesAreSent) {
  const auto bytes = test::bytes_of("02 00 00 00  63 00 00 00 02 00 00 00 EE EE" +
                                    std::string("05 00 00 00 1E 00 00 00 43 00") + std::string(56, '0'));
  ByteReader reader(bytes, ByteOrder::Little);
  const auto model = parse_natnet_model(reader, v41);
  ASSERT_TRUE(model) << model.error().text();
  EXPECT_EQ(model->cameras, 1u);
  ASSERT_EQ(model->unread.size(), 1u);
  EXPECT_NE(model->unread[0].find("unknown kind 99"), std::string::npos);
}

TEST(NatNetSkeleton, CirclesAmongParentsAndDoubleNamesAreNoTrouble) {
  NatNetSkeleton odd{"Odd", 1, {}};
  for (int b = 1; b <= 4; ++b) odd.bones.push_back({"same", b, b % 4 + 1, Vec3::Zero()});
  odd.bones.push_back({"own", 5, 5, Vec3::Zero()});
  Listener listener = connected({odd});
  NatNetSkeletonFrame frame{1, {}};
  for (int b = 1; b <= 5; ++b) {
    NatNetBody body;
    body.id = b;
    body.position = Vec3(b, 1, 1);
    body.tracked = true;
    frame.bones.push_back(body);
  }
  listener.take(frame_packet(frame_of({frame}), v41));
  ASSERT_EQ(listener.out.frames.size(), 1u);
  const auto& names = *listener.out.frames[0].points;
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

TEST(NatNetMessages, OtherProtocolsAndCutPacketsAreNamed) {
  Listener listener("natnet://h");
  listener.take(test::bytes_of("23 62 75 6E 64 6C 65 00"));  // "#bundle": OSC
  EXPECT_TRUE(listener.has_issue("other-protocol"));
  listener.forget();
  listener.take(test::bytes_of("07"));
  EXPECT_TRUE(listener.has_issue("truncated"));
  listener.forget();
  listener.take(test::bytes_of("07 00 40 00 01"));
  EXPECT_NE(listener.issues().find("announces 64 bytes behind its head, but has 1"), std::string::npos);
  listener.forget();
  listener.take(server_info({2, 10}));
  EXPECT_TRUE(listener.has_issue("old-version"));
}

TEST(NatNetMessages, TheServerInfoHas283Bytes) {
  EXPECT_EQ(server_info({3, 0}).size(), 283u);  // as a real server's of version 3
}

TEST(NatNetBoneNames, OfEveryConventionFindTheJoints) {
  const auto sided = [](std::vector<std::string> middle, const std::vector<std::string>& left,
                        const std::vector<std::string>& right) {
    middle.insert(middle.end(), left.begin(), left.end());
    middle.insert(middle.end(), right.begin(), right.end());
    return middle;
  };
  const std::vector<std::vector<std::string>> conventions = {
      sided({"Hip", "Ab", "Chest", "Neck", "Head"},
            {"LShoulder", "LUArm", "LFArm", "LHand", "LThigh", "LShin", "LFoot", "LToe"},
            {"RShoulder", "RUArm", "RFArm", "RHand", "RThigh", "RShin", "RFoot", "RToe"}),
      sided({"Hips", "Spine", "Spine1", "Neck", "Head"},
            {"LeftShoulder", "LeftArm", "LeftForeArm", "LeftHand", "LeftUpLeg", "LeftLeg", "LeftFoot",
             "LeftToeBase"},
            {"RightShoulder", "RightArm", "RightForeArm", "RightHand", "RightUpLeg", "RightLeg", "RightFoot",
             "RightToeBase"}),
      sided({"Hips", "Chest", "Chest2", "Neck", "Head"},
            {"LeftCollar", "LeftShoulder", "LeftElbow", "LeftWrist", "LeftHip", "LeftKnee", "LeftAnkle",
             "LeftToe"},
            {"RightCollar", "RightShoulder", "RightElbow", "RightWrist", "RightHip", "RightKnee",
             "RightAnkle", "RightToe"}),
      sided({"pelvis", "spine_01", "spine_02", "neck_01", "head"},
            {"clavicle_l", "upperarm_l", "lowerarm_l", "hand_l", "thigh_l", "calf_l", "foot_l", "ball_l"},
            {"clavicle_r", "upperarm_r", "lowerarm_r", "hand_r", "thigh_r", "calf_r", "foot_r", "ball_r"})};
  // Lower back, upper back, left shoulder, elbow and knee, by convention.
  const std::vector<std::vector<std::string>> expected = {
      {"Ab", "Chest", "LUArm", "LFArm", "LShin"},
      {"Spine", "Spine1", "LeftArm", "LeftForeArm", "LeftLeg"},
      {"Chest", "Chest2", "LeftShoulder", "LeftElbow", "LeftKnee"},
      {"spine_01", "spine_02", "upperarm_l", "lowerarm_l", "calf_l"}};
  for (std::size_t c = 0; c < conventions.size(); ++c) {
    const JointMap* fitting = nullptr;
    for (const JointMap& map : builtin_joint_maps())
      if (!fitting && bind_joints(map, conventions[c]).missing.empty()) fitting = &map;
    ASSERT_TRUE(fitting) << conventions[c][0];
    EXPECT_EQ(fitting->name, "motive");
    const JointBinding binding = bind_joints(*fitting, conventions[c]);
    int i = 0;
    for (const int joint : std::array<int, 5>{joints::LowerBack, joints::UpperBack, joints::left_shoulder,
                                              joints::left_elbow, joints::left_knee})
      EXPECT_EQ(conventions[c][static_cast<std::size_t>(
                    binding.terms[static_cast<std::size_t>(joint)].front().first)],
                expected[c][static_cast<std::size_t>(i++)]);
  }
}

}  // namespace
}  // namespace abrazo::natnet_decoder_test
