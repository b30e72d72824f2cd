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
#include "tests/core/stream/natnet_packets.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::natnet_decoder_test {
namespace {

using Eigen::Quaterniond;
using test::Listener;
using namespace natnet_test;

/// To a server set to Z up: what Motive streams then.
NatNetSkeletonFrame z_up(NatNetSkeletonFrame frame) {
  const auto turned = [](const Vec3& v) { return Vec3(v.x(), -v.z(), v.y()); };
  for (NatNetBody& body : frame.bones) {
    body.position = turned(body.position);
    body.rotation.vec() = turned(body.rotation.vec());
  }
  return frame;
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

TEST(NatNetModelDescription, OnlyTheSkeletonsOwnNameIsTakenOffItsBones) {
  const auto names_in = [](const std::string& skeleton_name, std::vector<std::string> names) {
    ByteWriter writer(ByteOrder::Little);
    for (const int head : {1, 2}) writer.i32(head);  // one description, a skeleton
    writer.c_string(skeleton_name);
    writer.i32(7);
    writer.i32(static_cast<std::int32_t>(names.size()));
    for (std::size_t b = 0; b < names.size(); ++b) {
      writer.c_string(names[b]);
      writer.i32(static_cast<std::int32_t>(b + 1));
      writer.i32(static_cast<std::int32_t>(b));
      writer.vec3(Vec3::UnitY());
      writer.i32(0);  // markers
    }
    ByteReader reader(writer.bytes(), ByteOrder::Little);
    const auto model = parse_natnet_model(reader, {3, 0});
    for (std::size_t b = 0; b < names.size(); ++b) names[b] = model->skeletons.at(0).bones.at(b).name;
    return names;
  };
  EXPECT_EQ(names_in("Ana", {"Ana_Hip", "Ana:Head"}), (std::vector<std::string>{"Hip", "Head"}));
  EXPECT_EQ(names_in("Ana", {"Arm_twist", "An"}), (std::vector<std::string>{"Arm_twist", "An"}));
  EXPECT_EQ(names_in("", {"_Hip"}), std::vector<std::string>{"_Hip"});
}

TEST(NatNetModelDescription, AnAssetIsPassedOverWhole) {
  for (const int markers : {0, 1, 3}) {
    ByteWriter writer(ByteOrder::Little);
    for (const int head : {1, 6}) writer.i32(head);  // one description, an asset
    const std::size_t size_at = writer.size();
    writer.u32(0);
    writer.c_string("A");
    for (const int number : {1, 2, 0, markers}) writer.i32(number);  // kind, number, rigid bodies, markers
    for (int m = 0; m < markers; ++m) {
      writer.c_string("M");
      writer.i32(m);
      writer.vec3(Vec3::UnitX());
      writer.i32(1);
      for (int rest = 0; rest < 2; ++rest) writer.u8(0);
    }
    writer.u32_at(size_at, static_cast<std::uint32_t>(writer.size() - size_at - 4));
    ByteReader reader(writer.bytes(), ByteOrder::Little);
    const auto model = parse_natnet_model(reader, v41);
    ASSERT_TRUE(model) << model.error().text();
    EXPECT_TRUE(model->unread.empty()) << markers << ": " << model->unread.front();
  }
}

TEST(NatNetModelDescription, AnAssetThatIsCutOffIsNotRead) {
  ByteWriter writer(ByteOrder::Little);
  for (const int head : {1, 6}) writer.i32(head);
  const std::size_t size_at = writer.size();
  writer.u32(0);
  writer.c_string("A");
  for (const int number : {1, 2, 0, 1}) writer.i32(number);
  writer.c_string("LeftAnkleOutside");
  for (int rest = 0; rest < 20; ++rest) writer.u8(0);  // of the 22 bytes behind the marker's name
  writer.u32_at(size_at, static_cast<std::uint32_t>(writer.size() - size_at - 4));
  ByteReader reader(writer.bytes(), ByteOrder::Little);
  const auto model = parse_natnet_model(reader, v41);
  ASSERT_TRUE(model) << model.error().text();
  EXPECT_EQ(model->assets, 0u);
  ASSERT_EQ(model->unread.size(), 1u);
  EXPECT_NE(model->unread[0].find("a marker's description"), std::string::npos) << model->unread[0];
}

TEST(NatNetModelDescription, ADeviceIsCountedAndItsChannelsPassedOver) {
  ByteWriter writer(ByteOrder::Little);
  for (const int head : {2, 4}) writer.i32(head);  // two descriptions, of which the first is a device
  const std::size_t size_at = writer.size();
  writer.u32(0);
  writer.i32(1);
  writer.c_string("amplifier");
  writer.c_string("A-1");
  for (const int number : {1, 2, 2}) writer.i32(number);  // kind, kind of its data, channels
  writer.c_string("left");
  writer.c_string("right");
  writer.u32_at(size_at, static_cast<std::uint32_t>(writer.size() - size_at - 4));
  writer.i32(5);  // a camera
  writer.u32(2 + 28);
  writer.c_string("C");
  for (int rest = 0; rest < 28; ++rest) writer.u8(0);
  ByteReader reader(writer.bytes(), ByteOrder::Little);
  const auto model = parse_natnet_model(reader, v41);
  ASSERT_TRUE(model) << model.error().text();
  EXPECT_EQ(model->devices, 1u);
  EXPECT_EQ(model->cameras, 1u);
  EXPECT_TRUE(model->unread.empty());
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
  listener.pass_time(0);  // asks who is there
  listener.take(server_info({2, 10}));
  EXPECT_TRUE(listener.has_issue("old-version"));
  listener.forget();
  listener.take(frame_packet(frame_of({}), v41));
  EXPECT_TRUE(listener.has_issue("old-version")) << "why its frames cannot be read: " << listener.issues();
  EXPECT_FALSE(listener.has_issue("no-version"));
}

TEST(NatNetMessages, AGroupIsFourNumbersFrom0To255) {
  EXPECT_EQ(parse_natnet_group("239.0.0.255"), 0xEF0000FF);
  for (const char* none :
       {"239.0.0.256", "239.0.-1.1", "-17.0.0.1", "239.0.0", "239.0.0.1.2", "239.0.x.1", "10.0.0.9", ""})
    EXPECT_FALSE(parse_natnet_group(none)) << none;
}

TEST(NatNetMessages, AVersionIsOneOf3Point0To4Point2) {
  EXPECT_EQ(parse_natnet_version("3.0"), (NatNetVersion{3, 0}));
  EXPECT_EQ(parse_natnet_version("4.2"), (NatNetVersion{4, 2}));
  for (const char* none : {"2.10", "4.3", "5.0", "-3.0", "4", "4.x", "4.1.0", ""})
    EXPECT_FALSE(parse_natnet_version(none)) << none;
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
