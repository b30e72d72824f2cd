#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/positions.hpp"
#include "core/motion/body/body.hpp"
#include "core/stream/net/datagram.hpp"
#include "core/stream/protocol/stream_uri.hpp"

namespace abrazo {

/// One pose to send.
struct OutgoingPose {
  Pose pose = Pose::Zero();  ///< world [m]
  double time_s = 0;         ///< own clock, from 0
  bool tracked = true;       ///< false: a held pose, because there is no new one
};

/// A protocol for sending: poses in, packets out. Independent of sockets and clocks. One character each.
class StreamEncoder {
 public:
  virtual ~StreamEncoder() = default;
  /// The packets of one frame, in order.
  virtual std::vector<std::vector<std::uint8_t>> packets(const OutgoingPose& pose) = 0;
  /// For protocols with requests: the answers to a request.
  /// @return whether the client wants frames
  virtual bool answer(const Datagram& /*question*/, std::vector<OutgoingDatagram>& /*answers*/) {
    return false;
  }
  /// Sets the bone lengths from the next pose on; frame numbers and times continue.
  virtual void set_body(const Body& body) = 0;
  /// Resets counters and state, like a restarted sender.
  virtual void restart() = 0;
};

}  // namespace abrazo
