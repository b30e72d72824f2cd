#include "core/stream/vmc/vmc_decoder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/motion/body/joint_set.hpp"
#include "core/stream/humanoid/humanoid_bones.hpp"
#include "tests/core/stream/vmc_packets.hpp"

namespace abrazo::vmc_decoder_test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using namespace test;

void expect_near(const Vec3& actual, const Vec3& expected, double tolerance = 1e-5) {
  EXPECT_LT((actual - expected).norm(), tolerance)
      << actual.transpose() << " instead of " << expected.transpose();
}

/// The T-pose of `t_pose` in our space: left at +X.
void expect_t_pose(const Receiver& receiver) {
  expect_near(receiver.point("Hips"), {0, 0.95, 0});
  expect_near(receiver.point("LeftUpperArm"), {0.16, 1.37, 0});
  expect_near(receiver.point("LeftHand"), {0.68, 1.37, 0});
  expect_near(receiver.point("RightHand"), {-0.68, 1.37, 0});
  expect_near(receiver.point("Head"), {0, 1.51, 0});
  expect_near(receiver.point("LeftFoot"), {0.09, 0.08, 0});
  expect_near(receiver.point("RightToes"), {-0.09, 0.03, 0.13});
}

TEST(VmcDecoder, ReadsEveryFramingOfRealSenders) {
  using Framing = std::vector<Bytes> (*)(const UnityPose&, float);
  for (const Framing framing :
       {Framing(as_vmc_application), Framing(as_slimevr), Framing(as_plain_messages)}) {
    Receiver receiver;
    for (int f = 0; f < 3; ++f) {
      receiver.take(framing(t_pose(), 10.0F + static_cast<float>(f)), 1 + f / 60.0);
      ASSERT_EQ(receiver.out.frames.size(), static_cast<std::size_t>(f) + 1);
      expect_t_pose(receiver);
      EXPECT_EQ(receiver.out.frames.back().sender_time_s, 10.0 + f);
      EXPECT_EQ(receiver.out.frames.back().first_arrived_s,
                1 + f / 60.0 + (framing == as_plain_messages ? 1e-4 : 0));
    }
    EXPECT_THAT(receiver.out.issues, IsEmpty());
    EXPECT_EQ(receiver.out.frames[0].performer, "127.0.0.1:50000");
    EXPECT_EQ(receiver.out.frames[0].points, receiver.out.frames[2].points);
  }
}

TEST(VmcDecoder, ReadsASenderWithoutTime) {
  Receiver receiver;
  std::vector<Bytes> frame = as_plain_messages(t_pose(), 0);
  frame.pop_back();
  receiver.take(frame, 1);
  EXPECT_THAT(receiver.out.frames, IsEmpty());
  receiver.pass_time(1.02);
  ASSERT_EQ(receiver.out.frames.size(), 1u);
  expect_t_pose(receiver);
  EXPECT_EQ(receiver.out.frames[0].sender_time_s, std::nullopt);
}

TEST(VmcDecoder, TurnsUnitysLeftHandIntoTheLeftHand) {
  // In Unity's left-handed space +30 degrees about Z turn X towards Y; the left arm points to -X, so that it
  // is raised by a negative angle.
  UnityPose raised = t_pose();
  raised["LeftUpperArm"].rotation = unity_rotation(-30, Vec3::UnitZ());
  Receiver receiver;
  receiver.take(as_slimevr(raised, 1), 1);
  const double along = 0.27 + 0.25;
  expect_near(receiver.point("LeftHand"), {0.16 + along * std::cos(0.5235988), 1.37 + along * 0.5, 0});
  expect_near(receiver.point("RightHand"), {-0.68, 1.37, 0});
  EXPECT_GT(receiver.joints()(joints::left_wrist, 1), receiver.joints()(joints::right_wrist, 1) + 0.2);
}

