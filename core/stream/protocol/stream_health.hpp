#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace abrazo {

/// The tracking of a performer counts as lost after this time without a pose, and the next pose starts a new
/// motion. Shorter than the gap after which the solver does so by itself
/// (PartnerSynthesizer::tracking_loss_s): the stream knows the reason and reports it first; the solver's
/// limit is for inputs that report nothing.
inline constexpr double default_performer_loss_s = 0.25;

/// Measurements of a stream per performer. Times are over about the last second.
struct PerformerHealth {
  std::string performer;
  std::uint64_t frames = 0;
  double rate_hz = 0;
  double interval_p50_ms = 0, interval_p95_ms = 0;  ///< between arrivals
  double assembly_p50_ms = 0, assembly_p95_ms = 0;  ///< first packet of a frame to its last
  double delay_ms = 0;                              ///< added by the jitter buffer
  std::uint64_t lost = 0;                           ///< gaps in the sender's counter
  std::uint64_t repeated = 0;                       ///< duplicate frames
  std::uint64_t reordered = 0;                      ///< out of order, but in time for the jitter buffer
  std::uint64_t late = 0;                           ///< arrived after a newer one was delivered
  std::uint64_t held_joints = 0;                    ///< untracked joints kept from the previous frame
  std::uint64_t interruptions = 0;                  ///< losses of tracking that ended
  std::uint64_t clock_jumps = 0;
  bool uses_sender_time = false;  ///< otherwise frames have the times at which they arrived
  std::uint64_t restarts = 0;     ///< restarts of the sender's counter or time
  std::uint64_t unusable = 0;     ///< frames without a pose: too many joints untracked or unknown
  std::uint64_t dropped = 0;      ///< poses replaced by a newer one before the solver took them
  bool tracked = false;           ///< now
  bool calibrated = false;
  std::vector<std::string> calibration_doubts;  ///< deviations from a T-pose, with what to change
  std::string joint_map;                        ///< "unity", ...
  std::vector<std::string> estimated_joints;
  double height_m = 0;     ///< of the head joint
  std::string correction;  ///< correction of the sender's positions: "unit cm, Z up, floor +0.12 m"; or empty
  double last_s = -1;      ///< session clock, of the newest frame
};

/// One line of advice: the observation, and what to do about it.
struct StreamDiagnosis {
  enum class Severity { Note, Warning, Error };
  std::string kind;  ///< short and stable: "no-packets", "other-protocol", "two-senders", ...
  Severity severity = Severity::Warning;
  std::string text;
};

/// "note", "warning", "error".
constexpr const char* severity_word(StreamDiagnosis::Severity severity) {
  switch (severity) {
    case StreamDiagnosis::Severity::Error:
      return "error";
    case StreamDiagnosis::Severity::Warning:
      return "warning";
    case StreamDiagnosis::Severity::Note:
      break;
  }
  return "note";
}

/// Count and newest text of one kind of issue.
struct IssueCount {
  std::string kind;
  std::uint64_t count = 0;
  std::string latest;
};

/// The state of a source at one time, as a value, for the connection panel and the summary of `abrazo live`.
struct StreamHealth {
  enum class State { Waiting, Receiving, Stalled, Failed };
  State state = State::Waiting;
  std::string uri;
  std::string listening;  ///< "0.0.0.0:39539"
  double taken_s = 0;     ///< session clock, of this value
  std::uint64_t packets = 0, bytes = 0, packets_with_issues = 0;
  std::uint64_t overflowed = 0;  ///< packets dropped by the kernel because they were not read in time
  double last_packet_s = -1;
  std::array<std::uint8_t, 16> first_bytes{};  ///< of the newest unreadable packet
  std::vector<std::string> senders;
  std::vector<PerformerHealth> performers;
  std::string followed;  ///< performer whose poses are taken when none is named; empty before the first
  /// Senders that began together with the followed one, and it, while nobody has named the user; else empty.
  std::vector<std::string> undecided;
  std::vector<IssueCount> issues;
  std::vector<StreamDiagnosis> diagnoses;  ///< most severe first
  std::vector<std::string> facts;
};

/// The state of one sink.
struct SinkHealth {
  std::string uri;
  std::string character;  ///< "partner", "user"
  std::uint64_t frames = 0, packets = 0, bytes = 0, failures = 0;
  std::string latest_failure;
};

}  // namespace abrazo
