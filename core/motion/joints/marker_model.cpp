#include "core/motion/joints/marker_model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/statistics.hpp"
#include "core/motion/body/body_proportions.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/motion/joints/joint_map.hpp"
#include "core/motion/joints/marker_gaps.hpp"
#include "core/motion/joints/marker_geometry.hpp"
#include "core/motion/joints/performers.hpp"

namespace abrazo {

namespace {

using enum MarkerPlace;

// Sizes of an average adult that skin markers do not determine.
constexpr double marker_radius_m = 0.007;
constexpr double knee_width_of_leg = 0.128, ankle_width_of_leg = 0.085, elbow_width_of_leg = 0.090;
constexpr double shoulder_below_acromion =
    0.17;  ///< of the distance of both: Rab et al., Gait Posture 15 (2002) 113
constexpr double hand_depth_m = 0.0125, foot_depth_m = 0.013;  ///< from the skin to the middle
constexpr double head_below_band_m = 0.05, head_below_top_m = 0.12;
constexpr double toe_tip_of_foot = 0.27;
constexpr double lower_back_share = 0.265, upper_back_share = 0.527,
                 thorax_share = 0.79;  ///< of root to neck

constexpr double sides[2] = {1.0, -1.0};

/// The points of a file that are a model's markers; several for one place are averaged.
class MarkerSet {
 public:
  MarkerSet(const MarkerModel& model, const std::vector<std::string>& points) {
    std::map<std::string, int> known;
    for (std::size_t p = 0; p < points.size(); ++p)
      known.emplace(plain_point_name(points[p]), static_cast<int>(p));
    for (std::size_t place = 0; place < marker_place_count; ++place)
      for (const std::size_t side : {0U, 1U})
        for (const std::string& name : model.names[place][side]) {
          const auto found = known.find(plain_point_name(name));
          if (found == known.end()) continue;
          auto& chosen = points_[place][side];
          const bool mean = model.toes_are_mean && place == static_cast<std::size_t>(Toe);
          if (chosen.empty() || mean) chosen.push_back(found->second);
        }
  }
  bool has(MarkerPlace place, std::size_t side = 0) const { return !of(place, side).empty(); }
  bool has_both(MarkerPlace place) const { return has(place, 0) && has(place, 1); }
  const std::vector<int>& of(MarkerPlace place, std::size_t side) const {
    return points_[static_cast<std::size_t>(place)][side];
  }
  std::vector<int> all() const {
    std::vector<int> every;
    for (const auto& both : points_)
      for (const auto& some : both) every.insert(every.end(), some.begin(), some.end());
    return every;
  }

 private:
  std::array<std::array<std::vector<int>, 2>, marker_place_count> points_;
};

/// Sizes of one person, the same in all frames [m].
struct Sizes {
  double pelvis_width = 0, pelvis_depth = 0, leg = 0;
};

/// One frame of markers in metres, and the joints found so far.
class FrameSolver {
 public:
  FrameSolver(const MarkerSet& set, const Sizes& sizes, Positions frame)
      : set_(set), sizes_(sizes), frame_(std::move(frame)) {}
  Vec3 marker(MarkerPlace place, std::size_t side = 0) const {
    Vec3 sum = Vec3::Zero();
    for (const int point : set_.of(place, side)) sum += frame_.row(point).transpose();
    return sum / static_cast<double>(set_.of(place, side).size());
  }
  Vec3 pelvis_back() const {
    if (set_.has_both(PelvisBack)) return (marker(PelvisBack, 0) + marker(PelvisBack, 1)) / 2;
    return marker(Sacrum);
  }
  Pose solve();

 private:
  Vec3 joint(int index) const { return pose_.row(index).transpose(); }
  void put(int index, const Vec3& place) { pose_.row(index) = place.transpose(); }
  void pelvis();
  void trunk();
  void head();
  void leg(std::size_t side);
  void foot(std::size_t side);
  void arm(std::size_t side);
  void hand(std::size_t side);
  Vec3 inward_at_elbow(std::size_t side, const Vec3& shoulder, const Vec3& wrist) const;

