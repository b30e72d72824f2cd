#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/stream/protocol/stream_decoder.hpp"
#include "core/stream/protocol/stream_health.hpp"
#include "core/stream/protocol/stream_uri.hpp"
#include "core/stream/receive/sender_clock.hpp"
#include "core/stream/receive/stream_meter.hpp"

namespace abrazo {

/// Recent observations of one performer, beside its health. Times on the session clock.
struct PerformerObservation {
  PerformerHealth health;
  std::uint64_t recent_frames = 0, recent_lost = 0, recent_late = 0, recent_repeated = 0, recent_unusable = 0;
  std::uint64_t recent_held_frames = 0;
  PostureMeter::Posture posture;
  double first_s = 0;                                         ///< time of first appearance
  double last_pose_s = -1;                                    ///< newest frame with a pose; -1 = none
  double frozen_s = 0;                                        ///< duration without a change of pose
  SenderClock::Doubt clock_doubt = SenderClock::Doubt::None;  ///< then the times of arrival are used
  double last_clock_jump_s = -1, last_restart_s = -1;
  bool is_calibrating = false;
  std::string why_no_pose;  ///< reason for the newest frame without one
};

/// Input of the advice about a stream.
struct StreamObservation {
  StreamUri uri;
  double opened_s = 0, now_s = 0;
  double performer_loss_s = default_performer_loss_s;
  std::uint64_t packets = 0;
  double last_packet_s = -1;
  double last_frame_s = -1;          ///< newest frame of any performer
  double last_understood_s = -1;     ///< newest packet that was decoded without an issue
  std::uint64_t recent_unknown = 0;  ///< unreadable packets within the last seconds
  std::uint64_t recent_packets = 0;
  std::array<std::uint8_t, 16> first_bytes{};  ///< of the newest unreadable packet
  std::size_t first_bytes_count = 0, unknown_size = 0;
  std::uint64_t recent_overflow = 0;
  std::vector<std::string> recent_senders;  ///< active within the last two seconds
  std::string stranger;                     ///< rejected sender of the last seconds, and why
  std::string followed;                     ///< performer who plays the user; empty = named, or none yet
  std::vector<std::string> undecided;       ///< see StreamHealth
  std::string sender_change;                ///< recent change of the followed performer or accepted sender
  double last_sender_change_s = -1;
  std::string failure;        ///< why the socket failed
  std::string group_failure;  ///< why a multicast group could not be joined
  std::string lost_address;   ///< listening address that this machine no longer has
  StreamIssue latest_issue;   ///< the newest of the decoder
  std::string unreadable;     ///< why the newest unreadable packet could not be read
  std::vector<PerformerObservation> performers;
};

/// Which protocol a packet looks like: "VMC (OSC)", "NatNet", "Xsens MVN (MXTP)", "Rokoko (JSON)", ...; none
/// if unknown.
std::optional<std::string> protocol_of(const std::array<std::uint8_t, 16>& first_bytes, std::size_t count,
                                       std::size_t packet_size);

/// Advice, most severe first (docs/guide/live/diagnoses.md). A pure function.
std::vector<StreamDiagnosis> diagnose(const StreamObservation& seen);

}  // namespace abrazo
