#include "core/motion/files/up_axis_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/statistics.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

using joints::left_ankle, joints::right_ankle, joints::left_toe_base, joints::right_toe_base, joints::Head;

constexpr double usual_standing_m = 1.7;                        ///< from the feet to the head joint
constexpr double lowest_rest_m = -0.10, highest_rest_m = 0.20;  ///< of a joint that rests on a floor at 0

/// From feet to head, along any axis.
Vec3 feet_to_head(const Pose& pose) {
  return (pose.row(Head) - 0.5 * (pose.row(left_ankle) + pose.row(right_ankle))).transpose();
}

class Posture {
 public:
  explicit Posture(const std::vector<Pose>& poses) : poses_(poses) {
    std::vector<double> sizes;
    for (const Pose& pose : poses) sizes.push_back(feet_to_head(pose).norm());
    metre_ = quantile(sizes, 0.9) / usual_standing_m;
  }

  std::size_t frames() const { return poses_.size(); }

  /// Frames in which the person is upright along this axis.
  std::size_t upright(UpAxis up) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(poses_, [&](const Pose& pose) { return is_upright(pose, up); }));
  }

  /// Whether there are frames in which somebody stands along this axis: a tenth of all.
  bool anybody_upright(UpAxis up) const { return 10 * upright(up) >= frames(); }
  bool mostly_upright(UpAxis up) const { return 2 * upright(up) > frames(); }

  /// Whether a floor at 0 lies below the toes and the head is above the feet in a tenth of the frames at
  /// least, if that axis points up.
  bool stands_on_zero(UpAxis up) const {
    const auto [axis, sign] = column_of(up);
    std::vector<double> toes, above;
    for (const Pose& pose : poses_) {
      toes.push_back(std::min(sign * pose(left_toe_base, axis), sign * pose(right_toe_base, axis)));
      const Vec3 upwards = feet_to_head(pose);
      above.push_back(sign * upwards[axis] / upwards.norm());
    }
    return quantile(above, 0.9) > 0.9 && rests_on_zero(toes);
  }

  /// Whether the hands are on a floor at 0, below the head, in most frames in which the person is head down.
  bool stands_on_hands(UpAxis up) const {
    const auto [axis, sign] = column_of(up);
    std::vector<double> hands;
    std::size_t head_down = 0, hands_below = 0;
    for (const Pose& pose : poses_) {
      if (!is_upright(pose, opposite(up))) continue;
      ++head_down;
      const double lower =
          std::min(sign * pose(joints::left_hand, axis), sign * pose(joints::right_hand, axis));
      hands.push_back(lower);
      if (lower < sign * pose(Head, axis)) ++hands_below;
    }
    return 2 * hands_below > head_down && rests_on_zero(hands) && !stands_on_zero(opposite(up));
  }

  /// Whether the whole body stays close above a floor at 0 in most frames.
  bool lies_on_zero(UpAxis up) const {
    constexpr double highest_of_lying_m = 0.6;
    const auto [axis, sign] = column_of(up);
    std::size_t low = 0;
    for (const Pose& pose : poses_) {
      const auto heights = (sign * pose.col(axis)).eval();
      if (heights.minCoeff() > lowest_rest_m * metre_ && heights.maxCoeff() < highest_of_lying_m * metre_)
        ++low;
    }
    return 2 * low > frames();
  }

  /// Median over the frames of the vector from feet to head.
  Vec3 median_upwards() const {
    Vec3 median;
    std::vector<double> values;
    for (int axis = 0; axis < 3; ++axis) {
      values.clear();
      for (const Pose& pose : poses_) values.push_back(feet_to_head(pose)[axis]);
      median[axis] = upper_median(values);
    }
    return median;
  }

 private:
  static bool is_upright(const Pose& pose, UpAxis up) {
    constexpr double within_45_degrees = 0.7;
    const auto [axis, sign] = column_of(up);
    const Vec3 upwards = feet_to_head(pose);
    const double hips = sign * pose(joints::Root, axis);
    const double feet = sign * 0.5 * (pose(left_ankle, axis) + pose(right_ankle, axis));
    return sign * upwards[axis] > within_45_degrees * upwards.norm() && sign * pose(Head, axis) > hips &&
           hips > feet;
  }

  bool rests_on_zero(const std::vector<double>& heights) const {
    if (heights.empty()) return false;
    const double rest = quantile(heights, 0.05);
    return rest > lowest_rest_m * metre_ && rest < highest_rest_m * metre_;
  }

  const std::vector<Pose>& poses_;
  double metre_ = 1;  ///< in the file's unit, by the size of the person
};

