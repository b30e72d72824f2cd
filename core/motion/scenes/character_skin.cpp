#include "core/motion/scenes/character_skin.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>

#include "core/base/limits.hpp"
#include "core/motion/scenes/glb_file.hpp"
#include "core/motion/scenes/gltf_json.hpp"
#include "core/motion/scenes/gltf_values.hpp"
#include "core/motion/scenes/humanoid_rig.hpp"

namespace abrazo {

namespace {

using Json = nlohmann::json;

constexpr std::size_t most_points = 500'000, most_triangles = 1'000'000, most_carriers = 65'535;
constexpr std::size_t most_values_read = 20'000'000;  ///< primitives may share their points
constexpr double most_metres = 1e6;
constexpr int triangle_mode = 4;

/// Puts the primitives of a file together.
class SkinReader {
 public:
  SkinReader(const GlbFile& glb, const HumanoidRig& rig) : glb_(glb), rig_(rig) {}

  /// What is wrong; empty = nothing.
  std::string read();
  CharacterSkin& skin() { return skin_; }

 private:
  std::string add_mesh(std::size_t node);
  std::string add_primitive(const Json& primitive, std::size_t first_carrier, std::size_t carriers,
                            bool is_skinned);
  /// The carriers of a skin, once. @return false for a damaged one
  bool add_carriers(const Json& skin);
  std::optional<GltfValues> attribute(const Json& primitive, const char* name, const char* type) const;
  std::optional<Eigen::Vector3f> vector(const GltfValues& values, std::size_t at) const;
  std::optional<CharacterSkin::Share> share(const GltfValues& joints, const GltfValues& weights,
                                            std::size_t at, std::size_t first, std::size_t carriers) const;
  void complete_normals(std::size_t first_point, std::size_t first_triangle);

