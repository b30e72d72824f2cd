#include <gtest/gtest.h>

#include "core/motion/body/body.hpp"
#include "core/stream/natnet/natnet_encoder.hpp"
#include "core/stream/natnet/natnet_messages.hpp"
#include "tests/core/stream/mocap_stream.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::natnet_hostile_test {
namespace {

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