TEST(VmcDecoder, ReadsAnArmRaisedByOscsend) {
  // The message of osc_packet_test: LeftUpperArm turned by -45 degrees about Unity's Z, sent by oscsend.
  Receiver receiver("vmc://0.0.0.0:39539?split=port");
  receiver.take(as_plain_messages(t_pose(), 1), 1);
  receiver.take(
      from_hex("2f564d432f4578742f426f6e652f506f73000000 2c73666666666666660000004c656674557070657241726d"
               "00000000be051eb800000000000000000000000000000000bec3ef153f6c835e"),
      1.1, {0x7f000001, 41234});
  receiver.pass_time(1.2);
  ASSERT_EQ(receiver.out.frames.size(), 2u);
  expect_near(receiver.point("LeftHand"), {0.16 + 0.52 * std::sqrt(0.5), 1.37 + 0.52 * std::sqrt(0.5), 0});
}

TEST(VmcDecoder, PutsTheRootInFrontOfTheHips) {
  UnityPose pose = t_pose();
  Receiver receiver;
  OscElement root = unity_bone("root", {1, 0, 2}, unity_rotation(90, Vec3::UnitY()));
  root.address = "/VMC/Ext/Root/Pos";
  std::vector<OscElement> messages = {osc_time(1), root};
  for (const OscElement& bone : bones_of(pose)) messages.push_back(bone);
  receiver.take(bundle_of(messages), 1);
  // Unity's Y turns clockwise seen from above: forward (+Z) goes to the right (+X). Ours has the right at -X.
  expect_near(receiver.point("Hips"), {-1, 0.95, 2});
  expect_near(receiver.point("LeftToes") - receiver.point("LeftFoot"), {-0.13, -0.05, 0});
}

TEST(VmcDecoder, ReadsARootWithScaleAndOffsetWithoutApplyingThem) {
  Receiver receiver;
  OscElement root = unity_bone("root", {0, 0, 0}, Eigen::Quaterniond::Identity());
  root.address = "/VMC/Ext/Root/Pos";
  for (const float value : {1.1F, 1.1F, 1.1F, 0.0F, 0.2F, 0.0F})
    root.arguments.push_back(OscArgument::of(value));
  std::vector<OscElement> messages = {osc_time(1), root};
  for (const OscElement& bone : bones_of(t_pose())) messages.push_back(bone);
  receiver.take(bundle_of(messages), 1);
  expect_t_pose(receiver);
  EXPECT_THAT(receiver.decoder->facts(), Contains(HasSubstr("root scale (not applied)")));
}

TEST(VmcDecoder, KnowsAllNamesOfUnitysHumanoid) {
  EXPECT_EQ(humanoid::bone_count, 55);
  Receiver receiver;
  UnityPose pose = t_pose();
  for (int bone = 0; bone < humanoid::bone_count; ++bone)
    if (!pose.contains(humanoid_bone_name(bone))) pose[humanoid_bone_name(bone)].position = {0, 0.01, 0};
  pose["LastBone"];
  receiver.take(as_slimevr(pose, 1), 1);
  EXPECT_EQ(receiver.count("unknown-bone"), 0);
  for (const char* name : {"UpperChest", "Jaw", "LeftEye", "RightLittleDistal", "LeftThumbIntermediate"})
    EXPECT_TRUE(receiver.has_point(name)) << name;
  EXPECT_FALSE(receiver.has_point("LastBone"));
}

TEST(VmcDecoder, TakesTheThumbsOfVrmOne) {
  Receiver receiver;
  std::vector<OscElement> messages = {osc_time(1)};
  for (const OscElement& bone : bones_of(t_pose())) messages.push_back(bone);
  for (const char* name : {"LeftThumbMetacarpal", "LeftThumbProximal", "LeftThumbDistal"})
    messages.push_back(unity_bone(name, {-0.03, 0, 0}, Eigen::Quaterniond::Identity()));
  receiver.take(bundle_of(messages), 1);
  ASSERT_EQ(receiver.out.frames.size(), 1u);
  expect_near(receiver.point("LeftThumbDistal"), {0.68 + 0.09, 1.37, 0});
  EXPECT_TRUE(receiver.has_point("LeftThumbIntermediate"));
}

