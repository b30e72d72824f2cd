#pragma once

#include "core/motion/body/clip.hpp"
#include "core/stream/receive/pose_source.hpp"

namespace abrazo {

/// The frames of a clip one after another, at its rate or thinned to `max_rate_hz`, at the clip's own times
/// from 0.
class WholeClip : public PoseSource, public FiniteInput {
 public:
  explicit WholeClip(Clip clip, double max_rate_hz = 120);

  std::optional<SourcePose> poll(double now_s) override;
  double next_due_s() const override;
  double rate_hz() const override { return rate_hz_; }
  std::optional<Body> body() const override { return body_; }
  /// The next frame is the first again.
  void set_max_rate(double max_rate_hz) override;
  FiniteInput* finite() override { return this; }
  bool is_over() const override { return next_ >= frames(); }

  void begin_at(double clip_time_s) override;
  std::uint64_t frames() const override;
  double last_s() const override;

 private:
  Clip clip_;
  Body body_;
  double rate_hz_;
  std::uint64_t next_ = 0;  ///< number of the next pose, at rate_hz_
};

}  // namespace abrazo
