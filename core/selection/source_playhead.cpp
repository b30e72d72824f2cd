#include "core/selection/source_playhead.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abrazo {

namespace {

constexpr double same_moment_share = 1e-9;  ///< of the way between two frames

/// Number of pairs of the stretch after `pair` in `direction`, at most `most`.
int pairs_left(const MotionLibrary& library, int pair, int direction, int most) {
  if (library.later_pair(pair, direction * most) >= 0) return most;
  int fits = 0, too_far = most;
  while (too_far - fits > 1) {
    const int middle = (fits + too_far) / 2;
    (library.later_pair(pair, direction * middle) >= 0 ? fits : too_far) = middle;
  }
  return fits;
}

RootFrame between(const RootFrame& a, const RootFrame& b, double share) {
  return {a.position + share * (b.position - a.position),
          a.heading_rad + share * within_half_turn(b.heading_rad - a.heading_rad)};
}

PairPose in_take(const MotionLibrary& library, int pair) {
  const RootFrame& root = library.root(pair);
  return (library.pose(pair) * root.rotation().transpose()).rowwise() + root.position.transpose();
}

}  // namespace

double within_half_turn(double angle) {
  return std::remainder(angle, 2 * std::numbers::pi);
}

double pair_rate(const MotionLibrary& library, int pair) {
  const LibraryTake& take = library.take_of(pair);
  return take.fps / take.frame_stride;
}

SourcePlayhead moved(const MotionLibrary& library, const SourcePlayhead& playhead, double source_s) {
  const double to = playhead.fraction + source_s * pair_rate(library, playhead.pair);
  const double farthest = library.pair_count();
  const auto whole = static_cast<int>(std::floor(std::clamp(to, -farthest, farthest)));
  SourcePlayhead there = playhead;
  const int reached = whole == 0 ? 0
                                 : (whole > 0 ? 1 : -1) * pairs_left(library, playhead.pair,
                                                                     whole > 0 ? 1 : -1, std::abs(whole));
  there.pair = library.later_pair(playhead.pair, reached);
  there.fraction = reached == whole ? to - whole : 0;
  if (there.fraction < same_moment_share || library.later_pair(there.pair, 1) < 0) there.fraction = 0;
  return there;
}

double recorded_ahead(const MotionLibrary& library, const SourcePlayhead& playhead, double most_s) {
  const double rate = pair_rate(library, playhead.pair);
  const int most = std::max(1, static_cast<int>(std::ceil(most_s * rate)));
  return (pairs_left(library, playhead.pair, 1, most) - playhead.fraction) / rate;
}

int nearest_pair(const MotionLibrary& library, const SourcePlayhead& playhead) {
  return playhead.fraction < 0.5 ? playhead.pair : library.later_pair(playhead.pair, 1);
}

std::optional<double> seconds_to(const MotionLibrary& library, const SourcePlayhead& playhead, int pair) {
  if (playhead.pair < 0 || library.later_pair(playhead.pair, pair - playhead.pair) != pair)
    return std::nullopt;
  return (pair - playhead.pair - playhead.fraction) / pair_rate(library, pair);
}

RecordedMoment recorded_moment(const MotionLibrary& library, const SourcePlayhead& playhead) {
  RecordedMoment moment;
  RootFrame leader = library.root(playhead.pair);
  PairPose world = in_take(library, playhead.pair);
  const int next = playhead.fraction > 0 ? library.later_pair(playhead.pair, 1) : -1;
  if (next >= 0) {
    leader = between(leader, library.root(next), playhead.fraction);
    world += playhead.fraction * (in_take(library, next) - world);
  }
  moment.partner_in_take = root_frame(world.bottomRows<joint_count>());
  moment.partner_own = to_normalized(world.bottomRows<joint_count>(), moment.partner_in_take);
  RootFrame on_floor = leader;
  on_floor.position.y() = 0;
  moment.pair = (world.rowwise() - on_floor.position.transpose()) * on_floor.rotation();
  moment.partner.position = moment.pair.row(joint_count).transpose();
  moment.partner.heading_rad = within_half_turn(moment.partner_in_take.heading_rad - leader.heading_rad);
  return moment;
}

}  // namespace abrazo
