#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "core/stream/net/udp_socket.hpp"
#include "core/stream/receive/stream_receiver.hpp"
#include "core/stream/send/pose_sink.hpp"
#include "tests/core/stream/plain_stream.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::receiver_test {
namespace {

using test::plain_packet, test::PlainDecoder, test::PlainFrame;
using testing::HasSubstr;

/// What the receiving thread said, to be waited for.
class Heard {
 public:
  void add(const ReceivedPose& pose) {
    const std::scoped_lock lock(mutex_);
    poses_.push_back(pose);
    condition_.notify_all();
  }
  std::vector<ReceivedPose> wait_for(std::size_t count,
                                     std::chrono::milliseconds at_most = std::chrono::seconds(20)) {
    std::unique_lock lock(mutex_);
    condition_.wait_for(lock, at_most, [&] { return poses_.size() >= count; });
    return poses_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable condition_;
  std::vector<ReceivedPose> poses_;
};

/// A receiver on a free port of this machine and a socket that sends to it.
class LoopbackReceiver : public testing::Test {
 protected:
  LoopbackReceiver() { listen_with(std::make_unique<PlainDecoder>()); }
  ~LoopbackReceiver() override { receiver_->unlisten(listener_); }

  void listen_with(std::unique_ptr<StreamDecoder> decoder) {
    auto opened =
        StreamReceiver::open(*parse_stream_uri("vmc://127.0.0.1:0"), clock_, {}, std::move(decoder));
    if (!opened) throw std::runtime_error(opened.error().text());
    receiver_ = *opened;
    listener_ = receiver_->listen([this](const ReceivedPose& pose) { heard_.add(pose); });
    const std::string at = receiver_->health().listening;
    port_ = static_cast<std::uint16_t>(std::stoi(at.substr(at.find(':') + 1)));
  }

  void send(const PlainFrame& frame) { send_bytes(plain_packet(frame)); }
  void send_bytes(const std::vector<std::uint8_t>& bytes) {
    const Status sent = sender_.send({0x7F000001, port_}, bytes);
    ASSERT_TRUE(sent) << sent.error().text();
  }

  SessionClock clock_;
  Heard heard_;
  std::shared_ptr<StreamReceiver> receiver_;
  UdpSocket sender_ = std::move(*UdpSocket::bind({0x7F000001, 0}));
  std::uint16_t port_ = 0;
  int listener_ = 0;
};

TEST_F(LoopbackReceiver, WhoListensBeforeItBeginsHearsTheFirstPoseToo) {
  Heard heard;
  StreamReceiverOptions options;
  options.prepare = [&](StreamReceiver& receiver) {
    const std::string at = receiver.health().listening;
    const auto port = static_cast<std::uint16_t>(std::stoi(at.substr(at.find(':') + 1)));
    ASSERT_TRUE(sender_.send({0x7F000001, port}, plain_packet({"Ana", 1, 0.5, test::standing_pose()})));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));  // a receiver that runs takes it now
    receiver.listen([&](const ReceivedPose& pose) { heard.add(pose); });
  };
  const auto opened = StreamReceiver::open(*parse_stream_uri("vmc://127.0.0.1:0"), clock_, options,
                                           std::make_unique<PlainDecoder>());
  ASSERT_TRUE(opened) << opened.error().text();
  EXPECT_EQ(heard.wait_for(1).size(), 1U);
}

/// Has so much to answer to each packet that a pose is counted long before it is handed out.
class TalkativeDecoder : public PlainDecoder {
 public:
  void take(const Datagram& datagram, Decoded& out) override {
    PlainDecoder::take(datagram, out);
    const std::vector<std::uint8_t> bytes(10);
    for (int i = 0; i < 2000; ++i) out.replies.push_back({datagram.from, bytes});
  }
};

TEST_F(LoopbackReceiver, WhatWasCountedHasBeenHeardByWhoStopsListening) {
  listen_with(std::make_unique<TalkativeDecoder>());
  for (std::uint64_t i = 0; i < 20; ++i) {
    std::atomic<int> heard = 0;
    const int number = receiver_->listen([&](const ReceivedPose&) { ++heard; });
    send({"Ana", static_cast<std::int64_t>(i), {}, test::standing_pose()});
    const auto counted = [&] {
      const StreamHealth health = receiver_->health();
      return !health.performers.empty() && health.performers[0].frames == i + 1;
    };
    while (!counted()) std::this_thread::yield();
    receiver_->unlisten(number);
    ASSERT_EQ(heard, 1) << "pose " << i;
  }
}

