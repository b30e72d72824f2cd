// Programs that others wrote, on the other end of our streams: oscsend and oscdump of liblo.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <sstream>

#include "core/base/text.hpp"
#include "core/motion/files/import_clip.hpp"
#include "tests/cli/live_fixture.hpp"

namespace abrazo::test::real_peers_test {
namespace {

using ::testing::AnyOf;
using ::testing::SizeIs;

constexpr int head = 16, left_hand = 20, right_hand = 24;

bool has_program(const std::string& name) {
  return std::system(("command -v " + name + " > /dev/null 2>&1").c_str()) == 0;
}

/// Bones of an avatar in the T-pose, in Unity's space: the parent's end to the bone's beginning [m].
constexpr const char* avatar[] = {"Hips 0 0.95 0",
                                  "Spine 0 0.1 0",
                                  "Chest 0 0.12 0",
                                  "UpperChest 0 0.12 0",
                                  "Neck 0 0.12 0",
                                  "Head 0 0.1 0",
                                  "LeftShoulder -0.03 0.08 0",
                                  "LeftUpperArm -0.13 0 0",
                                  "LeftLowerArm -0.27 0 0",
                                  "LeftHand -0.25 0 0",
                                  "RightShoulder 0.03 0.08 0",
                                  "RightUpperArm 0.13 0 0",
                                  "RightLowerArm 0.27 0 0",
                                  "RightHand 0.25 0 0",
                                  "LeftUpperLeg -0.09 -0.07 0",
                                  "LeftLowerLeg 0 -0.4 0",
                                  "LeftFoot 0 -0.4 0",
                                  "LeftToes 0 -0.05 0.13",
                                  "RightUpperLeg 0.09 -0.07 0",
                                  "RightLowerLeg 0 -0.4 0",
                                  "RightFoot 0 -0.4 0",
                                  "RightToes 0 -0.05 0.13"};

/// Turned by 90 degrees about Unity's Z, so that the left arm, which lies along negative X, points up.
constexpr const char* arm_up = "0 0 -0.70710678 0.70710678";

class RealPeers : public LiveTest {
 protected:
  void SetUp() override {
    if (!has_program("oscsend") || !has_program("oscdump"))
      GTEST_SKIP() << "oscsend and oscdump are not installed (liblo-tools)";
  }

  /// A process, and so a sending port, for each message.
  void osc_send(std::uint16_t port, const std::vector<std::string>& messages) const {
    std::string script;
    for (const std::string& message : messages)
      script += fmt::format("oscsend 127.0.0.1 {} {} || exit 1\n", port, message);
    ASSERT_EQ(RunningCommand({"/bin/sh", "-c", script}, folder()).wait().status, 0);
  }

