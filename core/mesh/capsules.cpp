#include "core/mesh/capsules.hpp"

#include <algorithm>

namespace abrazo {

namespace {

constexpr double point_length_sq = 1e-16;    ///< [m^2] a shorter segment is a point
constexpr double parallel_fraction = 1e-12;  ///< sin^2 of the angle below which segments count as parallel

struct Parameters {
  double s = 0;
  double t = 0;
};

/// Minimum of |(a + s u) - (c + t v)|^2 over the unit square, by its stationary point and the clamped edges.
/// u = b - a, v = d - c, w = a - c.
Parameters closest_parameters(const Vec3& u, const Vec3& v, const Vec3& w) {
  const double uu = u.squaredNorm();
  const double vv = v.squaredNorm();
  const double uv = u.dot(v);
  const double uw = u.dot(w);
  const double vw = v.dot(w);
  const auto in_unit = [](double x) { return std::clamp(x, 0.0, 1.0); };
  if (uu < point_length_sq && vv < point_length_sq) return {};
  if (uu < point_length_sq) return {0, in_unit(vw / vv)};
  if (vv < point_length_sq) return {in_unit(-uw / uu), 0};
  const double determinant = uu * vv - uv * uv;
  // Parallel segments have many closest points: any will do, so start from a.
  const double s =
      determinant > parallel_fraction * uu * vv ? in_unit((uv * vw - vv * uw) / determinant) : 0.0;
  const double t = (uv * s + vw) / vv;
  if (t < 0) return {in_unit(-uw / uu), 0};
  if (t > 1) return {in_unit((uv - uw) / uu), 1};
  return {s, t};
}

}  // namespace

SegmentApproach closest_points(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto [s, t] = closest_parameters(b - a, d - c, a - c);
  const Vec3 gap = (a + s * (b - a)) - (c + t * (d - c));
  const double distance = gap.norm();
  return {s, t, distance, distance > 1e-12 ? Vec3(gap / distance) : Vec3(Vec3::Zero())};
}

const CapsuleRadii& generic_capsule_radii() {
  constexpr double thigh = 0.075, shank = 0.05, foot = 0.035, toes = 0.03;
  constexpr double upper_arm = 0.045, forearm = 0.038, hand = 0.03;
  constexpr double hip_joint = 0;     // within the lower back's end and the thigh's
  constexpr double clavicle = 0.045;  // the shoulder's top reaches out of the thorax
  static constexpr CapsuleRadii radii = {hip_joint, thigh,     shank,   foot, toes,  // left leg
                                         hip_joint, thigh,     shank,   foot, toes,  // right leg
                                         0.12,      0.125,     0.13,  // lower back, upper back, thorax
                                         0.05,      0.05,      0.09,  // lower neck, upper neck, head
                                         clavicle,  upper_arm, forearm, hand,   // left arm
                                         clavicle,  upper_arm, forearm, hand};  // right arm
  return radii;
}

bool is_hand_or_forearm(int bone) {
  using namespace joints;
  const int end = bone + 1;
  return end == left_wrist || end == left_hand || end == right_wrist || end == right_hand;
}

}  // namespace abrazo
