#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/cli/command_line.hpp"
#include "app/cli/interruption.hpp"
#include "app/cli/motion_reading.hpp"
#include "core/base/session_clock.hpp"
#include "core/motion/body/resample.hpp"
#include "core/stream/receive/clip_source.hpp"
#include "core/stream/send/pose_sink.hpp"

namespace abrazo::app {

namespace {

constexpr double longest_sleep_s = 0.1;  ///< an interruption is noticed as soon

struct SendOptions {
  MotionReading input;
  std::string to;
  double rate_hz = 0, seconds = 0;
  bool loop = false, json = false;
};

/// What was sent, and how evenly.
struct Sent {
  double seconds = 0, latest_s = 0;  ///< `latest_s`: of all poses, how late the latest went out
  std::uint64_t skipped = 0;         ///< poses that were not sent since a newer one was due
};

/// The clip at the requested rate.
Clip at_rate(const Clip& clip, double rate_hz) {
  if (rate_hz <= 0 || rate_hz == clip.fps) return clip;
  std::vector<StampedPose> stamped;
  stamped.reserve(clip.poses.size());
  for (std::size_t i = 0; i < clip.poses.size(); ++i)
    stamped.push_back({static_cast<double>(i) / clip.fps, clip.poses[i]});
  return {clip.name, rate_hz, resample(stamped, rate_hz).poses};
}

Sent play(CommandLine& line, const SendOptions& options, ClipSource& source, PoseSink& sink) {
  const SessionClock clock;
  const double end_s = options.loop ? options.seconds : source.clip().duration_s();
  const double stop_s = options.seconds > 0 && options.seconds < end_s ? options.seconds : end_s;
  const Progress progress = terminal_progress(line);
  Sent sent;
  std::uint64_t frames = 0;
  while (!interrupted()) {
    const double now_s = clock.now_s();
    const bool is_over = stop_s > 0 && now_s >= stop_s;
    // Who wakes up late for the last pose sends it all the same.
    if (const auto pose = source.poll(is_over ? stop_s - 0.5 / source.rate_hz() : now_s)) {
      sink.send({pose->pose, pose->time_s, true});
      sent.latest_s = std::max(sent.latest_s, clock.now_s() - pose->time_s);
      sent.skipped = pose->dropped;
      if (++frames % static_cast<std::uint64_t>(std::ceil(source.rate_hz())) == 0)
        report(progress, stop_s > 0 ? now_s / stop_s : 0,
               fmt::format("sending to {}, {:.0f} s", options.to, now_s));
    }
    if (is_over) break;
    std::this_thread::sleep_until(clock.at(std::min(source.next_due_s(), now_s + longest_sleep_s)));
  }
  sent.seconds = clock.now_s();
  clear_progress(line);
  return sent;
}

double sent_rate_hz(const Sent& sent, const SinkHealth& health) {
  return sent.seconds > 0 ? static_cast<double>(health.frames) / sent.seconds : 0;
}

std::string summary(const SendOptions& options, const Sent& sent, const SinkHealth& health) {
  return fmt::format("{} frames in {} packets ({:.1f} a second) to {}; {} left out, {} refused\n",
                     health.frames, health.packets, sent_rate_hz(sent, health), options.to, sent.skipped,
                     health.failures);
}

std::string summary_json(const SendOptions& options, const Sent& sent, const SinkHealth& health) {
  const nlohmann::ordered_json json = {{"to", options.to},
                                       {"seconds", sent.seconds},
                                       {"frames", health.frames},
                                       {"rate_hz", sent_rate_hz(sent, health)},
                                       {"packets", health.packets},
                                       {"bytes", health.bytes},
                                       {"skipped", sent.skipped},
                                       {"latest_ms", 1000 * sent.latest_s},
                                       {"failures", health.failures},
                                       {"latest_failure", health.latest_failure}};
  return json.dump();
}

Status run_send(CommandLine& line, const SendOptions& options) {
  const auto uri = parse_stream_uri(options.to);
  if (!uri) return uri.error();
  auto input = read_performer(line, options.input);
  if (!input) return input.error();
  if (input->clip.poses.empty()) return Error{"has no frames", options.input.file};
  const Body body = body_of(input->clip.poses);
  auto sink = PoseSink::open(*uri, body, "clip");
  if (!sink) return sink.error();
  Clip clip = at_rate(input->clip, options.rate_hz);
  const double rate_hz = clip.fps;
  ClipSource source(std::move(clip), rate_hz, options.loop);
  const Sent sent = play(line, options, source, **sink);
  const SinkHealth health = (*sink)->health();
  if (options.json)
    answer_json(line, summary_json(options, sent, health));
  else if (!line.quiet)
    answer(line, summary(options, sent, health));
  // UDP reports a missing receiver only occasionally; if all packets are refused, there never was one.
  if (health.packets == 0 && health.failures > 0)
    return Error{"nothing could be sent: " + health.latest_failure, options.to};
  return Done{};
}

}  // namespace

void add_send_command(CommandLine& line) {
  auto options = std::make_shared<SendOptions>();
  CLI::App* send = line.app.add_subcommand("send", "replays a clip as a live stream, in real time");
  send->add_option("FILE", options->input.file, "the motion: .bvh, or .amc with its .asf")->required();
  add_reading_options(*send, options->input);
  send->add_option("--to", options->to,
                   "vmc://HOST:PORT[?framing=t-last|t-first|split], natnet://HOST[:PORT] (answers clients there), "
                   "xsens://HOST:PORT")
      ->required()
      ->type_name("URI");
  send->add_option("--rate", options->rate_hz,
                   "poses per second; rotations are interpolated between the frames of the clip")
      ->check(above_zero)
      ->type_name("HZ");
  send->add_option("--seconds", options->seconds, "end after this time")->check(above_zero)->type_name("N");
  send->add_flag("--loop", options->loop, "begin again at the end, until interrupted");
  send->add_flag("--json", options->json, "the summary as one JSON object on stdout");
  send->callback([&line, options] {
    if (const Status done = run_send(line, *options); !done) fail(line, done.error());
  });
}

}  // namespace abrazo::app
