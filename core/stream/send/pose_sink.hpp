#pragma once

#include <memory>

#include "core/base/session_clock.hpp"
#include "core/stream/protocol/stream_encoder.hpp"
#include "core/stream/protocol/stream_health.hpp"

namespace abrazo {

/// Target of a character's poses: an encoder and a socket. `send` is called by one thread, `health` by any.
class PoseSink {
 public:
  /// @param character name for `health`: "partner", "user"
  static Result<std::unique_ptr<PoseSink>> open(const StreamUri& uri, const Body& body,
                                                std::string character);
  virtual ~PoseSink() = default;
  /// Never blocks: packets that the network does not accept immediately are dropped and counted as failures.
  virtual void send(const OutgoingPose& pose) = 0;
  /// Sets the bone lengths from the next pose on; called by the sending thread.
  virtual void set_body(const Body& body) = 0;
  virtual SinkHealth health() const = 0;
};

}  // namespace abrazo
