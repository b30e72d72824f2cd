#include "app/cli/live_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "app/cli/text_lines.hpp"
#include "core/session/frames/latency.hpp"
#include "core/stream/protocol/stream_uri.hpp"

namespace abrazo::app {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t frames_of_a_line = 240;

/// Null without any value.
Json stage_json(const StageLatency& stage) {
  if (stage.frames == 0) return nullptr;
  return {{"frames", stage.frames},
          {"p50", stage.p50_ms},
          {"p95", stage.p95_ms},
          {"p99", stage.p99_ms},
          {"max", stage.max_ms}};
}

Json latency_json(const LatencyBreakdown& latency) {
  return {{"interval", stage_json(latency.arrival_interval)},
          {"assembly", stage_json(latency.assembly)},
          {"wait", stage_json(latency.wait)},
          {"solve", stage_json(latency.solve)},
          {"send", stage_json(latency.send)},
          {"in_to_out", stage_json(latency.packet_to_packet)},
          {"in_to_result", stage_json(latency.packet_to_result)}};
}

void add_latency(TextLines& text, const LatencyBreakdown& latency) {
  const bool was_sent = latency.packet_to_packet.frames > 0;
  const std::pair<std::string_view, const StageLatency&> rows[] = {
      {"between poses", latency.arrival_interval},
      {"assembly", latency.assembly},
      {"wait", latency.wait},
      {"solve", latency.solve},
      {"send", latency.send},
      {was_sent ? "packet in to packet out" : "packet in to partner's pose",
       was_sent ? latency.packet_to_packet : latency.packet_to_result}};
  const auto is_empty = [](const auto& row) { return row.second.frames == 0; };
  if (std::all_of(std::begin(rows), std::end(rows), is_empty)) return;
  text.add("  {:<26}{:>8}{:>8}{:>8}{:>8}", "ms", "p50", "p95", "p99", "max");
  for (const auto& [name, stage] : rows)
    if (stage.frames > 0)
      text.add("  {:<26}{:>8.2f}{:>8.2f}{:>8.2f}{:>8.2f}", name, stage.p50_ms, stage.p95_ms, stage.p99_ms,
               stage.max_ms);
}

Json performer_json(const PerformerHealth& performer) {
  return {{"performer", performer.performer},
          {"frames", performer.frames},
          {"rate_hz", performer.rate_hz},
          {"interval_ms", {{"p50", performer.interval_p50_ms}, {"p95", performer.interval_p95_ms}}},
          {"assembly_ms", {{"p50", performer.assembly_p50_ms}, {"p95", performer.assembly_p95_ms}}},
          {"lost", performer.lost},
          {"repeated", performer.repeated},
          {"reordered", performer.reordered},
          {"late", performer.late},
          {"held_joints", performer.held_joints},
          {"interruptions", performer.interruptions},
          {"clock_jumps", performer.clock_jumps},
          {"clock", performer.uses_sender_time ? "sender" : "arrival"},
          {"restarts", performer.restarts},
          {"unusable", performer.unusable},
          {"dropped", performer.dropped},
          {"joint_map", performer.joint_map},
          {"estimated_joints", performer.estimated_joints},
          {"correction", performer.correction},
          {"height_m", performer.height_m},
          {"calibrated", performer.calibrated}};
}

std::string_view word_of(StreamHealth::State state) {
  switch (state) {
    case StreamHealth::State::Waiting:
      return "waiting";
    case StreamHealth::State::Receiving:
      return "receiving";
    case StreamHealth::State::Stalled:
      return "stalled";
    case StreamHealth::State::Failed:
      break;
  }
  return "failed";
}

Json stream_json(const StreamHealth& stream) {
  Json json = {{"uri", stream.uri},
               {"state", word_of(stream.state)},
               {"listening", stream.listening},
               {"reach", listening_words(stream.listening)},
               {"packets", stream.packets},
               {"bytes", stream.bytes},
               {"packets_with_issues", stream.packets_with_issues},
               {"overflowed", stream.overflowed},
               {"senders", stream.senders},
               {"followed", stream.followed},
               {"undecided", stream.undecided},
               {"performers", Json::array()},
               {"issues", Json::array()},
               {"facts", stream.facts}};
  for (const PerformerHealth& performer : stream.performers)
    json["performers"].push_back(performer_json(performer));
  for (const IssueCount& issue : stream.issues)
    json["issues"].push_back({{"kind", issue.kind}, {"count", issue.count}, {"latest", issue.latest}});
  return json;
}

void add_stream(TextLines& text, const StreamHealth& stream) {
  text.add("listening {}: {} packets, {} with something wrong, {} not fetched in time",
           listening_words(stream.listening), stream.packets, stream.packets_with_issues, stream.overflowed);
  for (const PerformerHealth& performer : stream.performers)
    text.add("  {}: {} frames, {} lost, {} late, {} gave no pose", performer.performer, performer.frames,
             performer.lost, performer.late, performer.unusable);
  for (const IssueCount& issue : stream.issues)
    text.add("  {} x {}: {}", issue.count, issue.kind, issue.latest);
}

Json diagnosis_json(const LiveEnd::Diagnosis& seen) {
  return {{"kind", seen.newest.kind},
          {"severity", severity_word(seen.newest.severity)},
          {"first_s", seen.first_s},
          {"last_s", seen.last_s},
          {"text", seen.newest.text}};
}

void add_diagnosis(TextLines& text, const LiveEnd::Diagnosis& seen) {
  text.add("  {:.0f} to {:.0f} s, {}: {}", seen.first_s, seen.last_s, severity_word(seen.newest.severity),
           seen.newest.text);
}

Json sink_json(const SinkHealth& sink) {
  return {{"uri", sink.uri},
          {"character", sink.character},
          {"frames", sink.frames},
          {"packets", sink.packets},
          {"bytes", sink.bytes},
          {"failures", sink.failures},
          {"latest_failure", sink.latest_failure}};
}

void add_sink(TextLines& text, const SinkHealth& sink) {
  text.add("{} to {}: {} frames in {} packets{}", sink.character, sink.uri, sink.frames, sink.packets,
           sink.failures == 0 ? std::string()
                              : fmt::format(", {} refused ({})", sink.failures, sink.latest_failure));
}

Json recording_json(const Recorder::State& state) {
  return {{"path", state.path},   {"frames", state.frames}, {"poses", state.poses},
          {"bytes", state.bytes}, {"lost", state.lost},     {"failure", state.failure}};
}

void add_recording(TextLines& text, const Recorder::State& state) {
  text.add("{}: {} frames and {} poses, {:.1f} MB, {} lost{}", state.path, state.frames, state.poses,
           1e-6 * static_cast<double>(state.bytes), state.lost,
           state.failure.empty() ? "" : " (" + state.failure + ")");
}

}  // namespace