ImportWarning axis_remark(std::string detail) {
  return {"up-axis", 0, std::move(detail)};
}

ImportWarning axis_question(std::string detail) {
  return {"up-axis", 0, std::move(detail), Hint::SetUpAxis, true};
}

std::string frames_of(std::size_t frames, const Posture& posture) {
  return std::to_string(frames) + " of " + std::to_string(posture.frames()) + " frames";
}

/// "the head is above the hips and the hips above the feet along Z in 340 of 340 frames".
std::string how_upright(UpAxis up, const Posture& posture) {
  const auto [axis, sign] = column_of(up);
  const char* where = sign > 0 ? "above" : "below";
  return std::string("the head is ") + where + " the hips and the hips " + where + " the feet along " +
         axis_label(sign > 0 ? up : opposite(up)) + " in " + frames_of(posture.upright(up), posture);
}

UpAxisChoice kept_as_handstand(UpAxis up, const Posture& posture, bool is_guess) {
  return {up, is_guess,
          axis_question(
              "the person is head down along " + axis_label(up) + " in " +
              frames_of(posture.upright(opposite(up)), posture) +
              ", with the hands on a floor at 0; that was taken as a handstand, say the axis if it is not")};
}

/// As the file states, unless nobody stands along that axis.
UpAxisChoice stated_axis(UpAxis stated, const Posture& posture) {
  const UpAxisChoice as_stated{stated, false, {}};
  if (posture.anybody_upright(stated)) return as_stated;
  for (const UpAxis other : {UpAxis::Y, UpAxis::Z, UpAxis::MinusY, UpAxis::MinusZ}) {
    if (other == stated || !posture.mostly_upright(other)) continue;
    if (other == opposite(stated)) {
      if (posture.stands_on_hands(stated)) return kept_as_handstand(stated, posture, false);
    } else if (posture.lies_on_zero(stated) && !posture.stands_on_zero(other)) {
      return as_stated;
    }
    return {other, true,
            axis_question("the file says that " + axis_label(stated) + " points up, but " +
                          how_upright(other, posture) + "; " + axis_label(other) +
                          " was taken, say the axis if that is wrong")};
  }
  return as_stated;
}

/// Y unless Z is clear, by the axis from feet to head, median over the frames. A crawling person mostly has
/// the head in front of the feet: then the standing frames decide.
UpAxisChoice guessed_axis(const Posture& posture) {
  const Vec3 up = posture.median_upwards();
  const UpAxis along = up.z() > std::abs(up.y()) ? UpAxis::Z : UpAxis::Y;
  const UpAxis other = along == UpAxis::Y ? UpAxis::Z : UpAxis::Y;
  const auto taken = [](UpAxis axis) {
    return UpAxisChoice{axis, true,
                        axis == UpAxis::Y
                            ? std::nullopt
                            : std::optional(axis_remark("Z was taken as up: the head is above the "
                                                        "feet along it"))};
  };
  if (!posture.stands_on_zero(along) && posture.stands_on_zero(other)) return taken(other);
  if (up[column_of(along).column] >= 0.7 * up.norm()) return taken(along);
  if (!posture.anybody_upright(along) && posture.mostly_upright(UpAxis::MinusY)) {
    if (posture.stands_on_hands(UpAxis::Y)) return kept_as_handstand(UpAxis::Y, posture, true);
    return {UpAxis::MinusY, true,
            axis_question(how_upright(UpAxis::MinusY, posture) +
                          "; -Y was taken as up, say the axis if they stand on their hands")};
  }
  for (const UpAxis unusual : {UpAxis::MinusZ, UpAxis::X, UpAxis::MinusX})
    if (!posture.anybody_upright(along) && posture.mostly_upright(unusual) &&
        posture.stands_on_zero(unusual) && !posture.lies_on_zero(UpAxis::Y) &&
        !posture.lies_on_zero(UpAxis::Z))
      return {unusual, true,
              axis_question(how_upright(unusual, posture) + "; " + axis_label(unusual) +
                            " was taken as up, say the axis if that is wrong")};
  return {along, true,
          axis_question("the head is mostly not above the feet along Y or Z; " + axis_label(along) +
                        " was taken as up, say if it is the other")};
}

}  // namespace

UpAxisChoice choose_up_axis(std::optional<UpAxis> stated, const std::vector<Pose>& poses) {
  const Posture posture(poses);
  return stated ? stated_axis(*stated, posture) : guessed_axis(posture);
}

}  // namespace abrazo
