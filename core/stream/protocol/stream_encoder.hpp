#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/positions.hpp"
#include "core/motion/body/body.hpp"
#include "core/stream/net/datagram.hpp"
#include "core/stream/protocol/stream_uri.hpp"

namespace abrazo {

/// One pose to be sent.
struct OutgoingPose {
  Pose pose = Pose::Zero();  ///< world [m]
  double time_s = 0;         ///< on our clock, from 0 on
  bool tracked = true;       ///< false: the pose is held because there is none
};

/// A protocol in the other direction: poses in, packets out. Knows neither socket nor clock. One character
/// each.
class StreamEncoder {
 public:
  virtual ~StreamEncoder() = default;
  /// The packets of one frame, in order.
  virtual std::vector<std::vector<std::uint8_t>> packets(const OutgoingPose& pose) = 0;
  /// Where the protocol has a conversation: what to answer, and from when on to send to whom.
  /// @return whether the asker wants frames
  virtual bool answer(const Datagram& /*question*/, std::vector<OutgoingDatagram>& /*answers*/) {
    return false;
  }
  /// The poses from the next one on have these bones; numbers and times go on.
  virtual void set_body(const Body& body) = 0;
  /// Starts over as a sender that was restarted: counters and state start again.
  virtual void restart() = 0;
};

}  // namespace abrazo
