#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include "core/motion/body/body.hpp"
#include "core/stream/natnet/natnet_encoder.hpp"
#include "core/stream/natnet/natnet_messages.hpp"
#include "tests/core/stream/mocap_stream.hpp"
#include "tests/core/stream/natnet_packets.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::natnet_hostile_test {
namespace {

using namespace natnet_test;
using Packet = std::vector<std::uint8_t>;

/// Knows the server, and has asked it for its model.
test::Listener waiting_for_a_model(NatNetVersion version) {
  test::Listener listener("natnet://10.0.0.5");
  listener.pass_time(0);
  listener.take(server_info(version));
  listener.pass_time(0);
  listener.forget();
  return listener;
}

/// A message with these bytes behind its head.
Packet model_of_bytes(std::span<const std::uint8_t> bytes) {
  ByteWriter writer(ByteOrder::Little);
  for (const std::uint8_t byte : bytes) writer.u8(byte);
  return natnet_packet(NatNetMessage::ModelDef, writer);
}

std::size_t count_issues(const test::Listener& listener, std::string_view kind) {
  return static_cast<std::size_t>(
      std::count_if(listener.out.issues.begin(), listener.out.issues.end(),
                    [kind](const StreamIssue& issue) { return issue.kind == kind; }));
}

/// The server is asked again, answers with its model, and its frames have poses.
void expect_recovery(test::Listener& listener, const Packet& model, const Packet& frame) {
  listener.take(frame, 0.3);
  listener.pass_time(0.6);
  listener.take(model, 0.6);
  listener.forget();
  listener.take(frame, 0.7);
  EXPECT_EQ(listener.out.frames.size(), 2u) << listener.issues();
}

TEST(NatNetHostile, MutatedPacketsAreIssuesOrFramesButNeverFatal) {
  std::size_t frames = 0;
  for (const char* version : {"3.0", "4.1"}) {
    const Pose pose = test::standing_pose();
    auto server =
        make_natnet_encoder(*parse_stream_uri(std::string("natnet://h?version=") + version), body_of(pose));
    ASSERT_TRUE(server);
    std::vector<std::vector<std::uint8_t>> good;
    for (const NatNetMessage request :
         {NatNetMessage::Connect, NatNetMessage::RequestModelDef, NatNetMessage::EchoRequest}) {
      std::vector<OutgoingDatagram> answers;
      (*server)->answer({{}, 0, natnet_request(request, "12345678")}, answers);
      for (OutgoingDatagram& answer : answers) good.push_back(std::move(answer.bytes));
    }
    for (int f = 0; f < 5; ++f)
      for (auto& packet : (*server)->packets({pose, f / 60.0, true})) good.push_back(std::move(packet));
    test::Listener listener("natnet://h");
    for (const std::size_t answer : {0U, 1U}) {
      listener.pass_time(0);
      listener.take(good[answer]);
    }
    frames += test::feed_mutations(listener, good, 50'000, 7);
  }
  EXPECT_GT(frames, 10'000u) << "mutations far too coarse to reach what is behind the counts";
}

// Every four bytes of a model may be a count or a size.
TEST(NatNetHostile, NoCountAndNoSizeOfAModelIsBelieved) {
  const std::vector<NatNetSkeleton> pair = {skeleton("Ana", 1), skeleton("Bo", 2)};
  for (const NatNetVersion version : {NatNetVersion{3, 0}, v41, NatNetVersion{4, 2}}) {
    const Packet good = model_packet(pair, version);
    for (std::size_t at = natnet_head_bytes; at + 4 <= good.size(); ++at)
      for (const std::uint32_t value : {0U, 2U, 0xFFU, 0xFFFFU, 0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU}) {
        Packet packet = good;
        for (std::size_t byte = 0; byte < 4; ++byte)
          packet[at + byte] = static_cast<std::uint8_t>(value >> (8 * byte));
        test::Listener listener = waiting_for_a_model(version);
        listener.take(packet);
        EXPECT_LE(listener.out.issues.size(), pair.size() + 1) << at << " " << value;
        EXPECT_LT(listener.issues().size() + listener.decoder->facts().size(), 2000u) << at << " " << value;
      }
  }
}

TEST(NatNetHostile, AModelInSeveralDatagramsIsNotTakenInPartsAndTheWholeOneIsAfterwards) {
  const std::vector<NatNetSkeleton> pair = {skeleton("Ana", 1), skeleton("Bo", 2)};
  for (const NatNetVersion version : {NatNetVersion{3, 0}, v41, NatNetVersion{4, 2}}) {
    const Packet good = model_packet(pair, version);
    const Packet frame = frame_packet(frame_of({posed(pair[0], false), posed(pair[1], false)}), version);
    for (std::size_t cut = natnet_head_bytes + 1; cut < good.size(); ++cut) {
      const std::span<const std::uint8_t> all(good);
      // Cut by the network: only the first has a head. Then each with its own, which fits.
      test::Listener by_network = waiting_for_a_model(version), by_sender = waiting_for_a_model(version);
      by_network.take(all.first(cut));
      EXPECT_TRUE(by_network.has_issue("truncated")) << cut;
      by_network.take(all.subspan(cut));
      by_sender.take(model_of_bytes(all.subspan(natnet_head_bytes, cut - natnet_head_bytes)));
      EXPECT_FALSE(by_sender.out.issues.empty()) << cut;
      by_sender.take(model_of_bytes(all.subspan(cut)));
      expect_recovery(by_network, good, frame);
      expect_recovery(by_sender, good, frame);
    }
  }
}

TEST(NatNetHostile, ThousandsOfSkeletonsAndOneThousandsOfTimesAreWorkedOnOnce) {
  std::vector<NatNetSkeleton> many = {skeleton("Ana", 1)};
  for (std::int32_t id = 2; id < 3000; ++id) many.push_back({"", id, {}});
  test::Listener listener = waiting_for_a_model(v41);
  listener.take(model_packet(many, v41));
  EXPECT_EQ(count_issues(listener, "too-many-performers"), 1u) << listener.issues();
  EXPECT_LT(listener.decoder->facts().size(), 80u);
  listener.forget();
  std::vector<NatNetSkeletonFrame> repeated(150, posed(many[0], false));
  for (std::int32_t id = 5000; id < 7000; ++id) repeated.push_back({id, {}});
  listener.take(frame_packet(frame_of(repeated), v41), 0.1);
  EXPECT_EQ(listener.out.frames.size(), 1u);
  EXPECT_EQ(count_issues(listener, "repeated-skeleton"), 1u) << listener.issues();
  EXPECT_EQ(count_issues(listener, "unknown-skeleton"), 1u) << listener.issues();
}

TEST(NatNetHostile, MutatedQuestionsDoNotHurtTheServer) {
  auto server = make_natnet_encoder(*parse_stream_uri("natnet://h"), body_of(test::standing_pose()));
  ASSERT_TRUE(server);
  for (int id = 0; id < 300; ++id)
    for (std::size_t length = 0; length < 12; ++length) {
      std::vector<std::uint8_t> question(length, 0xFF);
      if (length > 0) question[0] = static_cast<std::uint8_t>(id);
      if (length > 1) question[1] = static_cast<std::uint8_t>(id >> 8);
      std::vector<OutgoingDatagram> answers;
      (*server)->answer({{}, 0, question}, answers);
      EXPECT_LE(answers.size(), 1u);
    }
}

}  // namespace
}  // namespace abrazo::natnet_hostile_test