TEST(VmcDecoder, HangsBonesOnTheNextAncestorThatIsThere) {
  UnityPose pose = t_pose();
  for (const char* name :
       {"Chest", "UpperChest", "Neck", "LeftShoulder", "RightShoulder", "LeftToes", "RightToes"})
    pose.erase(name);
  pose["LeftUpperArm"].position = {-0.16, 0.32, 0};  // from the spine
  pose["Spine"].rotation = unity_rotation(90, Vec3::UnitY());
  Receiver receiver;
  receiver.take(as_slimevr(pose, 1), 1);
  expect_near(receiver.point("LeftUpperArm"), {0, 1.37, 0.16});
  EXPECT_EQ(receiver.joints().allFinite(), true);
  // Without toes the foot's own end tells where it points.
  EXPECT_TRUE(receiver.has_point("LeftFoot_End"));
  EXPECT_GT(receiver.joints()(joints::left_toe_tip, 2), 0.1);
}

TEST(VmcDecoder, ABoneAtItsParentsPlaceWithoutATurnIsMissingAndNotShort) {
  UnityPose pose = t_pose();
  for (const char* name : {"LeftToes", "RightToes", "Chest"}) pose[name] = {};
  Receiver receiver;
  receiver.take(as_slimevr(pose, 1), 1);
  EXPECT_FALSE(receiver.has_point("LeftToes"));
  EXPECT_FALSE(receiver.has_point("Chest"));
  EXPECT_TRUE(receiver.has_point("LeftFoot_End"));
  EXPECT_GT(receiver.joints()(joints::left_toe_tip, 2), 0.1) << "as without toes";
  EXPECT_THAT(receiver.decoder->facts(),
              testing::Contains(HasSubstr("3 more at their parent's place are left out")));
  pose["LeftHand"] = {};
  receiver.out.frames.clear();
  receiver.take(as_slimevr(pose, 2), 2);
  EXPECT_THAT(receiver.out.frames, IsEmpty());
  EXPECT_THAT(receiver.text("missing-bones"), HasSubstr("no pose without LeftHand"));
}

TEST(VmcDecoder, CountsUnknownBonesAndLeavesThemOut) {
  Receiver receiver;
  UnityPose pose = t_pose();
  pose["Tail"];
  pose["hips"];
  receiver.take(as_slimevr(pose, 1), 1);
  EXPECT_EQ(receiver.count("unknown-bone"), 2);
  EXPECT_THAT(receiver.text("unknown-bone"), HasSubstr("'Tail'"));
  expect_t_pose(receiver);
}

/// A frame in which one bone's message is another one.
Bytes frame_with(const OscElement& instead, float time) {
  std::vector<OscElement> messages = {osc_time(time)};
  for (const OscElement& bone : bones_of(t_pose()))
    if (bone.arguments[0].text != "LeftUpperArm") messages.push_back(bone);
  messages.push_back(instead);
  return bundle_of(messages);
}

TEST(VmcDecoder, TakesDoublesAndIntegersForFloatsAndCountsThem) {
  OscElement arm = unity_bone("LeftUpperArm", {-0.13, 0, 0}, Eigen::Quaterniond::Identity());
  arm.arguments[1].type = 'd';
  arm.arguments[7].type = 'i';
  Receiver receiver;
  receiver.take(frame_with(arm, 1), 1);
  EXPECT_EQ(receiver.count("other-numbers"), 1);
  expect_t_pose(receiver);
}

TEST(VmcDecoder, IgnoresFurtherArgumentsAndUnknownAddresses) {
  OscElement arm = unity_bone("LeftUpperArm", {-0.13, 0, 0}, Eigen::Quaterniond::Identity());
  arm.arguments.push_back(OscArgument::of(5));
  Receiver receiver;
  receiver.take(frame_with(arm, 1), 1);
  receiver.take(write_osc(std::vector{osc_message("/VMC/Ext/Blend/Apply", {})}), 1.001);
  receiver.take(write_osc(std::vector{osc_message("/somewhere/else", {OscArgument::of("x")})}), 1.002);
  EXPECT_THAT(receiver.out.issues, IsEmpty());
  expect_t_pose(receiver);
}

