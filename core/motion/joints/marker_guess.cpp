#include "core/motion/joints/marker_guess.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/statistics.hpp"

namespace abrazo {
namespace {

using enum MarkerPlace;

constexpr std::size_t fewest_markers = 12, most_frames = 160;
constexpr double no_place_cost = 9;  ///< of a marker that is left without a place
constexpr double rigid = 0.006;      ///< change of a distance within a segment [body heights]

/// Parts that move as one.
enum class Segment { Head, Trunk, Pelvis, UpperArm, Forearm, Hand, Thigh, Shank, Foot };

/// A place of the standing person: x to the left, y up from the floor, z to the front [body heights].
struct PlaceOnBody {
  MarkerPlace place;
  Segment segment;
  Vec3 at;
  double spread;  ///< over persons and laboratories, one standard deviation
  double rarity;  ///< cost of being used at all
};

const std::vector<PlaceOnBody>& places_on_body() {
  // Proportions of an adult (Drillis and Contini 1966); markers lie about a centimetre off the skin.
  static const std::vector<PlaceOnBody> places = {
      {Neck, Segment::Trunk, {0, 0.855, -0.06}, 0.025, 0},
      {Back, Segment::Trunk, {0, 0.72, -0.085}, 0.035, 0},
      {Clavicle, Segment::Trunk, {0, 0.815, 0.04}, 0.025, 0},
      {Sternum, Segment::Trunk, {0, 0.735, 0.065}, 0.03, 0},
      {Sacrum, Segment::Pelvis, {0, 0.58, -0.085}, 0.025, 0.5},
      {HeadTop, Segment::Head, {0, 1.0, 0.0}, 0.02, 1},
      {HeadFront, Segment::Head, {0, 0.955, 0.06}, 0.025, 1},
      {HeadSide, Segment::Head, {0.05, 0.95, 0.01}, 0.025, 2},
      {HeadFrontSide, Segment::Head, {0.042, 0.955, 0.05}, 0.025, 0},
      {HeadBackSide, Segment::Head, {0.042, 0.955, -0.05}, 0.025, 0},
      {Ear, Segment::Head, {0.045, 0.93, 0.0}, 0.02, 1},
      {ClavicleSide, Segment::Trunk, {0.025, 0.82, 0.04}, 0.02, 1.5},
      {PelvisFront, Segment::Pelvis, {0.072, 0.565, 0.055}, 0.025, 0},
      {PelvisBack, Segment::Pelvis, {0.028, 0.575, -0.08}, 0.025, 0},
      {Shoulder, Segment::Trunk, {0.105, 0.84, -0.015}, 0.025, 0},
      {Thigh, Segment::Thigh, {0.085, 0.41, 0.02}, 0.045, 0},
      {Knee, Segment::Thigh, {0.085, 0.28, 0.0}, 0.025, 0},
      {KneeInner, Segment::Thigh, {0.025, 0.28, 0.0}, 0.025, 0},
      {Shin, Segment::Shank, {0.07, 0.17, 0.0}, 0.04, 0},
      {Ankle, Segment::Shank, {0.075, 0.045, -0.025}, 0.02, 0},
      {AnkleInner, Segment::Shank, {0.03, 0.05, -0.015}, 0.02, 0},
      {Heel, Segment::Foot, {0.05, 0.03, -0.06}, 0.02, 0},
      {Toe, Segment::Foot, {0.062, 0.032, 0.075}, 0.022, 0},
      {ToeInner, Segment::Foot, {0.042, 0.028, 0.075}, 0.02, 1},
      {ToeOuter, Segment::Foot, {0.088, 0.02, 0.045}, 0.02, 1},
      {ToeTip, Segment::Foot, {0.055, 0.02, 0.11}, 0.02, 1.5},
  };
  return places;
}

/// The arm's places: raised to the side by `raised`, the elbow bent to the front by `bent` [rad].
std::vector<PlaceOnBody> places_on_arm(double raised, double bent) {
  const Vec3 shoulder(0.105, 0.815, -0.01), front(0, 0, 1);
  const Vec3 upper(std::sin(raised), -std::cos(raised), 0);
  const Vec3 outward(std::cos(raised), std::sin(raised), 0);
  const Vec3 fore = std::cos(bent) * upper + std::sin(bent) * front;
  // The thumb shows to the front of a hanging arm, and inward of one that is bent.
  const Vec3 thumb = std::cos(bent) * front - std::sin(bent) * (0.6 * outward + 0.8 * upper);
  const Vec3 elbow = shoulder + 0.175 * upper, wrist = elbow + 0.145 * fore, hand = wrist + 0.05 * fore;
  return {
      {UpperArm, Segment::UpperArm, shoulder + 0.09 * upper + 0.03 * outward, 0.035, 0.5},
      {Elbow, Segment::UpperArm, elbow + 0.026 * outward, 0.03, 0},
      {ElbowInner, Segment::UpperArm, elbow - 0.026 * outward, 0.03, 0},
      {WristThumb, Segment::Forearm, wrist + 0.022 * thumb, 0.03, 0},
      {WristLittle, Segment::Forearm, wrist - 0.022 * thumb, 0.03, 0},
      {Hand, Segment::Hand, hand + 0.01 * outward, 0.03, 0},
      {HandThumb, Segment::Hand, hand + 0.022 * thumb, 0.025, 0.5},
      {HandLittle, Segment::Hand, hand - 0.022 * thumb, 0.025, 0.5},
  };
}

bool has_two_sides(MarkerPlace place) {
  return static_cast<std::size_t>(place) >= first_sided_place;
}

/// A place with its side.
struct Slot {
  PlaceOnBody on_body;
  std::size_t side = 0;
  Vec3 at() const { return side == 0 ? on_body.at : Vec3(-on_body.at.x(), on_body.at.y(), on_body.at.z()); }
};

std::vector<Slot> slots_of(double raised, double bent) {
  std::vector<PlaceOnBody> all = places_on_body();
  for (const PlaceOnBody& place : places_on_arm(raised, bent)) all.push_back(place);
  std::vector<Slot> slots;
  for (const PlaceOnBody& place : all)
    for (std::size_t side = 0; side < (has_two_sides(place.place) ? 2U : 1U); ++side)
      slots.push_back({place, side});
  return slots;
}

/// The cheapest assignment of rows to columns, each column once (Kuhn 1955, by shortest augmenting paths).
/// @param cost  rows <= columns  @return the column of each row
std::vector<int> cheapest_assignment(const Eigen::MatrixXd& cost) {
  const int rows = static_cast<int>(cost.rows()), columns = static_cast<int>(cost.cols());
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::vector<double> of_row(static_cast<std::size_t>(rows) + 1),
      of_column(static_cast<std::size_t>(columns) + 1);
  std::vector<int> row_of(static_cast<std::size_t>(columns) + 1), way(static_cast<std::size_t>(columns) + 1);
  const auto at = [](auto& values, int i) -> auto& {
    return values[static_cast<std::size_t>(i)];
  };
  for (int row = 1; row <= rows; ++row) {
    at(row_of, 0) = row;
    int column = 0;
    std::vector<double> least(static_cast<std::size_t>(columns) + 1, infinite);
    std::vector<char> used(static_cast<std::size_t>(columns) + 1, 0);
    do {
      at(used, column) = 1;
      const int now = at(row_of, column);
      double step = infinite;
      int next = 0;
      for (int c = 1; c <= columns; ++c) {
        if (at(used, c)) continue;
        const double reduced = cost(now - 1, c - 1) - at(of_row, now) - at(of_column, c);
        if (reduced < at(least, c)) at(least, c) = reduced, at(way, c) = column;
        if (at(least, c) < step) step = at(least, c), next = c;
      }
      for (int c = 0; c <= columns; ++c)
        if (at(used, c))
          at(of_row, at(row_of, c)) += step, at(of_column, c) -= step;
        else
          at(least, c) -= step;
      column = next;
    } while (at(row_of, column) != 0);
    do {
      const int before = at(way, column);
      at(row_of, column) = at(row_of, before);
      column = before;
    } while (column != 0);
  }
  std::vector<int> columns_of(static_cast<std::size_t>(rows), -1);
  for (int c = 1; c <= columns; ++c)
    if (at(row_of, c) > 0) at(columns_of, at(row_of, c) - 1) = c - 1;
  return columns_of;
}

/// Frames of the motion, Y up, with most markers seen.
std::vector<Positions> upright_frames(const NamedMotion& motion, UpAxis up) {
  std::vector<Positions> frames;
  const std::size_t step = std::max<std::size_t>(1, motion.frames.size() / most_frames);
  for (std::size_t f = 0; f < motion.frames.size(); f += step) {
    Positions frame = motion.frames[f];
    turn_to_y_up(frame, up);
    Eigen::Index seen = 0;
    for (Eigen::Index p = 0; p < frame.rows(); ++p) seen += frame.row(p).allFinite() ? 1 : 0;
    if (3 * seen >= 2 * frame.rows()) frames.push_back(std::move(frame));
  }
  return frames;
}

double extent_along(const NamedMotion& motion, int axis) {
  std::vector<double> extents;
  for (const Positions& frame : motion.frames) {
    double low = 1e300, high = -1e300;
    for (Eigen::Index p = 0; p < frame.rows(); ++p)
      if (std::isfinite(frame(p, axis)))
        low = std::min(low, frame(p, axis)), high = std::max(high, frame(p, axis));
    if (high > low) extents.push_back(high - low);
  }
  return extents.empty() ? 0 : quantile(extents, 0.5);
}

/// Mean and standard deviation over time of the distances between markers.
struct Distances {
  Eigen::MatrixXd mean, deviation;
};

Distances distances_over_time(const std::vector<Positions>& frames) {
  const Eigen::Index n = frames.front().rows();
  Distances found{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n)};
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < i; ++j) {
      double sum = 0, squares = 0, seen = 0;
      for (const Positions& frame : frames) {
        const double distance = (frame.row(i) - frame.row(j)).norm();
        if (std::isfinite(distance)) sum += distance, squares += distance * distance, ++seen;
      }
      const double mean = seen > 0 ? sum / seen : 1e9;
      found.mean(i, j) = found.mean(j, i) = mean;
      found.deviation(i, j) = found.deviation(j, i) =
          seen > 1 ? std::sqrt(std::max(0.0, squares / seen - mean * mean)) : 1e9;
    }
  return found;
}

