#include "core/synthesis/edit/capsule_contacts.hpp"

#include <algorithm>

#include "core/mesh/capsules.hpp"

namespace abrazo {

namespace {

struct Segment {
  Vec3 from, to;

  Vec3 middle() const { return 0.5 * (from + to); }
  double half_length() const { return 0.5 * (to - from).norm(); }
};

Segment bone_segment(const PairPose& pose, int b, int first_vertex) {
  const auto [from, to] = bone(b);
  return {pose.row(from + first_vertex), pose.row(to + first_vertex)};
}

/// The bones that end at wrist and hand of an arm.
std::array<int, 2> lower_arm(bool left) {
  using namespace joints;
  return left ? std::array<int, 2>{LeftWrist - 1, LeftHand - 1}
              : std::array<int, 2>{RightWrist - 1, RightHand - 1};
}

}  // namespace

CapsuleContacts::CapsuleContacts() {
  near_.reserve(static_cast<std::size_t>(bone_count * bone_count));
}

void CapsuleContacts::find_near(const PairPose& pose, double gap_m) {
  near_.clear();
  std::array<Segment, bone_count> passive_segments;
  std::array<Vec3, bone_count> passive_middles;
  std::array<double, bone_count> passive_halves;
  for (int b = 0; b < bone_count; ++b) {
    const auto at = static_cast<std::size_t>(b);
    passive_segments[at] = bone_segment(pose, b, joint_count);
    passive_middles[at] = passive_segments[at].middle();
    passive_halves[at] = passive_segments[at].half_length();
  }
  for (int i = 0; i < bone_count; ++i) {
    const double active_radius = active_[static_cast<std::size_t>(i)];
    if (active_radius <= 0) continue;
    const Segment one = bone_segment(pose, i, 0);
    const Vec3 middle = one.middle();
    const double half = one.half_length();
    for (int j = 0; j < bone_count; ++j) {
      const double passive_radius = passive_[static_cast<std::size_t>(j)];
      if (passive_radius <= 0 || held_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]) continue;
      const double reach = active_radius + passive_radius + gap_m;
      const double farthest = reach + half + passive_halves[static_cast<std::size_t>(j)];
      if ((middle - passive_middles[static_cast<std::size_t>(j)]).squaredNorm() > farthest * farthest)
        continue;
      const Segment& other = passive_segments[static_cast<std::size_t>(j)];
      const SegmentApproach approach = closest_points(one.from, one.to, other.from, other.to);
      if (approach.distance > reach) continue;
      NearPair found;
      found.active_bone = i;
      found.passive_bone = j;
      found.s = approach.s;
      found.t = approach.t;
      found.normal = approach.normal;
      found.depth = active_radius + passive_radius - approach.distance;
      found.excess = found.depth - allowed_depth_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      near_.push_back(found);
    }
  }
}

void CapsuleContacts::prepare(const PairPose& selected, const CapsuleRadii& active,
                              const CapsuleRadii& passive, double clearance_m) {
  active_ = active;
  passive_ = passive;
  sides_ = selected;
  clearance_m_ = clearance_m;
  for (auto& row : recorded_depth_) row.fill(0);
  for (auto& row : held_) row.fill(false);
  for (const bool active_left : {true, false})
    for (const bool passive_left : {true, false}) {
      const auto active_arm = lower_arm(active_left);
      const auto passive_arm = lower_arm(passive_left);
      if (!hands_hold(selected, {active_arm[1] + 1, passive_arm[1] + 1})) continue;
      for (const int i : active_arm)
        for (const int j : passive_arm)
          held_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = true;
    }
  find_near(selected, 0.0);
  for (const NearPair& pair : near_)
    recorded_depth_[static_cast<std::size_t>(pair.active_bone)][static_cast<std::size_t>(pair.passive_bone)] =
        std::max(0.0, pair.depth);
  for (std::size_t i = 0; i < allowed_depth_.size(); ++i)
    for (std::size_t j = 0; j < allowed_depth_.size(); ++j)
      allowed_depth_[i][j] = recorded_depth_[i][j] - clearance_m;
}

void CapsuleContacts::add_rows(const PairPose& iterate, std::vector<ConstraintRow>& rows) {
  find_near(iterate, activation_gap_m);
  const auto pressing = [](const NearPair& x, const NearPair& y) {
    if (x.excess != y.excess) return x.excess > y.excess;
    return std::pair(x.active_bone, x.passive_bone) < std::pair(y.active_bone, y.passive_bone);
  };
  std::sort(near_.begin(), near_.end(), pressing);
  const std::size_t count = std::min<std::size_t>(near_.size(), max_rows);
  for (std::size_t n = 0; n < count; ++n) {
    const NearPair& pair = near_[n];
    const auto [a, b] = bone(pair.active_bone);
    const auto [c, d] = bone(pair.passive_bone);
    Vec3 normal = pair.normal;
    if (pair.depth > 0 || normal.isZero()) {
      // A capsule whose axis went through the other's is pushed back, not on.
      const Segment one = bone_segment(sides_, pair.active_bone, 0);
      const Segment other = bone_segment(sides_, pair.passive_bone, joint_count);
      const Vec3 recorded = closest_points(one.from, one.to, other.from, other.to).normal;
      if (normal.isZero() || normal.dot(recorded) < 0) normal = recorded;
    }
    if (normal.isZero()) continue;
    ConstraintRow row;
    row.kind = RowKind::Capsule;
    row.inequality = true;
    row.count = 4;
    row.vertices = {a, b, c + joint_count, d + joint_count};
    row.weights = {1 - pair.s, pair.s, pair.t - 1, -pair.t};
    row.direction = normal;
    row.target = active_[static_cast<std::size_t>(pair.active_bone)] +
                 passive_[static_cast<std::size_t>(pair.passive_bone)] -
                 allowed_depth_[static_cast<std::size_t>(pair.active_bone)]
                               [static_cast<std::size_t>(pair.passive_bone)];
    rows.push_back(row);
  }
}

double CapsuleContacts::deepest_excess_m(const PairPose& pose) {
  find_near(pose, clearance_m_);
  double deepest_m = 0;
  for (const NearPair& pair : near_) deepest_m = std::max(deepest_m, pair.excess);
  return deepest_m;
}

void CapsuleContacts::measure(const PairPose& result, std::vector<CapsuleContact>& contacts,
                              double& deepest_m, double& deepest_excess_m) {
  contacts.clear();
  deepest_m = 0;
  deepest_excess_m = 0;
  find_near(result, 0.0);
  std::sort(near_.begin(), near_.end(),
            [](const NearPair& x, const NearPair& y) { return x.depth > y.depth; });
  for (const NearPair& pair : near_) {
    const auto [a, b] = bone(pair.active_bone);
    const auto [c, d] = bone(pair.passive_bone);
    contacts.push_back({{a, b},
                        {c + joint_count, d + joint_count},
                        pair.depth,
                        recorded_depth_[static_cast<std::size_t>(pair.active_bone)]
                                       [static_cast<std::size_t>(pair.passive_bone)]});
    deepest_m = std::max(deepest_m, pair.depth);
    deepest_excess_m =
        std::max(deepest_excess_m, pair.depth - recorded_depth_[static_cast<std::size_t>(pair.active_bone)]
                                                               [static_cast<std::size_t>(pair.passive_bone)]);
  }
}

}  // namespace abrazo
