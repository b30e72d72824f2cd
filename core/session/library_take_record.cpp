#include "core/session/library_take_record.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/base/version.hpp"
#include "core/library/motion_library.hpp"
#include "core/mesh/laplacian.hpp"

namespace abrazo {

LibraryTakeRecord::LibraryTakeRecord(std::shared_ptr<const MotionLibrary> library, const std::string& take,
                                     std::vector<Tier> tiers)
    : library_(std::move(library)), take_(take) {
  const int number = library_->find_take(take);
  if (number < 0) throw std::invalid_argument("the library has no take '" + take + "'");
  const LibraryTake& about = library_->takes()[static_cast<std::size_t>(number)];
  fps_ = about.fps;
  // A frame that is there in both roles comes once, as performer a leading.
  for (int pair = 0; pair < library_->pair_count(); ++pair)
    if (static_cast<int>(library_->source(pair).take) == number) pairs_.push_back(pair);
  const auto frame_of = [&](int pair) { return library_->source(pair).frame; };
  std::ranges::stable_sort(pairs_, {}, frame_of);
  const auto doubled = std::ranges::unique(pairs_, {}, frame_of);
  pairs_.erase(doubled.begin(), doubled.end());
  contents_.program = std::string("abrazo ") + version();
  contents_.inputs = {{1, take_, 0}};
  contents_.annotations = std::move(tiers);
  if (pairs_.empty()) return;
  contents_.frames = pairs_.size();
  contents_.last_frame = pairs_.size() - 1;
  contents_.first_s = time_of(pairs_.front());
  contents_.last_s = time_of(pairs_.back());
  contents_.takes = {{1, take_, contents_.first_s, contents_.last_s, 0, contents_.last_frame, {}, false}};
}

double LibraryTakeRecord::time_of(int pair) const {
  return static_cast<double>(library_->source(pair).frame) / fps_;
}

FrameSnapshotPtr LibraryTakeRecord::frame(std::uint64_t index) const {
  if (index >= pairs_.size()) return nullptr;
  const int pair = pairs_[static_cast<std::size_t>(index)];
  auto frame = std::make_shared<FrameSnapshot>();
  frame->index = index;
  frame->time_s = time_of(pair);
  frame->input_frame = static_cast<std::int64_t>(library_->source(pair).frame);
  frame->library = library_;
  FrameResult& result = frame->result;
  result.result = result.selected_pair = library_->pair_in_world(pair, library_->root(pair));
  frame->user = result.active();
  const auto edges = library_->edges(pair);
  const auto tetrahedra = library_->tetrahedra(pair);
  result.edges.assign(edges.begin(), edges.end());
  result.tetrahedra.assign(tetrahedra.begin(), tetrahedra.end());
  Laplacian laplacian;
  laplacian.build(result.edges, result.selected_pair, frame->settings.edge_weights);
  for (const MeshEdge& edge : result.edges)
    result.edge_weights.push_back(0.5 *
                                  (laplacian.weight(edge[0], edge[1]) + laplacian.weight(edge[1], edge[0])));
  result.edge_residuals_m.assign(result.edges.size(), 0.0);
  return frame;
}

Result<RowsRead> LibraryTakeRecord::each_frame(
    double from_s, double to_s, const std::function<Status(const FrameSnapshot&)>& visit) const {
  RowsRead rows;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const double time_s = time_of(pairs_[i]);
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
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const int pair = pairs_[i];
    const double time_s = time_of(pair);
    if (time_s < from_s || time_s > to_s) continue;
    const PairSource& source = library_->source(pair);
    Status visited = visit({i, time_s, take_, static_cast<int>(source.frame), source.swapped,
                            std::string(library_->label(pair))});
    if (!visited) return visited;
  }
  return Done{};
}

}  // namespace abrazo
