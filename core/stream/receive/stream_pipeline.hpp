#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/stream/protocol/stream_decoder.hpp"
#include "core/stream/receive/performer_stream.hpp"

namespace abrazo {

/// Combines the URI's options and the caller's. @return an Error that names the invalid value
Result<PerformerStream::Options> performer_options(const StreamUri& uri, const StreamReceiverOptions& given);

/// A receiver without socket and thread: packets and time in; poses, measurements and advice out. Not
/// thread-safe.
class StreamPipeline {
 public:
  /// @param now_s session clock, at the start of listening
  StreamPipeline(std::unique_ptr<StreamDecoder> decoder, StreamUri uri, PerformerStream::Options options,
                 double now_s);

  struct Output {
    std::vector<ReceivedPose> poses;  ///< of every performer, before the jitter buffer
    std::vector<OutgoingDatagram> replies;
  };
  /// @param truncated the packet was larger than the buffer: counted, not read
  void take(const Datagram& datagram, double now_s, Output& out, bool truncated = false);
  /// Call at least every 10 ms.
  void pass_time(double now_s, Output& out);

  void calibrate(const std::string& performer, double over_s, double now_s);
  void set_delay(double delay_s);
  std::optional<Endpoint> wanted_group() const { return decoder_->wanted_group(); }

  /// Notes the performer whose poses are taken when none is named.
  void note_followed(const std::string& performer) { counted_.followed = performer; }
  /// Notes the performers of whom any may be the user, because they began together; empty = that is known.
  void note_undecided(std::vector<std::string> performers) { counted_.undecided = std::move(performers); }
  /// Notes a packet that was rejected because only `server` is accepted: neither read nor counted as a
  /// packet.
  void note_stranger(const Endpoint& stranger, const std::string& server, double now_s);
  /// Notes a change of the followed performer or accepted sender; reported for a while.
  void note_sender_change(const std::string& text, double now_s);
  /// Notes the total number of packets dropped by the kernel.
  void note_overflow(std::uint64_t total, double now_s);
  void note_failure(const std::string& text) { failure_ = text; }
  void note_group_failure(const std::string& text) { group_failure_ = text; }
  /// Sets the listening address that this machine no longer has; empty = it is available.
  void note_lost_address(const std::string& address) { lost_address_ = address; }
  void note_issue(const StreamIssue& issue);
  void note_listening(const std::string& text) { listening_ = text; }

  const StreamUri& uri() const { return uri_; }
  StreamHealth health(double now_s) const;
  StreamObservation observe(double now_s) const;
  std::vector<std::string> performers() const;
  /// By the name, or one that the sender told later; null if it has not appeared. `streams` has them in order
  /// of appearance.
  PerformerStream* find(const std::string& performer);
  const std::vector<std::unique_ptr<PerformerStream>>& streams() const { return streams_; }

 private:
  void work_off(Decoded& decoded, double now_s, Output& out);
  void take_frame(const PerformerFrame& frame, double now_s, Output& out);
  PerformerStream* stream_of(const PerformerFrame& frame, double now_s);
  void note_sender(const Endpoint& sender, double now_s);
  void note_unknown(const Datagram& datagram, const std::string& why, double now_s);

  std::unique_ptr<StreamDecoder> decoder_;
  StreamUri uri_;
  PerformerStream::Options options_;
  double opened_s_;
  std::vector<std::unique_ptr<PerformerStream>> streams_;
  StreamHealth counted_;  ///< counters
  std::map<std::string, IssueCount> issues_;
  std::map<Endpoint, double> senders_;  ///< last time of each
  RecentCount recent_packets_, recent_unknown_, recent_overflow_, recent_strangers_;
  std::size_t first_bytes_count_ = 0, unknown_size_ = 0;
  double last_frame_s_ = -1, last_understood_s_ = -1, last_sender_change_s_ = -1;
  StreamIssue latest_issue_;
  std::string listening_, failure_, group_failure_, lost_address_, unreadable_, stranger_, sender_change_;
};

}  // namespace abrazo