/// Markers of the trunk and the pelvis, which turn with the person: those between hip and neck height of
/// which most keep their distance to each other.
std::vector<Eigen::Index> core_markers(const Eigen::VectorXd& heights, const Distances& distances) {
  std::vector<Eigen::Index> best;
  for (Eigen::Index seed = 0; seed < heights.size(); ++seed) {
    if (heights[seed] < 0.5 || heights[seed] > 0.9) continue;
    std::vector<Eigen::Index> group = {seed};
    std::vector<Eigen::Index> others;
    for (Eigen::Index i = 0; i < heights.size(); ++i)
      if (i != seed && heights[i] > 0.5 && heights[i] < 0.9) others.push_back(i);
    std::ranges::sort(others, {}, [&](Eigen::Index i) { return distances.deviation(seed, i); });
    for (const Eigen::Index i : others)
      if (std::ranges::all_of(group, [&](Eigen::Index g) { return distances.deviation(g, i) < 2.5 * rigid; }))
        group.push_back(i);
    if (group.size() > best.size()) best = group;
  }
  return best;
}

/// The markers in the space of the trunk [body heights].
struct MeanBody {
  Positions places;          ///< mean over time; y from the floor
  Eigen::Vector2d walks_to;  ///< sum of the steps, x and z of that space
};