TEST_F(LoopbackReceiver, GivesThePoseOfAPacketFromTheNetwork) {
  const auto source = receiver_->source();
  EXPECT_FALSE(source->poll(clock_.now_s()));
  const Pose sent = test::standing_pose();
  send({"Ana", 1, 0.5, sent});
  const auto heard = heard_.wait_for(1);
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_EQ(heard[0].performer, "Ana");
  EXPECT_EQ(heard[0].pose.pose, sent);
  EXPECT_EQ(heard[0].sender_time_s, 0.5);

  const auto pose = source->poll(clock_.now_s());
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->pose, sent);
  EXPECT_TRUE(pose->discontinuous) << "nothing comes before the first pose";
  EXPECT_GE(pose->arrived_s, 0);
  EXPECT_LE(pose->arrived_s, pose->assembled_s);
  EXPECT_FALSE(source->poll(clock_.now_s())) << "a pose is given once";

  const StreamHealth health = receiver_->health();
  EXPECT_EQ(health.state, StreamHealth::State::Receiving);
  EXPECT_EQ(health.packets, 1U);
  ASSERT_EQ(health.performers.size(), 1U);
  EXPECT_EQ(health.performers[0].joint_map, "cmu");
  EXPECT_TRUE(health.performers[0].tracked);
}

TEST_F(LoopbackReceiver, WakesWhoeverWaitsForAPose) {
  const auto source = receiver_->source();
  std::mutex mutex;
  std::condition_variable condition;
  int calls = 0;
  source->on_arrival([&] {
    const std::scoped_lock lock(mutex);
    ++calls;
    condition.notify_all();
  });
  send({"Ana", 1, {}, test::standing_pose()});
  std::unique_lock lock(mutex);
  EXPECT_TRUE(condition.wait_for(lock, std::chrono::seconds(20), [&] { return calls == 1; }));
  lock.unlock();
  source->on_arrival({});
}

TEST_F(LoopbackReceiver, ASourceOutlivesItsReceiver) {
  send({"Ana", 1, {}, test::standing_pose()});
  heard_.wait_for(1);
  auto source = receiver_->source("Ana");
  receiver_->unlisten(listener_);
  receiver_.reset();
  receiver_ = *StreamReceiver::open(*parse_stream_uri("vmc://127.0.0.1:0"), clock_, {},
                                    std::make_unique<PlainDecoder>());
  EXPECT_TRUE(source->poll(clock_.now_s()));
  source.reset();
}

TEST_F(LoopbackReceiver, MayBeAskedByManyThreadsWhileItReceives) {
  constexpr int frames = 300;
  std::atomic<bool> done = false;
  const auto source = receiver_->source();
  std::jthread asking([&] {
    while (!done) {
      const StreamHealth health = receiver_->health();
      EXPECT_LE(health.performers.size(), 1U);
      receiver_->measured_body("Ana");
      receiver_->performers();
    }
  });
  std::jthread changing([&] {
    while (!done) {
      receiver_->set_delay(0.01);
      receiver_->calibrate("", 0.001);
      const int number = receiver_->listen([](const ReceivedPose&) {});
      const auto another = receiver_->source("Ana");
      another->on_arrival([] {});
      another->set_max_rate(50);
      receiver_->set_delay(0);
      receiver_->unlisten(number);
    }
  });
  for (int i = 0; i < frames; ++i) {
    send({"Ana", i, {}, test::standing_pose()});
    heard_.wait_for(static_cast<std::size_t>(i) + 1);
    source->poll(clock_.now_s());
    source->next_due_s();
  }
  done = true;
  asking.join();
  changing.join();
  const StreamHealth health = receiver_->health();
  EXPECT_EQ(health.packets, static_cast<std::uint64_t>(frames));
  EXPECT_EQ(health.overflowed, 0U);
  EXPECT_EQ(health.performers.at(0).lost, 0U);
}

TEST_F(LoopbackReceiver, ShowsTheFirstBytesOfWhatItCannotRead) {
  send_bytes({'M', 'X', 'T', 'P', '0', '2'});
  send({"Ana", 1, {}, test::standing_pose()});
  heard_.wait_for(1);
  const StreamHealth health = receiver_->health();
  EXPECT_EQ(health.packets_with_issues, 1U);
  EXPECT_EQ(health.first_bytes[0], 'M');
  EXPECT_EQ(health.issues.at(0).kind, "other-protocol");
  EXPECT_EQ(health.senders.size(), 1U);
}

