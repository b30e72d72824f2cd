// abrazo_long_recording LIBRARY.h5 INPUT SECONDS OUT.abrazo [SAMPLES.csv]
// A live session at 120 Hz in real time: INPUT (a motion file) in a loop as the user, the same poses as if
// two performers were received, everything recorded. Every 10 s one line of figures: memory, file, frames,
// delay of the writing thread. In the end the file is opened and its frames are counted.
#include <fmt/core.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include "core/base/text.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/motion/files/import_clip.hpp"
#include "core/session/file/session_file.hpp"
#include "core/session/run/session_engine.hpp"
#include "core/stream/receive/clip_source.hpp"

namespace {

using namespace abrazo;

constexpr double rate_hz = 120;
constexpr double sampled_each_s = 10;

/// The clip at 120 frames a second, poses in between on straight lines.
Clip at_stream_rate(const Clip& clip) {
  Clip faster = clip;
  faster.fps = rate_hz;
  faster.poses.clear();
  const double frames = static_cast<double>(clip.poses.size() - 1) / clip.fps * rate_hz;
  for (int i = 0; i <= static_cast<int>(frames); ++i) {
    const double at = i * clip.fps / rate_hz;
    const auto before = static_cast<std::size_t>(at);
    const double share = at - static_cast<double>(before);
    const Pose& after = clip.poses[std::min(before + 1, clip.poses.size() - 1)];
    faster.poses.push_back((1 - share) * clip.poses[before] + share * after);
  }
  return faster;
}

double resident_mb() {
  std::ifstream statm("/proc/self/statm");
  long long total = 0, resident = 0;
  statm >> total >> resident;
  return static_cast<double>(resident * sysconf(_SC_PAGESIZE)) / 1e6;
}

struct Figures {
  std::FILE* csv;
  void header() const {
    write(
        "seconds,resident_mb,file_mb,solved,frames,poses,lost,behind_ms,history_frames,history_evicted,cpu_"
        "s");
  }
  void sample(const SessionEngine& engine, double now_s) const {
    const Recorder::State state = engine.recorder()->state();
    const FrameSnapshotPtr newest = engine.latest().newest();
    const auto span = engine.history().span();
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const double cpu_s = static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec);
    write(fmt::format("{:.1f},{:.1f},{:.2f},{},{},{},{},{:.1f},{},{},{:.0f}", now_s, resident_mb(),
                      static_cast<double>(state.bytes) / 1e6, newest ? newest->index + 1 : 0, state.frames,
                      state.poses, state.lost, 1000 * state.behind_s, span.frames, span.evicted, cpu_s));
    if (!state.failure.empty()) fmt::print(stderr, "{}\n", state.failure);
  }
  void write(const std::string& line) const {
    fmt::print(csv, "{}\n", line);
    std::fflush(csv);
  }
};

/// Runs the session and hands over poses as a receiver would.
void run(SessionEngine& engine, const Clip& clip, double seconds, const Figures& figures) {
  const SessionClock& clock = engine.clock();
  const double start_s = clock.now_s();
  double next_sample_s = 0;
  for (std::size_t i = 0;; ++i) {
    const double now_s = clock.now_s() - start_s;
    if (now_s >= seconds) break;
    if (now_s >= next_sample_s) {
      figures.sample(engine, now_s);
      next_sample_s += sampled_each_s;
    }
    for (const char* performer : {"Ana", "Luis"}) {
      ReceivedPose received;
      received.performer = performer;
      received.pose.pose = clip.poses[i % clip.poses.size()];
      received.pose.time_s = received.pose.arrived_s = received.pose.assembled_s = clock.now_s();
      engine.recorder()->pose_received(received);
    }
    std::this_thread::sleep_until(clock.at(start_s + static_cast<double>(i + 1) / rate_hz));
  }
  figures.sample(engine, clock.now_s() - start_s);
}

int check(const std::string& path) {
  const auto file = SessionFile::open(path);
  if (!file) {
    fmt::print(stderr, "{}\n", file.error().text());
    return 1;
  }
  std::uint64_t next = (*file)->contents().first_frame, gaps = 0;
  const auto pass = (*file)->each_frame(-1e18, 1e18, [&](const FrameSnapshot& frame) -> Status {
    if (frame.index != next) ++gaps;
    next = frame.index + 1;
    return Done{};
  });
  if (!pass) {
    fmt::print(stderr, "{}\n", pass.error().text());
    return 1;
  }
  fmt::print("{} frames on disk, {} of them readable, {} indices missing between the first and the last\n",
             (*file)->contents().frames, pass->read, gaps);
  for (const std::string& line : (*file)->recovery()) fmt::print("{}\n", line);
  return pass->damaged == 0 && gaps == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    fmt::print(stderr, "abrazo_long_recording LIBRARY.h5 INPUT SECONDS OUT.abrazo [SAMPLES.csv]\n");
    return 2;
  }
  auto library = read_library(argv[1]);
  auto input = load_motion(argv[2], "", ImportOptions{});
  const auto seconds = parse_number(argv[3]);
  if (!library || !input || !seconds) {
    fmt::print(stderr, "{}\n", !library ? library.error().text() : !input ? input.error().text() : argv[3]);
    return 1;
  }
  const auto shared = std::make_shared<const MotionLibrary>(std::move(*library));
  auto synthesizer = PartnerSynthesizer::create(shared, *preset("responsive"));
  if (!synthesizer) {
    fmt::print(stderr, "{}\n", synthesizer.error().text());
    return 1;
  }
  const Clip clip = at_stream_rate(input->front().clip);
  std::FILE* csv = argc > 5 ? std::fopen(argv[5], "w") : stdout;
  const Figures figures{csv};
  figures.header();
  {
    SessionEngine engine(std::move(*synthesizer), std::make_shared<ClipSource>(clip, rate_hz));
    RecordingFacts facts{argv[1], shared->name(), static_cast<std::uint64_t>(shared->pair_count()),
                         argv[2], shared,         {}};
    if (const Status recording = engine.record(argv[4], facts); !recording) {
      fmt::print(stderr, "{}\n", recording.error().text());
      return 1;
    }
    run(engine, clip, *seconds, figures);
    const std::shared_ptr<Recorder> recorder = engine.recorder();
    const Status stopped = engine.stop_recording();
    if (!stopped) fmt::print(stderr, "{}\n", stopped.error().text());
    fmt::print("{} frames and {} poses written, {} lost\n", recorder->state().frames, recorder->state().poses,
               recorder->state().lost);
  }
  return check(argv[4]);
}
