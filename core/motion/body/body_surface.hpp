#pragma once

#include <cstdint>
#include <vector>

#include "core/base/positions.hpp"
#include "core/motion/body/joint_tree.hpp"

namespace abrazo {

/// A closed surface around a skeleton in its T-pose, for viewers: a rounded, tapered limb around every bone,
/// which meets its neighbours in the joints. Widths go with the length of the bones, as on a person of that
/// height; they are none of the capsules that contact is judged by.
struct BodySurface {
  struct Vertex {
    Vec3 place;   ///< [m]
    Vec3 normal;  ///< unit, smooth
    int node;     ///< of the tree: the one whose turning moves it
  };
  std::vector<Vertex> vertices;
  std::vector<std::uint16_t> corners;  ///< three per triangle, anticlockwise seen from outside
};

/// @param places  of the tree's nodes [m]
BodySurface body_surface(const std::vector<JointTree::Node>& nodes, const std::vector<Vec3>& places);

}  // namespace abrazo
