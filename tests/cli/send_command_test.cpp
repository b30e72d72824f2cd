#include <csignal>
#include <thread>

#include "core/stream/vmc/osc_packet.hpp"
#include "tests/cli/live_fixture.hpp"

namespace abrazo::test::send_command_test {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

class SendCommand : public CommandLineTest {
 protected:
  SendCommand() { make_demo(); }
  TestReceiver receiver;
};

/// Addresses of a packet's messages, in order.
std::vector<std::string> addresses_of(const Bytes& packet) {
  std::vector<std::string> addresses;
  for (const OscElement& element : read_osc(packet).elements)
    if (element.kind == OscElement::Kind::Message) addresses.push_back(element.address);
  return addresses;
}

TEST_F(SendCommand, AClipGoesOutOnceAtItsRateAndIsSummedUp) {
  RunningCommand command({ABRAZO_PROGRAM, "send", "demo/salsa_01_a.bvh", "--fps", "150", "--json", "--to",
                          uri_of("vmc", receiver.port())},
                         folder());
  ASSERT_TRUE(wait_until([&] {
    receiver.packets();  // or the system's buffer is full
    return command.finished();
  }));
  const Outcome outcome = command.wait();
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto said = nlohmann::json::parse(outcome.out);
  const auto info = nlohmann::json::parse(run("motion info demo/salsa_01_a.bvh --json").out);
  EXPECT_EQ(said["frames"].get<int>() + said["skipped"].get<int>(), info["frames"].get<int>())
      << "what is late gives way to the newest";
  EXPECT_EQ(said["failures"], 0);
  EXPECT_THAT(receiver.packets(), SizeIs(said["packets"].get<std::size_t>()));
}

TEST_F(SendCommand, HeldUpTillAfterTheEndItSendsTheLastPoseAndCountsTheOthers) {
  RunningCommand command({ABRAZO_PROGRAM, "send", "demo/salsa_01_a.bvh", "--fps", "600", "--json", "--to",
                          uri_of("vmc", receiver.port())},
                         folder());
  ASSERT_TRUE(wait_until([&] { return !receiver.packets().empty(); }));
  command.signal(SIGSTOP);
  std::this_thread::sleep_for(std::chrono::seconds(2));  // the clip is over
  command.signal(SIGCONT);
  const Outcome outcome = command.wait();
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto said = nlohmann::json::parse(outcome.out);
  const auto info = nlohmann::json::parse(run("motion info demo/salsa_01_a.bvh --json").out);
  EXPECT_GT(said["skipped"], 0);
  EXPECT_EQ(said["frames"].get<int>() + said["skipped"].get<int>(), info["frames"].get<int>());
}

TEST_F(SendCommand, TheFramingIsTheOneAskedFor) {
  ASSERT_EQ(run("send demo/salsa_01_a.bvh --seconds 1 --to " + uri_of("vmc", receiver.port())).status, 0);
  EXPECT_EQ(addresses_of(receiver.packets().at(0)).back(), "/VMC/Ext/T");
  TestReceiver split;
  ASSERT_EQ(
      run("send demo/salsa_01_a.bvh --seconds 1 --to " + uri_of("vmc", split.port(), "framing=split")).status,
      0);
  EXPECT_THAT(addresses_of(split.packets().at(0)), SizeIs(12));
  EXPECT_EQ(addresses_of(split.packets().at(1)).back(), "/VMC/Ext/T");
  TestReceiver other;
  ASSERT_EQ(run("send demo/salsa_01_a.bvh --seconds 1 --to " + uri_of("vmc", other.port(), "framing=t-first"))
                .status,
            0);
  EXPECT_EQ(addresses_of(other.packets().at(0)).front(), "/VMC/Ext/T");
}

TEST_F(SendCommand, WhatCannotBeMeantIsRefused) {
  expect_failure(run("send demo/salsa_01_a.bvh --to 127.0.0.1:39539"), "expected vmc://HOST:PORT");
  expect_failure(run("send demo/salsa_01_a.bvh --to clip:x.bvh"), "clip");
  expect_failure(run("send demo/salsa_01_a.bvh --to vmc://127.0.0.1:39539?framing=last"), "framing");
  expect_failure(run("send demo/salsa_01_a.bvh --to vmc://127.0.0.1:39539?delay=20"), "for listening");
  expect_failure(run("send demo/none.bvh --to vmc://127.0.0.1:39539"), "demo/none.bvh");
  expect_wrong_usage(run("send demo/salsa_01_a.bvh"), "--to is required");
  expect_wrong_usage(run("send demo/salsa_01_a.bvh --to vmc://127.0.0.1:1 --rate 0"),
                     "expected a number above 0");
}

TEST_F(SendCommand, ALoopGoesOnTillItIsInterrupted) {
  RunningCommand command({ABRAZO_PROGRAM, "send", "demo/salsa_01_a.bvh", "--fps", "6000", "--rate", "100",
                          "--loop", "--json", "--to", uri_of("vmc", receiver.port())},
                         folder());
  const std::size_t laps = 5 * 20 * 2;  // 1152 frames at 6000 Hz, sent at 100 Hz, in two packets each
  EXPECT_TRUE(wait_until([&] { return receiver.packets().size() > laps; }));
  command.signal(SIGINT);
  const Outcome outcome = command.wait();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_GT(nlohmann::json::parse(outcome.out)["frames"], 100);
}

}  // namespace
}  // namespace abrazo::test::send_command_test