Eigen::Matrix2d turn_between(const Positions& from, const Positions& to,
                             const std::vector<Eigen::Index>& which, Eigen::Vector2d& from_middle,
                             Eigen::Vector2d& to_middle) {
  from_middle.setZero(), to_middle.setZero();
  double seen = 0;
  const auto both = [&](Eigen::Index p) { return from.row(p).allFinite() && to.row(p).allFinite(); };
  for (const Eigen::Index p : which)
    if (both(p))
      from_middle += Eigen::Vector2d(from(p, 0), from(p, 2)),
          to_middle += Eigen::Vector2d(to(p, 0), to(p, 2)), ++seen;
  if (seen < 2) return Eigen::Matrix2d::Constant(std::nan(""));
  from_middle /= seen, to_middle /= seen;
  double along = 0, across = 0;
  for (const Eigen::Index p : which)
    if (both(p)) {
      const Eigen::Vector2d a = Eigen::Vector2d(from(p, 0), from(p, 2)) - from_middle;
      const Eigen::Vector2d b = Eigen::Vector2d(to(p, 0), to(p, 2)) - to_middle;
      along += a.dot(b), across += a.x() * b.y() - a.y() * b.x();
    }
  return Eigen::Rotation2Dd(std::atan2(across, along)).toRotationMatrix();
}

