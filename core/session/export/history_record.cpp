#include "core/session/export/history_record.hpp"

#include <algorithm>
#include <utility>

#include "core/base/version.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

namespace {

SessionSource source_of(const FrameSnapshot& frame, const MotionLibrary* open) {
  SessionSource source;
  source.frame = frame.index;
  source.time_s = frame.time_s;
  const FrameResult& result = frame.result;
  const MotionLibrary* library = frame.library ? frame.library.get() : open;
  if (result.selected < 0) return source;
  const int pair = result.candidates[static_cast<std::size_t>(result.selected)].pair;
  if (!frame.library && frame.noted_pairs) {
    const auto noted = frame.noted_pairs->by_number.find(pair);
    if (noted == frame.noted_pairs->by_number.end()) return source;
    source.take = noted->second.take;
    source.take_frame = noted->second.frame;
    source.swapped = noted->second.swapped;
    source.label = noted->second.label;
    return source;
  }
  if (!library) return source;
  if (pair < 0 || pair >= library->pair_count()) return source;
  source.take = library->take_of(pair).name;
  source.take_frame = static_cast<int>(library->source(pair).frame);
  source.swapped = library->source(pair).swapped;
  source.label = library->label(pair);
  return source;
}

}  // namespace

Result<std::unique_ptr<HistoryRecord>> HistoryRecord::create(RunningExport running,
                                                             const Progress& progress) {
  std::unique_ptr<HistoryRecord> record(new HistoryRecord(std::move(running)));
  if (const Status looked = record->look_through(progress); !looked) return looked.error();
  return record;
}

Status HistoryRecord::look_through(const Progress& progress) {
  FrameRange frames = running_.frames;
  const auto count = static_cast<double>(std::max<std::uint64_t>(1, frames.size()));
  while (const FrameSnapshotPtr frame = frames.next()) {
    if (!report(progress, static_cast<double>(sources_.size()) / count, "Looking through the session"))
      return Error{"cancelled; nothing was written", where()};
    note(*frame);
  }
  unreadable_ = frames.size() - sources_.size();
  contents_.program = std::string("abrazo ") + version();
  contents_.takes = running_.takes;
  contents_.markers = running_.markers;
  contents_.annotations = running_.noted;
  contents_.inputs = {{1, running_.input, 0}};
  contents_.frames = sources_.size();
  if (sources_.empty()) return Done{};
  contents_.first_frame = sources_.front().frame;
  contents_.last_frame = sources_.back().frame;
  contents_.first_s = sources_.front().time_s;
  contents_.last_s = sources_.back().time_s;
  cursor_ = running_.frames;
  return Done{};
}

void HistoryRecord::note(const FrameSnapshot& frame) {
  sources_.push_back(source_of(frame, running_.library.get()));
  if (contents_.settings.empty() || contents_.settings.back().settings != frame.settings)
    contents_.settings.push_back({frame.index, frame.time_s, frame.settings});
  // Frames share their decisions until one is made.
  if (frame.decisions == decisions_) return;
  decisions_ = frame.decisions;
  contents_.decisions.push_back(
      {frame.index, frame.time_s, frame.decisions ? *frame.decisions : Decisions{}});
}

/// When they were is known from the frames around them.
std::uint64_t HistoryRecord::unreadable_between(double from_s, double to_s) const {
  if (unreadable_ == 0 || sources_.empty()) return unreadable_;
  std::uint64_t inside = 0, placed = 0;
  for (std::size_t i = 1; i < sources_.size(); ++i) {
    const std::uint64_t lost = sources_[i].frame - sources_[i - 1].frame - 1;
    placed += lost;
    if (sources_[i].time_s >= from_s && sources_[i - 1].time_s <= to_s) inside += lost;
  }
  // The others are before the first frame or behind the last.
  if (placed < unreadable_ && (from_s < contents_.first_s || to_s > contents_.last_s))
    inside += unreadable_ - placed;
  return std::min(inside, unreadable_);
}

Result<RowsRead> HistoryRecord::each_frame(double from_s, double to_s,
                                           const std::function<Status(const FrameSnapshot&)>& visit) const {
  RowsRead rows;
  FrameRange frames = running_.frames;
  while (const FrameSnapshotPtr frame = frames.next()) {
    if (frame->time_s < from_s) continue;
    if (frame->time_s > to_s) break;
    if (const Status visited = visit(*frame); !visited) return visited.error();
    ++rows.read;
  }
  rows.damaged = unreadable_between(from_s, to_s);
  if (rows.damaged > 0) rows.damage = "they cannot be read back from the file that is being recorded";
  return rows;
}

Result<RowsRead> HistoryRecord::each_pose(std::optional<int> /*performer*/, double /*from_s*/,
                                          double /*to_s*/,
                                          const std::function<Status(const ReceivedPose&)>& /*visit*/) const {
  return RowsRead{};
}

Status HistoryRecord::each_source(double from_s, double to_s,
                                  const std::function<Status(const SessionSource&)>& visit) const {
  for (const SessionSource& source : sources_) {
    if (source.time_s < from_s || source.time_s > to_s) continue;
    if (Status visited = visit(source); !visited) return visited;
  }
  return Done{};
}

FrameSnapshotPtr HistoryRecord::frame(std::uint64_t index) {
  if (!at_cursor_ || at_cursor_->index > index) {
    cursor_.rewind();
    at_cursor_ = cursor_.next();
  }
  while (at_cursor_ && at_cursor_->index < index) at_cursor_ = cursor_.next();
  return at_cursor_ && at_cursor_->index == index ? at_cursor_ : nullptr;
}

}  // namespace abrazo
