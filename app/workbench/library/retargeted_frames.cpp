#include "app/workbench/library/retargeted_frames.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <utility>

#include "core/bodies/retargeted_frame.hpp"

namespace abrazo::app {
namespace {

constexpr double frame_rounding = 1e-6;  // of times after additions and subtractions [frames]

FrameResult result_of_recording(const RecordedPair& recorded, std::size_t frame) {
  FrameResult result;
  result.selected_pair << recorded.active.poses.at(frame), recorded.passive.poses.at(frame);
  result.result = result.selected_pair;
  result.query_world = recorded.active.poses.at(frame);
  result.morph_steps = {result.result};
  result.status = StepStatus::Ok;
  result.message.clear();
  return result;
}

}  // namespace

std::size_t PreviewedPair::frame_at(double time_s) const {
  const double frame = std::floor(time_s * fps() + frame_rounding) - static_cast<double>(first_frame);
  return static_cast<std::size_t>(std::clamp(frame, 0.0, static_cast<double>(frames() - 1)));
}

const PreviewedPair::Piece* PreviewedPair::piece_of(std::size_t frame) const {
  for (const Piece& piece : pieces | std::views::reverse)
    if (piece.has(frame)) return &piece;
  return nullptr;
}

RetargetedFrames::RetargetedFrames(PreviewedPair pair, Shows shows) : pair_(std::move(pair)), shows_(shows) {}

FrameStore::Span RetargetedFrames::span() const {
  const std::size_t last = pair_.frames() - 1;
  return {pair_.time_of(0), pair_.time_of(last), 0, last, pair_.frames()};
}

FrameSnapshotPtr RetargetedFrames::at(double time_s) const {
  if (time_s * pair_.fps() + frame_rounding < static_cast<double>(pair_.first_frame)) return nullptr;
  return frame(pair_.frame_at(time_s));
}

FrameSnapshotPtr RetargetedFrames::frame(std::uint64_t index) const {
  if (index >= pair_.frames()) return nullptr;
  const std::scoped_lock lock(mutex_);
  if (!last_ || last_->index != index) last_ = make(static_cast<std::size_t>(index));
  return last_;
}

std::vector<FrameSnapshotPtr> RetargetedFrames::range(double from_s, double to_s, std::size_t most) const {
  const double first =
      std::ceil(from_s * pair_.fps() - frame_rounding) - static_cast<double>(pair_.first_frame);
  const double last =
      std::floor(to_s * pair_.fps() + frame_rounding) - static_cast<double>(pair_.first_frame);
  if (last < 0 || last < first) return {};
  return between(static_cast<std::uint64_t>(std::max(first, 0.0)), static_cast<std::uint64_t>(last), most);
}

std::vector<FrameSnapshotPtr> RetargetedFrames::between(std::uint64_t first, std::uint64_t last,
                                                        std::size_t most) const {
  std::vector<FrameSnapshotPtr> made;
  if (first >= pair_.frames() || last < first) return made;
  last = std::min<std::uint64_t>(last, pair_.frames() - 1);
  const std::uint64_t there = last - first + 1, count = std::min<std::uint64_t>(there, most);
  for (std::uint64_t i = 0; i < count; ++i)
    made.push_back(make(static_cast<std::size_t>(first + i * there / count)));
  return made;
}

FrameSnapshotPtr RetargetedFrames::make(std::size_t frame) const {
  auto snapshot = std::make_shared<FrameSnapshot>();
  const PreviewedPair::Piece* piece = shows_ == Shows::Recording ? nullptr : pair_.piece_of(frame);
  snapshot->result = piece ? frame_result_of(*piece->pair, frame - piece->first)
                           : result_of_recording(*pair_.recorded, frame);
  snapshot->index = frame;
  snapshot->time_s = pair_.time_of(frame);
  snapshot->input_frame = pair_.first_frame + static_cast<long long>(frame);
  snapshot->user = snapshot->result.query_world;
  snapshot->settings.morph_steps = 1;  // a fit is not a series of steps
  snapshot->settings.projection_steps = 0;
  snapshot->input_rate_hz = pair_.fps();
  return snapshot;
}

}  // namespace abrazo::app
