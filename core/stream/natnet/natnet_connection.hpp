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

  void heard(const Datagram& datagram);
  void take_server_info(const NatNetServerInfo& info);
  void take_model() { wants_model_ = false; }
  void take_echo(ByteReader& reader, double arrived_s);
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
  void request(NatNetMessage id, std::vector<OutgoingDatagram>& out) const;

  bool knows_host_;
  std::optional<NatNetVersion> given_version_;
  std::optional<NatNetServerInfo> server_;
  Endpoint server_place_;  ///< of the last packet; used only when the host is not known
  bool wants_model_ = true;
  bool is_reconnecting_ = false;  ///< after a silence
  std::optional<double> heard_s_, connect_s_, model_s_, keep_alive_s_, echo_s_;
  std::optional<double> server_minus_session_s_;  ///< clock offset by the last echo
  double sending_latency_s_ = 0;                  ///< exposure to sending, smoothed
  double network_latency_s_ = 0;                  ///< sending to arrival, smoothed
  bool has_sending_latency_ = false, has_network_latency_ = false;
};

}  // namespace abrazo