  const MarkerSet& set_;
  const Sizes& sizes_;
  Positions frame_;
  Pose pose_ = Pose::Zero();
  Vec3 left_ = Vec3::UnitX(), trunk_up_ = Vec3::UnitY(), neck_ = Vec3::Zero();
};

void FrameSolver::pelvis() {
  const Vec3 left = marker(PelvisFront, 0), right = marker(PelvisFront, 1), back = pelvis_back();
  const Vec3 front = (left + right) / 2;
  const Eigen::Matrix3d axes = pelvis_axes(left, right, back);
  left_ = axes.col(0);
  put(joints::Root, (front + back) / 2);
  put(joints::left_hip, front + axes * hip_centre(sizes_.pelvis_width, sizes_.pelvis_depth, 1));
  put(joints::right_hip, front + axes * hip_centre(sizes_.pelvis_width, sizes_.pelvis_depth, -1));
}

/// The spine is a parabola from the root over the middle of the chest to the neck's base.
void FrameSolver::trunk() {
  const Vec3 root = joint(joints::Root);
  const Vec3 front = set_.has(Clavicle) ? marker(Clavicle) : marker(Sternum);
  neck_ = (marker(Neck) + front) / 2;
  const Vec3 line = neck_ - root;
  Vec3 bow = Vec3::Zero();
  double middle = 0.5;
  if (set_.has(Back) && set_.has(Sternum)) {
    const Vec3 chest = (marker(Back) + marker(Sternum)) / 2;
    middle = std::clamp((chest - root).dot(line) / line.squaredNorm(), 0.35, 0.75);
    bow = chest - (root + middle * line);
    bow -= bow.dot(line) / line.squaredNorm() * line;
  }
  const auto spine = [&](double share) -> Vec3 {
    return root + share * line + share * (1 - share) / (middle * (1 - middle)) * bow;
  };
  put(joints::LowerBack, spine(lower_back_share));
  put(joints::UpperBack, spine(upper_back_share));
  put(joints::Thorax, spine(thorax_share));
  put(joints::LowerNeck, neck_);
  const Vec3 across = marker(Shoulder, 0) - marker(Shoulder, 1);
  trunk_up_ = (line - line.dot(across) / across.squaredNorm() * across).normalized();
  for (const std::size_t side : {0U, 1U})
    put(side == 0 ? joints::left_shoulder : joints::right_shoulder,
        marker(Shoulder, side) - shoulder_below_acromion * across.norm() * trunk_up_);
}

void FrameSolver::head() {
  Vec3 middle;
  if (set_.has_both(HeadFrontSide) && set_.has_both(HeadBackSide)) {
    const Vec3 front = (marker(HeadFrontSide, 0) + marker(HeadFrontSide, 1)) / 2;
    const Vec3 back = (marker(HeadBackSide, 0) + marker(HeadBackSide, 1)) / 2;
    const Vec3 left = marker(HeadFrontSide, 0) - marker(HeadFrontSide, 1);
    const Vec3 up = (front - back).cross(left).normalized();
    middle = (front + back) / 2 - head_below_band_m * up;
  } else if (set_.has(HeadTop)) {
    middle = marker(HeadTop) + head_below_top_m * (neck_ - marker(HeadTop)).normalized();
  } else {
    middle = (marker(HeadFrontSide, 0) + marker(HeadFrontSide, 1)) / 2;
  }
  put(joints::Head, middle);
  put(joints::UpperNeck, (neck_ + middle) / 2);
}

void FrameSolver::leg(std::size_t side) {
  const bool left = side == 0;
  const Vec3 hip = joint(left ? joints::left_hip : joints::right_hip);
  const Vec3 fallback = -sides[side] * left_;
  const auto inward = [&](MarkerPlace outer, const Vec3& above, const Vec3& below,
                          const Vec3& otherwise) -> Vec3 {
    if (!set_.has(outer, side)) return otherwise;
    const Vec3 away = away_from(marker(outer, side), above, below);
    return away + (1 - away.norm()) * otherwise;
  };
  Vec3 knee, ankle;
  Vec3 knee_inward = fallback;
  if (set_.has(KneeInner, side)) {
    knee = (marker(Knee, side) + marker(KneeInner, side)) / 2;
    knee_inward = (knee - marker(Knee, side)).normalized();
  } else {
    knee_inward = inward(Thigh, hip, marker(Knee, side), fallback);
    knee = chord_centre(hip, marker(Knee, side), knee_inward,
                        knee_width_of_leg * sizes_.leg / 2 + marker_radius_m);
  }
  if (set_.has(AnkleInner, side))
    ankle = (marker(Ankle, side) + marker(AnkleInner, side)) / 2;
  else
    ankle = chord_centre(knee, marker(Ankle, side), inward(Shin, knee, marker(Ankle, side), knee_inward),
                         ankle_width_of_leg * sizes_.leg / 2 + marker_radius_m);
  put(left ? joints::left_knee : joints::right_knee, knee);
  put(left ? joints::left_ankle : joints::right_ankle, ankle);
}

void FrameSolver::foot(std::size_t side) {
  const bool left = side == 0;
  const Vec3 ankle = joint(left ? joints::left_ankle : joints::right_ankle), toe = marker(Toe, side);
  const Vec3 heel = set_.has(Heel, side) ? marker(Heel, side) : ankle;
  const Vec3 along = (toe - heel).normalized();
  Vec3 up = ankle - (heel + toe) / 2;
  up -= up.dot(along) * along;
  const Vec3 sole = up.norm() > 1e-6 ? Vec3(up.normalized()) : Vec3(Vec3::Zero());
  const Vec3 base = toe - (marker_radius_m + foot_depth_m) * sole;
  put(left ? joints::left_toe_base : joints::right_toe_base, base);
  Vec3 tip = ankle + toe_tip_beyond_foot * (base - ankle);
  if (set_.has(ToeTip, side))
    tip = marker(ToeTip, side) - (marker_radius_m + foot_depth_m) * sole;
  else if (set_.has(Heel, side))
    tip = base + toe_tip_of_foot * (toe - heel);
  put(left ? joints::left_toe_tip : joints::right_toe_tip, tip);
}

/// A bent elbow shows its axis; of a straight one, markers beside it tell.
Vec3 FrameSolver::inward_at_elbow(std::size_t side, const Vec3& shoulder, const Vec3& wrist) const {
  const Vec3 elbow = marker(Elbow, side);
  Vec3 straight = -sides[side] * left_;
  if (set_.has(UpperArm, side)) {
    const Vec3 away = away_from(marker(UpperArm, side), shoulder, elbow);
    straight = away + (1 - away.norm()) * straight;
  } else if (set_.has(WristThumb, side) && set_.has(WristLittle, side)) {
    straight = (marker(WristLittle, side) - marker(WristThumb, side)).normalized();
  }
  const Vec3 axis = sides[side] * (elbow - shoulder).normalized().cross((wrist - elbow).normalized());
  constexpr double clearly_bent = 0.35;
  const double share = std::min(1.0, axis.norm() / clearly_bent);
  return share * axis.stableNormalized() + (1 - share) * straight;
}

void FrameSolver::arm(std::size_t side) {
  const bool left = side == 0;
  const Vec3 shoulder = joint(left ? joints::left_shoulder : joints::right_shoulder);
  Vec3 wrist = Vec3::Zero();
  int wrist_markers = 0;
  for (const MarkerPlace place : {WristThumb, WristLittle})
    if (set_.has(place, side)) wrist += marker(place, side), ++wrist_markers;
  wrist /= wrist_markers;
  Vec3 elbow;
  if (set_.has(ElbowInner, side))
    elbow = (marker(Elbow, side) + marker(ElbowInner, side)) / 2;
  else
    elbow = chord_centre(shoulder, marker(Elbow, side), inward_at_elbow(side, shoulder, wrist),
                         elbow_width_of_leg * sizes_.leg / 2 + marker_radius_m);
  put(left ? joints::left_elbow : joints::right_elbow, elbow);
  put(left ? joints::left_wrist : joints::right_wrist, wrist);
}

void FrameSolver::hand(std::size_t side) {
  const bool left = side == 0;
  const Vec3 elbow = joint(left ? joints::left_elbow : joints::right_elbow);
  const Vec3 wrist = joint(left ? joints::left_wrist : joints::right_wrist);
  Vec3 hand = elbow + hand_beyond_forearm * (wrist - elbow);
  if (set_.has(Hand, side)) {
    hand = marker(Hand, side);
    if (set_.has(WristThumb, side) && set_.has(WristLittle, side)) {
      const Vec3 back_of_hand =
          sides[side] *
          (marker(WristThumb, side) - marker(WristLittle, side)).cross(hand - wrist).stableNormalized();
      hand -= (marker_radius_m + hand_depth_m) * back_of_hand;
    }
  }
  put(left ? joints::left_hand : joints::right_hand, hand);
}

Pose FrameSolver::solve() {
  pelvis();
  trunk();
  head();
  for (const std::size_t side : {0U, 1U}) {
    leg(side);
    foot(side);
    arm(side);
    hand(side);
  }
  return pose_;
}

Sizes sizes_of(const MarkerSet& set, const std::vector<Positions>& frames, double metres_per_unit) {
  std::vector<double> widths, depths, legs;
  const std::size_t step = std::max<std::size_t>(1, frames.size() / 500);
  for (std::size_t f = 0; f < frames.size(); f += step) {
    const FrameSolver frame(set, {}, frames[f] * metres_per_unit);
    const Vec3 left = frame.marker(PelvisFront, 0), right = frame.marker(PelvisFront, 1);
    widths.push_back((left - right).norm());
    depths.push_back(((left + right) / 2 - frame.pelvis_back()).norm());
    legs.push_back((left - frame.marker(Knee, 0)).norm() +
                   (frame.marker(Knee, 0) - frame.marker(Ankle, 0)).norm());
  }
  // The hip is some 8 cm below the marker at the front of the pelvis.
  return {upper_median(widths), upper_median(depths), upper_median(legs) - 0.08};
}

}  // namespace

std::vector<std::string> missing_markers(const MarkerModel& model, const std::vector<std::string>& points) {
  const MarkerSet set(model, points);
  std::vector<std::string> missing;
  const auto need = [&](bool there, MarkerPlace place, std::size_t side) {
    const auto& names = model.names[static_cast<std::size_t>(place)][side];
    if (!there && !names.empty()) missing.push_back(names.front());
  };
  need(set.has(Neck), Neck, 0);
  need(set.has(Clavicle) || set.has(Sternum), Clavicle, 0);
  const bool head = set.has(HeadTop) || set.has_both(HeadFrontSide);
  need(head, model.names[static_cast<std::size_t>(HeadTop)][0].empty() ? HeadFrontSide : HeadTop, 0);
  for (const std::size_t side : {0U, 1U}) {
    need(set.has(PelvisBack, side) || set.has(Sacrum), PelvisBack, side);
    for (const MarkerPlace place : {PelvisFront, Shoulder, Elbow, Knee, Ankle, Toe})
      need(set.has(place, side), place, side);
    need(set.has(WristThumb, side) || set.has(WristLittle, side), WristThumb, side);
  }
  return missing;
}

double unit_of_markers(const MarkerModel& model, const NamedMotion& markers) {
  const MarkerSet set(model, markers.points);
  std::vector<double> legs;
  const std::size_t step = std::max<std::size_t>(1, markers.frames.size() / 100);
  for (std::size_t f = 0; f < markers.frames.size(); f += step) {
    const FrameSolver frame(set, {}, markers.frames[f]);
    const double leg = (frame.marker(PelvisFront, 0) - frame.marker(Knee, 0)).norm() +
                       (frame.marker(Knee, 0) - frame.marker(Ankle, 0)).norm();
    if (std::isfinite(leg)) legs.push_back(leg);
  }
  constexpr double usual_leg_m = 0.90;
  const double leg = legs.empty() ? usual_leg_m : upper_median(legs);
  double best = 1;
  for (const double unit : {1.0, 0.0254, 0.01, 0.001})
    if (std::abs(std::log(leg * unit / usual_leg_m)) < std::abs(std::log(leg * best / usual_leg_m)))
      best = unit;
  return best;
}

Result<NamedMotion> joints_of_markers(const MarkerModel& model, const NamedMotion& markers,
                                      double metres_per_unit) {
  NamedMotion joints = markers;
  // What is not needed and has gaps is done without.
  std::vector<std::string> whole = markers.points, with_gaps;
  for (std::size_t p = 0; p < whole.size(); ++p)
    if (!gaps_of(markers, {static_cast<int>(p)}).empty()) with_gaps.push_back(std::exchange(whole[p], ""));
  const bool without = missing_markers(model, whole).empty();
  const MarkerSet set(model, without ? whole : markers.points);
  if (const std::string gaps = gaps_of(markers, set.all()); !gaps.empty())
    return Error{
        gaps +
            ", and nothing near it moves with it; fill the gap in the capturing program, or cut these "
            "frames off",
        markers.name};
  if (!with_gaps.empty())
    joints.warnings.push_back(
        {"done-without", 0, some_of(with_gaps) + ": not always seen, and done without"});
  const Sizes sizes = sizes_of(set, markers.frames, metres_per_unit);
  joints.points.assign(joint_names.begin(), joint_names.end());
  joints.parents.assign(joint_parents.begin(), joint_parents.end());
  for (Positions& frame : joints.frames)
    frame = FrameSolver(set, sizes, frame * metres_per_unit).solve() / metres_per_unit;
  return joints;
}

}  // namespace abrazo
