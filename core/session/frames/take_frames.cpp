#include "core/session/frames/take_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <mutex>
#include <unordered_map>

#include "core/mesh/laplacian.hpp"
#include "core/mesh/other_body.hpp"

namespace abrazo {

namespace {

/// Some 8 s at 60 Hz, 10 kB each.
constexpr std::size_t kept_frames = 512;

/// A frame of the take and a pair that has it.
struct Place {
  int frame = 0;
  int pair = -1;
};

std::vector<Place> places_of(const MotionLibrary& library, std::uint32_t take) {
  std::vector<Place> places;
  for (int pair = 0; pair < library.pair_count(); ++pair)
    if (const PairSource& source = library.source(pair); source.take == take)
      places.push_back({static_cast<int>(source.frame), pair});
  // Of a frame that is there with both roles, the first: with A active.
  std::stable_sort(places.begin(), places.end(), [](Place a, Place b) { return a.frame < b.frame; });
  places.erase(std::unique(places.begin(), places.end(), [](Place a, Place b) { return a.frame == b.frame; }),
               places.end());
  return places;
}

class LibraryTakeFrames : public TakeFrames {
 public:
  LibraryTakeFrames(std::shared_ptr<const MotionLibrary> library, int take)
      : library_(std::move(library)),
        about_(library_->takes()[static_cast<std::size_t>(take)]),
        places_(places_of(*library_, static_cast<std::uint32_t>(take))) {}

  bool empty() const { return places_.empty(); }
  double fps() const override { return about_.fps; }
  int take_frames() const override { return about_.frames; }
  int pair(std::uint64_t index) const override { return places_.at(static_cast<std::size_t>(index)).pair; }

  Span span() const override {
    return {time_of(0), time_of(places_.size() - 1), 0, places_.size() - 1, places_.size()};
  }
  FrameSnapshotPtr at(double time_s) const override {
    // Tolerance for frame times after additions and subtractions.
    const int frame = static_cast<int>(std::floor(time_s * about_.fps + 1e-6));
    const auto after = std::upper_bound(places_.begin(), places_.end(), frame,
                                        [](int wanted, Place place) { return wanted < place.frame; });
    return after == places_.begin() ? nullptr : made(static_cast<std::size_t>(after - places_.begin()) - 1);
  }
  FrameSnapshotPtr frame(std::uint64_t index) const override {
    return index < places_.size() ? made(static_cast<std::size_t>(index)) : nullptr;
  }
  std::vector<FrameSnapshotPtr> range(double from_s, double to_s, std::size_t most) const override {
    const auto first =
        std::lower_bound(places_.begin(), places_.end(), from_s,
                         [this](Place place, double time) { return place.frame / about_.fps < time - 1e-9; });
    const auto end = std::upper_bound(places_.begin(), places_.end(), to_s, [this](double time, Place place) {
      return time + 1e-9 < place.frame / about_.fps;
    });
    if (first >= end) return {};
    return between(static_cast<std::uint64_t>(first - places_.begin()),
                   static_cast<std::uint64_t>(end - places_.begin()) - 1, most);
  }
  std::vector<FrameSnapshotPtr> between(std::uint64_t first, std::uint64_t last,
                                        std::size_t most) const override {
    std::vector<FrameSnapshotPtr> frames;
    if (first >= places_.size() || last < first || most == 0) return frames;
    last = std::min<std::uint64_t>(last, places_.size() - 1);
    const std::uint64_t there = last - first + 1;
    const std::uint64_t count = std::min<std::uint64_t>(there, most);
    frames.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i)
      frames.push_back(make(static_cast<std::size_t>(first + i * there / count)));
    return frames;
  }
  std::vector<double> times(double from_s, double to_s) const override {
    std::vector<double> times_s;
    for (std::size_t place = 0; place < places_.size(); ++place)
      if (const double time_s = time_of(place); time_s >= from_s && time_s <= to_s) times_s.push_back(time_s);
    return times_s;
  }
  /// Nothing was solved, so nothing can be solved again.
  std::optional<std::uint64_t> state_before(std::uint64_t) const override { return std::nullopt; }

