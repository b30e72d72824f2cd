#include "widgets/library/take_coverage.hpp"

#include <algorithm>
#include <limits>

#include "core/session/frame_in_library.hpp"

namespace abrazo::widgets {

void TakeCoverage::begin(std::shared_ptr<const MotionLibrary> library) {
  library_ = std::move(library);
  takes_.clear();
  distances_.clear();
  next_index_ = 0;
  if (!library_) return;
  for (const LibraryTake& take : library_->takes()) {
    const int stride = std::max(1, take.frame_stride);
    takes_.push_back(
        {take.frames, stride, 0, 0,
         std::vector<std::uint32_t>(static_cast<std::size_t>((take.frames + stride - 1) / stride))});
  }
}

void TakeCoverage::append(const FrameSnapshot& frame) {
  const FrameResult& result = frame.result;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Candidate& candidate : result.candidates)
    nearest = std::min(nearest, candidate.feature_distance);
  if (!result.candidates.empty()) distances_.push_back(static_cast<float>(nearest));
  const int pair = selected_pair(frame, library_);
  if (!library_ || pair < 0 || pair >= library_->pair_count()) return;
  const PairSource& source = library_->source(pair);
  Take& take = takes_[source.take];
  const std::size_t kept = source.frame / static_cast<std::size_t>(take.stride);
  if (kept >= take.times.size()) return;
  ++take.selected;
  if (take.times[kept]++ == 0) ++take.selected_frames;
}

bool TakeCoverage::append_new(const FrameHistory& history) {
  const auto frames = history.since(next_index_);
  for (const FrameSnapshotPtr& frame : frames) append(*frame);
  if (!frames.empty()) next_index_ = frames.back()->index + 1;
  return !frames.empty();
}

int TakeCoverage::times_selected(int take) const {
  return takes_[static_cast<std::size_t>(take)].selected;
}

double TakeCoverage::share_selected(int take) const {
  const Take& of = takes_[static_cast<std::size_t>(take)];
  return of.times.empty() ? 0 : of.selected_frames / static_cast<double>(of.times.size());
}

std::vector<int> TakeCoverage::heat(int take, int parts) const {
  const Take& of = takes_[static_cast<std::size_t>(take)];
  std::vector<int> heat(static_cast<std::size_t>(std::max(parts, 0)));
  if (heat.empty() || of.selected == 0) return heat;
  for (std::size_t kept = 0; kept < of.times.size(); ++kept)
    heat[kept * heat.size() / of.times.size()] += static_cast<int>(of.times[kept]);
  return heat;
}

std::optional<double> TakeCoverage::share_within(double distance_m) const {
  if (distances_.empty()) return std::nullopt;
  const auto near = std::count_if(distances_.begin(), distances_.end(),
                                  [&](float distance) { return static_cast<double>(distance) < distance_m; });
  return static_cast<double>(near) / static_cast<double>(distances_.size());
}

}  // namespace abrazo::widgets
