// recording_victim OUT.abrazo: records a live session at 120 Hz in real time until it is killed. Every frame
// that is handed to the recorder is one line on standard output: index, session time, monotonic time of
// handing over, frames that the recorder says are on disk, age of the oldest that is not [s].
#include <unistd.h>

#include <cstdio>
#include <string>
#include <thread>

#include "tests/core/session/recorded_session.hpp"
#include "tests/support/settings.hpp"

namespace {

using namespace abrazo;

double monotonic_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Reporter : FrameListener {
  explicit Reporter(std::shared_ptr<Recorder> to) : recorder(std::move(to)) {}
  std::shared_ptr<Recorder> recorder;
  void frame_solved(const FrameSnapshotPtr& frame) override {
    const Recorder::State state = recorder->state();
    recorder->frame_solved(frame);
    char line[160];
    const int size = std::snprintf(
        line, sizeof line, "%llu %.6f %.6f %llu %.6f\n", static_cast<unsigned long long>(frame->index),
        frame->time_s, monotonic_s(), static_cast<unsigned long long>(state.frames), state.behind_s);
    if (write(STDOUT_FILENO, line, static_cast<std::size_t>(size)) != size) _exit(3);
  }
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  auto recorder = Recorder::open(argv[1], test::session_facts());
  if (!recorder) {
    std::fprintf(stderr, "%s\n", recorder.error().text().c_str());
    return 1;
  }
  CommandQueue commands;
  FrameHistory history;
  LatestSlot<FrameSnapshot> latest;
  auto synthesizer =
      std::move(*PartnerSynthesizer::create(test::session_library(), test::responsive_by_pose()));
  Clip clip = test::swinging_take("user", 600, 4).a;
  clip.fps = 120;
  LiveLoop loop(std::move(synthesizer), std::make_unique<ClipSource>(clip, 120), commands, history, latest);
  commands.push(AttachListener{std::make_shared<Reporter>(*recorder)});
  (*recorder)->begin_take("salsa 3");
  const SessionClock clock;
  while (true) {
    const double due_s = loop.turn(clock.now_s());
    for (const char* performer : {"Ana", "Luis"})
      (*recorder)->pose_received(test::received(performer, clock.now_s(), clip.poses.front()));
    std::this_thread::sleep_until(clock.at(due_s));
  }
}
