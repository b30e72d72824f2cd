#include "widgets/library/take_coverage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/session/frames/frame_in_library.hpp"

namespace abrazo::widgets {

namespace {

constexpr double per_metre = 1000;
constexpr std::size_t most_millimetres = 4000;

}  // namespace

void TakeCoverage::begin(std::shared_ptr<const MotionLibrary> library) {
  library_ = std::move(library);
  takes_.clear();
  distances_.assign(most_millimetres + 1, 0);
  user_frames_ = 0;
  next_index_ = 0;
  read_ = all_ = 0;
  if (!library_) return;
  for (const LibraryTake& take : library_->takes()) {
    const int stride = std::max(1, take.frame_stride);
    takes_.push_back(
        {take.frames, stride, 0, 0,
         std::vector<std::uint64_t>(static_cast<std::size_t>((take.frames + stride - 1) / stride))});
  }
}

void TakeCoverage::append(const FrameSnapshot& frame, std::uint64_t stands_for) {
  ++read_;
  all_ += stands_for;
  const FrameResult& result = frame.result;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Candidate& candidate : result.candidates)
    nearest = std::min(nearest, candidate.feature_distance);
  if (!result.candidates.empty() && library_) {
    distances_[static_cast<std::size_t>(std::min(double{most_millimetres}, nearest * per_metre))] +=
        stands_for;
    user_frames_ += stands_for;
  }
  const int pair = selected_pair(frame, library_);
  if (!library_ || pair < 0 || pair >= library_->pair_count()) return;
  const PairSource& source = library_->source(pair);
  Take& take = takes_[source.take];
  const std::size_t kept = source.frame / static_cast<std::size_t>(take.stride);
  if (kept >= take.times.size()) return;
  take.selected += static_cast<int>(stands_for);
  if (take.times[kept] == 0) ++take.selected_frames;
  take.times[kept] += stands_for;
}

bool TakeCoverage::append_new(const FrameHistory& history) {
  const auto frames = history.next_since(next_index_);
  const std::uint64_t most = frames.empty() ? 1 : history.frames_each();
  for (const FrameSnapshotPtr& frame : frames) {
    // A number that is missing otherwise is of a frame that was not recorded, and no frame stands for it.
    const std::uint64_t apart = read_ > 0 ? frame->index + 1 - next_index_ : 1;
    append(*frame, std::min(apart, most));
    next_index_ = frame->index + 1;
  }
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
  if (user_frames_ == 0) return std::nullopt;
  const auto end = static_cast<std::ptrdiff_t>(
      std::clamp(std::round(distance_m * per_metre), 0.0, double{most_millimetres}));
  const auto near = std::accumulate(distances_.begin(), distances_.begin() + end, std::uint64_t{0});
  return static_cast<double>(near) / static_cast<double>(user_frames_);
}

}  // namespace abrazo::widgets
