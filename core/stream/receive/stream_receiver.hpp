#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/session_clock.hpp"
#include "core/motion/joints/joint_map.hpp"
#include "core/stream/protocol/stream_health.hpp"
#include "core/stream/protocol/stream_uri.hpp"
#include "core/stream/receive/pose_source.hpp"

namespace abrazo {

class StreamDecoder;
class StreamReceiver;

struct StreamReceiverOptions {
  double delay_s = 0;  ///< of the jitter buffer: poses are given out so long after they were due
  std::optional<JointMap> joint_map;  ///< nothing = the built-in one that fits
  double tracking_loss_s = default_tracking_loss_s;
  /// Called with the receiver when its port is open and before it takes the first packet: who listens from
  /// here on misses nothing.
  std::function<void(StreamReceiver&)> prepare = {};
};

/// A pose of one of a stream's performers, in 25 joints.
struct ReceivedPose {
  std::string performer;
  SourcePose pose;
  std::optional<double> sender_time_s;
};

/// A live stream: socket, thread, decoder, assembly of the 25 joints, jitter buffer, health. Safe to call
/// from any thread. Ends with this object.
class StreamReceiver {
 public:
  /// @return an Error that names the port when it cannot be bound, and which one is free
  static Result<std::shared_ptr<StreamReceiver>> open(const StreamUri& uri, const SessionClock& clock,
                                                      const StreamReceiverOptions& options = {});
  /// The same with a decoder of one's own instead of the scheme's.
  static Result<std::shared_ptr<StreamReceiver>> open(const StreamUri& uri, const SessionClock& clock,
                                                      const StreamReceiverOptions& options,
                                                      std::unique_ptr<StreamDecoder> decoder);
  virtual ~StreamReceiver() = default;

  virtual const StreamUri& uri() const = 0;
  virtual StreamHealth health() const = 0;
  virtual std::vector<std::string> performers() const = 0;

  /// Poses of one performer, for the solver. @param performer  empty = the first that is seen
  virtual std::unique_ptr<PoseSource> source(const std::string& performer = {}) = 0;

  /// Every pose of every performer, before the jitter buffer, as it comes; called from the receiving thread.
  /// @return number to take the listener away with
  virtual int listen(std::function<void(const ReceivedPose&)> listener) = 0;
  /// The listener was given whatever health() counted before; it gets nothing after. Not from a listener.
  virtual void unlisten(int number) = 0;

  virtual void set_delay(double delay_s) = 0;
  /// The performer stands in the T-pose: rest rotations, and measures of the body from the poses of the next
  /// `over_s` seconds. @param performer  empty = all
  virtual void calibrate(const std::string& performer, double over_s = 1) = 0;
  /// Calibrated measures of a performer, when there are.
  virtual std::optional<Body> measured_body(const std::string& performer) const = 0;
};

}  // namespace abrazo