void LiveReport::frame_solved(const FrameSnapshotPtr& frame) {
  const std::scoped_lock lock(mutex_);
  frame_times_.push_back(frame->times);
  relaxed_ += frame->result.status == StepStatus::Relaxed;
  failed_ += frame->result.status == StepStatus::Failed;
  source_changes_ += frame->result.source_changed;
  dropped_inputs_ = frame->dropped_inputs;
  if (frame->result.status == StepStatus::Failed) latest_failure_ = frame->result.message;
}

std::size_t LiveReport::solved() const {
  const std::scoped_lock lock(mutex_);
  return frame_times_.size() - failed_;
}

std::string LiveReport::latest_failure() const {
  const std::scoped_lock lock(mutex_);
  return latest_failure_;
}

std::string LiveReport::line(double now_s) const {
  const std::scoped_lock lock(mutex_);
  if (frame_times_.empty()) return fmt::format("{:.0f} s, waiting for a pose", now_s);
  const std::span<const FrameTimes> all(frame_times_);
  const StageLatency latency = latency_of(all.last(std::min(frames_of_a_line, all.size()))).packet_to_result;
  return fmt::format("{:.0f} s, {} frames{}, {} failed", now_s, all.size(),
                     latency.frames == 0 ? std::string()
                                         : fmt::format(", partner after {:.1f} ms (95 %: {:.1f})",
                                                       latency.p50_ms, latency.p95_ms),
                     failed_);
}

std::string LiveReport::text(const LiveEnd& end) const {
  const std::scoped_lock lock(mutex_);
  TextLines text;
  text.add("{} frames in {:.1f} s; {} relaxed, {} failed, {} changes of source, {} poses replaced",
           frame_times_.size(), end.seconds, relaxed_, failed_, source_changes_, dropped_inputs_);
  if (!latest_failure_.empty()) text.add("  the newest failure: {}", latest_failure_);
  add_latency(text, latency_of(frame_times_));
  if (end.stream) add_stream(text, *end.stream);
  for (const LiveEnd::Diagnosis& diagnosis : end.diagnoses) add_diagnosis(text, diagnosis);
  for (const SinkHealth& sink : end.sinks) add_sink(text, sink);
  if (end.recording) add_recording(text, *end.recording);
  return text.take();
}

std::string LiveReport::json(const LiveEnd& end) const {
  const std::scoped_lock lock(mutex_);
  Json json = {{"seconds", end.seconds},
               {"frames", frame_times_.size()},
               {"relaxed", relaxed_},
               {"failed", failed_},
               {"latest_failure", latest_failure_},
               {"source_changes", source_changes_},
               {"replaced_unsolved", dropped_inputs_},
               {"latency_ms", latency_json(latency_of(frame_times_))},
               {"stream", end.stream ? stream_json(*end.stream) : Json(nullptr)},
               {"diagnoses", Json::array()},
               {"sinks", Json::array()},
               {"recording", end.recording ? recording_json(*end.recording) : Json(nullptr)}};
  for (const LiveEnd::Diagnosis& diagnosis : end.diagnoses)
    json["diagnoses"].push_back(diagnosis_json(diagnosis));
  for (const SinkHealth& sink : end.sinks) json["sinks"].push_back(sink_json(sink));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace abrazo::app
