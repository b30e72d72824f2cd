#include "app/workbench/stream/latency_log.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo::app {

using widgets::latency_sample;
using widgets::LatencySample;
using widgets::LatencyStage;

void LatencyLog::clear() {
  *this = {};
}

void LatencyLog::follow(const FrameHistory& history) {
  for (const FrameSnapshotPtr& frame : history.next_since(m_next)) append(*frame);
}

void LatencyLog::append(const FrameSnapshot& frame) {
  m_entries.push_back({frame.index, latency_sample(frame, m_hasBefore ? &m_before : nullptr)});
  if (m_entries.size() > most_samples) m_entries.pop_front();
  m_before.times = frame.times;
  m_hasBefore = true;
  m_next = frame.index + 1;
}

const LatencyLog::Entry* LatencyLog::find(std::uint64_t index) const {
  const auto found =
      std::lower_bound(m_entries.begin(), m_entries.end(), index,
                       [](const Entry& entry, std::uint64_t wanted) { return entry.index < wanted; });
  return found == m_entries.end() || found->index != index ? nullptr : &*found;
}

void LatencyLog::drawn(std::uint64_t index, double render_ms, double to_screen_ms) {
  auto* entry = const_cast<Entry*>(find(index));
  double& render = entry ? entry->sample.stages[static_cast<std::size_t>(LatencyStage::Render)] : render_ms;
  if (!entry || std::isfinite(render)) return;
  render = render_ms;
  entry->sample.to_screen = to_screen_ms;
}

std::vector<LatencySample> LatencyLog::range(const FrameHistory& history, double from_s, double to_s) const {
  std::vector<LatencySample> samples;
  if (!m_entries.empty() && m_entries.front().sample.time_s <= from_s) {
    for (const Entry& entry : m_entries)
      if (entry.sample.time_s >= from_s && entry.sample.time_s <= to_s) samples.push_back(entry.sample);
    return samples;
  }
  FrameSnapshotPtr before;
  for (const FrameSnapshotPtr& frame : history.range(from_s, to_s)) {
    const Entry* kept = find(frame->index);
    samples.push_back(kept ? kept->sample : latency_sample(*frame, before.get()));
    before = frame;
  }
  return samples;
}

LatencySample LatencyLog::of(const FrameHistory& history, const FrameSnapshot& frame) const {
  if (const Entry* kept = find(frame.index)) return kept->sample;
  const FrameSnapshotPtr before = history.stepped(frame.time_s, -1);
  return latency_sample(frame, before && before->index < frame.index ? before.get() : nullptr);
}

}  // namespace abrazo::app
