#include "core/stream/receive/performer_stream.hpp"

#include <algorithm>
#include <bit>

#include "core/base/checksum.hpp"

#include "core/motion/body/person_bounds.hpp"

namespace abrazo {

namespace {

constexpr std::size_t most_calibration_poses = 4000;
constexpr double between_breaks_s = 0.5;  ///< two senders in one would break off with every frame

/// The same bits give the same number.
std::uint64_t content_of(const Positions& positions) {
  Checksum sum;
  for (Eigen::Index i = 0; i < positions.size(); ++i)
    sum.add(std::bit_cast<std::uint64_t>(positions.data()[i]));
  return static_cast<std::uint64_t>(sum.value());
}

}  // namespace

PerformerStream::PerformerStream(std::string name, const Options& options, double now_s)
    : name_(std::move(name)),
      options_(options),
      assembly_(options.assembly),
      buffer_(options.delay_s),
      first_seen_s_(now_s) {}

bool PerformerStream::count(FrameOrder::Kind kind, double now_s) {
  recent_frames_.add(now_s);
  ++health_.frames;
  if (order_.lost() > counted_lost_) recent_lost_.add(now_s, order_.lost() - counted_lost_);
  counted_lost_ = order_.lost();
  if (kind == FrameOrder::Kind::Repeated) {
    ++health_.repeated;
    recent_repeated_.add(now_s);
  } else if (kind == FrameOrder::Kind::Stray) {
    ++health_.late;
    recent_late_.add(now_s);
  } else if (kind == FrameOrder::Kind::Restarted) {
    ++health_.restarts;
    last_restart_s_ = now_s;
    break_pending_ = true;
    clock_.restart();
    assembly_.forget();
  }
  return kind != FrameOrder::Kind::Repeated && kind != FrameOrder::Kind::Stray;
}

double PerformerStream::session_time(const PerformerFrame& frame, FrameOrder::Kind kind) {
  if (!frame.sender_time_s) return frame.arrived_s;
  if (kind != FrameOrder::Kind::Earlier && clock_.take(*frame.sender_time_s, frame.arrived_s)) {
    ++health_.clock_jumps;
    last_clock_jump_s_ = frame.arrived_s;
    break_pending_ = true;
  }
  return std::min(clock_.session_time(*frame.sender_time_s).value_or(frame.arrived_s), frame.arrived_s);
}

bool PerformerStream::breaks_off(const Pose& pose, const PerformerFrame& frame) {
  if (last_pose_s_ >= 0 && frame.arrived_s - last_pose_s_ > options_.performer_loss_s) {
    ++health_.interruptions;
    break_pending_ = true;
  }
  const bool jump = last_ && PostureMeter::is_jump(*last_, pose, frame.arrived_s - last_pose_s_);
  if (jump && frame.arrived_s - last_break_s_ > between_breaks_s) break_pending_ = true;
  if (break_pending_ || jump) last_break_s_ = frame.arrived_s;
  return std::exchange(break_pending_, false);
}

PerformerStream::Outcome PerformerStream::take(const PerformerFrame& frame, double now_s) {
  last_frame_s_ = std::max(last_frame_s_, frame.arrived_s);
  has_sender_time_ = frame.sender_time_s.has_value();
  also_called_ = frame.also_called;
  const FrameOrder::Placed placed =
      order_.place({frame.counter, frame.sender_time_s, content_of(frame.positions), frame.arrived_s});
  if (!count(placed.kind, now_s)) return {};
  arrivals_.add(frame.first_arrived_s, frame.arrived_s);
  FrameAssembly::Assembled assembled = assembly_.assemble(frame);
  Outcome outcome{{}, std::move(assembled.issue)};
  health_.held_joints += static_cast<std::uint64_t>(assembled.held);
  if (assembled.held > 0) recent_held_.add(now_s);
  if (!assembled.pose) {
    ++health_.unusable;
    recent_unusable_.add(now_s);
    if (outcome.issue) why_no_pose_ = outcome.issue->text;
    return outcome;
  }
  // Delivered anyway: the solver then holds and reports why.
  if (!outcome.issue)
    if (const auto reason = why_not_a_person(*assembled.pose))
      outcome.issue = StreamIssue{"not-a-person", std::string(reason->sentence())};
  SourcePose pose;
  pose.pose = *assembled.pose;
  pose.time_s = session_time(frame, placed.kind);
  pose.arrived_s = frame.first_arrived_s;
  pose.assembled_s = std::max(now_s, frame.arrived_s);
  const bool in_order = placed.kind != FrameOrder::Kind::Earlier;
  if (in_order) {
    pose.discontinuous = breaks_off(pose.pose, frame);
    posture_.add(pose.pose, frame.arrived_s);
    last_ = pose.pose;
    last_pose_s_ = frame.arrived_s;
  }
  if (calibrating_ && frame.first_arrived_s <= calibrating_->until_s &&
      calibrating_->poses.size() < most_calibration_poses)
    calibrating_->poses.push_back(pose.pose);
  outcome.pose = ReceivedPose{name_, pose, frame.sender_time_s};
  const JitterBuffer::Fate fate = buffer_.push({placed.place, pose.time_s, pose}, now_s);
  if (fate == JitterBuffer::Fate::Reordered) ++health_.reordered;
  if (fate == JitterBuffer::Fate::Late) {
    ++health_.late;
    recent_late_.add(now_s);
  }
  return outcome;
}

void PerformerStream::calibrate(double over_s, double now_s) {
  calibrating_ = Calibrating{now_s + std::clamp(over_s, 0.0, 60.0), {}};
  health_.calibration_doubts.clear();
}

void PerformerStream::pass_time(double now_s) {
  if (!calibrating_ || now_s < calibrating_->until_s) return;
  const std::vector<Pose> poses = std::move(calibrating_->poses);
  calibrating_.reset();
  if (poses.empty()) {
    health_.calibration_doubts = {
        "no pose came meanwhile; nothing was measured, calibrate again when there are"};
    return;
  }
  const StreamCalibration calibration = calibration_of(poses);
  body_ = calibration.body;
  health_.calibration_doubts = calibration.doubts;
  health_.calibrated = true;
  if (options_.floor_by_calibration)
    assembly_.set_floor(assembly_.correction().floor_y_m + calibration.floor_y_m);
}

PerformerObservation PerformerStream::observe(double now_s) const {
  PerformerObservation seen;
  PerformerHealth& health = seen.health;
  health = health_;
  health.performer = name_;
  const ArrivalMeter::Times times = arrivals_.times(now_s);
  health.rate_hz = times.rate_hz;
  health.interval_p50_ms = times.interval_p50_ms;
  health.interval_p95_ms = times.interval_p95_ms;
  health.assembly_p50_ms = times.assembly_p50_ms;
  health.assembly_p95_ms = times.assembly_p95_ms;
  health.delay_ms = 1000 * buffer_.delay_s();
  health.lost = order_.lost();
  health.tracked = last_pose_s_ >= 0 && now_s - last_pose_s_ <= options_.performer_loss_s;
  health.joint_map = assembly_.joint_map();
  health.estimated_joints = assembly_.estimated_joints();
  if (last_) health.height_m = (*last_)(joints::Head, 1);
  health.correction = assembly_.correction().text();
  health.last_s = last_frame_s_;
  seen.recent_frames = recent_frames_.value(now_s);
  seen.recent_lost = recent_lost_.value(now_s);
  seen.recent_late = recent_late_.value(now_s);
  seen.recent_repeated = recent_repeated_.value(now_s);
  seen.recent_unusable = recent_unusable_.value(now_s);
  seen.recent_held_frames = recent_held_.value(now_s);
  seen.posture = posture_.posture();
  seen.first_s = first_seen_s_;
  seen.last_pose_s = last_pose_s_;
  seen.frozen_s = posture_.frozen_s();
  if (has_sender_time_) seen.clock_doubt = clock_.doubt();
  health.uses_sender_time = has_sender_time_ && clock_.doubt() == SenderClock::Doubt::None;
  seen.last_clock_jump_s = last_clock_jump_s_;
  seen.last_restart_s = last_restart_s_;
  seen.is_calibrating = calibrating_.has_value();
  seen.why_no_pose = why_no_pose_;
  return seen;
}

}  // namespace abrazo
