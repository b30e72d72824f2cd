#pragma once

#include <cstdint>
#include <optional>

#include "core/base/positions.hpp"
#include "core/motion/body.hpp"

namespace abrazo {

/// A pose of the user as it arrived.
struct SourcePose {
  Pose pose = Pose::Zero();    ///< world [m]
  double time_s = 0;           ///< on the source's own clock
  std::int64_t frame = -1;     ///< of the clip; -1 for a device
  bool discontinuous = false;  ///< does not follow from the previous one (loop, seek, tracking loss)
  std::uint64_t dropped = 0;   ///< poses replaced by newer ones since the start
};

/// Where the user's motion comes from. Polled by the solver thread with the session clock.
class PoseSource {
 public:
  virtual ~PoseSource() = default;
  /// The newest pose if there is one that was not given out yet.
  virtual std::optional<SourcePose> poll(double now_s) = 0;
  /// Session time at which the next pose is due; lets the solver thread sleep till then.
  virtual double next_due_s() const = 0;
  virtual double rate_hz() const = 0;
  /// Measures of the user where the source knows them.
  virtual std::optional<Body> body() const { return std::nullopt; }
};

}  // namespace abrazo
