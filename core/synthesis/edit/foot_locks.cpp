#include "core/synthesis/edit/foot_locks.hpp"

#include <algorithm>

namespace abrazo {

namespace {

// The user's own foot is planted where it is held, so it can only be as far off as it slides under the speed
// limit.
constexpr double active_release_distance_m = 0.05;
constexpr double passive_release_distance_m = 0.20;
constexpr double source_change_distance_m = 0.10;
constexpr double longest_reach = 0.995;

}  // namespace

void FootLocks::reset() {
  *this = FootLocks();
}

bool FootLocks::may_be_held(const FootSituation& wanted, const Foot& foot, double farthest_m) {
  return (wanted.toe_base - foot.toe_base).norm() <= farthest_m &&
         (wanted.hip - foot.ankle).norm() <= longest_reach * wanted.leg_length;
}

void FootLocks::update(const Situations& feet, const PairPose* previous, bool source_changed) {
  for (std::size_t f = 0; f < feet_.size(); ++f) {
    const FootSituation& wanted = feet[f];
    Foot& foot = feet_[f];
    const bool passive = f >= 2;
    const bool was_locked = foot.locked;
    double farthest = passive ? passive_release_distance_m : active_release_distance_m;
    if (passive && source_changed) farthest = source_change_distance_m;
    if (!foot.locked && foot.was_landed && previous != nullptr) {
      foot.ankle = previous->row(ankles[f]);
      foot.toe_base = previous->row(ankles[f] + 1);
    }
    foot.locked =
        wanted.landed && foot.was_landed && previous != nullptr && may_be_held(wanted, foot, farthest);
    foot.was_landed = wanted.landed;
    if (passive) passive_released_[f - 2] = was_locked && !foot.locked;
  }
}

void FootLocks::add_rows(int bodies, std::vector<ConstraintRow>& rows) const {
  for (std::size_t f = 0; f < feet_.size(); ++f) {
    if (!feet_[f].locked || static_cast<int>(f) >= 2 * bodies) continue;
    add_position_rows(ankles[f], feet_[f].ankle, rows);
    add_position_rows(ankles[f] + 1, feet_[f].toe_base, rows);
  }
}

int FootLocks::held(int bodies) const {
  return static_cast<int>(
      std::count_if(feet_.begin(), feet_.begin() + 2 * bodies, [](const Foot& foot) { return foot.locked; }));
}

void FootLocks::release(int bodies) {
  for (std::size_t f = static_cast<std::size_t>(2 * bodies); f < feet_.size(); ++f) feet_[f].locked = false;
}

void FootLocks::list(int bodies, std::vector<FootLock>& locks) const {
  locks.clear();
  for (std::size_t f = 0; f < feet_.size(); ++f)
    if (feet_[f].locked && static_cast<int>(f) < 2 * bodies) locks.push_back({f < 2, f % 2 == 0});
}

double FootLocks::drift(int bodies, const PairPose& positions) const {
  double largest = 0;
  for (std::size_t f = 0; f < feet_.size(); ++f) {
    if (!feet_[f].locked || static_cast<int>(f) >= 2 * bodies) continue;
    largest = std::max({largest, (Vec3(positions.row(ankles[f])) - feet_[f].ankle).norm(),
                        (Vec3(positions.row(ankles[f] + 1)) - feet_[f].toe_base).norm()});
  }
  return largest;
}

}  // namespace abrazo
