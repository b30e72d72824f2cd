#pragma once

#include <cstdint>
#include <vector>

#include "core/base/positions.hpp"
#include "core/motion/body/joint_tree.hpp"

namespace abrazo {

/// A closed surface around a skeleton in its T-pose, for viewers: a rounded, tapered limb around every bone
/// that meets its neighbours at the joints. Widths are proportional to bone lengths, as for a person of that
/// height; they are not the capsules used for contact.
struct BodySurface {
  struct Vertex {
    Vec3 place;   ///< [m]
    Vec3 normal;  ///< unit, smooth
    int node;     ///< of the tree: the node whose rotation moves it
  };
  std::vector<Vertex> vertices;
  std::vector<std::uint16_t> corners;  ///< three per triangle, anticlockwise seen from outside
};

/// @param places  of the tree's nodes [m]
BodySurface body_surface(const std::vector<JointTree::Node>& nodes, const std::vector<Vec3>& places);

}  // namespace abrazo