  static std::vector<std::string> pose(const std::string& turned_bone, double time_s) {
    std::vector<std::string> messages = {"/VMC/Ext/OK i 1", "/VMC/Ext/Root/Pos sfffffff root 0 0 0 0 0 0 1"};
    for (const std::string bone : avatar) {
      const bool turned = bone.starts_with(turned_bone + " ");
      messages.push_back("/VMC/Ext/Bone/Pos sfffffff " + bone + " " + (turned ? arm_up : "0 0 0 1"));
    }
    messages.push_back(fmt::format("/VMC/Ext/T f {:.3f}", time_s));
    return messages;
  }
};

TEST_F(RealPeers, AnArmThatOscsendRaisesIsRaisedHere) {
  const std::uint16_t port = free_port();
  TestReceiver partner;
  start_at(port, uri_of("vmc", port, "split=port"),
           "--record s.abrazo --send " + uri_of("vmc", partner.port()));
  using Clock = std::chrono::steady_clock;
  double time_s = 0, longest_s = 0;  // between two times of the sender
  auto sent = Clock::now();
  const auto send = [&](const std::string& turned) {
    osc_send(port, pose(turned, time_s += 0.5));
    longest_s = std::max(longest_s, std::chrono::duration<double>(Clock::now() - sent).count());
    sent = Clock::now();
  };
  for (int i = 0; i < 3; ++i) send("none");
  ASSERT_TRUE(wait_until([&] { return !partner.packets().empty(); }));
  for (int i = 0; i < 3; ++i) send("LeftUpperArm");
  const auto said = statistics();
  EXPECT_GT(said["frames"], 0);
  for (const auto& issue : said["stream"]["issues"]) {
    const auto kind = issue["kind"].get<std::string>();
    // On a busy machine the time of the sender, which comes last in a pose, really stands while the 25
    // processes of the next one begin.
    if (kind == "frozen-sender" && longest_s > 0.5) continue;
    // Between two processes 8 ms may pass, and the bones so far are a frame.
    EXPECT_THAT(kind, AnyOf("incomplete-frame", "missing-bones")) << issue["latest"];
  }
  EXPECT_EQ(said["stream"]["packets"], 6 * 25);
  ASSERT_THAT(said["stream"]["performers"], SizeIs(1));
  EXPECT_EQ(said["stream"]["performers"][0]["joint_map"], "unity");

  const auto frames = recorded_frames("s.abrazo");
  ASSERT_FALSE(frames.empty());
  const Pose& last = frames.back().user;
  const auto is_down = [](const FrameSnapshot& frame) { return frame.user(left_hand, 1) < 1.7; };
  const auto before = std::find_if(frames.rbegin(), frames.rend(), is_down);
  ASSERT_NE(before, frames.rend()) << "the T-pose came first";
  const Pose& first = before->user;
  EXPECT_NEAR(first(head, 1), 1.6, 0.1);
  EXPECT_NEAR(first(left_hand, 1), 1.37, 0.001) << "in the T-pose the hands are as high as the shoulders";
  EXPECT_GT(first(left_hand, 0), 0.6) << "left is at positive X for one who faces positive Z";
  EXPECT_NEAR(first(right_hand, 0), -first(left_hand, 0), 1e-6);
  EXPECT_GT(last(left_hand, 1), 1.9);
  EXPECT_NEAR(last(left_hand, 0), 0.16, 0.02) << "straight above the shoulder joint";
  EXPECT_NEAR(last(right_hand, 1), first(right_hand, 1), 1e-6);
  // The answer follows: the solved user's hand comes up too, and the partner is somewhere near.
  const PairPose& result = frames.back().result.result;
  EXPECT_GT(result(left_hand, 1), before->result.result(left_hand, 1) + 0.2);
  EXPECT_TRUE(result.allFinite());
}

/// "e9d6f3b2.1f2e3d4c /VMC/Ext/T f 0.016667"
struct DumpedMessage {
  std::string address, types;
  std::vector<std::string> values;
};

std::vector<DumpedMessage> parse_dump(const std::string& text) {
  std::vector<DumpedMessage> messages;
  for (const std::string_view line : split_lines(text)) {
    std::istringstream in{std::string(line)};
    DumpedMessage message;
    std::string time, word;
    if (!(in >> time >> message.address)) continue;
    in >> message.types;
    while (in >> word) message.values.push_back(word);
    messages.push_back(std::move(message));
  }
  return messages;
}

// So few frames that all of them fit into the system's buffer, however late oscdump comes to read them.
TEST_F(RealPeers, OscdumpReadsThePartnerThatWeSend) {
  const std::uint16_t port = free_port();
  RunningCommand dump({"/bin/sh", "-c", fmt::format("exec oscdump -L {}", port)}, folder());
  ASSERT_TRUE(wait_until([&] { return dump.finished() || is_open(port); }));
  const Outcome outcome = run(
      "live --library demo.h5 --seconds 1 --step-rate 30 --json --listen clip:demo/salsa_01_a.bvh --send " +
      uri_of("vmc", port));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto frames = nlohmann::json::parse(outcome.out)["sinks"][0]["frames"].get<std::size_t>();
  ASSERT_GT(frames, 0U);
  const auto times_in = [&] {
    std::size_t times = 0;
    for (const DumpedMessage& message : parse_dump(dump.answers_so_far()))
      times += message.address == "/VMC/Ext/T";
    return times;
  };
  EXPECT_TRUE(wait_until([&] { return times_in() >= frames; }));
  dump.signal(SIGINT);
  const auto messages = parse_dump(dump.wait().out);

  std::size_t bones = 0, roots = 0, oks = 0, applied = 0, times = 0, strange = 0, since_time = 0;
  double time_s = -1;
  for (const DumpedMessage& message : messages) {
    if (message.address == "/VMC/Ext/Bone/Pos") {
      ++bones, ++since_time;
      ASSERT_EQ(message.types, "sfffffff");
      ASSERT_THAT(message.values, SizeIs(8));
      EXPECT_EQ(message.values[0].front(), '"');
      double squares = 0;
      for (std::size_t i = 4; i < 8; ++i) squares += std::pow(parse_number(message.values[i]).value(), 2);
      EXPECT_NEAR(squares, 1, 1e-4) << "a rotation";
    } else if (message.address == "/VMC/Ext/Root/Pos") {
      ++roots;
      EXPECT_EQ(message.types, "sfffffffffffff");
      EXPECT_EQ(message.values.at(0), "\"root\"");
    } else if (message.address == "/VMC/Ext/Blend/Apply") {
      ++applied;
    } else if (message.address == "/VMC/Ext/OK") {
      ++oks;
      EXPECT_EQ(message.types, "iiii");
      EXPECT_EQ(message.values, (std::vector<std::string>{"1", "3", "0", "1"}));
    } else if (message.address == "/VMC/Ext/T") {
      ++times;
      EXPECT_EQ(message.types, "f");
      EXPECT_EQ(since_time, std::size(avatar)) << "all bones in front of the time";
      EXPECT_GT(parse_number(message.values.at(0)).value(), time_s);
      time_s = parse_number(message.values.at(0)).value();
      since_time = 0;
    } else {
      strange += !message.address.starts_with("/VMC/Thru/");
    }
  }
  EXPECT_EQ(times, frames);
  EXPECT_EQ(roots, frames);
  EXPECT_EQ(oks, frames);
  EXPECT_EQ(applied, frames);
  EXPECT_EQ(bones, std::size(avatar) * frames);
  EXPECT_EQ(strange, 0U);
}

/// The receivers of examples/receive, with both bodies of a dance.
class ExampleReceivers : public LiveTest {
 protected:
  /// Starts it with a port for each body, and sends a second of the dance to both.
  void send_to(const std::vector<std::string>& program) {
    receiver_ = std::make_unique<RunningCommand>(program, folder());
    ASSERT_TRUE(wait_until([&] { return is_open(ports_[0]) && is_open(ports_[1]); }))
        << receiver_->errors_so_far();
    for (std::size_t body = 0; body < 2; ++body) {
      const Outcome sent =
          run(fmt::format("send {} --seconds 1 --json --to {}", clips_[body], uri_of("vmc", ports_[body])));
      ASSERT_EQ(sent.status, 0) << sent.err;
      frames_[body] = nlohmann::json::parse(sent.out)["frames"];
    }
  }
  std::vector<nlohmann::json> lines_of(std::size_t body, const std::string& answers) const {
    std::vector<nlohmann::json> lines;
    for (const std::string_view line : split_lines(answers))
      if (line.starts_with('{'))
        if (auto json = nlohmann::json::parse(line); json["port"] == ports_[body])
          lines.push_back(std::move(json));
    return lines;
  }
  /// The hips stand where they stand in a frame of the clip [m]; X of both spaces points the other way.
  void expect_in_the_clip(std::size_t body, const nlohmann::json& hips, double x_is) const {
    const auto clips = load_motion(path(clips_[body]).string(), "", {});
    ASSERT_TRUE(clips);
    const Vec3 at(x_is * hips[0].get<double>(), hips[1], hips[2]);
    double nearest = 1e9;
    for (const Pose& pose : clips->front().clip.poses)
      nearest = std::min(nearest, (pose.row(0).transpose() - at).norm());
    EXPECT_LT(nearest, 1e-3) << clips_[body] << ": " << at.transpose();
  }

