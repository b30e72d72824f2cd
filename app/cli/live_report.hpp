#pragma once

#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/session/frames/frame_listener.hpp"
#include "core/session/run/recorder.hpp"
#include "core/stream/protocol/stream_health.hpp"

namespace abrazo::app {

/// Results of a finished live session.
struct LiveEnd {
  /// A diagnosis of any time of the session, with its newest text.
  struct Diagnosis {
    double first_s = 0, last_s = 0;  ///< session clock
    StreamDiagnosis newest;
  };
  double seconds = 0;
  std::optional<StreamHealth> stream;  ///< at the end; none for a clip
  std::vector<Diagnosis> diagnoses;    ///< of the whole session, in order of appearance
  std::vector<SinkHealth> sinks;
  std::optional<Recorder::State> recording;
};

/// Collects the statistics of the frames of a live session.
class LiveReport : public FrameListener {
 public:
  void frame_solved(const FrameSnapshotPtr& frame) override;

  /// Frames that were solved; the others failed.
  std::size_t solved() const;
  std::string latest_failure() const;
  /// Present state, for a line on the terminal.
  std::string line(double now_s) const;
  std::string text(const LiveEnd& end) const;
  /// Times in milliseconds; the latency stages sum to in_to_out.
  std::string json(const LiveEnd& end) const;

 private:
  mutable std::mutex mutex_;
  std::vector<FrameTimes> frame_times_;  ///< 40 bytes a frame: an hour at 120 Hz is 17 MB
  std::size_t relaxed_ = 0, failed_ = 0, source_changes_ = 0;
  std::uint64_t dropped_inputs_ = 0;
  std::string latest_failure_;
};

}  // namespace abrazo::app