MeanBody mean_body(const std::vector<Positions>& frames, const std::vector<Eigen::Index>& core) {
  const Eigen::Index n = frames.front().rows();
  std::size_t fullest = 0;
  Eigen::Index most = -1;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    Eigen::Index seen = 0;
    for (Eigen::Index p = 0; p < n; ++p) seen += frames[f].row(p).allFinite() ? 1 : 0;
    if (seen > most) most = seen, fullest = f;
  }
  MeanBody body;
  body.places = frames[fullest];
  for (int round = 0; round < 3; ++round) {
    Positions sum = Positions::Zero(n, 3);
    Eigen::VectorXd seen = Eigen::VectorXd::Zero(n);
    Eigen::Vector2d last_place = Eigen::Vector2d::Constant(std::nan(""));
    body.walks_to.setZero();
    for (const Positions& frame : frames) {
      Eigen::Vector2d middle, reference;
      const Eigen::Matrix2d turn = turn_between(frame, body.places, core, middle, reference);
      if (!turn.allFinite()) continue;
      if (last_place.allFinite()) body.walks_to += turn * (middle - last_place);
      last_place = middle;
      for (Eigen::Index p = 0; p < n; ++p) {
        if (!frame.row(p).allFinite()) continue;
        const Eigen::Vector2d place = turn * (Eigen::Vector2d(frame(p, 0), frame(p, 2)) - middle);
        sum.row(p) += Eigen::RowVector3d(place.x(), frame(p, 1), place.y());
        ++seen[p];
      }
    }
    for (Eigen::Index p = 0; p < n; ++p)
      body.places.row(p) =
          seen[p] > 0 ? (sum.row(p) / seen[p]).eval() : Eigen::RowVector3d::Constant(std::nan("")).eval();
  }
  return body;
}

/// Turned about the vertical by an angle, with the middle between left and right at x = 0.
Positions turned_by(const Positions& places, double angle) {
  Positions turned = places;
  const double c = std::cos(angle), s = std::sin(angle);
  turned.col(0) = c * places.col(0) - s * places.col(2);
  turned.col(2) = s * places.col(0) + c * places.col(2);
  return turned;
}

/// The person of the table moved and stretched so that it lies on the markers.
struct Fit {
  Vec3 scale = Vec3::Ones(), shift = Vec3::Zero();
  Vec3 of(const Vec3& place) const { return scale.cwiseProduct(place) + shift; }
};

struct Assignment {
  std::vector<int> slot;  ///< of each marker; -1: none
  double cost = 0;
};

Eigen::MatrixXd place_costs(const Positions& markers, const std::vector<Slot>& slots, const Fit& fit) {
  Eigen::MatrixXd cost(markers.rows(), static_cast<Eigen::Index>(slots.size()));
  for (Eigen::Index m = 0; m < cost.rows(); ++m)
    for (Eigen::Index s = 0; s < cost.cols(); ++s) {
      const Slot& slot = slots[static_cast<std::size_t>(s)];
      const double off = (markers.row(m).transpose() - fit.of(slot.at())).norm() / slot.on_body.spread;
      cost(m, s) = std::isfinite(off) ? std::min(off * off / 2 + slot.on_body.rarity, 40.0) : 40.0;
    }
  return cost;
}

Assignment assign(const Eigen::MatrixXd& cost) {
  Eigen::MatrixXd with_none(cost.rows(), cost.cols() + cost.rows());
  with_none.leftCols(cost.cols()) = cost;
  with_none.rightCols(cost.rows()).setConstant(no_place_cost);
  Assignment found{cheapest_assignment(with_none), 0};
  for (std::size_t m = 0; m < found.slot.size(); ++m) {
    found.cost += with_none(static_cast<Eigen::Index>(m), found.slot[m]);
    if (found.slot[m] >= cost.cols()) found.slot[m] = -1;
  }
  return found;
}