TEST(VmcDecoder, IgnoresMessagesWithTooFewArgumentsOrOtherTypes) {
  Receiver receiver;
  receiver.take(as_slimevr(t_pose(), 1), 1);
  OscElement few = unity_bone("LeftUpperArm", {9, 9, 9}, Eigen::Quaterniond::Identity());
  few.arguments.pop_back();
  receiver.take(frame_with(few, 2), 2);
  EXPECT_EQ(receiver.count("too-few-arguments"), 1);
  EXPECT_THAT(receiver.text("too-few-arguments"), HasSubstr("has 7 arguments; expected 'sfffffff'"));
  OscElement other = unity_bone("LeftUpperArm", {9, 9, 9}, Eigen::Quaterniond::Identity());
  other.arguments[0] = OscArgument::of(3);
  receiver.take(frame_with(other, 3), 3);
  EXPECT_EQ(receiver.count("wrong-types"), 1);
  ASSERT_EQ(receiver.out.frames.size(), 3u);
  expect_t_pose(receiver);
  EXPECT_EQ(receiver.count("incomplete-frame"), 1);  // one bone less than in the frame before
}

TEST(VmcDecoder, KeepsTheLastRotationWhenOneCannotBe) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Receiver receiver;
  UnityPose raised = t_pose();
  raised["LeftUpperArm"].rotation = unity_rotation(-90, Vec3::UnitZ());
  receiver.take(as_slimevr(raised, 1), 1);
  const Vec3 hand = receiver.point("LeftHand");
  float time = 2;
  const auto take_rotation = [&](double x, double y, double z, double w) {
    OscElement arm = unity_bone("LeftUpperArm", {-0.13, 0, 0}, Eigen::Quaterniond(w, x, y, z));
    receiver.take(frame_with(arm, time), static_cast<double>(time));
    time += 1;
    expect_near(receiver.point("LeftHand"), hand);
  };
  take_rotation(static_cast<double>(nan), 0, 0, 1);
  EXPECT_EQ(receiver.count("not-finite"), 1);
  take_rotation(0, 0, 0, 0);
  EXPECT_EQ(receiver.count("zero-rotation"), 1);
  take_rotation(0, 0, 0, 0.4);
  take_rotation(1, 1, 1, 1);
  EXPECT_EQ(receiver.count("bad-rotation"), 2);
  EXPECT_THAT(receiver.text("bad-rotation"), HasSubstr("LeftUpperArm"));
  OscElement infinite = unity_bone("LeftUpperArm", {-0.13, 0, 0}, Eigen::Quaterniond::Identity());
  infinite.arguments[2].number = std::numeric_limits<double>::infinity();
  receiver.take(frame_with(infinite, time), static_cast<double>(time));
  expect_near(receiver.point("LeftHand"), hand);
  EXPECT_EQ(receiver.count("not-finite"), 2);
}

TEST(VmcDecoder, NormalisesRotationsThatAreNearlyOfLengthOne) {
  Receiver receiver;
  Eigen::Quaterniond longer = unity_rotation(-90, Vec3::UnitZ());
  longer.coeffs() *= 1.3;
  receiver.take(frame_with(unity_bone("LeftUpperArm", {-0.13, 0, 0}, longer), 1), 1);
  expect_near(receiver.point("LeftHand"), {0.16, 1.37 + 0.52, 0});
  EXPECT_THAT(receiver.out.issues, IsEmpty());
}

TEST(VmcDecoder, UsesAnAverageBodyForASenderWithoutOffsets) {
  UnityPose pose = t_pose();
  for (auto& [name, bone] : pose) bone.position.setZero();
  pose["LeftLowerArm"].rotation = unity_rotation(90, Vec3::UnitY());  // forwards
  Receiver receiver;
  OscElement root = unity_bone("root", {1, 0, 0}, Eigen::Quaterniond::Identity());
  root.address = "/VMC/Ext/Root/Pos";
  std::vector<OscElement> messages = {osc_time(1), root};
  for (const OscElement& bone : bones_of(pose)) messages.push_back(bone);
  receiver.take(bundle_of(messages), 1);
  expect_near(receiver.point("Hips"), {-1, 0.95, 0});
  expect_near(receiver.point("LeftHand") - receiver.point("LeftLowerArm"), {0, 0, 0.25});
  EXPECT_NEAR(receiver.joints()(joints::left_ankle, 1), 0.08, 1e-6);
  EXPECT_THAT(receiver.decoder->facts(), ElementsAre(HasSubstr("no offsets: an average body's are used")));
}

