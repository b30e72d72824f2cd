#pragma once

#include <optional>
#include <string>

#include "core/stream/receive/stream_pipeline.hpp"

namespace abrazo {

/// Reads the poses of one performer from a pipeline: always the newest due one, never one older than the
/// last. Not thread-safe.
class PoseReader {
 public:
  /// @param performer empty = the first that appears; of two that appear within a second the one that sends
  /// clearly more poses; if it falls silent and another appears later (a restarted sender on another port),
  /// that one
  explicit PoseReader(std::string performer) : wanted_(std::move(performer)) {}

  std::optional<SourcePose> poll(StreamPipeline& pipeline, double now_s);
  double next_due_s(StreamPipeline& pipeline) const;
  double rate_hz(StreamPipeline& pipeline) const;
  /// Limits the rate evenly; skipped poses count as dropped. 0 = all.
  void set_max_rate(double max_rate_hz) { max_rate_hz_ = max_rate_hz; }
  const std::string& performer() const { return followed_; }

 private:
  PerformerStream* follow(StreamPipeline& pipeline, double now_s);
  void note_undecided(StreamPipeline& pipeline, const PerformerStream* followed, double now_s) const;
  bool is_wanted(double time_s, double rate_hz);

  std::string wanted_, followed_;
  double followed_since_s_ = -1;  ///< first seen time of the followed performer: another may appear under its
                                  ///< name
  JitterBuffer::Cursor cursor_;
  double max_rate_hz_ = 0, next_slot_s_ = 0;
  double last_time_s_ = 0, last_poll_s_ = 0;
  bool started_ = false, break_pending_ = true;
  std::uint64_t dropped_ = 0;
};

}  // namespace abrazo
