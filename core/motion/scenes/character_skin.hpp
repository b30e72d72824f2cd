#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo {

struct GlbFile;
struct HumanoidRig;

/// The surface of a character, bound to the nodes of its rig: all its primitives as one. Of a skinned vertex
/// the four bones of its first set count; meshes without a skin move with their node. Shapes of faces (morph
/// targets) and textures are not read.
struct CharacterSkin {
  /// A node that carries vertices, and the way from the mesh to the node at rest.
  struct Carrier {
    int node;
    Eigen::Affine3f from_mesh;
  };
  struct Share {
    std::array<std::uint16_t, 4> carriers;
    std::array<float, 4> weights;  ///< descending, sum 1
  };
  std::vector<Carrier> carriers;
  std::vector<Eigen::Vector3f> points, normals;      ///< in the mesh; normals have unit length
  std::vector<Share> shares;                         ///< of each point
  std::vector<std::array<std::uint8_t, 3>> colours;  ///< of each point: the material's base colour, sRGB
  std::vector<std::array<std::int32_t, 3>> triangles;
};

/// @param where  the file's name, for messages
/// @return an Error if there is no mesh, if it is damaged or compressed, or has more than 500 000 points or
/// 1 000 000 triangles
Result<CharacterSkin> read_character_skin(const GlbFile& glb, const HumanoidRig& rig,
                                          const std::string& where);

/// Places of a skin's points in a pose (linear blend skinning).
class SkinShape {
 public:
  explicit SkinShape(const CharacterSkin& skin) : matrices_(skin.carriers.size()) {}

  /// Does not allocate.
  /// @param world   of every node of the rig
  /// @param scale   of the result
  /// @param points, normals  3 numbers for each point of the skin
  void place(const CharacterSkin& skin, std::span<const Eigen::Affine3d> world, double scale,
             std::span<float> points, std::span<float> normals);

 private:
  // Four columns of four: products and sums of whole registers.
  std::vector<Eigen::Matrix4f, Eigen::aligned_allocator<Eigen::Matrix4f>> matrices_;  ///< by carrier
};

}  // namespace abrazo