TEST(VmcDecoder, KeepsTheHipsOfASenderWithoutOtherOffsets) {
  UnityPose pose = t_pose();
  for (auto& [name, bone] : pose)
    if (name != "Hips") bone.position.setZero();
  pose["Hips"].position = {0.5, 0.76, 0.25};  // 80 % of an average body
  Receiver receiver;
  receiver.take(as_slimevr(pose, 1), 1);
  expect_near(receiver.point("Hips"), {-0.5, 0.76, 0.25});
  expect_near(receiver.point("LeftHand") - receiver.point("LeftLowerArm"), {0.8 * 0.25, 0, 0});
}

TEST(VmcDecoder, GivesNoPoseWithoutTheBonesThatEveryHumanoidHas) {
  UnityPose pose = t_pose();
  pose.erase("LeftFoot");
  pose.erase("Hips");
  Receiver receiver;
  receiver.take(as_slimevr(pose, 1), 1);
  EXPECT_THAT(receiver.out.frames, IsEmpty());
  EXPECT_THAT(receiver.text("missing-bones"), HasSubstr(": no pose without Hips, LeftFoot"));
  pose = t_pose();
  std::erase_if(pose, [](const auto& bone) {
    return bone.first.find("Leg") != std::string::npos || bone.first.find("Foot") != std::string::npos ||
           bone.first.find("Toes") != std::string::npos;
  });
  Receiver of_upper_body;
  of_upper_body.take(as_slimevr(pose, 2), 2);
  EXPECT_THAT(of_upper_body.text("missing-bones"),
              HasSubstr(": bones come, but no legs: no pose without LeftUpperLeg, "));
}

TEST(VmcDecoder, TakesEverySenderForAPerformer) {
  Receiver receiver;
  UnityPose other = t_pose();
  other["Hips"].position.x() = 2;
  for (int f = 0; f < 3; ++f) {
    receiver.take(as_vmc_application(t_pose(), static_cast<float>(f)), 1.0 + f, {0x7f000001, 50000});
    receiver.take(as_vmc_application(other, static_cast<float>(f)), 1.005 + f, {0x7f000001, 50001});
  }
  ASSERT_EQ(receiver.out.frames.size(), 6u);
  EXPECT_EQ(receiver.out.frames[4].performer, "127.0.0.1:50000");
  EXPECT_EQ(receiver.out.frames[5].performer, "127.0.0.1:50001");
  EXPECT_NEAR(receiver.out.frames[5].positions(0, 0), -2, 1e-6);
  EXPECT_THAT(receiver.out.issues, IsEmpty());
  EXPECT_EQ(receiver.decoder->facts().size(), 2u);
}

TEST(VmcDecoder, TakesAllSendersOfAPortForOnePerformerWhenAsked) {
  // As oscsend does, which takes another port every time.
  Receiver receiver("vmc://0.0.0.0:39539?split=port");
  const auto packets = as_plain_messages(t_pose(), 1);
  for (std::size_t p = 0; p < packets.size(); ++p)
    receiver.take(packets[p], 1, {0x7f000001, static_cast<std::uint16_t>(40000 + p)});
  ASSERT_EQ(receiver.out.frames.size(), 1u);
  EXPECT_EQ(receiver.out.frames[0].performer, "all senders");
  const auto uri = parse_stream_uri("vmc://0.0.0.0:39539?split=port");
  StreamUri wrong = *uri;
  wrong.options.find("split")->second = "name";
  EXPECT_THAT(make_vmc_decoder(wrong).error().message, HasSubstr("expected sender"));
}

TEST(VmcDecoder, BoundsTheNumberOfSenders) {
  Receiver receiver;
  const Bytes packet = as_slimevr(t_pose(), 1)[0];
  for (std::uint16_t port = 1; port <= 1000; ++port) receiver.take(packet, 0.001 * port, {0x7f000001, port});
  EXPECT_EQ(receiver.decoder->facts().size(), 16u);
  EXPECT_EQ(receiver.count("many-senders"), 1000 - 16);
  EXPECT_THAT(receiver.text("many-senders"), HasSubstr("split=port"));
}