 private:
  double time_of(std::size_t place) const { return places_[place].frame / about_.fps; }
  FrameSnapshotPtr make(std::size_t place) const;
  FrameSnapshotPtr made(std::size_t place) const;

  std::shared_ptr<const MotionLibrary> library_;
  LibraryTake about_;
  std::vector<Place> places_;

  using Kept = std::list<std::pair<std::size_t, FrameSnapshotPtr>>;
  mutable std::mutex mutex_;
  mutable Kept kept_;  ///< most recently used first
  mutable std::unordered_map<std::size_t, Kept::iterator> kept_at_;
};

FrameSnapshotPtr LibraryTakeFrames::make(std::size_t place) const {
  const auto [frame, pair] = places_[place];
  const bool swapped = library_->source(pair).swapped;
  auto snapshot = std::make_shared<FrameSnapshot>();
  FrameResult& result = snapshot->result;
  const PairPose& pose = library_->pose(pair);
  const RootFrame& root = library_->root(pair);
  const Pose active = to_world(pose.topRows<joint_count>(), root);
  const Pose passive = to_world(pose.bottomRows<joint_count>(), root);
  result.result.topRows<joint_count>() = swapped ? passive : active;
  result.result.bottomRows<joint_count>() = swapped ? active : passive;
  result.selected_pair = result.result;
  result.query_world = result.result.topRows<joint_count>();
  result.query_root = swapped ? root_frame(result.query_world) : root;
  result.query_normalized = to_normalized(result.query_world, result.query_root);
  result.features = pose_features(result.query_normalized);
  for (const MeshEdge& edge : library_->edges(pair))
    result.edges.push_back(swapped ? edge_of_other_body(edge) : edge);
  for (const MeshTetrahedron& tetrahedron : library_->tetrahedra(pair))
    result.tetrahedra.push_back(swapped ? tetrahedron_of_other_body(tetrahedron) : tetrahedron);
  result.edge_weights = inverse_edge_weights(result.edges, result.selected_pair);
  result.edge_residuals_m.assign(result.edges.size(), 0.0);
  result.candidates.push_back({pair, 0, false, {}, {}});
  result.selected = 0;
  result.status = StepStatus::Ok;
  result.message.clear();
  snapshot->index = place;
  snapshot->time_s = frame / about_.fps;
  snapshot->input_frame = frame;
  snapshot->user = result.query_world;
  // The character in front is performer A: active in this pair, or the passive one of a swapped pair.
  snapshot->settings.user_role = swapped ? UserRole::Passive : UserRole::Active;
  snapshot->library = library_;
  snapshot->input_rate_hz = about_.fps / std::max(1, about_.frame_stride);
  return snapshot;
}

FrameSnapshotPtr LibraryTakeFrames::made(std::size_t place) const {
  const std::scoped_lock lock(mutex_);
  if (const auto found = kept_at_.find(place); found != kept_at_.end()) {
    kept_.splice(kept_.begin(), kept_, found->second);
    return found->second->second;
  }
  kept_.emplace_front(place, make(place));
  kept_at_[place] = kept_.begin();
  if (kept_.size() > kept_frames) {
    kept_at_.erase(kept_.back().first);
    kept_.pop_back();
  }
  return kept_.front().second;
}

}  // namespace

Result<std::shared_ptr<const TakeFrames>> TakeFrames::create(std::shared_ptr<const MotionLibrary> library,
                                                             std::string_view take) {
  const int found = library->find_take(take);
  if (found < 0) return Error{fmt::format("has no take '{}'", take), library->name()};
  auto frames = std::make_shared<const LibraryTakeFrames>(library, found);
  if (frames->empty()) return Error{fmt::format("has no frames of the take '{}'", take), library->name()};
  return std::shared_ptr<const TakeFrames>(std::move(frames));
}

std::vector<double> inverse_edge_weights(std::span<const MeshEdge> edges, const PairPose& reference) {
  Laplacian laplacian;
  laplacian.build(edges, reference, EdgeWeights::Inverse);
  std::vector<double> weights;
  for (const MeshEdge& edge : edges)
    weights.push_back(0.5 * (laplacian.weight(edge[0], edge[1]) + laplacian.weight(edge[1], edge[0])));
  return weights;
}

}  // namespace abrazo