  const GlbFile& glb_;
  const HumanoidRig& rig_;
  CharacterSkin skin_;
  std::size_t values_read_ = 0;
  std::size_t primitives_ = 0;
};

std::string SkinReader::read() {
  for (const Json& name : member(glb_.json, "extensionsRequired"))
    for (const char* packed :
         {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_mesh_quantization"})
      if (name == packed)
        return "its mesh is compressed (" + std::string(packed) +
               "); export the character without compression";
  for (std::size_t n = 0; n < rig_.nodes.size(); ++n)
    if (glb_.json["nodes"][n].contains("mesh"))
      if (std::string wrong = add_mesh(n); !wrong.empty()) return wrong;
  return skin_.triangles.empty() ? "has no mesh to show" : "";
}

bool SkinReader::add_carriers(const Json& skin) {
  const Json& joints = member(skin, "joints");
  if (!joints.is_array() || joints.empty()) return false;
  std::optional<GltfValues> binds;
  if (const Json& index = member(skin, "inverseBindMatrices"); !index.is_null()) {
    if (!index.is_number_unsigned()) return false;
    binds = GltfValues::find(glb_, index.get<std::uint64_t>(), "MAT4");
    if (!binds || !binds->is_float() || binds->size() < joints.size()) return false;
  }
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (!joints[j].is_number_unsigned() || joints[j].get<std::uint64_t>() >= rig_.nodes.size()) return false;
    CharacterSkin::Carrier carrier{joints[j].get<int>(), Eigen::Affine3f::Identity()};
    for (int column = 0; binds && column < 4; ++column)
      for (int row = 0; row < 3; ++row)
        carrier.from_mesh.matrix()(row, column) =
            static_cast<float>(binds->number(j, static_cast<std::size_t>(4 * column + row)));
    if (!carrier.from_mesh.matrix().allFinite()) return false;
    skin_.carriers.push_back(carrier);
  }
  return true;
}

std::string SkinReader::add_mesh(std::size_t node) {
  const Json& of_node = glb_.json["nodes"][node];
  const Json& mesh = element(member(glb_.json, "meshes"), of_node["mesh"]);
  const Json& primitives = member(mesh, "primitives");
  if (!primitives.is_array()) return "its meshes are damaged";
  primitives_ += primitives.size();  // nodes may share a mesh
  if (primitives_ > limits::character_primitives)
    return "its nodes show more than " + std::to_string(limits::character_primitives) +
           " primitives; join those with the same material";
  const std::size_t first = skin_.carriers.size();
  const bool is_skinned = of_node.contains("skin");
  if (is_skinned) {
    if (!add_carriers(element(member(glb_.json, "skins"), of_node["skin"]))) return "its skin is damaged";
  } else {
    skin_.carriers.push_back({static_cast<int>(node), Eigen::Affine3f::Identity()});
  }
  if (skin_.carriers.size() > most_carriers) return "has more than 65 535 joints in its skins";
  for (const Json& primitive : primitives)
    if (std::string wrong = add_primitive(primitive, first, skin_.carriers.size() - first, is_skinned);
        !wrong.empty())
      return wrong;
  return {};
}

std::optional<GltfValues> SkinReader::attribute(const Json& primitive, const char* name,
                                                const char* type) const {
  const Json& index = member(member(primitive, "attributes"), name);
  if (!index.is_number_unsigned()) return std::nullopt;
  return GltfValues::find(glb_, index.get<std::uint64_t>(), type);
}

std::optional<Eigen::Vector3f> SkinReader::vector(const GltfValues& values, std::size_t at) const {
  const Eigen::Vector3d read(values.number(at, 0), values.number(at, 1), values.number(at, 2));
  // Of numbers and what is no number maxCoeff may give the number.
  if (!read.allFinite() || read.cwiseAbs().maxCoeff() >= most_metres) return std::nullopt;
  return read.cast<float>();
}

/// The strongest first, with the sum 1.
std::optional<CharacterSkin::Share> SkinReader::share(const GltfValues& joints, const GltfValues& weights,
                                                      std::size_t at, std::size_t first,
                                                      std::size_t carriers) const {
  std::array<std::pair<double, std::size_t>, 4> parts;
  double sum = 0;
  for (std::size_t c = 0; c < parts.size(); ++c) {
    parts[c] = {weights.number(at, c), static_cast<std::size_t>(joints.integer(at, c))};
    if (!(parts[c].first >= 0 && parts[c].first < most_metres)) return std::nullopt;
    if (parts[c].first > 0 && parts[c].second >= carriers) return std::nullopt;
    sum += parts[c].first;
  }
  std::ranges::sort(parts, std::greater{});
  CharacterSkin::Share share{};
  for (std::size_t c = 0; c < parts.size(); ++c) {
    const bool counts = parts[c].first > 0;
    share.carriers[c] = static_cast<std::uint16_t>(first + (counts ? parts[c].second : 0));
    share.weights[c] = counts ? static_cast<float>(parts[c].first / sum) : 0.0F;
  }
  if (!(sum > 0)) share.weights[0] = 1;
  return share;
}

/// sRGB from the linear base colour of a primitive's material; none: it is invisible.
std::optional<std::array<std::uint8_t, 3>> colour_of(const Json& material) {
  constexpr double gamma = 2.2, faintest = 0.02;
  std::array<std::uint8_t, 3> colour{};
  const Json& factor = member(member(material, "pbrMetallicRoughness"), "baseColorFactor");
  const auto channel = [&](std::size_t c) {
    const bool given = factor.is_array() && c < factor.size() && factor[c].is_number();
    return given ? std::clamp(factor[c].get<double>(), 0.0, 1.0) : 1.0;
  };
  if (member(material, "alphaMode") == "BLEND" && channel(3) < faintest) return std::nullopt;
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = static_cast<std::uint8_t>(std::lround(255 * std::pow(channel(c), 1 / gamma)));
  return colour;
}

std::string SkinReader::add_primitive(const Json& primitive, std::size_t first_carrier, std::size_t carriers,
                                      bool is_skinned) {
  const std::string damaged = "its meshes are damaged";
  const Json& mode = member(primitive, "mode");
  if (!mode.is_null() && mode != triangle_mode)
    return "its mesh has lines, points or strips; it needs triangles";
  const auto points = attribute(primitive, "POSITION", "VEC3");
  const auto normals = attribute(primitive, "NORMAL", "VEC3");
  const auto joints = attribute(primitive, "JOINTS_0", "VEC4"),
             weights = attribute(primitive, "WEIGHTS_0", "VEC4");
  if (!points || !points->is_float()) return damaged;
  const bool has_normals = member(member(primitive, "attributes"), "NORMAL").is_number();
  if (has_normals && (!normals || normals->size() != points->size())) return damaged;
  if (is_skinned && (!joints || !joints->is_integer() || !weights || joints->size() != points->size() ||
                     weights->size() != points->size()))
    return "its skin lacks the joints and weights of its points";
  const auto colour = colour_of(element(member(glb_.json, "materials"), member(primitive, "material")));
  if (!colour) return {};
  std::optional<GltfValues> indices;
  if (const Json& index = member(primitive, "indices"); !index.is_null()) {
    if (index.is_number_unsigned()) indices = GltfValues::find(glb_, index.get<std::uint64_t>(), "SCALAR");
    if (!indices || !indices->is_integer()) return damaged;
  }
  const std::size_t corners = indices ? indices->size() : points->size();
  values_read_ += points->size() + corners;
  const std::size_t first_triangle = skin_.triangles.size(), first_point = skin_.points.size();
  if (values_read_ > most_values_read || corners / 3 > most_triangles - first_triangle)
    return "its mesh is too large; at most 500 000 points and 1 000 000 triangles are shown";
  // Primitives often share the points of a whole character: only those of the own triangles are taken.
  std::vector<std::int32_t> taken(points->size(), -1);
  for (std::size_t t = 0; t + 2 < corners; t += 3) {
    std::array<std::int32_t, 3> triangle{};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint64_t point = indices ? indices->integer(t + c, 0) : t + c;
      if (point >= points->size()) return damaged;
      std::int32_t& place = taken[static_cast<std::size_t>(point)];
      if (place < 0) {
        if (skin_.points.size() >= most_points)
          return "its mesh is too large; at most 500 000 points and 1 000 000 triangles are shown";
        const auto at = static_cast<std::size_t>(point);
        const auto read = vector(*points, at);
        const auto normal = has_normals ? vector(*normals, at) : Eigen::Vector3f(0, 0, 0);
        const auto carried =
            is_skinned ? share(*joints, *weights, at, first_carrier, carriers)
                       : CharacterSkin::Share{{static_cast<std::uint16_t>(first_carrier)}, {1, 0, 0, 0}};
        if (!read || !normal || !carried) return damaged;
        place = static_cast<std::int32_t>(skin_.points.size());
        skin_.points.push_back(*read);
        skin_.normals.push_back(*normal);
        skin_.shares.push_back(*carried);
        skin_.colours.push_back(*colour);
      }
      triangle[c] = place;
    }
    skin_.triangles.push_back(triangle);
  }
  complete_normals(first_point, first_triangle);
  return {};
}

/// Normals that a file lacks, from the triangles around each point.
void SkinReader::complete_normals(std::size_t first_point, std::size_t first_triangle) {
  std::vector<Eigen::Vector3f> sums(skin_.points.size() - first_point, Eigen::Vector3f::Zero());
  for (std::size_t t = first_triangle; t < skin_.triangles.size(); ++t) {
    const auto corner = [&](std::size_t c) { return static_cast<std::size_t>(skin_.triangles[t][c]); };
    const Eigen::Vector3f& from = skin_.points[corner(0)];
    const Eigen::Vector3f out = (skin_.points[corner(1)] - from).cross(skin_.points[corner(2)] - from);
    for (std::size_t c = 0; c < 3; ++c) sums[corner(c) - first_point] += out;
  }
  for (std::size_t p = first_point; p < skin_.points.size(); ++p) {
    Eigen::Vector3f& normal = skin_.normals[p];
    if (normal.norm() < 1e-6F) normal = sums[p - first_point];
    normal = normal.norm() > 1e-20F ? normal.normalized() : Eigen::Vector3f::UnitY();
  }
}

}  // namespace

Result<CharacterSkin> read_character_skin(const GlbFile& glb, const HumanoidRig& rig,
                                          const std::string& where) {
  SkinReader reader(glb, rig);
  if (const std::string wrong = reader.read(); !wrong.empty()) return Error{wrong, where};
  return std::move(reader.skin());
}

void SkinShape::place(const CharacterSkin& skin, std::span<const Eigen::Affine3d> world, double scale,
                      std::span<float> points, std::span<float> normals) {
  for (std::size_t c = 0; c < matrices_.size(); ++c) {
    const CharacterSkin::Carrier& carrier = skin.carriers[c];
    Eigen::Affine3d moved = world[static_cast<std::size_t>(carrier.node)] * carrier.from_mesh.cast<double>();
    moved.matrix().topRows<3>() *= scale;
    matrices_[c] = moved.matrix().cast<float>();
  }
  for (std::size_t p = 0; p < skin.points.size(); ++p) {
    const CharacterSkin::Share& share = skin.shares[p];
    Eigen::Matrix4f blend = share.weights[0] * matrices_[share.carriers[0]];
    for (std::size_t c = 1; c < 4 && share.weights[c] > 0; ++c)
      blend += share.weights[c] * matrices_[share.carriers[c]];
    const Eigen::Vector3f& at = skin.points[p];
    const Eigen::Vector3f& out = skin.normals[p];
    const Eigen::Vector4f point =
        blend.col(0) * at.x() + blend.col(1) * at.y() + blend.col(2) * at.z() + blend.col(3);
    const Eigen::Vector4f normal = blend.col(0) * out.x() + blend.col(1) * out.y() + blend.col(2) * out.z();
    // The fourth number of a normal is 0. Scales of characters are uniform, so that it stays upright.
    const float length = normal.norm();
    const float shorten = length > 1e-20F ? 1 / length : 0;
    for (int axis = 0; axis < 3; ++axis) {
      points[3 * p + static_cast<std::size_t>(axis)] = point[axis];
      normals[3 * p + static_cast<std::size_t>(axis)] = shorten * normal[axis];
    }
  }
}

}  // namespace abrazo