/// Markers that lie left and right of the middle as in a mirror: first the left one.
std::vector<std::pair<Eigen::Index, Eigen::Index>> mirrored_pairs(const Positions& markers, double middle) {
  constexpr double farthest = 0.06;
  const auto nearest_of_mirrored = [&](Eigen::Index m) {
    const Eigen::RowVector3d mirrored(2 * middle - markers(m, 0), markers(m, 1), markers(m, 2));
    Eigen::Index nearest = -1;
    double least = farthest;
    for (Eigen::Index other = 0; other < markers.rows(); ++other)
      if (const double off = (markers.row(other) - mirrored).norm(); off < least)
        least = off, nearest = other;
    return nearest;
  };
  std::vector<std::pair<Eigen::Index, Eigen::Index>> pairs;
  for (Eigen::Index m = 0; m < markers.rows(); ++m) {
    const Eigen::Index mate = nearest_of_mirrored(m);
    if (mate >= 0 && mate != m && markers(m, 0) > markers(mate, 0) && nearest_of_mirrored(mate) == m)
      pairs.emplace_back(m, mate);
  }
  return pairs;
}

/// Both of a pair at the two sides of one place; then the others at what is left.
Assignment assign_in_pairs(const Eigen::MatrixXd& cost, const std::vector<Slot>& slots,
                           const std::vector<std::pair<Eigen::Index, Eigen::Index>>& pairs) {
  std::vector<Eigen::Index> left_slots;  // the right one follows
  for (std::size_t s = 0; s < slots.size(); ++s)
    if (has_two_sides(slots[s].on_body.place) && slots[s].side == 0)
      left_slots.push_back(static_cast<Eigen::Index>(s));
  const auto n_pairs = static_cast<Eigen::Index>(pairs.size()),
             n_places = static_cast<Eigen::Index>(left_slots.size());
  Eigen::MatrixXd both(n_pairs, n_places + n_pairs);
  both.setConstant(2 * no_place_cost);
  for (Eigen::Index p = 0; p < n_pairs; ++p)
    for (Eigen::Index s = 0; s < n_places; ++s) {
      const auto& [left, right] = pairs[static_cast<std::size_t>(p)];
      const Eigen::Index slot = left_slots[static_cast<std::size_t>(s)];
      both(p, s) = cost(left, slot) + cost(right, slot + 1);
    }
  Eigen::MatrixXd rest = cost;
  Assignment found{std::vector<int>(static_cast<std::size_t>(cost.rows()), -1), 0};
  const std::vector<int> places = pairs.empty() ? std::vector<int>() : cheapest_assignment(both);
  for (std::size_t p = 0; p < places.size(); ++p) {
    if (places[p] >= n_places) continue;
    const Eigen::Index slot = left_slots[static_cast<std::size_t>(places[p])];
    for (const auto& [marker, taken] :
         {std::pair(pairs[p].first, slot), std::pair(pairs[p].second, slot + 1)}) {
      found.slot[static_cast<std::size_t>(marker)] = static_cast<int>(taken);
      rest.row(marker).setConstant(40), rest.col(taken).setConstant(40);
    }
  }
  const Assignment others = assign(rest);
  for (std::size_t m = 0; m < found.slot.size(); ++m)
    if (found.slot[m] < 0) found.slot[m] = others.slot[m];
  for (std::size_t m = 0; m < found.slot.size(); ++m)
    found.cost += found.slot[m] < 0 ? no_place_cost : cost(static_cast<Eigen::Index>(m), found.slot[m]);
  return found;
}

/// Per axis the scale and shift that bring the places nearest to their markers; held near one.
Fit fit_to(const Positions& markers, const std::vector<Slot>& slots, const Assignment& assignment) {
  Fit fit;
  for (int axis = 0; axis < 3; ++axis) {
    double n = 0, a = 0, b = 0, aa = 0, ab = 0;
    for (std::size_t m = 0; m < assignment.slot.size(); ++m) {
      if (assignment.slot[m] < 0) continue;
      const double from = slots[static_cast<std::size_t>(assignment.slot[m])].at()[axis];
      const double to = markers(static_cast<Eigen::Index>(m), axis);
      n += 1, a += from, b += to, aa += from * from, ab += from * to;
    }
    constexpr double towards_one = 0.02;
    const double spread = aa - a * a / std::max(n, 1.0) + towards_one;
    const double scale = n > 0 ? (ab - a * b / n + towards_one) / spread : 1;
    // Heights follow from the highest marker; broad and narrow persons differ more.
    fit.scale[axis] = axis == 1 ? std::clamp(scale, 0.95, 1.05) : std::clamp(scale, 0.8, 1.25);
    fit.shift[axis] = n > 0 ? (b - fit.scale[axis] * a) / n : 0;
  }
  return fit;
}

