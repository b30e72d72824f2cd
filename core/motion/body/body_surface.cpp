#include "core/motion/body/body_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

using namespace joints;

/// Half the width of a body ring_vertices the bone that ends at a joint, on a person of 1.70 m [m].
struct LimbShape {
  double at_start, at_end;
  double depth = 1;  ///< from front to back, as a share of the width
};

LimbShape shape_of(int joint) {
  switch (joint) {
    case LeftHipJoint:
    case RightHipJoint:
      return {0.085, 0.088};
    case LeftFemur:
    case RightFemur:
      return {0.088, 0.056};
    case LeftTibia:
    case RightTibia:
      return {0.056, 0.040};
    case LeftFoot:
    case RightFoot:
      return {0.040, 0.034};
    case LeftToes:
    case RightToes:
      return {0.034, 0.026};
    case LowerBack:
      return {0.118, 0.118, 0.78};
    case UpperBack:
      return {0.118, 0.130, 0.78};
    case Thorax:
      return {0.130, 0.120, 0.78};
    case LowerNeck:
      return {0.060, 0.054};
    case UpperNeck:
      return {0.054, 0.058};
    case Head:
      return {0.075, 0.098};
    case LeftClavicle:
    case RightClavicle:
      return {0.070, 0.060};
    case LeftHumerus:
    case RightHumerus:
      return {0.056, 0.042};
    case LeftWrist:
    case RightWrist:
      return {0.042, 0.031};
    default:
      return {0.033, 0.027};  // hands
  }
}

constexpr int ring_vertices = 14;  ///< vertices of a ring
constexpr int cap = 4;             ///< rings from a limb's pole to where its side begins

/// A limb as rings from pole to pole.
class Limb {
 public:
  Limb(const Vec3& from, const Vec3& to, const LimbShape& shape, double scale)
      : from_(from), to_(to), shape_(shape), scale_(scale) {
    along_ = (to - from).normalized();
    const Vec3 to_side = std::abs(along_.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitZ();
    front_ = to_side.cross(along_).normalized();
    side_ = front_.cross(along_);  // turning from side to front is anticlockwise, seen from the end
  }

  void add_to(BodySurface& surface, int node) const {
    const auto first = static_cast<std::uint16_t>(surface.vertices.size());
    for (int ring = 0; ring < 2 * cap; ++ring) add_ring(surface, ring, node);
    for (int ring = 0; ring + 1 < 2 * cap; ++ring)
      for (int i = 0; i < ring_vertices; ++i) {
        const int here = ring * ring_vertices + i, beside = ring * ring_vertices + (i + 1) % ring_vertices;
        for (const int corner :
             {here, beside, here + ring_vertices, beside, beside + ring_vertices, here + ring_vertices})
          surface.corners.push_back(static_cast<std::uint16_t>(first + corner));
      }
    add_pole(surface, first, true, node);
    add_pole(surface, first, false, node);
  }

 private:
  /// Half the first rings lie on the ball ring_vertices the beginning, the others on that ring_vertices the
  /// end.
  void add_ring(BodySurface& surface, int ring, int node) const {
    const bool at_start = ring < cap;
    const double quarter = std::numbers::pi / 2;
    const double height = at_start ? quarter * (ring + 1 - cap) / cap : quarter * (ring - cap) / cap;
    const double radius = scale_ * (at_start ? shape_.at_start : shape_.at_end);
    const Vec3 centre = at_start ? from_ : to_;
    for (int i = 0; i < ring_vertices; ++i) {
      const double turn = 2 * std::numbers::pi * i / ring_vertices;
      const Vec3 across = std::cos(turn) * side_ + shape_.depth * std::sin(turn) * front_;
      const Vec3 outwards = std::cos(turn) * side_ + std::sin(turn) / shape_.depth * front_;
      surface.vertices.push_back(
          {centre + radius * (std::cos(height) * across + std::sin(height) * along_),
           (std::cos(height) * outwards.normalized() + std::sin(height) * along_).normalized(), node});
    }
  }

  void add_pole(BodySurface& surface, std::uint16_t first, bool at_start, int node) const {
    const auto pole = static_cast<std::uint16_t>(surface.vertices.size());
    const double radius = scale_ * (at_start ? shape_.at_start : shape_.at_end);
    surface.vertices.push_back(at_start ? BodySurface::Vertex{from_ - radius * along_, -along_, node}
                                        : BodySurface::Vertex{to_ + radius * along_, along_, node});
    const int ring = at_start ? 0 : (2 * cap - 1) * ring_vertices;
    for (int i = 0; i < ring_vertices; ++i) {
      const auto here = static_cast<std::uint16_t>(first + ring + i);
      const auto beside = static_cast<std::uint16_t>(first + ring + (i + 1) % ring_vertices);
      surface.corners.insert(surface.corners.end(),
                             {pole, at_start ? beside : here, at_start ? here : beside});
    }
  }

  Vec3 from_, to_, along_, side_, front_;
  LimbShape shape_;
  double scale_;
};

/// Of a body against that of the shapes: by how high its head is in the T-pose.
double scale_of(const std::vector<Vec3>& places) {
  constexpr double head_joint_m = 1.62;
  double lowest = places.front().y(), highest = lowest;
  for (const Vec3& place : places) {
    lowest = std::min(lowest, place.y());
    highest = std::max(highest, place.y());
  }
  return std::clamp((highest - lowest) / head_joint_m, 0.1, 10.0);
}

}  // namespace

BodySurface body_surface(const std::vector<JointTree::Node>& nodes, const std::vector<Vec3>& places) {
  BodySurface surface;
  const double scale = scale_of(places);
  for (std::size_t n = 1; n < nodes.size(); ++n) {
    if (nodes[n].offset.norm() < 1e-6) continue;  // a helper: no bone ends there
    const auto parent = static_cast<std::size_t>(nodes[n].parent);
    const Limb limb(places[parent], places[n], shape_of(nodes[n].joint), scale);
    limb.add_to(surface, static_cast<int>(parent));
  }
  return surface;
}

}  // namespace abrazo
