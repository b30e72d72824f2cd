#include "tests/cli/live_fixture.hpp"

#include <fmt/format.h>

#include <array>
#include <csignal>
#include <iterator>
#include <sstream>
#include <thread>

#include "core/motion/files/import_clip.hpp"
#include "core/stream/send/encoders.hpp"

namespace abrazo::test {

namespace {

constexpr auto between_frames = std::chrono::microseconds(16667);
constexpr auto between_looks = std::chrono::milliseconds(5);
constexpr auto patience = std::chrono::minutes(3);

}  // namespace

bool wait_until(const std::function<bool()>& is_so) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!is_so()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(between_looks);
  }
  return true;
}

std::string uri_of(const std::string& scheme, std::uint16_t port, const std::string& options) {
  return fmt::format("{}://127.0.0.1:{}{}{}", scheme, port, options.empty() ? "" : "?", options);
}

TestSender::TestSender(const std::string& uri, const Clip& clip)
    : to_{this_machine, parse_stream_uri(uri)->port},
      socket_(*UdpSocket::bind({this_machine, 0})),
      clip_(clip),
      encoder_(*make_stream_encoder(*parse_stream_uri(uri), body_of(clip.poses))) {}

std::vector<Bytes> TestSender::next_packets() {
  const double time_s = std::chrono::duration<double>(Clock::now() - began_).count();
  return encoder_->packets({clip_.poses[next_++ % clip_.poses.size()], time_s, true});
}

void TestSender::send(const Bytes& bytes) {
  EXPECT_TRUE(socket_.send(to_, bytes));
}

void TestSender::send_frame() {
  std::this_thread::sleep_until(due_);
  due_ = Clock::now() + between_frames;
  for (const Bytes& packet : next_packets()) send(packet);
}

bool TestSender::send_until(const std::function<bool()>& is_so) {
  const auto end = Clock::now() + patience;
  while (!is_so()) {
    if (Clock::now() > end) return false;
    send_frame();
  }
  return true;
}

void TestSender::restart() {
  began_ = Clock::now();
  encoder_->restart();
}

TestReceiver::TestReceiver() : socket_(*UdpSocket::bind({this_machine, 0})) {}

const std::vector<Bytes>& TestReceiver::packets() {
  std::array<std::uint8_t, 65536> buffer;
  while (true) {
    const auto received = socket_.receive(buffer, clock_);
    if (!received || !*received) return packets_;
    packets_.emplace_back(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>((*received)->size));
  }
}

LiveTest::LiveTest() {
  make_library();
  auto clips = load_motion(path("demo/salsa_01_a.bvh").string(), "", {});
  if (!clips) throw std::runtime_error(clips.error().text());
  clip_ = std::move(clips->front().clip);
}

LiveTest::~LiveTest() {
  if (live && !live->finished()) live->signal(SIGKILL);
}

void LiveTest::start(const std::string& listen, const std::string& words) {
  std::istringstream in("live --library demo.h5 --json --listen " + listen + " " + words);
  std::vector<std::string> all{std::istream_iterator<std::string>(in), {}};
  all.insert(all.begin(), ABRAZO_PROGRAM);
  live = std::make_unique<RunningCommand>(all, folder());
}

void LiveTest::start_at(std::uint16_t port, const std::string& listen, const std::string& words) {
  start(listen, words);
  ASSERT_TRUE(wait_until([&] { return live->finished() || is_open(port); }));
  ASSERT_FALSE(live->finished()) << live->wait().err;
}

Outcome LiveTest::end() {
  live->signal(SIGINT);
  return live->wait();
}

nlohmann::json LiveTest::statistics() {
  const Outcome outcome = end();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out);
}

bool LiveTest::has_warned_of(const std::string& part) const {
  return live->errors_so_far().find(part) != std::string::npos;
}

std::shared_ptr<const SessionFile> LiveTest::session(const std::string& name) const {
  auto file = SessionFile::open(path(name).string());
  if (!file) throw std::runtime_error(file.error().text());
  return *file;
}

std::vector<FrameSnapshot> LiveTest::recorded_frames(const std::string& name) const {
  std::vector<FrameSnapshot> frames;
  const auto read = session(name)->each_frame(-1e9, 1e9, [&](const FrameSnapshot& frame) -> Status {
    frames.push_back(frame);
    return Done{};
  });
  EXPECT_TRUE(read) << read.error().text();
  return frames;
}

nlohmann::json entry_of(const nlohmann::json& list, const std::string& kind) {
  for (const auto& entry : list)
    if (entry["kind"] == kind) return entry;
  return nullptr;
}

}  // namespace abrazo::test
