#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/stream/natnet/natnet_frame.hpp"
#include "core/stream/protocol/stream_decoder.hpp"

namespace abrazo {

/// The client's side of the conversation with a NatNet server: when to ask for what. Sends nothing itself.
class NatNetConnection {
 public:
  /// @param knows_host  false: no request is sent before the first packet shows where the server is
  NatNetConnection(bool knows_host, std::optional<NatNetVersion> given_version);

  /// Where requests go when the host is not known.
  void set_server_place(const Endpoint& from);
  /// Answers count only where they were asked for a moment ago: a packet that nobody asked for changes
  /// neither version nor group nor model. An answer that contradicts a version whose frames are being read
  /// changes nothing either.
  /// @return what was wrong with it; nothing when it counts, or says only what is known
  std::optional<StreamIssue> take_server_info(const NatNetServerInfo& info, double arrived_s);
  /// Whether a model description that came then was asked for.
  bool expects_model(double arrived_s) const;
  void take_model(double arrived_s);
  /// The model description makes no sense in this version: the server is asked again what it is.
  void doubt_version() { is_reconnecting_ = is_in_doubt_ = true; }
  void take_echo(ByteReader& reader, double arrived_s);
  /// A frame of this version, read to its end. @param gave_poses  of described skeletons, which no other
  /// version's would by chance
  void frame_was_read(bool gave_poses, double arrived_s);
  /// After a moment of nothing else the version is in doubt.
  void frame_was_unreadable(double arrived_s);
  void take_stamps(const NatNetStamps& stamps, double arrived_s);
  /// Asks for the model (again) as soon as it was not asked for a moment ago.
  void want_model() { wants_model_ = true; }
  /// Requests that are due.
  void ask(double now_s, std::vector<OutgoingDatagram>& out);

  const std::optional<NatNetServerInfo>& server() const { return server_; }
  /// Of the bit stream: as given, or as the server says.
  std::optional<NatNetVersion> version() const;
  /// "camera to sending 5.2 ms, network 0.3 ms"; empty when not known.
  std::string latency() const;

 private:
  void want_model_now();
  void request(NatNetMessage id, std::vector<OutgoingDatagram>& out) const;

  bool knows_host_;
  std::optional<NatNetVersion> given_version_;
  std::optional<NatNetServerInfo> server_;
  Endpoint server_place_;  ///< of the last packet; used only when the host is not known
  bool wants_model_ = true;
  bool is_reconnecting_ = false;  ///< after a silence
  bool connect_answered_ = false;
  std::optional<double> heard_s_, connect_s_, model_s_, keep_alive_s_, echo_s_;
  bool is_in_doubt_ = false;                            ///< whether the version is right
  std::optional<double> poses_s_, unreadable_since_s_;  ///< frames with poses; frames that cannot be read
  std::optional<double> server_minus_session_s_;        ///< clock offset by the last echo
  double sending_latency_s_ = 0;                        ///< exposure to sending, smoothed
  double network_latency_s_ = 0;                        ///< sending to arrival, smoothed
  bool has_sending_latency_ = false, has_network_latency_ = false;
};

}  // namespace abrazo