/// A pose whose every arm bone is turned by so much.
UnityPose turned(double degrees) {
  UnityPose pose = t_pose();
  for (const char* name : {"Hips", "LeftUpperArm", "RightUpperArm", "LeftLowerArm", "RightLowerArm", "Spine"})
    pose[name].rotation = unity_rotation(degrees, Vec3(1, 2, 3).normalized());
  return pose;
}

TEST(VmcDecoder, SaysThatTwoSendersShareAnAddress) {
  for (const bool packets_alternate : {false, true}) {
    Receiver receiver;
    for (int f = 0; f < 150; ++f) {
      const double time = f / 60.0;
      const auto one = as_vmc_application(turned(0.5 * f), static_cast<float>(100 + time));
      const auto two = as_vmc_application(turned(90 + 0.3 * f), static_cast<float>(3 + time));
      if (packets_alternate) {
        for (std::size_t p = 0; p < one.size(); ++p) {
          receiver.take(one[p], time);
          receiver.take(two[p], time);
        }
      } else {
        receiver.take(one, time);
        receiver.take(two, time + 0.007);
      }
      receiver.pass_time(time + 0.01);
    }
    EXPECT_EQ(receiver.count("two-senders"), 2) << packets_alternate;
    EXPECT_THAT(receiver.text("two-senders"), HasSubstr("its own port"));
  }
}

TEST(VmcDecoder, DoesNotTakeQuickMotionForTwoSenders) {
  Receiver receiver;
  for (int f = 0; f < 300; ++f) {
    receiver.take(as_slimevr(turned(60 * std::sin(0.3 * f)), static_cast<float>(f) / 60), f / 60.0);
    receiver.pass_time(f / 60.0);
  }
  EXPECT_THAT(receiver.out.issues, IsEmpty());
}

TEST(VmcDecoder, SaysThatTheSendersClockStands) {
  Receiver receiver;
  for (int f = 0; f < 150; ++f) {
    receiver.take(as_slimevr(turned(f), 7.25F), f / 60.0);
    receiver.pass_time(f / 60.0);
  }
  EXPECT_EQ(receiver.out.frames.size(), 150u);
  EXPECT_EQ(receiver.count("frozen-sender"), 2);  // once a second
  EXPECT_THAT(receiver.text("frozen-sender"), HasSubstr("T stands at 7.25 s"));
}

TEST(VmcDecoder, SaysThatTheSenderWasRestarted) {
  Receiver receiver;
  receiver.take(as_slimevr(t_pose(), 100), 1);
  receiver.take(as_slimevr(turned(10), 0.02F), 1.02);
  EXPECT_EQ(receiver.count("clock-reset"), 1);
  EXPECT_EQ(receiver.out.frames.size(), 2u);
  receiver.take(as_slimevr(turned(20), 0.01F), 1.04);  // overtaken, not restarted
  EXPECT_EQ(receiver.count("clock-reset"), 1);
  EXPECT_EQ(receiver.out.frames.size(), 3u);
}

TEST(VmcDecoder, SaysWhatTheSenderSaysOfItself) {
  const auto issues_of = [](std::vector<int> ok, bool bones) {
    Receiver receiver;
    std::vector<OscArgument> arguments;
    for (const int value : ok) arguments.push_back(OscArgument::of(value));
    for (int f = 0; f < 80; ++f) {
      receiver.take(write_osc(std::vector{osc_message("/VMC/Ext/OK", arguments)}), f / 60.0);
      if (bones)
        receiver.take(as_slimevr(turned(f), static_cast<float>(f) / 60), f / 60.0);
      else
        receiver.take(write_osc(std::vector{osc_time(static_cast<float>(f) / 60)}), f / 60.0);
      receiver.pass_time(f / 60.0);
    }
    std::vector<std::string> kinds;
    for (const StreamIssue& issue : receiver.out.issues)
      if (issue.kind != "duplicate-packet") kinds.push_back(issue.kind);
    return kinds;
  };
  // SlimeVR's own OK of one number follows in the frames with bones.
  EXPECT_THAT(issues_of({0}, false), ElementsAre("no-bones", "not-loaded"));
  EXPECT_THAT(issues_of({1, 2, 0, 1}, false), ElementsAre("no-bones", "not-calibrated"));
  EXPECT_THAT(issues_of({1, 3, 0, 0}, false), ElementsAre("no-bones", "not-tracking"));
  EXPECT_THAT(issues_of({1, 3, 0}, true), IsEmpty());
}