/// What markers of one segment say of another that is said to be on it.
void add_rigidity(const std::vector<Slot>& slots, const Assignment& assignment, const Distances& distances,
                  Eigen::MatrixXd& cost) {
  for (Eigen::Index m = 0; m < cost.rows(); ++m)
    for (Eigen::Index s = 0; s < cost.cols(); ++s) {
      const Slot& slot = slots[static_cast<std::size_t>(s)];
      std::vector<double> changes;
      for (std::size_t other = 0; other < assignment.slot.size(); ++other) {
        if (assignment.slot[other] < 0 || static_cast<Eigen::Index>(other) == m) continue;
        const Slot& mate = slots[static_cast<std::size_t>(assignment.slot[other])];
        const bool has_sides = slot.on_body.segment > Segment::Pelvis;
        if (mate.on_body.segment != slot.on_body.segment || (has_sides && mate.side != slot.side)) continue;
        changes.push_back(distances.deviation(m, static_cast<Eigen::Index>(other)));
      }
      if (changes.empty()) continue;
      const double change = quantile(changes, 0.3) / rigid;
      cost(m, s) += std::min(6.0, 0.15 * change * change);
    }
}

/// Which of the two a marker is: the share of the best place against the next, and how well it lies there.
double confidence_of(const Eigen::MatrixXd& cost, Eigen::Index marker, int slot) {
  const double own = cost(marker, slot);
  double others = std::exp(-no_place_cost);
  for (Eigen::Index s = 0; s < cost.cols(); ++s) {
    if (s == slot || cost(marker, s) >= 40) continue;
    others += std::exp(-cost(marker, s));
  }
  return std::exp(-own) / (std::exp(-own) + others) * std::exp(-0.12 * own);
}

struct Best {
  Assignment assignment;
  Eigen::MatrixXd cost;
  std::vector<Slot> slots;
};

/// Settles fit, segments and places in turn.
Best settled(const Positions& markers, const std::vector<Slot>& slots, const Distances& distances,
             int rounds) {
  Best best;
  best.slots = slots;
  Fit fit;
  for (int round = 0; round < rounds; ++round) {
    best.cost = place_costs(markers, slots, fit);
    if (round > 1) add_rigidity(slots, best.assignment, distances, best.cost);
    best.assignment = round > 1 ? assign_in_pairs(best.cost, slots, mirrored_pairs(markers, fit.shift.x()))
                                : assign(best.cost);
    fit = fit_to(markers, slots, best.assignment);
  }
  return best;
}

/// Height of the highest marker: on the head, at its temples, or at the neck of a set without a head.
constexpr std::array marker_tops = {1.0, 0.955, 0.855};

/// Arms raised and elbows bent [rad].
constexpr std::array<std::pair<double, double>, 6> arm_poses = {
    {{0.15, 0.2}, {0.2, 0.8}, {0.2, 1.5}, {0.7, 0.3}, {1.5, 0.05}, {0.9, 1.2}}};

constexpr int search_rounds = 3;

/// How the person of the table is held against the markers.
struct Hypothesis {
  double top = 1, angle = 0;
  std::pair<double, double> arms;
};

