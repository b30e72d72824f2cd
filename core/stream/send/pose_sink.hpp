#pragma once

#include <memory>

#include "core/base/session_clock.hpp"
#include "core/stream/protocol/stream_encoder.hpp"
#include "core/stream/protocol/stream_health.hpp"

namespace abrazo {

/// Where a character's poses go: an encoder and a socket. `send` is called by one thread, `health` by any.
class PoseSink {
 public:
  /// @param character  what is sent, for `health`: "partner", "user"
  static Result<std::unique_ptr<PoseSink>> open(const StreamUri& uri, const Body& body,
                                                std::string character);
  virtual ~PoseSink() = default;
  /// Never waits: what the network does not accept immediately is dropped and counted as a failure.
  virtual void send(const OutgoingPose& pose) = 0;
  /// The poses from the next one on have these bones; called by the thread that sends.
  virtual void set_body(const Body& body) = 0;
  virtual SinkHealth health() const = 0;
};

}  // namespace abrazo
