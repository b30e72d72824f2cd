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
  double delay_s = 0;                 ///< delay of the jitter buffer
  std::optional<JointMap> joint_map;  ///< none = the built-in one that fits
  double performer_loss_s = default_performer_loss_s;
  /// Called with the receiver after its port is open and before the first packet is read, so that listeners
  /// added here miss nothing.
  std::function<void(StreamReceiver&)> prepare = {};
};

/// A pose of a stream's performer, as 25 joints.
struct ReceivedPose {
  std::string performer;
  SourcePose pose;
  std::optional<double> sender_time_s;
};

/// A live stream: socket, thread, decoder, assembly of the 25 joints, jitter buffer, health. Thread-safe. The
/// destructor closes the stream.
class StreamReceiver {
 public:
  /// @return an Error with the port if it cannot be bound, and a free one
  static Result<std::shared_ptr<StreamReceiver>> open(const StreamUri& uri, const SessionClock& clock,
                                                      const StreamReceiverOptions& options = {});
  /// The same with a given decoder instead of the scheme's.
  static Result<std::shared_ptr<StreamReceiver>> open(const StreamUri& uri, const SessionClock& clock,
                                                      const StreamReceiverOptions& options,
                                                      std::unique_ptr<StreamDecoder> decoder);
  virtual ~StreamReceiver() = default;

  virtual const StreamUri& uri() const = 0;
  virtual StreamHealth health() const = 0;
  virtual std::vector<std::string> performers() const = 0;

  /// Poses of one performer, for the solver. @param performer empty = the first that appears
  virtual std::unique_ptr<PoseSource> source(const std::string& performer = {}) = 0;

  /// Adds a listener for every pose of every performer, before the jitter buffer; called from the receiving
  /// thread.
  /// @return number for `unlisten`
  virtual int listen(std::function<void(const ReceivedPose&)> listener) = 0;
  /// Removes a listener. It has received everything that health() counted before, and gets nothing
  /// afterwards. Do not call it from a listener.
  virtual void unlisten(int number) = 0;

  virtual void set_delay(double delay_s) = 0;
  /// Calibrates a performer in the T-pose: rest rotations, and the body from the poses of the next `over_s`
  /// seconds. @param performer empty = all
  virtual void calibrate(const std::string& performer, double over_s = 1) = 0;
  /// Calibrated body of a performer, if available.
  virtual std::optional<Body> measured_body(const std::string& performer) const = 0;
};

}  // namespace abrazo
