#include <fmt/format.h>

#include <csignal>
#include <limits>
#include <ostream>

#include "core/stream/vmc/osc_packet.hpp"
#include "tests/cli/live_fixture.hpp"

namespace abrazo::test::live_command_test {
namespace {

using ::testing::AnyOf;
using ::testing::Ge;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

Bytes bone_message(const std::string& bone, float number) {
  std::vector<OscArgument> arguments = {OscArgument::of(bone)};
  for (int i = 0; i < 7; ++i) arguments.push_back(OscArgument::of(number));
  const std::vector<OscElement> packet = {osc_message("/VMC/Ext/Bone/Pos", arguments)};
  return write_osc(packet);
}

class LiveCommand : public LiveTest {
 protected:
  /// A stream of our own into a live session whose partner comes to us, once it does.
  void start_streaming(const std::string& words = {}, const std::string& options = {}) {
    const std::uint16_t port = free_port();
    start_at(port, uri_of("vmc", port, options), "--send " + uri_of("vmc", partner.port()) + " " + words);
    sender = std::make_unique<TestSender>(uri_of("vmc", port), clip());
    listen_port = port;
    ASSERT_TRUE(sender->send_until([&] { return !partner.packets().empty(); }));
  }
  /// Streams till so many more packets of the partner are there.
  void stream(std::size_t packets) {
    const std::size_t wanted = partner.packets().size() + packets;
    ASSERT_TRUE(sender->send_until([&] { return partner.packets().size() >= wanted; }));
  }

