#include "core/motion/joints/marker_model.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/statistics.hpp"
#include "core/motion/body/body_proportions.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/motion/joints/marker_gaps.hpp"
#include "core/motion/joints/marker_geometry.hpp"
#include "core/motion/joints/marker_hips.hpp"
#include "core/motion/joints/marker_set.hpp"
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
constexpr double head_of_trunk = 0.41;              ///< from the neck's base on, of root to neck
constexpr double half_neck_of_shoulders = 1.0 / 6;  ///< from C7 or the collar bones to the neck's base
constexpr double neck_above_shoulders = 0.06;       ///< both of the distance between the acromia
constexpr double lower_back_share = 0.265, upper_back_share = 0.527,
                 thorax_share = 0.79;  ///< of root to neck

constexpr double sides[2] = {1.0, -1.0};

/// Sizes of one person, the same in all frames [m].
struct Sizes {
  double pelvis_width = 0, pelvis_depth = 0, leg = 0;
  std::array<Vec3, 2> hips{Vec3::Zero(), Vec3::Zero()};  ///< HipCentres::places
};

/// One frame of markers in metres, and the joints found so far.
class FrameSolver {
 public:
  FrameSolver(const MarkerSet& set, const Sizes& sizes, Positions frame)
      : set_(set), sizes_(sizes), frame_(std::move(frame)) {}
  Vec3 marker(MarkerPlace place, std::size_t side = 0) const {
    return frame_.row(set_.of(place, side)).transpose();
  }
  Vec3 middle(MarkerPlace place) const { return (marker(place, 0) + marker(place, 1)) / 2; }
  Pose solve();

 private:
  Vec3 joint(int index) const { return pose_.row(index).transpose(); }
  void put(int index, const Vec3& place) { pose_.row(index) = place.transpose(); }
  void pelvis();
  Vec3 neck_base() const;
  void trunk();
  void head();
  void leg(std::size_t side);
  Vec3 toe_marker(std::size_t side, const Vec3& heel) const;
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
  const Vec3 left = marker(PelvisFront, 0), right = marker(PelvisFront, 1), back = pelvis_back(set_, frame_);
  const Vec3 front = (left + right) / 2;
  const Eigen::Matrix3d axes = pelvis_axes(left, right, back);
  left_ = axes.col(0);
  put(joints::Root, (front + back) / 2);
  put(joints::left_hip, front + axes * sizes_.hips[0]);
  put(joints::right_hip, front + axes * sizes_.hips[1]);
}

/// Between C7 and the collar bones; where one of both is not marked, as far from the other as in an average
/// adult, and above the shoulders where neither is.
Vec3 FrameSolver::neck_base() const {
  std::optional<Vec3> front;
  if (set_.has(Clavicle))
    front = marker(Clavicle);
  else if (set_.has_both(ClavicleSide))
    front = middle(ClavicleSide);
  else if (set_.has(Sternum))
    front = marker(Sternum);
  if (front && set_.has(Neck)) return (marker(Neck) + *front) / 2;
  const Vec3 across = marker(Shoulder, 0) - marker(Shoulder, 1), between = middle(Shoulder);
  const Vec3 trunk = between - joint(joints::Root);
  const Vec3 forward = across.cross(trunk).normalized();
  if (front) return *front - half_neck_of_shoulders * across.norm() * forward;
  if (set_.has(Neck)) return marker(Neck) + half_neck_of_shoulders * across.norm() * forward;
  return between + neck_above_shoulders * across.norm() * trunk.normalized();
}

