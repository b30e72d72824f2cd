#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/stream/natnet/natnet_frame.hpp"
#include "core/stream/protocol/stream_decoder.hpp"

namespace abrazo {

/// The client side of a NatNet connection: decides when to request what. Sends nothing itself.
class NatNetConnection {
 public:
  /// @param knows_host  false: no request is sent before the first packet shows where the server is
  NatNetConnection(bool knows_host, std::optional<NatNetVersion> given_version);

  /// Sets the target of requests if the host is unknown.
  void set_server_place(const Endpoint& from);
  /// Answers are accepted only shortly after a request: an unsolicited packet changes neither version nor
  /// group nor model. An answer that contradicts a version whose frames are being read is ignored too.
  /// @return the problem; none if it was accepted or has nothing new
  std::optional<StreamIssue> take_server_info(const NatNetServerInfo& info, double arrived_s);
  /// Whether a server's description of itself that arrived at this time was requested.
  bool expects_server_info(double arrived_s) const;
  /// Whether a model description that arrived at this time was requested.
  bool expects_model(double arrived_s) const;
  void take_model(double arrived_s);
  /// Reports a model description that is invalid in this version: the server is asked for its version again.
  void doubt_version() { is_reconnecting_ = is_in_doubt_ = true; }
  void take_echo(ByteReader& reader, double arrived_s);
  /// Reports a frame read completely in this version. @param gave_poses it had poses of described skeletons,
  /// which is impossible by chance in a wrong version
  void frame_was_read(bool gave_poses, double arrived_s);
  /// Reports an unreadable frame. If only such frames arrive for a while, the version is in doubt.
  void frame_was_unreadable(double arrived_s);
  void take_stamps(const NatNetStamps& stamps, double arrived_s);
  /// Requests the model (again), unless it was requested a moment ago.
  void want_model() { wants_model_ = true; }
  /// Requests that are due.
  void ask(double now_s, std::vector<OutgoingDatagram>& out);

  const std::optional<NatNetServerInfo>& server() const { return server_; }
  /// Bit stream version: the given one, or the server's.
  std::optional<NatNetVersion> version() const;
  /// "camera to sending 5.2 ms, network 0.3 ms"; empty if unknown.
  std::string latency() const;

 private:
  void want_model_now();
  void request(NatNetMessage id, std::vector<OutgoingDatagram>& out) const;

  bool knows_host_;
  std::optional<NatNetVersion> given_version_;
  std::optional<NatNetServerInfo> server_;
  Endpoint server_place_;  ///< of the last packet; used only if the host is unknown
  bool wants_model_ = true;
  bool is_reconnecting_ = false;  ///< after a time without packets
  bool connect_answered_ = false;
  std::optional<double> heard_s_, connect_s_, model_s_, keep_alive_s_, echo_s_;
  bool is_in_doubt_ = false;                            ///< the version is in doubt
  std::optional<double> poses_s_, unreadable_since_s_;  ///< last frame with poses; first of the unreadable
                                                        ///< frames
  std::optional<double> server_minus_session_s_;        ///< clock offset by the last echo
  double sending_latency_s_ = 0;                        ///< exposure to sending, smoothed
  double network_latency_s_ = 0;                        ///< sending to arrival, smoothed
  bool has_sending_latency_ = false, has_network_latency_ = false;
};

}  // namespace abrazo
