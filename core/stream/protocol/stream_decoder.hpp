#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/positions.hpp"
#include "core/stream/net/datagram.hpp"
#include "core/stream/protocol/stream_uri.hpp"

namespace abrazo {

/// One performer at one instant, as a protocol gives it: named points, not yet the 25 joints.
struct PerformerFrame {
  std::string
      performer;  ///< stays the same while the stream lives: "192.168.1.7:39540", "Ana", "character 1"
  std::shared_ptr<const std::vector<std::string>> points;  ///< unique names; the same pointer while unchanged
  Positions positions;  ///< points x 3, right-handed, Y up [m]; a row that is not finite was not tracked
  std::optional<std::int64_t> counter;  ///< the sender's, where the protocol has one
  std::optional<double> sender_time_s;  ///< on the sender's clock; it may jump
  double first_arrived_s = 0;           ///< session clock, of its first packet
  double arrived_s = 0;                 ///< of the packet that completed it
};

/// Something wrong or noteworthy in a packet. Counted by kind, never fatal.
struct StreamIssue {
  std::string kind;  ///< short and stable: "truncated", "wrong-types", "not-finite", "no-bones", ...
  std::string text;  ///< what, where in the packet, what was expected and what to change
};

/// What came of a packet or of time passing. Appended to.
struct Decoded {
  std::vector<PerformerFrame> frames;
  std::vector<StreamIssue> issues;
  /// To be sent from the socket that receives. An address of 0 stands for the URI's host, a port of 0 for the
  /// URI's port: a decoder cannot look names up.
  std::vector<OutgoingDatagram> replies;
};

/// A protocol: bytes in, frames out. Knows neither socket nor clock nor thread. No bytes make it throw.
class StreamDecoder {
 public:
  virtual ~StreamDecoder() = default;
  virtual void take(const Datagram& datagram, Decoded& out) = 0;
  /// Called at least every 10 ms: silence may complete a frame, a connection may want its keep-alive.
  virtual void pass_time(double now_s, Decoded& out) = 0;
  /// The performer stands in the rest pose (T-pose) now: from here on rotations are counted from it. Without
  /// effect where the protocol sends positions. @param performer  empty = all
  virtual void calibrate(const std::string& performer) = 0;
  /// A multicast group and port that frames come to besides the receiving socket: known from the start or
  /// after an answer of the sender, so ask again after each `take`. What comes there goes into `take` as
  /// well.
  virtual std::optional<Endpoint> wanted_group() const { return std::nullopt; }
  /// What the sender says of itself, for people: "Motive 3.1.0, NatNet 4.1", "72 bones, no offsets".
  virtual std::vector<std::string> facts() const = 0;
};

}  // namespace abrazo
