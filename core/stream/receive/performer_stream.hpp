#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/stream/receive/frame_assembly.hpp"
#include "core/stream/receive/frame_order.hpp"
#include "core/stream/receive/jitter_buffer.hpp"
#include "core/stream/receive/sender_clock.hpp"
#include "core/stream/receive/stream_calibration.hpp"
#include "core/stream/receive/stream_diagnosis.hpp"
#include "core/stream/receive/stream_meter.hpp"
#include "core/stream/receive/stream_receiver.hpp"

namespace abrazo {

/// One performer of a stream: from the protocol's frames to poses in the jitter buffer, with all
/// measurements. The caller passes the time; independent of sockets and threads.
class PerformerStream {
 public:
  struct Options {
    FrameAssemblyOptions assembly;
    double delay_s = 0;
    double performer_loss_s = default_performer_loss_s;
    bool floor_by_calibration = true;
  };
  PerformerStream(std::string name, const Options& options, double now_s);

  struct Outcome {
    std::optional<ReceivedPose> pose;  ///< before the jitter buffer
    std::optional<StreamIssue> issue;
  };
  Outcome take(const PerformerFrame& frame, double now_s);
  /// Finishes a calibration whose time has passed.
  void pass_time(double now_s);
  void calibrate(double over_s, double now_s);
  void set_delay(double delay_s) { buffer_.set_delay(delay_s); }

  const std::string& name() const { return name_; }
  /// Its name, or one that its sender told later.
  bool is_called(const std::string& name) const {
    return name == name_ || (!name.empty() && name == also_called_);
  }
  double first_seen_s() const { return first_seen_s_; }
  double last_pose_s() const { return last_pose_s_; }  ///< arrival of the newest pose; -1 for none
  double last_frame_s() const { return last_frame_s_; }
  const std::optional<Body>& body() const { return body_; }
  double rate_hz(double now_s) const { return arrivals_.rate_hz(now_s); }
  JitterBuffer& buffer() { return buffer_; }
  const JitterBuffer& buffer() const { return buffer_; }
  void count_dropped(std::uint64_t count) { health_.dropped += count; }

  PerformerObservation observe(double now_s) const;

 private:
  bool count(FrameOrder::Kind kind, double now_s);
  double session_time(const PerformerFrame& frame, FrameOrder::Kind kind);
  bool breaks_off(const Pose& pose, const PerformerFrame& frame);

  std::string name_, also_called_;
  Options options_;
  FrameAssembly assembly_;
  FrameOrder order_;
  SenderClock clock_;
  JitterBuffer buffer_;
  ArrivalMeter arrivals_;
  PostureMeter posture_;
  PerformerHealth health_;  ///< counters
  RecentCount recent_frames_, recent_lost_, recent_late_, recent_repeated_, recent_unusable_, recent_held_;
  std::uint64_t counted_lost_ = 0;
  std::string why_no_pose_;
  std::optional<Pose> last_;
  double first_seen_s_;
  double last_frame_s_ = -1, last_pose_s_ = -1, last_break_s_ = -1;
  double last_clock_jump_s_ = -1, last_restart_s_ = -1;
  bool has_sender_time_ = false;
  bool break_pending_ = true;

  struct Calibrating {
    double until_s;
    std::vector<Pose> poses;
  };
  std::optional<Calibrating> calibrating_;
  std::optional<Body> body_;
};

}  // namespace abrazo