  std::array<std::uint16_t, 2> ports_ = {free_port(), free_port()};
  std::array<std::string, 2> clips_ = {"demo/salsa_01_a.bvh", "demo/salsa_01_b.bvh"};
  std::array<std::size_t, 2> frames_{};
  std::unique_ptr<RunningCommand> receiver_;
};

TEST_F(ExampleReceivers, InPythonEachBodyIsWhereItIsInItsClip) {
  send_to({"/usr/bin/python3", ABRAZO_EXAMPLES "/receive/receive.py", std::to_string(ports_[0]),
           std::to_string(ports_[1]), "--json"});
  ASSERT_TRUE(wait_until([&] { return lines_of(1, receiver_->answers_so_far()).size() >= frames_[1]; }));
  receiver_->signal(SIGINT);
  const Outcome outcome = receiver_->wait();
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  for (std::size_t body = 0; body < 2; ++body) {
    const auto lines = lines_of(body, outcome.out);
    ASSERT_THAT(lines, SizeIs(frames_[body]));
    expect_in_the_clip(body, lines.front()["hips"], -1);
    expect_in_the_clip(body, lines.back()["hips"], -1);
    EXPECT_EQ(lines.back()["bones"], 22);
    EXPECT_NE(lines.front()["heading_deg"], lines.back()["heading_deg"]);
  }
}

TEST_F(ExampleReceivers, InGodotEachBodyIsWhereItIsInItsClip) {
  if (!has_program("godot3-server")) GTEST_SKIP() << "godot3-server is not installed";
  std::filesystem::copy(ABRAZO_EXAMPLES "/receive/godot", path("godot"));
  send_to({"/usr/bin/env", "-u", "XDG_DATA_HOME", "-u", "XDG_CONFIG_HOME", "-u", "XDG_CACHE_HOME",
           "HOME=" + folder().string(), "godot3-server", "--path", path("godot").string(),
           fmt::format("--ports={},{}", ports_[0], ports_[1]), "--seconds=8"});
  const Outcome outcome = receiver_->wait();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (std::size_t body = 0; body < 2; ++body) {
    const auto lines = lines_of(body, outcome.out);
    ASSERT_THAT(lines, SizeIs(1)) << outcome.out;
    EXPECT_GT(lines[0]["frames"], 0);
    EXPECT_EQ(lines[0]["bones"], 22);
    expect_in_the_clip(body, lines[0]["hips"], 1);
  }
}

}  // namespace
}  // namespace abrazo::test::real_peers_test
