#include "core/session/run/leader_judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abrazo {

namespace {

constexpr double longest_gap_s = 0.3;
constexpr double smallest_distance_m = 1e-3;  ///< nearer than that is the recording itself

/// Pairs of a performer in this role: those annotated with who led.
std::vector<bool> unknown_pairs(const MotionLibrary& library) {
  std::vector<bool> left_out(static_cast<std::size_t>(library.pair_count()));
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    const PairSource& source = library.source(pair);
    const ActivePerformer assumed = source.swapped ? ActivePerformer::B : ActivePerformer::A;
    left_out[static_cast<std::size_t>(pair)] = source.annotated != assumed;
  }
  return left_out;
}

/// Mean square distance of the joints of two poses, each seen from its own place.
double square_distance(const Pose& pose, const RootFrame& from, const Pose& other,
                       const RootFrame& other_from) {
  return (to_normalized(pose, from) - to_normalized(other, other_from)).squaredNorm() / joint_count;
}

}  // namespace

LeaderJudge::LeaderJudge(std::shared_ptr<const RoleViews> views) {
  for (const UserRole role : {UserRole::Active, UserRole::Passive}) {
    Side& side = sides_[role == UserRole::Active ? 0 : 1];
    side.view = views->of(role);
    side.left_out = unknown_pairs(*views->library());
  }
}

void LeaderJudge::forget() {
  for (Side& side : sides_) side.seen.clear();
  fit_ = {};
}

void LeaderJudge::see(const Pose& user, const Body& user_body, double time_s) {
  const double since_s = time_s - last_look_s_;
  if (since_s >= 0 && since_s < between_looks_s * (1 - 1e-6)) return;
  if (since_s < 0 || since_s > longest_gap_s) forget();
  last_look_s_ = time_s;
  const bool same_user = user_body_ && user_body_->bone_lengths == user_body.bone_lengths;
  if (!same_user) forget();
  user_body_ = user_body;
  for (Side& side : sides_) {
    if (!side.retargeter || !same_user)
      side.retargeter.emplace(user_body, side.view.library->usual_active_body().body);
    Seen now{time_s, side.retargeter->apply(user), {}};
    now.root = root_frame(
        now.pose, side.seen.empty() ? std::nullopt : std::optional(side.seen.back().root.heading_rad));
    side.seen.push_back(now);
    while (side.seen.front().time_s < time_s - stretch_s - longest_gap_s) side.seen.pop_front();
  }
  const auto active = distance(sides_[0]), passive = distance(sides_[1]);
  if (!active || !passive) return;
  const bool is_first = fit_.active_m < 0;
  fit_.active_m = *active;
  fit_.passive_m = *passive;
  const double now =
      std::log(std::max(*passive, smallest_distance_m) / std::max(*active, smallest_distance_m));
  const double share = is_first ? 0.0 : 1 - std::exp(-since_s / memory_s);
  fit_.evidence += share * (now - fit_.evidence);
}

std::optional<double> LeaderJudge::distance(Side& side) const {
  const Seen& now = side.seen.back();
  if (now.time_s - side.seen.front().time_s < stretch_s) return std::nullopt;
  side.view.index->nearest_without(side.left_out, pose_features(to_normalized(now.pose, now.root)),
                                   neighbours, side.matches);
  double best = std::numeric_limits<double>::infinity();
  for (const PoseMatch& match : side.matches)
    if (const auto found = stretch_distance(side, match.pair, best)) best = std::min(best, *found);
  if (!std::isfinite(best)) return std::nullopt;
  return std::sqrt(best / poses_of_stretch);
}

/// Sum over the poses of the stretch that ends in `pair`; nothing when it was not recorded that far back, or
/// is more than `enough`.
std::optional<double> LeaderJudge::stretch_distance(const Side& side, int pair, double enough) const {
  const MotionLibrary& library = *side.view.library;
  const LibraryTake& take = library.take_of(pair);
  const double pair_rate_hz = take.fps / take.frame_stride;
  const Seen& now = side.seen.back();
  double sum = 0;
  for (int l = 0; l < poses_of_stretch; ++l) {
    const double back_s = stretch_s * l / (poses_of_stretch - 1);
    const int earlier = library.later_pair(pair, -static_cast<int>(std::lround(back_s * pair_rate_hz)));
    if (earlier < 0) return std::nullopt;
    const Pose recorded = to_world(library.pose(earlier).topRows<joint_count>(), library.root(earlier));
    sum +=
        square_distance(seen_before(side, now.time_s - back_s).pose, now.root, recorded, library.root(pair));
    if (sum >= enough) return std::nullopt;
  }
  return sum;
}

const LeaderJudge::Seen& LeaderJudge::seen_before(const Side& side, double time_s) {
  const auto after = std::lower_bound(side.seen.begin(), side.seen.end(), time_s,
                                      [](const Seen& seen, double t) { return seen.time_s < t; });
  if (after == side.seen.end()) return side.seen.back();
  if (after == side.seen.begin()) return *after;
  return after->time_s - time_s < time_s - std::prev(after)->time_s ? *after : *std::prev(after);
}

}  // namespace abrazo
