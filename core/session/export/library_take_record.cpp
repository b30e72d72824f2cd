#include "core/session/export/library_take_record.hpp"

#include <stdexcept>
#include <utility>

#include "core/base/version.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

LibraryTakeRecord::LibraryTakeRecord(std::shared_ptr<const MotionLibrary> library, const std::string& take,
                                     std::vector<Tier> tiers)
    : library_(std::move(library)), take_(take) {
  if (library_->find_take(take) < 0) throw std::invalid_argument("the library has no take '" + take + "'");
  contents_.program = std::string("abrazo ") + version();
  contents_.inputs = {{1, take_, 0}};
  contents_.annotations = std::move(tiers);
  auto frames = TakeFrames::create(library_, take);
  if (!frames) return;  // none of it is in the library
  frames_ = std::move(*frames);
  const auto span = frames_->span();
  contents_.frames = span.frames;
  contents_.last_frame = span.last_index;
  contents_.first_s = span.first_s;
  contents_.last_s = span.last_s;
  contents_.takes = {{1, take_, span.first_s, span.last_s, 0, span.last_index, {}, false}};
}

double LibraryTakeRecord::time_of(std::uint64_t index) const {
  return static_cast<double>(library_->source(frames_->pair(index)).frame) / frames_->fps();
}

double LibraryTakeRecord::frame_s() const {
  if (!frames_) return 0;
  const int take = library_->find_take(take_);
  return library_->takes()[static_cast<std::size_t>(take)].frame_stride / frames_->fps();
}

FrameSnapshotPtr LibraryTakeRecord::frame(std::uint64_t index) const {
  return frames_ ? frames_->frame(index) : nullptr;
}

Result<RowsRead> LibraryTakeRecord::each_frame(
    double from_s, double to_s, const std::function<Status(const FrameSnapshot&)>& visit) const {
  RowsRead rows;
  for (std::uint64_t i = 0; i < contents_.frames; ++i) {
    const double time_s = time_of(i);
    if (time_s < from_s || time_s > to_s) continue;
    if (const Status visited = visit(*frame(i)); !visited) return visited.error();
    ++rows.read;
  }
  return rows;
}

Result<RowsRead> LibraryTakeRecord::each_pose(
    std::optional<int> /*performer*/, double /*from_s*/, double /*to_s*/,
    const std::function<Status(const ReceivedPose&)>& /*visit*/) const {
  return RowsRead{};
}

Status LibraryTakeRecord::each_source(double from_s, double to_s,
                                      const std::function<Status(const SessionSource&)>& visit) const {
  for (std::uint64_t i = 0; i < contents_.frames; ++i) {
    const double time_s = time_of(i);
    if (time_s < from_s || time_s > to_s) continue;
    const int pair = frames_->pair(i);
    const PairSource& source = library_->source(pair);
    Status visited = visit({i, time_s, take_, static_cast<int>(source.frame), source.swapped,
                            std::string(library_->label(pair))});
    if (!visited) return visited;
  }
  return Done{};
}

}  // namespace abrazo
