#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/session/frames/frame_history.hpp"
#include "core/session/frames/frame_listener.hpp"
#include "core/session/frames/latest_slot.hpp"
#include "core/session/run/command_queue.hpp"
#include "core/session/run/live_loop.hpp"
#include "core/session/run/recorder.hpp"
#include "core/stream/receive/clip_source.hpp"
#include "tests/support/libraries.hpp"
#include "tests/support/settings.hpp"

namespace abrazo::test {

/// A folder of its own that is gone afterwards.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "abrazo-session-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::permissions(path_, std::filesystem::perms::owner_all, ignored);
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

inline std::shared_ptr<const MotionLibrary> session_library() {
  static const auto library = small_library();
  return library;
}

inline RecordingFacts session_facts() {
  return {"",
          "small",
          static_cast<std::uint64_t>(session_library()->pair_count()),
          "clip:user.bvh",
          session_library(),
          {}};
}

/// Hands every frame on, and keeps it.
struct FrameKeeper : FrameListener {
  std::shared_ptr<Recorder> recorder;
  std::vector<FrameSnapshotPtr> frames;
  void frame_solved(const FrameSnapshotPtr& frame) override {
    frames.push_back(frame);
    if (recorder) recorder->frame_solved(frame);
  }
};

/// A live loop with a clock of its own, whose frames are kept.
struct DrivenSession {
  CommandQueue commands;
  FrameHistory history;
  LatestSlot<FrameSnapshot> latest;
  std::shared_ptr<FrameKeeper> keeper = std::make_shared<FrameKeeper>();
  double now_s = 0;
  std::unique_ptr<LiveLoop> loop = make_loop();

  explicit DrivenSession(std::size_t history_bytes = std::size_t{512} << 20) : history(history_bytes) {
    commands.push(AttachListener{keeper});
  }

  std::unique_ptr<LiveLoop> make_loop() {
    auto synthesizer = std::move(*PartnerSynthesizer::create(session_library(), responsive_by_pose()));
    auto source = std::make_unique<ClipSource>(swinging_take("user", 300, 4).a);
    return std::make_unique<LiveLoop>(std::move(synthesizer), std::move(source), commands, history, latest);
  }

  void run_until(double to_s) {
    while (now_s < to_s) now_s = std::max(loop->turn(now_s), now_s + 1e-6);
  }
};

inline ReceivedPose received(const std::string& performer, double arrived_s, const Pose& pose) {
  ReceivedPose made;
  made.performer = performer;
  made.pose.pose = pose;
  made.pose.time_s = made.pose.arrived_s = arrived_s;
  made.pose.assembled_s = arrived_s + 0.001;
  made.sender_time_s = 100 + arrived_s;
  return made;
}

}  // namespace abrazo::test