TEST_F(LoopbackReceiver, APortThatIsTakenIsAnErrorThatNamesAFreeOne) {
  const auto second = StreamReceiver::open(*parse_stream_uri("vmc://127.0.0.1:" + std::to_string(port_)),
                                           clock_, {}, std::make_unique<PlainDecoder>());
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().text(), AllOf(HasSubstr("port " + std::to_string(port_) + " is held by"),
                                           HasSubstr("(process "), HasSubstr("which is free")));
}

TEST(StreamReceiver, AnAddressOfAnotherMachineCannotBeListenedOn) {
  const auto receiver = StreamReceiver::open(*parse_stream_uri("vmc://192.0.2.1:39539"), SessionClock(), {},
                                             std::make_unique<PlainDecoder>());
  ASSERT_FALSE(receiver);
  EXPECT_THAT(receiver.error().text(), HasSubstr("listen on 0.0.0.0:39539"));
}

TEST(StreamReceiver, AClipIsNoStream) {
  EXPECT_FALSE(StreamReceiver::open(*parse_stream_uri("clip:a.bvh"), SessionClock()));
}

/// What a sink sends arrives in a receiver, through the network of this machine.
class SinkToReceiver : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(StreamReceiver, SinkToReceiver, testing::Values("vmc", "xsens", "natnet"));

TEST_P(SinkToReceiver, ThePoseArrives) {
  const SessionClock clock;
  // A port that is free now; NatNet's server takes it, for the others the receiver does.
  const std::uint16_t port = UdpSocket::bind({0x7F000001, 0})->local().port;
  const StreamUri uri = *parse_stream_uri(GetParam() + "://127.0.0.1:" + std::to_string(port));
  const Pose pose = test::standing_pose();
  auto sink = PoseSink::open(uri, body_of(pose), "partner");
  ASSERT_TRUE(sink) << sink.error().text();
  auto opened = StreamReceiver::open(uri, clock);
  ASSERT_TRUE(opened) << opened.error().text();
  Heard heard;
  const int listener = (*opened)->listen([&](const ReceivedPose& received) { heard.add(received); });
  std::vector<ReceivedPose> poses;
  const double until_s = clock.now_s() + 20;
  for (int i = 0; poses.size() < 3 && clock.now_s() < until_s; ++i) {
    (*sink)->send({pose, i / 100.0, true});
    poses = heard.wait_for(3, std::chrono::milliseconds(10));
  }
  (*opened)->unlisten(listener);
  ASSERT_GE(poses.size(), 3U);
  EXPECT_LT((poses.back().pose.pose - pose).rowwise().norm().mean(), 0.1)
      << "up to what the protocol leaves out";
  const SinkHealth health = (*sink)->health();
  EXPECT_EQ(health.character, "partner");
  EXPECT_GT(health.packets, 2U);
  EXPECT_EQ(health.failures, 0U) << health.latest_failure;
}

TEST(PoseSink, CountsThatNobodyListensAndGoesOn) {
  const std::uint16_t port = UdpSocket::bind({0x7F000001, 0})->local().port;
  auto sink = PoseSink::open(*parse_stream_uri("vmc://127.0.0.1:" + std::to_string(port)),
                             body_of(test::standing_pose()), "partner");
  ASSERT_TRUE(sink) << sink.error().text();
  for (int i = 0; i < 5; ++i) (*sink)->send({test::standing_pose(), i / 100.0, true});
  EXPECT_GT((*sink)->health().failures, 0U);
  EXPECT_THAT((*sink)->health().latest_failure, HasSubstr("no program listens there"));
  EXPECT_EQ((*sink)->health().frames, 5U);
}

TEST(PoseSink, MustBeToldWhoReceives) {
  const Body body = body_of(test::standing_pose());
  EXPECT_FALSE(PoseSink::open(*parse_stream_uri("vmc://0.0.0.0:39539"), body, "partner"));
  EXPECT_FALSE(PoseSink::open(*parse_stream_uri("vmc://127.0.0.1?delay=20"), body, "partner"));
  EXPECT_FALSE(PoseSink::open(*parse_stream_uri("clip:a.bvh"), body, "partner"));
}

}  // namespace
}  // namespace abrazo::receiver_test
