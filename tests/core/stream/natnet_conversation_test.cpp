// What the decoder asks a NatNet server, and whose answers it takes.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "core/stream/natnet/natnet_decoder.hpp"
#include "core/stream/natnet/natnet_encoder.hpp"
#include "tests/core/stream/natnet_packets.hpp"

namespace abrazo::natnet_conversation_test {
namespace {

using test::Listener;
using namespace natnet_test;

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

TEST(NatNetTakeover, AnOldVersionOrNoGroupThatNobodyAskedForIsNotToldAsTheServers) {
  Listener listener = connected({skeleton("Ana", 1)});
  listener.take(forged_info({2, 0}), 0.1);
  EXPECT_TRUE(listener.has_issue("unasked-answer")) << listener.issues();
  EXPECT_FALSE(listener.has_issue("old-version")) << "what to do about it would be false advice";
}

TEST(NatNetTakeover, AnAnswerBeforeAnyQuestionIsNotTaken) {
  Listener listener("natnet://10.0.0.5");
  listener.take(forged_info({3, 0}), 0.1);
  EXPECT_TRUE(listener.has_issue("unasked-answer")) << listener.issues();
  EXPECT_FALSE(listener.decoder->wanted_group());
}

TEST(NatNetTakeover, AModelBetweenTheServersAnswerAndOurQuestionIsNotTaken) {
  Listener listener = connected({skeleton("Ana", 1)});
  listener.pass_time(2.5);  // silence: the server is asked again, and after it answers the model too
  listener.take(server_info(v41), 2.6);
  listener.take(model_packet({skeleton("Eve", 1)}, v41), 2.61);
  listener.take(frame_packet(frame_of({posed(skeleton("Ana", 1), false)}), v41), 2.62);
  ASSERT_EQ(listener.out.frames.size(), 1u);
  EXPECT_EQ(listener.out.frames[0].performer, "Ana");
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

}  // namespace
}  // namespace abrazo::natnet_conversation_test
