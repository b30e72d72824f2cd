#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "core/base/positions.hpp"
#include "core/motion/body/body.hpp"

namespace abrazo {

/// A pose of the user from a source.
struct SourcePose {
  Pose pose = Pose::Zero();    ///< world [m]
  double time_s = 0;           ///< on the source's own clock
  std::int64_t frame = -1;     ///< frame of the clip; -1 for a device
  bool discontinuous = false;  ///< does not follow from the previous one (loop, seek, tracking loss)
  std::uint64_t dropped = 0;   ///< poses replaced by newer ones since the start
  double arrived_s = -1;       ///< session clock, of the first packet it was made from; -1 for a clip
  double assembled_s = -1;     ///< when it was complete
};

/// Controls of a source that plays a recording.
class ReplayControl {
 public:
  virtual ~ReplayControl() = default;
  virtual void set_paused(bool paused, double now_s) = 0;
  virtual bool is_paused() const = 0;
  virtual void seek(double clip_time_s, double now_s) = 0;
  virtual void set_speed(double factor, double now_s) = 0;
};

/// A clip that is solved once over its length, as fast as that goes: `poll` has its next frame whenever it is
/// asked, with the clip's own times, and nothing after the last.
class FiniteInput {
 public:
  virtual ~FiniteInput() = default;
  /// The next pose is that of this time; 0 = the first.
  virtual void begin_at(double clip_time_s) = 0;
  virtual std::uint64_t frames() const = 0;
  virtual double last_s() const = 0;  ///< time of the last frame
};

/// Source of the user's motion. Polled by the solver thread with the session clock.
class PoseSource {
 public:
  virtual ~PoseSource() = default;
  /// The newest pose that was not returned yet, if any.
  virtual std::optional<SourcePose> poll(double now_s) = 0;
  /// Session time at which the next pose is due; lets the solver thread sleep until then.
  virtual double next_due_s() const = 0;
  virtual double rate_hz() const = 0;
  /// Poses above this rate are skipped (and count as dropped).
  virtual void set_max_rate(double max_rate_hz) = 0;
  /// Body of the user if the source knows it.
  virtual std::optional<Body> body() const { return std::nullopt; }
  /// Null for a device.
  virtual ReplayControl* replay() { return nullptr; }
  /// Null unless its frames are solved as fast as that goes.
  virtual FiniteInput* finite() { return nullptr; }
  /// Whether no pose comes before another source does: then the user is not lost, there is none.
  virtual bool is_over() const { return false; }
  /// The callback is called from another thread on arrival of a pose, so that no polling is needed.
  virtual void on_arrival(std::function<void()> called) { static_cast<void>(std::move(called)); }
};

}  // namespace abrazo
