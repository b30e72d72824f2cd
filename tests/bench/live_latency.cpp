// Latency of a live session as somebody outside sees it: real VMC packets of a clip go in, the partner's come
// back, and the time from the last packet of the one to the last packet of the other is taken here, not in
// the program that is measured.
//
//   live_latency CLIP --library LIB.h5 [--rate HZ]... [--seconds S] [--load 1] [-- words for abrazo live]
//   live_latency CLIP --to vmc://HOST:PORT --back PORT      a program that runs already sends to PORT
#include <fmt/core.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <atomic>
#include <csignal>
#include <exception>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "core/base/statistics.hpp"
#include "core/motion/body/resample.hpp"
#include "core/motion/files/import_clip.hpp"
#include "core/stream/net/udp_socket.hpp"
#include "core/stream/protocol/stream_encoder.hpp"
#include "core/stream/send/encoders.hpp"
#include "core/stream/vmc/osc_packet.hpp"
#include "tests/cli/run_command.hpp"
#include "tests/cli/udp_ports.hpp"

namespace {

using namespace abrazo;

using test::this_machine;

constexpr double warm_up_s = 2;
/// A pause now and then tells which answer is to which frame: the first after it, to the first after it. Too
/// short for tracking to count as lost.
constexpr double pause_s = 0.15;
constexpr double between_pauses_s = 2;
constexpr double last_answers_s = 0.5;

struct Options {
  std::string clip, library, to;
  std::uint16_t back = 0;
  std::vector<double> rates = {60, 120, 240};
  double seconds = 20;
  std::vector<std::string> words;
  bool json = false;
};

/// A frame by the time that stands in it and the time at which its last packet passed.
struct Passed {
  double sender_s = 0;
  double at_s = 0;
  bool after_pause = false;
};

/// "/VMC/Ext/T" of a packet; only a frame's last packet has one.
std::optional<double> time_in(std::span<const std::uint8_t> packet) {
  for (const OscElement& element : read_osc(packet).elements)
    if (element.kind == OscElement::Kind::Message && element.address == "/VMC/Ext/T" &&
        !element.arguments.empty())
      return element.arguments.front().number;
  return std::nullopt;
}

/// What comes back, stamped by the kernel, on a thread of its own.
class Answers {
 public:
  Answers(UdpSocket socket, const SessionClock& clock)
      : socket_(std::move(socket)), clock_(clock), thread_([this] { receive(); }) {}
  ~Answers() { stop(); }
  Answers(const Answers&) = delete;
  Answers& operator=(const Answers&) = delete;

  std::vector<Passed> taken() {
    const std::scoped_lock lock(mutex_);
    return passed_;
  }
  std::uint64_t overflowed() const { return socket_.overflowed(); }

 private:
  void stop() {
    stopping_ = true;
    wait_.wake();
    thread_.join();
  }
  void receive() {
    std::array<std::uint8_t, 65536> buffer;
    const int descriptor = socket_.descriptor();
    while (!stopping_) {
      wait_.wait({&descriptor, 1}, 100);
      while (true) {
        const auto received = socket_.receive(buffer, clock_);
        if (!received || !*received) break;
        const auto time = time_in(std::span(buffer).first((*received)->size));
        const std::scoped_lock lock(mutex_);
        if (time) passed_.push_back({*time, (*received)->arrived_s, false});
      }
    }
  }