TEST(VmcDecoder, LeavesOutAPacketThatCameTwice) {
  Receiver receiver;
  for (int f = 0; f < 3; ++f) {
    const auto packets = as_vmc_application(turned(10 * f), static_cast<float>(f));
    for (const Bytes& packet : packets) {
      receiver.take(packet, f);
      receiver.take(packet, f + 1e-4);
    }
  }
  EXPECT_EQ(receiver.out.frames.size(), 3u);
  EXPECT_EQ(receiver.count("duplicate-packet"), 6);
}

TEST(VmcDecoder, ShowsEachFrameOnceWhenPacketsOvertakeOneAnother) {
  Receiver receiver;
  for (int f = 0; f < 60; ++f) {
    auto packets = as_vmc_application(turned(f), static_cast<float>(f));
    ASSERT_EQ(packets.size(), 2u);
    if (f == 30) std::swap(packets[0], packets[1]);
    receiver.take(packets, f / 60.0);
    receiver.pass_time((f + 0.9) / 60.0);
  }
  // What came late is a frame of its own, closed by silence.
  EXPECT_EQ(receiver.out.frames.size(), 61u);
  EXPECT_EQ(receiver.count("incomplete-frame"), 2);
}

TEST(VmcDecoder, HoldsTheBonesOfAPacketThatWasLost) {
  Receiver receiver;
  receiver.take(as_vmc_application(t_pose(), 1), 1);
  const auto packets = as_vmc_application(turned(30), 2);
  receiver.take(packets.back(), 2);
  EXPECT_EQ(receiver.out.frames.size(), 2u);
  EXPECT_THAT(receiver.text("incomplete-frame"), HasSubstr("12 bones of the frame before did not come"));
}

TEST(VmcDecoder, SaysThatAPacketIsNotOfThisProtocol) {
  Receiver receiver;
  receiver.take(from_hex("4d5854503032000000000001"), 1);
  receiver.take(Bytes{}, 1);
  EXPECT_EQ(receiver.count("not-osc"), 1);
  EXPECT_EQ(receiver.count("truncated"), 1);
  EXPECT_THAT(receiver.decoder->facts(), IsEmpty());
}

TEST(VmcDecoder, PaysNoHeedToTimeTagsInTheFuture) {
  std::vector<OscElement> elements = {osc_bundle_begin(0xffffffff00000000u), osc_time(1)};
  for (const OscElement& bone : bones_of(t_pose())) elements.push_back(bone);
  elements.push_back(osc_bundle_end());
  Receiver receiver;
  receiver.take(write_osc(elements), 1);
  EXPECT_EQ(receiver.out.frames.size(), 1u);
}

TEST(VmcDecoder, GivesFinitePosesWhateverComes) {
  std::mt19937 random(5);
  Receiver receiver;
  const auto packets = as_vmc_application(t_pose(), 1);
  for (int i = 0; i < 20000; ++i) {
    Bytes bytes = packets[static_cast<std::size_t>(i) % packets.size()];
    for (int change = 0; change < 3; ++change)
      bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    receiver.take(bytes, 0.004 * i);
    receiver.pass_time(0.004 * i + 0.002);
    for (const PerformerFrame& frame : receiver.out.frames) {
      ASSERT_TRUE(frame.positions.allFinite());
      ASSERT_EQ(frame.positions.rows(), static_cast<Eigen::Index>(frame.points->size()));
    }
    ASSERT_LE(receiver.out.issues.size(), 64u);
    receiver.out = {};
  }
}

}  // namespace
}  // namespace abrazo::vmc_decoder_test
