#include "app/workbench/start/status_lines.hpp"

#include <string_view>

#include "app/workbench/document/document.hpp"
#include "app/workbench/start/responsiveness.hpp"
#include "app/workbench/start/start_times.hpp"
#include "core/base/json_text.hpp"
#include "core/session/frames/latency.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app {
namespace {

constexpr int collect_ms = 500;  // long before the history drops uncounted frames

JsonText& write(JsonText& json, const char* name, std::uint64_t count) {
  return json.key(name).value(static_cast<long long>(count));
}

void write(JsonText& json, const char* name, const StageLatency& stage) {
  json.key(name).begin_object().key("p50").value(stage.p50_ms).key("p99").value(stage.p99_ms);
  json.key("max").value(stage.max_ms).end_object();
}

void write_stream(JsonText& json, const StreamReceiver* receiver) {
  json.key("stream");
  if (!receiver) return static_cast<void>(json.null());
  const StreamHealth health = receiver->health();
  PerformerHealth sum;
  for (const PerformerHealth& one : health.performers) {
    sum.frames += one.frames;
    sum.lost += one.lost;
    sum.late += one.late;
    sum.dropped += one.dropped;
    sum.unusable += one.unusable;
  }
  json.begin_object();
  write(write(json, "packets", health.packets), "overflowed", health.overflowed);
  write(write(write(json, "frames", sum.frames), "lost", sum.lost), "late", sum.late);
  write(write(json, "dropped", sum.dropped), "unusable", sum.unusable).end_object();
}

void write_recording(JsonText& json, const Recorder* recorder) {
  json.key("recording");
  if (!recorder) return static_cast<void>(json.null());
  const Recorder::State state = recorder->state();
  json.begin_object().key("path").value(state.path);
  write(write(write(json, "frames", state.frames), "poses", state.poses), "bytes", state.bytes);
  write(json, "lost", state.lost).key("behind_s").value(state.behind_s);
  json.key("failure").value(state.failure).end_object();
}

}  // namespace

StatusLines::StatusLines(Document& document, const widgets::SceneView& scene,
                         const Responsiveness& responsiveness, double interval_s,
                         std::function<void(const std::string&)> write)
    : QObject(&document), m_document(document), m_scene(scene), m_responsiveness(responsiveness) {
  connect(&document, &Document::began, this, [this] { m_next = 0; });
  connect(&m_collect, &QTimer::timeout, this, &StatusLines::noteFrames);
  connect(&m_timer, &QTimer::timeout, this, [this, write = std::move(write)] { write(line()); });
  m_since.start();
  m_collect.start(collect_ms);
  m_timer.start(static_cast<int>(1000 * interval_s));
}

void StatusLines::noteFrames() {
  if (!m_document.session()) return;
  for (const FrameSnapshotPtr& frame : m_document.session()->engine().history().since(m_next)) {
    m_next = frame->index + 1;
    m_times.push_back(frame->times);
    m_relaxed += frame->result.status == StepStatus::Relaxed;
    m_failed += frame->result.status == StepStatus::Failed;
    m_dropped = frame->dropped_inputs;
  }
}

std::string StatusLines::line() {
  noteFrames();
  const double seconds = 1e-9 * static_cast<double>(m_since.nsecsElapsed());
  m_since.restart();
  const std::uint64_t pictures = m_scene.renderedFrames();
  const LatencyBreakdown latency = latency_of(m_times);
  JsonText json;
  json.begin_object().key("after_s").value(since_process_start_ms() / 1000).key("seconds").value(seconds);
  write(write(json, "solved", m_next), "solved_now", m_times.size());
  write(write(write(json, "relaxed", m_relaxed), "failed", m_failed), "replaced", m_dropped);
  write(json, "pictures", pictures).key("pictures_per_s");
  json.value(seconds > 0 ? static_cast<double>(pictures - m_pictures) / seconds : 0.0);
  json.key("latency_ms").begin_object();
  write(json, "in_to_out", latency.packet_to_packet);
  write(json, "in_to_result", latency.packet_to_result);
  write(json, "wait", latency.wait);
  write(json, "solve", latency.solve);
  json.end_object().key("answers_ms").begin_object();
  json.key("p99").value(m_responsiveness.overall().within_ms(0.99));
  json.key("longest").value(m_responsiveness.overall().longest_ms()).end_object();
  if (LiveSession* session = m_document.session()) {
    SessionEngine& engine = session->engine();
    const auto span = engine.history().span();
    write(json.key("history").begin_object(), "frames", span.frames).key("bytes");
    json.value(static_cast<long long>(span.bytes)).key("seconds").value(span.last_s - span.first_s);
    json.end_object();
    std::uint64_t sent = 0, refused = 0;
    for (const SinkHealth& sink : engine.sinks()) sent += sink.frames, refused += sink.failures;
    write(write(json, "sent", sent), "refused", refused);
    write_stream(json, engine.receiver().get());
    write_recording(json, engine.recorder().get());
  }
  m_times.clear();
  m_pictures = pictures;
  return json.end_object().take() + "\n";
}

}  // namespace abrazo::app