  UdpSocket socket_;
  SessionClock clock_;
  SocketWait wait_;
  std::mutex mutex_;
  std::vector<Passed> passed_;
  std::atomic<bool> stopping_ = false;
  std::thread thread_;
};

/// Plays the clip at the rate, with a pause now and then.
std::vector<Passed> send(const Options& options, const Clip& clip, double rate_hz, const Endpoint& to,
                         const SessionClock& clock) {
  const StreamUri uri = *parse_stream_uri("vmc://127.0.0.1:39539");
  const auto encoder = std::move(*make_stream_encoder(uri, body_of(clip.poses)));
  UdpSocket socket = std::move(*UdpSocket::bind({0, 0}));
  std::vector<Passed> sent;
  const double start_s = clock.now_s();
  double due_s = start_s, next_pause_s = start_s + warm_up_s;
  for (std::size_t i = 0; due_s < start_s + warm_up_s + options.seconds; ++i) {
    bool paused = false;
    if (due_s >= next_pause_s) {
      due_s += pause_s;
      next_pause_s += between_pauses_s;
      paused = true;
    }
    std::this_thread::sleep_until(clock.at(due_s));
    const auto packets = encoder->packets({clip.poses[i % clip.poses.size()], due_s - start_s, true});
    double at_s = 0;
    for (const auto& packet : packets) {
      at_s = clock.now_s();
      if (const Status done = socket.send(to, packet); !done) fmt::print(stderr, "{}\n", done.error().text());
    }
    sent.push_back({*time_in(packets.back()), at_s, paused});
    due_s += 1 / rate_hz;
  }
  std::this_thread::sleep_until(clock.at(clock.now_s() + last_answers_s));
  return sent;
}

struct Latencies {
  std::vector<double> ms;
  std::size_t sent = 0, answered = 0, stretches = 0;
};

/// Each stretch between pauses by itself: the offset between both clocks comes from its first frame.
Latencies matched(const std::vector<Passed>& sent, const std::vector<Passed>& answers, double interval_s) {
  Latencies all;
  for (std::size_t begin = 0; begin < sent.size(); ++begin) {
    if (!sent[begin].after_pause) continue;
    std::size_t end = begin + 1;
    while (end < sent.size() && !sent[end].after_pause) ++end;
    const double until_s = end < sent.size() ? sent[end].at_s : sent.back().at_s + last_answers_s;
    // A held pose may be sent again in the pause; the answer's own time tells the first new one.
    std::optional<double> offset_s;
    double previous_s = -1e9;
    std::size_t next = begin;
    bool counted = false;
    for (const Passed& answer : answers) {
      const double step_s = answer.sender_s - previous_s;
      previous_s = answer.sender_s;
      if (answer.at_s < sent[begin].at_s || answer.at_s >= until_s) continue;
      if (!offset_s && step_s < pause_s / 2) continue;
      if (!offset_s) offset_s = answer.sender_s - sent[begin].sender_s;
      const double wanted_s = answer.sender_s - *offset_s;
      while (next + 1 < end &&
             std::abs(sent[next + 1].sender_s - wanted_s) <= std::abs(sent[next].sender_s - wanted_s))
        ++next;
      if (std::abs(sent[next].sender_s - wanted_s) > 0.45 * interval_s) continue;
      all.ms.push_back(1000 * (answer.at_s - sent[next].at_s));
      ++all.answered;
      counted = true;
    }
    all.stretches += counted;
    all.sent += end - begin;
  }
  return all;
}

double load_of_machine() {
  double load = 0;
  std::ifstream("/proc/loadavg") >> load;
  return load;
}

void print_row(const Options& options, double rate_hz, const Latencies& found, const std::string& rest) {
  if (options.json) {
    fmt::print("{}\n", nlohmann::json{{"rate_hz", rate_hz},
                                      {"p50", percentile(found.ms, 0.5)},
                                      {"p95", percentile(found.ms, 0.95)},
                                      {"p99", percentile(found.ms, 0.99)},
                                      {"max", percentile(found.ms, 1)},
                                      {"sent", found.sent},
                                      {"answered", found.answered},
                                      {"rest", rest}}
                           .dump());
    std::fflush(stdout);
    return;
  }
  fmt::print("{:>5.0f}  {:>7.2f} {:>7.2f} {:>7.2f} {:>7.2f}  {:>7} {:>8}  {}  load {:.1f}\n", rate_hz,
             percentile(found.ms, 0.5), percentile(found.ms, 0.95), percentile(found.ms, 0.99),
             percentile(found.ms, 1), found.sent, found.answered, rest, load_of_machine());
  std::fflush(stdout);
}

/// The program's own account of a run: what of the frames sent did not come in, and its own p50 and p95.
std::string account_of(const std::string& json_text, std::size_t frames_sent, std::size_t answers) {
  const auto json = nlohmann::json::parse(json_text, nullptr, false);
  if (json.is_discarded() || json["stream"]["performers"].empty()) return "no statistics";
  const auto received = json["stream"]["performers"][0]["frames"].get<std::size_t>();
  const auto out = json["sinks"][0]["frames"].get<std::size_t>();
  const auto& own = json["latency_ms"]["in_to_out"];
  return fmt::format("lost in {}, lost out {}, replaced {}, own p50 {:.2f} p95 {:.2f}, solve p50 {:.2f}",
                     static_cast<long long>(frames_sent) - static_cast<long long>(received),
                     static_cast<long long>(out) - static_cast<long long>(answers),
                     json["replaced_unsolved"].get<std::size_t>(), own["p50"].get<double>(),
                     own["p95"].get<double>(), json["latency_ms"]["solve"]["p50"].get<double>());
}

Clip at_rate(const Clip& clip, double rate_hz) {
  std::vector<StampedPose> stamped;
  for (std::size_t i = 0; i < clip.poses.size(); ++i)
    stamped.push_back({static_cast<double>(i) / clip.fps, clip.poses[i]});
  return {clip.name, rate_hz, resample(stamped, rate_hz).poses};
}

/// A program that runs already.
void measure_running(const Options& options, const Clip& clip, double rate_hz) {
  const StreamUri uri = *parse_stream_uri(options.to);
  const SessionClock clock;
  auto socket = UdpSocket::bind({0, options.back});
  if (!socket) throw std::runtime_error(socket.error().text());
  Answers answers(std::move(*socket), clock);
  const auto sent =
      send(options, at_rate(clip, rate_hz), rate_hz, {*resolve_host(uri.host), uri.port}, clock);
  const Latencies found = matched(sent, answers.taken(), 1 / rate_hz);
  print_row(options, rate_hz, found, fmt::format("not fetched here {}", answers.overflowed()));
}

/// `abrazo live`, started and ended here.
void measure_child(const Options& options, const Clip& clip, double rate_hz) {
  const SessionClock clock;
  const std::uint16_t port = test::free_port();
  UdpSocket socket = std::move(*UdpSocket::bind({this_machine, 0}));
  std::vector<std::string> words = {ABRAZO_PROGRAM, "live",
                                    "--library",    options.library,
                                    "--listen",     fmt::format("vmc://127.0.0.1:{}", port),
                                    "--send",       fmt::format("vmc://127.0.0.1:{}", socket.local().port),
                                    "--json",       "--quiet"};
  words.insert(words.end(), options.words.begin(), options.words.end());
  Answers answers(std::move(socket), clock);
  test::RunningCommand live(words, ".");
  while (!live.finished() && !test::is_open(port)) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  if (live.finished()) throw std::runtime_error(live.wait().err);
  const auto sent = send(options, at_rate(clip, rate_hz), rate_hz, {this_machine, port}, clock);
  live.signal(SIGTERM);  // what a shell starts in the background has been told to ignore SIGINT
  const test::Outcome outcome = live.wait();
  const auto taken = answers.taken();
  // Poses held after the last frame are no answers of the program's count of solved ones.
  print_row(options, rate_hz, matched(sent, taken, 1 / rate_hz),
            account_of(outcome.out, sent.size(), taken.size()));
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Latency of a live session, taken from outside");
  app.add_option("CLIP", options.clip, "motion file that is streamed")->required();
  app.add_option("--library", options.library, "library for a session of its own");
  app.add_option("--to", options.to, "a running program listens there (vmc://HOST:PORT)");
  app.add_option("--back", options.back, "and sends its partner to this port");
  app.add_option("--rate", options.rates, "frames a second; may be repeated")->capture_default_str();
  app.add_option("--seconds", options.seconds, "for each rate")->capture_default_str();
  app.add_flag("--json", options.json, "one object a line in place of the table [ms]");
  app.add_option("words", options.words, "further words for abrazo live, behind --");
  CLI11_PARSE(app, argc, argv);
  if (options.library.empty() == options.to.empty() || options.to.empty() != (options.back == 0)) {
    fmt::print(stderr, "either --library, or --to and --back\n");
    return 2;
  }
  const auto clips = load_motion(options.clip, "", {});
  if (!clips) {
    fmt::print(stderr, "{}\n", clips.error().text());
    return 1;
  }
  if (!options.json) fmt::print("   Hz      p50     p95     p99     max ms   frames answered\n");
  try {
    for (const double rate_hz : options.rates) {
      if (options.to.empty())
        measure_child(options, clips->front().clip, rate_hz);
      else
        measure_running(options, clips->front().clip, rate_hz);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
