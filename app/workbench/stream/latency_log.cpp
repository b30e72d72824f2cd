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
  const bool follows = m_hasBefore && frame.index == m_next;
  m_entries.push_back(
      {frame.index, latency_sample(frame, follows ? &m_before : nullptr), m_hasBefore && !follows});
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

bool LatencyLog::has_all(double from_s, double to_s) const {
  if (m_entries.empty() || m_entries.front().sample.time_s > from_s) return false;
  auto entry = std::lower_bound(m_entries.begin(), m_entries.end(), from_s,
                                [](const Entry& one, double time_s) { return one.sample.time_s < time_s; });
  for (; entry != m_entries.end(); ++entry) {
    if (entry->is_after_others) return false;
    if (entry->sample.time_s > to_s) break;
  }
  return true;
}

std::vector<LatencySample> LatencyLog::range(const FrameHistory& history, double from_s, double to_s) {
  const bool is_followed = has_all(from_s, to_s);
  if (!is_followed) read(history, from_s, to_s);
  std::vector<LatencySample> samples;
  for (const Entry& entry : is_followed ? m_entries : m_read.entries)
    if (entry.sample.time_s >= from_s && entry.sample.time_s <= to_s)
      samples.push_back(is_followed ? entry.sample : with_drawing(entry.sample, entry.index));
  return samples;
}

void LatencyLog::read(const FrameHistory& history, double from_s, double to_s) {
  const bool goes_on = m_read.last && m_read.from_s <= from_s && from_s <= m_read.to_s && m_read.to_s <= to_s;
  if (goes_on && to_s == m_read.to_s) return;
  if (!goes_on) m_read = {};
  for (const FrameSnapshotPtr& frame : history.range(goes_on ? m_read.to_s : from_s, to_s)) {
    if (m_read.last && frame->index <= m_read.last->index) continue;
    const bool follows = m_read.last && frame->index == m_read.last->index + 1;
    m_read.entries.push_back({frame->index, latency_sample(*frame, follows ? m_read.last.get() : nullptr)});
    m_read.last = frame;
  }
  while (!m_read.entries.empty() && m_read.entries.front().sample.time_s < from_s) m_read.entries.pop_front();
  m_read.from_s = from_s;
  m_read.to_s = to_s;
}

LatencySample LatencyLog::with_drawing(LatencySample sample, std::uint64_t index) const {
  const Entry* kept = find(index);
  if (!kept) return sample;
  constexpr auto render = static_cast<std::size_t>(LatencyStage::Render);
  sample.stages[render] = kept->sample.stages[render];
  sample.to_screen = kept->sample.to_screen;
  return sample;
}

LatencySample LatencyLog::of(const FrameHistory& history, const FrameSnapshot& frame) const {
  const Entry* kept = find(frame.index);
  if (kept && !kept->is_after_others) return kept->sample;
  const FrameSnapshotPtr before = history.stepped(frame.time_s, -1);
  const bool follows = before && before->index + 1 == frame.index;
  return with_drawing(latency_sample(frame, follows ? before.get() : nullptr), frame.index);
}

}  // namespace abrazo::app