/// @return the guess, and what it costs against others of the motion
Result<std::pair<MarkerGuess, double>> guess_standing(const NamedMotion& motion, UpAxis up) {
  MarkerGuess guess;
  guess.up_axis = up;
  std::vector<Positions> frames = upright_frames(motion, up);
  if (frames.empty())
    return Error{"has no frame in which two thirds of its points are seen; a guess needs some", motion.name};
  std::vector<double> lows, highs;
  for (const Positions& frame : frames) {
    double low = 1e300, high = -1e300;
    for (Eigen::Index p = 0; p < frame.rows(); ++p)
      if (frame.row(p).allFinite()) low = std::min(low, frame(p, 1)), high = std::max(high, frame(p, 1));
    lows.push_back(low), highs.push_back(high);
  }
  const double floor = quantile(lows, 0.1), height = quantile(highs, 0.5) - floor;
  if (!(height > 0))
    return Error{"its points all lie at one height; a guess needs a standing body", motion.name};
  for (Positions& frame : frames) frame.col(1).array() -= floor, frame /= height;

  const Distances distances = distances_over_time(frames);
  Eigen::VectorXd heights(frames.front().rows());
  for (Eigen::Index p = 0; p < heights.size(); ++p) {
    std::vector<double> seen;
    for (const Positions& frame : frames)
      if (std::isfinite(frame(p, 1))) seen.push_back(frame(p, 1));
    heights[p] = seen.empty() ? -1 : quantile(seen, 0.5);
  }
  std::vector<Eigen::Index> core = core_markers(heights, distances);
  if (core.size() < 3) {
    core.resize(static_cast<std::size_t>(heights.size()));
    std::iota(core.begin(), core.end(), Eigen::Index{0});
  }
  const MeanBody body = mean_body(frames, core);
  constexpr double walks_at_least = 0.5;  // body heights
  guess.front_from_walking = body.walks_to.norm() > walks_at_least;

  Best best;
  double least = std::numeric_limits<double>::infinity();
  Hypothesis nearest;
  constexpr int turns = 36;
  for (const double top : marker_tops)
    for (int turn = 0; turn < turns; ++turn) {
      const double angle = 2 * 3.14159265358979 * turn / turns;
      const Positions markers = top * turned_by(body.places, angle);
      double against_walking = 0;
      if (guess.front_from_walking) {
        // In the turned space the steps go to z when the person walks forward.
        const Eigen::Vector2d to = body.walks_to.normalized();
        against_walking = 10 * (1 - (std::sin(angle) * to.x() + std::cos(angle) * to.y()));
      }
      for (const auto& arms : arm_poses) {
        const Best here = settled(markers, slots_of(arms.first, arms.second), distances, search_rounds);
        if (const double cost = here.assignment.cost + against_walking; cost < least)
          least = cost, nearest = {top, angle, arms};
      }
    }
  best = settled(nearest.top * turned_by(body.places, nearest.angle),
                 slots_of(nearest.arms.first, nearest.arms.second), distances, 6);
  double sum = 0;
  for (std::size_t m = 0; m < best.assignment.slot.size(); ++m) {
    const int slot = best.assignment.slot[m];
    if (slot < 0) continue;
    const Slot& on = best.slots[static_cast<std::size_t>(slot)];
    const double sure = confidence_of(best.cost, static_cast<Eigen::Index>(m), slot);
    guess.markers.push_back({static_cast<int>(m), on.on_body.place, on.side, sure});
    sum += sure;
  }
  std::ranges::sort(guess.markers, {},
                    [](const MarkerGuess::Marker& one) { return std::pair(one.place, one.side); });
  guess.confidence = sum / static_cast<double>(motion.points.size());
  return std::pair(std::move(guess), least);
}

}  // namespace

MarkerModel MarkerGuess::model(const NamedMotion& motion, double least_confidence) const {
  MarkerModel model;
  model.name = motion.name;
  for (const Marker& marker : markers)
    if (marker.confidence >= least_confidence)
      model.names[static_cast<std::size_t>(marker.place)][marker.side] = {
          motion.points[static_cast<std::size_t>(marker.point)]};
  return model;
}

Result<MarkerGuess> guess_markers(const NamedMotion& motion) {
  if (motion.points.size() < fewest_markers)
    return Error{
        "has " + std::to_string(motion.points.size()) + " points; a guess needs 12 markers of a body",
        motion.name};
  const UpAxis up = motion.up_axis.value_or(
      extent_along(motion, 2) > 1.15 * extent_along(motion, 1) ? UpAxis::Z : UpAxis::Y);
  auto standing = guess_standing(motion, up);
  auto hanging = guess_standing(motion, opposite(up));
  if (!standing || !hanging) return standing.error();
  return hanging->second < standing->second ? std::move(hanging->first) : std::move(standing->first);
}

}  // namespace abrazo
