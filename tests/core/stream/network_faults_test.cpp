// Who is heard, and what happens when the network goes away.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <net/ethernet.h>
#include <net/if.h>
#include <net/route.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <set>
#include <thread>

#include "core/stream/receive/stream_receiver.hpp"
#include "core/stream/receive/stream_sockets.hpp"
#include "core/stream/send/pose_sink.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::network_faults_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string listening_at(const std::string& uri) {
  const auto receiver = StreamReceiver::open(*parse_stream_uri(uri), SessionClock());
  return receiver ? (*receiver)->health().listening : receiver.error().text();
}

TEST(Loopback, IsWhereAStreamIsHeardUnlessAnotherAddressIsNamed) {
  for (const std::string scheme : {"vmc", "xsens"}) {
    EXPECT_THAT(listening_at(scheme + "://:0"), StartsWith("127.0.0.1:"));
    EXPECT_THAT(listening_at(scheme + "://*:0"), StartsWith("0.0.0.0:"));
    EXPECT_THAT(listening_at(scheme + "://0.0.0.0:0"), StartsWith("0.0.0.0:"));
  }
  EXPECT_THAT(listening_at("natnet://"), StartsWith("127.0.0.1:"))
      << "answers of a server on this machine come from this machine";
}

TEST(Loopback, APacketToAnotherAddressOfThisMachineIsNotHeard) {
  auto sockets = *StreamSockets::open(*parse_stream_uri("vmc://:0"));
  UdpSocket sender = *UdpSocket::bind({0x7F000001, 0});
  const std::vector<std::uint8_t> bytes{1, 2, 3};
  // 127.0.0.2 is this machine too, and would be heard by a socket that hears every address.
  ASSERT_TRUE(sender.send({0x7F000002, sockets.local().port}, bytes));
  ASSERT_TRUE(sender.send(sockets.local(), bytes));
  int heard = 0;
  while (heard == 0) {
    ASSERT_TRUE(sockets.wait(10'000));
    ASSERT_TRUE(sockets.receive(SessionClock(), [&](const Datagram&, auto) { ++heard; }));
  }
  EXPECT_EQ(heard, 1);
}

TEST(Loopback, AServerOfOthersIsAnsweredOnItsOwnNetworkOnly) {
  auto sink = PoseSink::open(*parse_stream_uri("natnet://"), body_of(test::standing_pose()), "partner");
  ASSERT_TRUE(sink) << sink.error().text();
  // Port 1510 of every other address of this machine is free for others.
  EXPECT_TRUE(UdpSocket::bind({0x7F000002, 1510}));
}

// ---- a network of our own, that can be switched off ----

bool ask_of_loopback(unsigned long what, ifreq& request) {
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  std::strcpy(request.ifr_name, "lo");
  const bool done = ::ioctl(socket, what, &request) == 0;
  ::close(socket);
  return done;
}

bool switch_loopback_on() {
  ifreq request{};
  if (!ask_of_loopback(SIOCGIFFLAGS, request)) return false;
  request.ifr_flags = static_cast<short>(request.ifr_flags | IFF_UP);
  return ask_of_loopback(SIOCSIFFLAGS, request);
}

/// Without one there is no way to 127.0.0.1, as when a cable is pulled.
bool set_loopback_address(std::uint32_t address) {
  sockaddr_in system{};
  system.sin_family = AF_INET;
  system.sin_addr.s_addr = htonl(address);
  ifreq request{};
  std::memcpy(&request.ifr_addr, &system, sizeof system);
  return ask_of_loopback(SIOCSIFADDR, request);
}
bool pull_the_cable() {
  return set_loopback_address(0);
}
bool plug_it_in() {
  return set_loopback_address(0x7F000001);
}

/// Everything leads through a network in which this machine has the address, and no other: a new lease,
/// another Wi-Fi.
bool be_at(std::uint32_t address) {
  if (!pull_the_cable() || !set_loopback_address(address)) return false;
  std::string device = "lo";
  rtentry route{};
  route.rt_dst.sa_family = route.rt_genmask.sa_family = AF_INET;
  route.rt_flags = RTF_UP;
  route.rt_dev = device.data();
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const bool done = ::ioctl(socket, SIOCADDRT, &route) == 0;
  ::close(socket);
  return done;
}
constexpr std::uint32_t at_home = 0x0A000005, in_the_studio = 0x0B000006;  // 10.0.0.5, 11.0.0.6

/// Sees every packet that goes out.
class PacketTap {
 public:
  PacketTap() : socket_(::socket(AF_PACKET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, htons(ETH_P_IP))) {}
  ~PacketTap() { ::close(socket_); }
  PacketTap(const PacketTap&) = delete;
  PacketTap& operator=(const PacketTap&) = delete;

  /// Where the packets since the last call came from.
  std::set<std::uint32_t> sources() const {
    std::set<std::uint32_t> seen;
    std::array<std::uint8_t, 2048> packet{};
    while (::recv(socket_, packet.data(), packet.size(), 0) >= 20) {
      std::uint32_t address = 0;
      std::memcpy(&address, packet.data() + 12, sizeof address);
      seen.insert(ntohl(address));
    }
    return seen;
  }

 private:
  int socket_;
};

/// UDP sockets of this network that are bound.
int bound_sockets() {
  std::ifstream table("/proc/thread-self/net/udp");
  std::string line;
  int lines = -1;  // the heading
  while (std::getline(table, line)) ++lines;
  return lines;
}

constexpr int not_allowed = 77;

/// Runs it in a process that has a network of its own. @return its exit status
int in_own_network(const std::function<bool()>& body) {
  const pid_t child = ::fork();
  if (child == 0) {
    if (::unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0 || !switch_loopback_on()) ::_exit(not_allowed);
    const bool good = body();
    std::cerr.flush();
    ::_exit(good && !testing::Test::HasFailure() ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

#define RUN_IN_OWN_NETWORK(...)                                                             \
  const int status = in_own_network(__VA_ARGS__);                                           \
  if (status == not_allowed) GTEST_SKIP() << "this user may not have a network of its own"; \
  EXPECT_EQ(status, 0)

TEST(NetworkGone, ASinkCountsWhatIsNotTakenAndGoesOnWhenTheNetworkIsBack) {
  RUN_IN_OWN_NETWORK([] {
    UdpSocket receiver = *UdpSocket::bind({0x7F000001, 0});
    auto sink = PoseSink::open(*parse_stream_uri("vmc://" + receiver.local().text()),
                               body_of(test::standing_pose()), "partner");
    (*sink)->send({test::standing_pose(), 0, true});
    EXPECT_EQ((*sink)->health().failures, 0U);
    EXPECT_TRUE(pull_the_cable());
    (*sink)->send({test::standing_pose(), 0.01, true});
    const SinkHealth gone = (*sink)->health();
    EXPECT_GT(gone.failures, 0U);
    EXPECT_THAT(gone.latest_failure, HasSubstr("is the network connected?"));
    EXPECT_TRUE(plug_it_in());
    (*sink)->send({test::standing_pose(), 0.02, true});
    EXPECT_EQ((*sink)->health().failures, gone.failures);
    EXPECT_GT((*sink)->health().packets, gone.packets);
    return true;
  });
}

TEST(NetworkGone, AReceiverHearsAgainWhenTheNetworkIsBack) {
  RUN_IN_OWN_NETWORK([] {
    auto sockets = *StreamSockets::open(*parse_stream_uri("vmc://:0"));
    UdpSocket sender = *UdpSocket::bind({0x7F000001, 0});
    EXPECT_TRUE(pull_the_cable());
    EXPECT_FALSE(sender.send(sockets.local(), std::vector<std::uint8_t>{1}));
    EXPECT_TRUE(sockets.receive(SessionClock(), [](const Datagram&, auto) {})) << "silence is no failure";
    EXPECT_TRUE(plug_it_in());
    EXPECT_TRUE(sender.send(sockets.local(), std::vector<std::uint8_t>{2}));
    int heard = 0;
    EXPECT_TRUE(sockets.wait(10'000));
    EXPECT_TRUE(sockets.receive(SessionClock(), [&](const Datagram& one, auto) { heard += one.bytes[0]; }));
    EXPECT_EQ(heard, 2);
    return true;
  });
}

TEST(NetworkGone, AServerThatNoNetworkLeadsToIsSaid) {
  RUN_IN_OWN_NETWORK([] {
    const auto sockets = StreamSockets::open(*parse_stream_uri("natnet://192.0.2.1"));
    EXPECT_FALSE(sockets);
    EXPECT_THAT(sockets ? "" : sockets.error().text(), HasSubstr("is the network connected?"));
    return true;
  });
}

TEST(NetworkGone, ASinkGoesOnFromTheAddressThatTheMachineHasThen) {
  RUN_IN_OWN_NETWORK([] {
    for (const std::string scheme : {"vmc://192.0.2.1:39540", "natnet://192.0.2.1:1510"}) {
      EXPECT_TRUE(be_at(at_home));
      auto sink = *PoseSink::open(*parse_stream_uri(scheme), body_of(test::standing_pose()), "partner");
      const PacketTap tap;
      sink->send({test::standing_pose(), 0, true});
      EXPECT_THAT(tap.sources(), ElementsAre(at_home)) << scheme;
      EXPECT_TRUE(be_at(in_the_studio));
      sink->send({test::standing_pose(), 0.01, true});
      EXPECT_THAT(tap.sources(), ElementsAre(in_the_studio)) << scheme;
      EXPECT_EQ(sink->health().failures, 0U) << sink->health().latest_failure;
    }
    return true;
  });
}

TEST(NetworkGone, ASinkWithoutAWayToItsReceiverIsHeardNowhereUntilThereIsOne) {
  RUN_IN_OWN_NETWORK([] {
    EXPECT_TRUE(pull_the_cable());
    auto sink = PoseSink::open(*parse_stream_uri("natnet://192.0.2.1:1510"), body_of(test::standing_pose()),
                               "partner");
    EXPECT_TRUE(sink);
    EXPECT_EQ(bound_sockets(), 0) << "a socket that every network reaches";
    (*sink)->send({test::standing_pose(), 0, true});
    EXPECT_THAT((*sink)->health().latest_failure, HasSubstr("is the network connected?"));
    EXPECT_TRUE(be_at(at_home));
    const PacketTap tap;
    (*sink)->send({test::standing_pose(), 0.01, true});
    EXPECT_THAT(tap.sources(), ElementsAre(at_home));
    return true;
  });
}

TEST(NetworkGone, AReceiverTalksToItsServerFromTheAddressThatTheMachineHasThen) {
  RUN_IN_OWN_NETWORK([] {
    EXPECT_TRUE(be_at(at_home));
    auto sockets = *StreamSockets::open(*parse_stream_uri("natnet://192.0.2.1"));
    EXPECT_TRUE(sockets.join({0xEFFF2A63, 1511}));
    EXPECT_TRUE(be_at(in_the_studio));
    const PacketTap tap;
    const Status sent = sockets.reply({{}, {1, 2, 3}});
    EXPECT_TRUE(sent) << sent.error().text();
    EXPECT_THAT(tap.sources(), ElementsAre(in_the_studio));
    EXPECT_EQ(sockets.local().address, in_the_studio);
    EXPECT_THAT(sockets.listening(), Not(HasSubstr("multicast"))) << "it was joined on the network before";
    EXPECT_TRUE(sockets.join({0xEFFF2A63, 1511}));
    EXPECT_THAT(sockets.listening(), HasSubstr("multicast"));
    return true;
  });
}

TEST(NetworkGone, AReceiverStaysAtTheInterfaceThatWasNamed) {
  RUN_IN_OWN_NETWORK([] {
    EXPECT_TRUE(be_at(at_home));
    auto sockets = *StreamSockets::open(*parse_stream_uri("natnet://192.0.2.1?interface=10.0.0.5"));
    EXPECT_TRUE(be_at(in_the_studio));
    EXPECT_FALSE(sockets.reply({{}, {1, 2, 3}}));
    EXPECT_EQ(sockets.local().address, at_home);
    return true;
  });
}

TEST(NetworkGone, ThatTheMachineLostTheAddressWhichIsListenedAtIsSaid) {
  RUN_IN_OWN_NETWORK([] {
    EXPECT_TRUE(be_at(at_home));
    const auto receiver = *StreamReceiver::open(*parse_stream_uri("vmc://10.0.0.5:0"), SessionClock());
    const auto is_said = [&] {
      const auto diagnoses = receiver->health().diagnoses;
      return !diagnoses.empty() && diagnoses.front().kind == "address-gone";
    };
    const auto becomes = [&](bool said) {
      const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
      while (is_said() != said && std::chrono::steady_clock::now() < until) std::this_thread::yield();
      return is_said() == said;
    };
    EXPECT_FALSE(is_said());
    EXPECT_TRUE(be_at(in_the_studio));
    EXPECT_TRUE(becomes(true));
    EXPECT_TRUE(be_at(at_home));
    EXPECT_TRUE(becomes(false));
    return true;
  });
}

TEST(Stranger, IsNotTakenForTheServerThatWasNamed) {
  RUN_IN_OWN_NETWORK([] {
    EXPECT_TRUE(be_at(at_home));
    const std::vector<std::uint8_t> bytes{1, 2, 3};
    const auto heard_from_home = [&](const std::string& uri) {
      auto sockets = *StreamSockets::open(*parse_stream_uri(uri));
      UdpSocket sender = *UdpSocket::bind({at_home, 0});
      EXPECT_TRUE(sender.send({at_home, sockets.local().port}, bytes));
      std::optional<StreamSockets::Packet> heard;
      EXPECT_TRUE(sockets.wait(10'000));
      EXPECT_TRUE(sockets.receive(SessionClock(), [&](const Datagram&, auto packet) { heard = packet; }));
      return heard;
    };
    EXPECT_EQ(heard_from_home("natnet://192.0.2.1"), StreamSockets::Packet::OfAStranger);
    EXPECT_EQ(heard_from_home("natnet://10.0.0.5"), StreamSockets::Packet::Whole);
    EXPECT_EQ(heard_from_home("natnet://0.0.0.0:0"), StreamSockets::Packet::Whole) << "no server was named";
    return true;
  });
}

TEST(Stranger, IsCountedAndSaidByTheReceiver) {
  RUN_IN_OWN_NETWORK([] {
    EXPECT_TRUE(be_at(at_home));
    const auto receiver = *StreamReceiver::open(*parse_stream_uri("natnet://192.0.2.1"), SessionClock());
    const std::string at = receiver->health().listening;
    const auto port = static_cast<std::uint16_t>(std::stoi(at.substr(at.find(':') + 1)));
    UdpSocket sender = *UdpSocket::bind({at_home, 0});
    EXPECT_TRUE(sender.send({at_home, port}, std::vector<std::uint8_t>{1, 2, 3}));
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    StreamHealth health;
    while (health.issues.empty() && std::chrono::steady_clock::now() < until) health = receiver->health();
    EXPECT_EQ(health.packets, 0U) << "a packet that was not heard hides no silence of the server";
    EXPECT_TRUE(health.senders.empty());
    EXPECT_EQ(health.diagnoses.size(), 1U);
    if (health.diagnoses.size() == 1U) {
      EXPECT_EQ(health.diagnoses[0].kind, "stranger");
      EXPECT_THAT(health.diagnoses[0].text,
                  HasSubstr("only the server 192.0.2.1 is accepted; packets of 10.0.0.5 are left out"));
    }
    return true;
  });
}

TEST(Multicast, OnlyWhatIsSentToTheGroupIsHeardAtItsPort) {
  RUN_IN_OWN_NETWORK([] {
    auto sockets = *StreamSockets::open(*parse_stream_uri("natnet://127.0.0.1"));
    const Endpoint group{0xEFFF2A63, 1511};
    const Status joined = sockets.join(group);
    EXPECT_TRUE(joined) << joined.error().text();
    UdpSocket sender = *UdpSocket::bind({0x7F000001, 0});
    EXPECT_TRUE(sender.send_through(0x7F000001));
    (void)sender.send({0x7F000001, 1511}, std::vector<std::uint8_t>{1});  // past the group
    EXPECT_TRUE(sender.send(group, std::vector<std::uint8_t>{2}));
    int heard = 0;
    EXPECT_TRUE(sockets.wait(10'000));
    EXPECT_TRUE(sockets.receive(SessionClock(), [&](const Datagram& one, auto) { heard += one.bytes[0]; }));
    EXPECT_EQ(heard, 2);
    EXPECT_THAT(sockets.listening(), HasSubstr(" and multicast 239.255.42.99:1511"));
    return true;
  });
}

TEST(Multicast, AGroupIsHeardWithoutAServer) {
  RUN_IN_OWN_NETWORK([] {
    auto opened =
        StreamSockets::open(*parse_stream_uri("natnet://*?multicast=239.255.42.99&interface=127.0.0.1"));
    EXPECT_TRUE(opened);
    const Endpoint group{0xEFFF2A63, 1511};
    const Status joined = opened->join(group);
    EXPECT_TRUE(joined) << joined.error().text();
    UdpSocket sender = *UdpSocket::bind({0x7F000001, 0});
    EXPECT_TRUE(sender.send_through(0x7F000001));
    EXPECT_TRUE(sender.send(group, std::vector<std::uint8_t>{2}));
    int heard = 0;
    EXPECT_TRUE(opened->wait(10'000));
    EXPECT_TRUE(opened->receive(SessionClock(), [&](const Datagram&, auto) { ++heard; }));
    EXPECT_EQ(heard, 1);
    return true;
  });
}

}  // namespace
}  // namespace abrazo::network_faults_test
