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

/// One performer at one instant as decoded: named points, not yet the 25 joints.
struct PerformerFrame {
  std::string performer;    ///< constant during the stream: "192.168.1.7:39540", "Ana", "character 1"
  std::string also_called;  ///< a name that the sender told after the first frame; or empty
  std::shared_ptr<const std::vector<std::string>> points;  ///< unique names; same pointer while unchanged
  Positions positions;  ///< points x 3, right-handed, Y up [m]; a row that is not finite was not tracked
  std::optional<std::int64_t> counter;  ///< of the sender, if the protocol has one
  std::optional<double> sender_time_s;  ///< on the sender's clock; it may jump
  double first_arrived_s = 0;           ///< session clock, of its first packet
  double arrived_s = 0;                 ///< of the packet that completed it
};

/// A defect or notable property of a packet. Counted by kind, never fatal.
struct StreamIssue {
  std::string kind;  ///< short and stable: "truncated", "wrong-types", "not-finite", "no-bones", ...
  std::string text;  ///< the defect, its position in the packet, what was expected and what to change
};

/// Output of a packet or of the passage of time. Decoders append to it.
struct Decoded {
  std::vector<PerformerFrame> frames;
  std::vector<StreamIssue> issues;
  /// To be sent from the receiving socket. Address 0 means the URI's host, port 0 the URI's port: a decoder
  /// cannot resolve names.
  std::vector<OutgoingDatagram> replies;
};

/// A protocol: bytes in, frames out. Independent of sockets, clocks and threads. No input makes it throw.
class StreamDecoder {
 public:
  virtual ~StreamDecoder() = default;
  virtual void take(const Datagram& datagram, Decoded& out) = 0;
  /// Called at least every 10 ms: a timeout may complete a frame, a connection may need its keep-alive.
  virtual void pass_time(double now_s, Decoded& out) = 0;
  /// Declares that the performer is in the rest pose (T-pose) now: later rotations are relative to it. No
  /// effect for protocols with positions. @param performer empty = all
  virtual void calibrate(const std::string& performer) = 0;
  /// A multicast group and port for frames beside the receiving socket: known from the start or after an
  /// answer of the sender, so query it after each `take`. Its packets also go to `take`.
  virtual std::optional<Endpoint> wanted_group() const { return std::nullopt; }
  /// Information from the sender, for people: "Motive 3.1.0, NatNet 4.1", "72 bones, no offsets".
  virtual std::vector<std::string> facts() const = 0;
};

}  // namespace abrazo