  TestReceiver partner;
  std::unique_ptr<TestSender> sender;
  std::uint16_t listen_port = 0;
};

// ---- in and out ----

struct Link {
  std::string scheme, options;
  friend std::ostream& operator<<(std::ostream& out, const Link& link) {
    return out << link.scheme << ' ' << link.options;
  }
};

class LiveLink : public LiveTest, public ::testing::WithParamInterface<Link> {};

TEST_P(LiveLink, WhatAbrazoSendsDrivesThePartner) {
  const Link& link = GetParam();
  const std::uint16_t port = free_port();
  TestReceiver partner;
  const std::vector<std::string> words = {ABRAZO_PROGRAM,
                                          "send",
                                          "demo/salsa_01_a.bvh",
                                          "--to",
                                          uri_of(link.scheme, port, link.options),
                                          "--loop",
                                          "--json",
                                          "--rate",
                                          "120"};
  std::unique_ptr<RunningCommand> sender;
  const bool server_first = link.scheme == "natnet";
  if (server_first) {
    sender = std::make_unique<RunningCommand>(words, folder());
    ASSERT_TRUE(wait_until([&] { return is_open(port) || sender->finished(); }));
    start(uri_of(link.scheme, port), "--send " + uri_of("vmc", partner.port()));
  } else {
    start_at(port, uri_of(link.scheme, port), "--send " + uri_of("vmc", partner.port()));
    sender = std::make_unique<RunningCommand>(words, folder());
  }
  EXPECT_TRUE(wait_until([&] { return partner.packets().size() > 100 || live->finished(); }));
  sender->signal(SIGINT);
  const Outcome sent = sender->wait();
  ASSERT_EQ(sent.status, 0) << sent.err;
  const auto said = nlohmann::json::parse(sent.out);
  EXPECT_GT(said["packets"], 0);
  const auto seen = statistics();
  EXPECT_GT(seen["frames"], 30);
  // Every loss of tracking is one failed frame: those that ended, and maybe the sender's end.
  const int interruptions = seen["stream"]["performers"][0]["interruptions"];
  EXPECT_THAT(seen["failed"].get<int>(), AnyOf(interruptions, interruptions + 1));
  EXPECT_EQ(seen["stream"]["performers"][0]["lost"], 0);
  EXPECT_EQ(seen["stream"]["performers"][0]["restarts"], 0);
  for (const auto& issue : seen["stream"]["issues"]) {
    // A busy machine cuts a frame in two; the first NatNet frame comes before the skeletons are known.
    EXPECT_THAT(issue["kind"].get<std::string>(), AnyOf("incomplete-frame", "missing-bones", "no-model"))
        << issue["latest"];
  }
  EXPECT_GE(seen["sinks"][0]["frames"], 30);
  const auto& latency = seen["latency_ms"];
  for (const char* stage : {"interval", "assembly", "wait", "solve", "send", "in_to_out"}) {
    EXPECT_GE(latency[stage]["p50"], 0) << stage;
    EXPECT_LE(latency[stage]["p50"], latency[stage]["max"]) << stage;
  }
  EXPECT_LE(latency["solve"]["p50"], latency["in_to_out"]["p50"]);
}

INSTANTIATE_TEST_SUITE_P(Protocols, LiveLink,
                         ::testing::Values(Link{"vmc", "framing=t-last"}, Link{"vmc", "framing=t-first"},
                                           Link{"vmc", "framing=split&root=origin"}, Link{"natnet", ""},
                                           Link{"xsens", ""}),
                         [](const auto& link) {
                           std::string name = link.param.scheme + link.param.options;
                           std::erase_if(name, [](char c) { return c == '=' || c == '-' || c == '&'; });
                           return name;
                         });

TEST_F(LiveCommand, AClipPlaysToItsEndAndIsAnswered) {
  const Outcome outcome = run("live --library demo.h5 --listen clip:demo/salsa_01_a.bvh --fps 480 --send " +
                              uri_of("vmc", partner.port()) + " --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto said = nlohmann::json::parse(outcome.out);
  EXPECT_GT(said["frames"], 0);
  EXPECT_GE(said["seconds"].get<double>(), static_cast<double>(clip().poses.size()) / 480);
  EXPECT_TRUE(said["stream"].is_null());
  EXPECT_TRUE(said["latency_ms"]["in_to_out"].is_null()) << "nothing arrived";
  EXPECT_GT(said["latency_ms"]["solve"]["p50"], 0);
  EXPECT_THAT(partner.packets(), Not(IsEmpty()));
}

TEST_F(LiveCommand, TheUserIsSentOnToo) {
  TestReceiver user;
  start_streaming("--send-user " + uri_of("vmc", user.port()));
  EXPECT_TRUE(sender->send_until([&] { return user.packets().size() > 10; }));
  const auto said = statistics();
  ASSERT_THAT(said["sinks"], SizeIs(2));
  EXPECT_EQ(said["sinks"][0]["character"], "partner");
  EXPECT_EQ(said["sinks"][1]["character"], "user");
  EXPECT_NE(partner.packets().back(), user.packets().back());
}

TEST_F(LiveCommand, WithoutJsonTheStatisticsAreATable) {
  const Outcome outcome =
      run("live --library demo.h5 --listen clip:demo/salsa_01_a.bvh --seconds 1 --record s.abrazo");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("frames in 1."));
  EXPECT_THAT(outcome.out, HasSubstr("solve"));
  EXPECT_THAT(outcome.out, HasSubstr("s.abrazo: "));
  const Outcome quiet = run("live --library demo.h5 --listen clip:demo/salsa_01_a.bvh --seconds 1 --quiet");
  EXPECT_EQ(quiet.status, 0);
  EXPECT_THAT(quiet.out + quiet.err, IsEmpty());
}

// ---- what is wrong ----

TEST_F(LiveCommand, GarbageIsCountedAndExplainedAndDoesNotStopIt) {
  start_streaming();
  const auto good = sender->next_packets();
  for (int i = 0; i < 20; ++i) {
    sender->send(Bytes(64, 0xEE));
    sender->send({});
    sender->send(Bytes(good[0].begin(), good[0].begin() + static_cast<std::ptrdiff_t>(good[0].size() / 2)));
    sender->send(bone_message("Hips", std::numeric_limits<float>::quiet_NaN()));
    sender->send(bone_message(std::string(3000, 'x'), 0));
    stream(1);
  }
  stream(100);
  const auto said = statistics();
  const auto& stream = said["stream"];
  EXPECT_THAT(stream["packets_with_issues"].get<int>(), Ge(60));
  for (const char* kind : {"not-osc", "truncated", "not-finite"}) {
    const auto issue = entry_of(stream["issues"], kind);
    ASSERT_FALSE(issue.is_null()) << kind << " in " << stream["issues"];
    EXPECT_GE(issue["count"], 20) << kind;
    EXPECT_THAT(issue["latest"].get<std::string>(), Not(IsEmpty()));
  }
  EXPECT_GT(said["frames"], 50);
}

TEST_F(LiveCommand, AnotherProtocolIsNamed) {
  const std::uint16_t port = free_port();
  start_at(port, uri_of("vmc", port));
  TestSender other(uri_of("xsens", port), clip());
  ASSERT_TRUE(other.send_until([&] { return has_warned_of("Xsens"); }));
  const Outcome outcome = end();
  EXPECT_EQ(outcome.status, 1) << "nobody moved";
  const auto said = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(said["frames"], 0);
  EXPECT_THAT(entry_of(said["diagnoses"], "other-protocol")["text"], HasSubstr("Xsens MVN"));
  EXPECT_THAT(outcome.err, HasSubstr("abrazo: " + uri_of("vmc", port) + ": packets come, but not as VMC"));
}

TEST_F(LiveCommand, TwoSendersOnOnePortAreTwoPerformersAndAreTold) {
  start_streaming();
  TestSender second(uri_of("vmc", listen_port), clip());
  ASSERT_TRUE(sender->send_until([&] {
    second.send_frame();
    return has_warned_of("choose who plays the user");
  }));
  const auto said = statistics();
  EXPECT_THAT(said["stream"]["performers"], SizeIs(2));
  EXPECT_THAT(said["stream"]["senders"], SizeIs(2));
  EXPECT_EQ(entry_of(said["diagnoses"], "two-senders")["severity"], "warning");
  EXPECT_GT(said["frames"], 0);
}

TEST_F(LiveCommand, OfTwoSendersThatBeginTogetherItSaysWhichIsFollowedAndAsksForAName) {
  const std::uint16_t port = free_port();
  start_at(port, uri_of("vmc", port), {});
  TestSender first(uri_of("vmc", port), clip()), second(uri_of("vmc", port), clip());
  ASSERT_TRUE(first.send_until([&] {
    second.send_frame();
    return has_warned_of("who is the user?");
  }));
  const auto said = statistics();
  EXPECT_TRUE(said["stream"]["undecided"].is_array()) << "those at the end, perhaps none then";
  EXPECT_THAT(entry_of(said["diagnoses"], "which-user")["text"],
              HasSubstr(said["stream"]["followed"].get<std::string>() + " is followed now"));
}

TEST_F(LiveCommand, ASenderThatBeginsAnewIsFollowed) {
  start_streaming();
  stream(200);
  sender->restart();
  stream(200);
  const auto said = statistics();
  EXPECT_EQ(said["stream"]["performers"][0]["restarts"], 1);
  EXPECT_FALSE(entry_of(said["diagnoses"], "sender-restarted").is_null()) << said["diagnoses"];
}

TEST_F(LiveCommand, WithoutAPacketItFailsAndSaysWhatToLookAt) {
  const std::uint16_t port = free_port();
  const Outcome outcome = run("live --library demo.h5 --seconds 2.5 --listen " + uri_of("vmc", port));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("0 frames in 2.5 s"));
  EXPECT_THAT(outcome.err, HasSubstr("abrazo: " + uri_of("vmc", port) + ": "));
  EXPECT_THAT(outcome.err, HasSubstr("no packet"));
}

TEST_F(LiveCommand, WhenEveryFrameFailsItFailsAndSaysWhy) {
  const Outcome outcome =
      run("live --library demo.h5 --seconds 1 --metres-per-unit 0.01 --listen clip:demo/salsa_01_a.bvh");
  EXPECT_EQ(outcome.status, 1) << outcome.out;
  EXPECT_THAT(outcome.err, HasSubstr("clip:demo/salsa_01_a.bvh: held: not a person: all bones together are"));
}

TEST_F(LiveCommand, APortThatSomebodyHasIsNamed) {
  expect_failure(run("live --library demo.h5 --listen " + uri_of("vmc", partner.port())),
                 "127.0.0.1:" + std::to_string(partner.port()));
  expect_failure(run("live --library demo.h5 --record s.abrazo --listen " + uri_of("vmc", partner.port())),
                 "127.0.0.1:" + std::to_string(partner.port()));
  EXPECT_THAT(names(), ::testing::ElementsAre("demo", "demo.h5")) << "no empty recording";
}

TEST_F(LiveCommand, WordsThatCannotBeMeantAreRefusedBeforeAnythingIsOpened) {
  const auto refused = [&](const std::string& words, const std::string& part) {
    expect_failure(run("live --library demo.h5 " + words), part);
  };
  refused("--listen osc://127.0.0.1:39539", "expected vmc://HOST:PORT");
  refused("--listen vmc://127.0.0.1:70000", "expected a number from 1 to 65535");
  refused("--listen vmc://127.0.0.1:39539?colour=red", "there is no option 'colour' for vmc");
  refused("--listen vmc://127.0.0.1:39539?framing=t-last", "for sending");
  refused("--listen vmc://127.0.0.1:39539 --listen xsens://0.0.0.0:9763", "one stream plays the user");
  refused("--listen vmc://127.0.0.1:39539 --skeleton 60.asf", "are for clip:FILE");
  refused("--listen clip:demo/salsa_01_a.bvh --calibrate 3", "--calibrate is for streams");
  refused("--listen clip:demo/salsa_01_a.bvh --send clip:out.bvh", "a clip is no place to send to");
  refused("--listen clip:demo/salsa_01_a.bvh --send vmc://127.0.0.1:39540?delay=20", "for listening");
  refused("--listen vmc://127.0.0.1:39539 --send vmc://localhost:39539", "would come back as the user");
  refused("--listen vmc://*:39539 --send-user vmc://127.0.0.1:39539", "would come back as the user");
  refused("--listen clip:demo/none.bvh", "demo/none.bvh");
  refused("--listen clip:demo/salsa_01_a.bvh --exclude nobody", "nobody");
  refused("--listen clip:demo/salsa_01_a.bvh --record demo.h5", "is also read");
  refused("--listen clip:demo/salsa_01_a.bvh --record none/s.abrazo", "the folder does not exist");
  expect_failure(run("live --library none.h5 --listen clip:demo/salsa_01_a.bvh"), "none.h5");
  expect_wrong_usage(run("live --library demo.h5"), "--listen is required");
  expect_wrong_usage(run("live --library demo.h5 --listen vmc://127.0.0.1:0 --take a"), "--record");
}

TEST_F(LiveCommand, AnotherProgramsFileIsNotRecordedOver) {
  write("s.abrazo", "a diary");
  expect_failure(
      run("live --library demo.h5 --listen clip:demo/salsa_01_a.bvh --seconds 1 --record s.abrazo"),
      "s.abrazo");
  EXPECT_EQ(read("s.abrazo"), "a diary");
}

// ---- recording ----

TEST_F(LiveCommand, CtrlCEndsTheRecordingWhole) {
  start_streaming("--record s.abrazo --take waltz");
  stream(100);
  const auto said = statistics();
  EXPECT_THAT(names(), ::testing::ElementsAre("demo", "demo.h5", "s.abrazo"))
      << "one file, nothing beside it";
  const auto file = session("s.abrazo");
  const SessionContents& contents = file->contents();
  EXPECT_THAT(file->recovery(), IsEmpty());
  ASSERT_THAT(contents.runs, SizeIs(1));
  EXPECT_TRUE(contents.runs[0].finished);
  EXPECT_EQ(contents.frames, said["frames"].get<std::uint64_t>());
  EXPECT_EQ(contents.frames, said["recording"]["frames"].get<std::uint64_t>());
  EXPECT_EQ(said["recording"]["lost"], 0);
  ASSERT_THAT(contents.takes, SizeIs(1));
  EXPECT_EQ(contents.takes[0].name, "waltz");
  EXPECT_FALSE(contents.takes[0].interrupted);
  EXPECT_EQ(contents.takes[0].last_frame, contents.last_frame);
  ASSERT_THAT(contents.performers, SizeIs(1));
  EXPECT_EQ(contents.performers[0].poses, said["stream"]["performers"][0]["frames"].get<std::uint64_t>());
  ASSERT_THAT(contents.inputs, SizeIs(1));
  EXPECT_EQ(contents.inputs[0].text, uri_of("vmc", listen_port));
}

TEST_F(LiveCommand, SettingsOfTheRunAreInTheRecording) {
  const std::string words = "live --library demo.h5 --listen clip:demo/salsa_01_a.bvh --seconds 1 --record ";
  ASSERT_EQ(run(words + "a.abrazo --alpha 0.3").status, 0);
  ASSERT_EQ(run(words + "b.abrazo --preset paper -k 4 --user-role passive").status, 0);
  Settings expected = *preset("responsive");
  expected.alpha = 0.3;
  EXPECT_EQ(session("a.abrazo")->contents().settings.at(0).settings, expected);
  expected = *preset("paper");
  expected.neighbours = 4;
  expected.user_role = UserRole::Passive;
  EXPECT_EQ(session("b.abrazo")->contents().settings.at(0).settings, expected);
}

TEST_F(LiveCommand, ASecondRunGoesOnInTheFileAsAnotherTake) {
  const std::string words =
      "live --library demo.h5 --listen clip:demo/salsa_01_a.bvh --seconds 1 --record s.abrazo";
  ASSERT_EQ(run(words).status, 0);
  ASSERT_EQ(run(words).status, 0);
  const auto file = session("s.abrazo");
  ASSERT_THAT(file->contents().takes, SizeIs(2));
  EXPECT_EQ(file->contents().takes[0].name, "take 1");
  EXPECT_EQ(file->contents().takes[1].name, "take 2");
  EXPECT_GT(file->contents().takes[1].first_frame, file->contents().takes[0].last_frame);
}

TEST_F(LiveCommand, OfAClipEverySolvedFrameIsRecordedFromTheFirstPoseOn) {
  const Outcome outcome =
      run("live --library demo.h5 --listen clip:demo/salsa_01_a.bvh --seconds 1 --json --record s.abrazo");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto frames = recorded_frames("s.abrazo");
  ASSERT_THAT(frames, Not(IsEmpty()));
  EXPECT_EQ(frames.front().input_frame, 0);
  EXPECT_EQ(frames.size(), nlohmann::json::parse(outcome.out)["frames"].get<std::size_t>());
  EXPECT_EQ(frames.front().index, 0U);
}

/// The trace of a recorded session has the bits of the frames that were recorded live.
class LiveReplay : public LiveCommand {
 protected:
  void expect_same_trace(const std::string& name) {
    const Outcome outcome = run("export " + name + " --what trace -o t.jsonl --json");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto said = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(said["differ"], 0);
    EXPECT_EQ(said["skipped"], 0);
    const auto frames = recorded_frames(name);
    const auto trace = parse_lines(read("t.jsonl"));
    ASSERT_EQ(trace.size(), frames.size() + 1);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const FrameSnapshot& frame = frames[i];
      const auto& line = trace[i + 1];
      EXPECT_EQ(line["time"].get<double>(), frame.time_s);
      if (frame.result.status == StepStatus::Failed) continue;
      for (const char* body : {"active", "passive"}) {
        const Pose pose = *body == 'a' ? Pose(frame.result.active()) : Pose(frame.result.passive());
        for (int joint = 0; joint < joint_count; ++joint)
          for (int axis = 0; axis < 3; ++axis)
            ASSERT_EQ(
                line[body][static_cast<std::size_t>(joint)][static_cast<std::size_t>(axis)].get<double>(),
                pose(joint, axis))
                << body << ", frame " << i << ", joint " << joint;
      }
    }
  }
};

TEST_F(LiveReplay, OfAClip) {
  ASSERT_EQ(
      run("live --library demo.h5 --listen clip:demo/salsa_01_a.bvh --fps 240 --record s.abrazo").status, 0);
  expect_same_trace("s.abrazo");
}

TEST_F(LiveReplay, OfAStream) {
  start_streaming("--record s.abrazo");
  stream(300);
  statistics();
  expect_same_trace("s.abrazo");
}

TEST_F(LiveReplay, OfAStreamThatBroke) {
  start_streaming("--record s.abrazo --alpha 0.2 --role-control leader");
  stream(100);
  sender->restart();
  for (int i = 0; i < 10; ++i) {
    sender->send(bone_message("LeftUpperArm", std::numeric_limits<float>::infinity()));
    stream(1);
  }
  ASSERT_TRUE(wait_until([&] { return has_warned_of("no packet for"); })) << "silence: tracking is lost";
  stream(100);
  statistics();
  expect_same_trace("s.abrazo");
}

}  // namespace
}  // namespace abrazo::test::live_command_test
