#pragma once

#include "core/motion/body/clip.hpp"
#include "core/stream/receive/pose_source.hpp"

namespace abrazo {

/// Plays a clip in a loop, as if from a capture system: poses at the clip's rate (or thinned to
/// `max_rate_hz`).
class ClipSource : public PoseSource, public ReplayControl {
 public:
  explicit ClipSource(Clip clip, double max_rate_hz = 120, bool loop = true);

  std::optional<SourcePose> poll(double now_s) override;
  double next_due_s() const override;
  double rate_hz() const override { return rate_hz_; }
  std::optional<Body> body() const override { return body_; }

  void set_max_rate(double max_rate_hz) override;
  ReplayControl* replay() override { return this; }

  void set_paused(bool paused, double now_s) override;
  bool is_paused() const override { return paused_; }
  void seek(double clip_time_s, double now_s) override;
  void set_speed(double factor, double now_s) override;
  const Clip& clip() const { return clip_; }

 private:
  double clip_time(double now_s) const;

  Clip clip_;
  Body body_;
  double rate_hz_;
  bool loop_;
  bool paused_ = false;
  double speed_ = 1;
  double base_now_s_ = 0;  ///< session time of base_clip_s_
  double base_clip_s_ = 0;
  std::int64_t last_tick_ = -1;  ///< number of poses since the base, at rate_hz_
  bool jumped_ = true;
  std::uint64_t dropped_ = 0;
};

}  // namespace abrazo