/// The spine is a parabola from the root over the middle of the chest to the neck's base.
void FrameSolver::trunk() {
  const Vec3 root = joint(joints::Root);
  neck_ = neck_base();
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
  Vec3 centre;
  if (set_.has_both(HeadFrontSide) && set_.has_both(HeadBackSide)) {
    const Vec3 front = middle(HeadFrontSide), back = middle(HeadBackSide);
    const Vec3 left = marker(HeadFrontSide, 0) - marker(HeadFrontSide, 1);
    const Vec3 up = (front - back).cross(left).normalized();
    centre = (front + back) / 2 - head_below_band_m * up;
  } else if (set_.has_both(Ear)) {
    centre = middle(Ear);
  } else if (set_.has(HeadTop)) {
    centre = marker(HeadTop) + head_below_top_m * (neck_ - marker(HeadTop)).normalized();
  } else if (set_.has_both(HeadFrontSide)) {
    centre = middle(HeadFrontSide);
  } else {
    centre = neck_ + head_of_trunk * (neck_ - joint(joints::Root));
  }
  put(joints::Head, centre);
  put(joints::UpperNeck, (neck_ + centre) / 2);
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

/// The head of the 2nd metatarsal; of an outer or inner one alone, what of the foot's line is beside it.
Vec3 FrameSolver::toe_marker(std::size_t side, const Vec3& heel) const {
  if (set_.has(Toe, side)) return marker(Toe, side);
  if (set_.has(ToeInner, side) && set_.has(ToeOuter, side))
    return (marker(ToeInner, side) + marker(ToeOuter, side)) / 2;
  const Vec3 beside = marker(set_.has(ToeOuter, side) ? ToeOuter : ToeInner, side);
  if (!set_.has(ToeTip, side)) return beside;
  const Vec3 foot = marker(ToeTip, side) - heel;
  return foot.squaredNorm() > 0 ? Vec3(heel + (beside - heel).dot(foot) / foot.squaredNorm() * foot) : beside;
}

void FrameSolver::foot(std::size_t side) {
  const bool left = side == 0;
  const Vec3 ankle = joint(left ? joints::left_ankle : joints::right_ankle);
  const Vec3 heel = set_.has(Heel, side) ? marker(Heel, side) : ankle;
  const Vec3 toe = toe_marker(side, heel);
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
  } else if (set_.has(HandThumb, side) && set_.has(HandLittle, side)) {
    hand = (marker(HandThumb, side) + marker(HandLittle, side)) / 2;
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
    const Positions metres = frames[f] * metres_per_unit;
    const FrameSolver frame(set, {}, metres);
    const Vec3 left = frame.marker(PelvisFront, 0), right = frame.marker(PelvisFront, 1);
    widths.push_back((left - right).norm());
    depths.push_back(((left + right) / 2 - pelvis_back(set, metres)).norm());
    legs.push_back((left - frame.marker(Knee, 0)).norm() +
                   (frame.marker(Knee, 0) - frame.marker(Ankle, 0)).norm());
  }
  // The hip is some 8 cm below the marker at the front of the pelvis.
  return {upper_median(widths), upper_median(depths), upper_median(legs) - 0.08};
}

/// The joints that no marker is near to.
std::vector<int> inferred_joints(const MarkerSet& set) {
  using namespace joints;
  std::vector<int> inferred;
  const bool front = set.has(Clavicle) || set.has_both(ClavicleSide) || set.has(Sternum);
  if (!front || !set.has(Neck)) inferred.push_back(LowerNeck);
  if (!set.has_both(HeadFrontSide) && !set.has_both(Ear) && !set.has(HeadTop))
    inferred.insert(inferred.end(), {UpperNeck, Head});
  for (const std::size_t side : {0U, 1U}) {
    if (!set.has(ToeTip, side) && !set.has(Heel, side))
      inferred.push_back(side == 0 ? left_toe_tip : right_toe_tip);
    if (!set.has(Hand, side) && !(set.has(HandThumb, side) && set.has(HandLittle, side)))
      inferred.push_back(side == 0 ? left_hand : right_hand);
  }
  return inferred;
}

std::vector<std::string> names_of_inferred(const std::vector<int>& joint_list) {
  std::vector<std::string> names;
  for (const int joint : joint_list) names.emplace_back(joint_names[static_cast<std::size_t>(joint)]);
  return names;
}

}  // namespace

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
  joints.inferred_joints = inferred_joints(set);
  if (!joints.inferred_joints.empty())
    joints.warnings.push_back(
        {"inferred-joints", 0,
         std::to_string(joints.inferred_joints.size()) +
             " of the 25 joints have no marker and were inferred from those beside them: " +
             some_of(names_of_inferred(joints.inferred_joints), 25)});
  Sizes sizes = sizes_of(set, markers.frames, metres_per_unit);
  const HipCentres hips =
      hip_centres(set, markers.frames, metres_per_unit, sizes.pelvis_width, sizes.pelvis_depth);
  sizes.hips = hips.places;
  if (const std::string words = hips.words(); !words.empty())
    joints.warnings.push_back({"functional-joints", 0, words});
  joints.points.assign(joint_names.begin(), joint_names.end());
  joints.parents.assign(joint_parents.begin(), joint_parents.end());
  for (Positions& frame : joints.frames)
    frame = FrameSolver(set, sizes, frame * metres_per_unit).solve() / metres_per_unit;
  return joints;
}

}  // namespace abrazo
