#include "core/motion/scenes/humanoid_rig.hpp"

#include <cmath>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>

#include "core/base/text.hpp"
#include "core/motion/scenes/glb_file.hpp"

namespace abrazo {

namespace {

using Json = nlohmann::json;

bool read_numbers(const Json& node, const char* key, std::span<double> numbers) {
  const auto found = node.find(key);
  if (found == node.end()) return true;
  if (!found->is_array() || found->size() != numbers.size()) return false;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!(*found)[i].is_number()) return false;
    numbers[i] = (*found)[i].get<double>();
    if (!std::isfinite(numbers[i])) return false;
  }
  return true;
}

bool read_local(const Json& node, Eigen::Affine3d& local) {
  if (!node.is_object()) return false;
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  if (!read_numbers(node, "matrix", std::span(matrix.data(), 16))) return false;
  Vec3 translation = Vec3::Zero(), scale = Vec3::Ones();
  Eigen::Vector4d rotation(0, 0, 0, 1);
  if (!read_numbers(node, "translation", std::span(translation.data(), 3)) ||
      !read_numbers(node, "rotation", std::span(rotation.data(), 4)) ||
      !read_numbers(node, "scale", std::span(scale.data(), 3)) || rotation.norm() < 1e-6)
    return false;
  local.matrix() = matrix;
  local = local * Eigen::Translation3d(translation) * Eigen::Quaterniond(rotation.normalized()) *
          Eigen::Scaling(scale);
  return std::abs(local.linear().determinant()) > 1e-15;
}

/// The nodes with their parents; in `order` a parent comes before its children. False for a damaged tree.
bool read_nodes(const Json& json, std::vector<RigNode>& nodes, std::vector<int>& order) {
  nodes.resize(json.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (!read_local(json[n], nodes[n].local)) return false;
    const auto children = json[n].find("children");
    if (children == json[n].end()) continue;
    if (!children->is_array()) return false;
    for (const Json& child : *children) {
      if (!child.is_number_unsigned() || child.get<std::uint64_t>() >= nodes.size()) return false;
      int& parent = nodes[child.get<std::size_t>()].parent;
      if (parent >= 0) return false;
      parent = static_cast<int>(n);
    }
  }
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (nodes[n].parent < 0) order.push_back(static_cast<int>(n));
  for (std::size_t i = 0; i < order.size(); ++i) {
    RigNode& node = nodes[static_cast<std::size_t>(order[i])];
    node.world =
        node.parent < 0 ? node.local : nodes[static_cast<std::size_t>(node.parent)].world * node.local;
    const Json& of_node = json[static_cast<std::size_t>(order[i])];
    if (of_node.contains("children"))
      for (const Json& child : of_node["children"]) order.push_back(child.get<int>());
  }
  return order.size() == nodes.size();  // otherwise there is a circle
}

using BoneNodes = std::map<std::string, int, std::less<>>;

void add_bone(const Json& node, const std::string& name, std::size_t nodes, BoneNodes& found) {
  if (node.is_number_unsigned() && node.get<std::uint64_t>() < nodes)
    found.emplace(lower_case(name), node.get<int>());
}

const Json& in(const Json& of, const char* key) {
  static const Json none = Json::object();
  return of.is_object() && of.contains(key) ? of[key] : none;
}

/// So that what is computed from it, and written as floats, stays finite.
bool is_within_reach(const Eigen::Affine3d& world) {
  constexpr double farthest = 1e9;
  const Eigen::Matrix3d back = world.linear().inverse();
  return world.matrix().allFinite() && back.allFinite() && world.matrix().cwiseAbs().maxCoeff() <= farthest &&
         back.cwiseAbs().maxCoeff() <= farthest;
}

std::string name_of_node(const Json& node, std::size_t number) {
  const auto name = node.find("name");
  return name != node.end() && name->is_string() ? in_quotes(name->get<std::string>())
                                                 : std::to_string(number);
}

/// By VRM's own list, else by names.
BoneNodes bone_nodes(const GlbFile& glb) {
  BoneNodes found = vrm_bone_nodes(glb);
  if (!found.empty()) return found;
  const Json& json = glb.json;
  const std::size_t nodes = json["nodes"].size();
  for (std::size_t n = 0; n < nodes; ++n) {
    const Json& name = in(json["nodes"][n], "name");
    if (!name.is_string()) continue;
    std::string plain = lower_case(name.get<std::string>());
    if (const auto colon = plain.rfind(':'); colon != std::string::npos) plain.erase(0, colon + 1);
    if (plain.starts_with("mixamorig")) plain.erase(0, std::string_view("mixamorig").size());
    for (const HumanoidBone& bone : humanoid_bones)
      if (plain == bone.name || plain == bone.mixamo) found.emplace(bone.name, static_cast<int>(n));
  }
  return found;
}

}  // namespace

BoneNodes vrm_bone_nodes(const GlbFile& glb) {
  const Json& json = glb.json;
  BoneNodes found;
  const std::size_t nodes = json["nodes"].size();
  for (const char* extension : {"VRMC_vrm", "VRMC_vrm_animation"}) {
    const Json& bones = in(in(in(in(json, "extensions"), extension), "humanoid"), "humanBones");
    if (bones.is_object())
      for (const auto& [name, bone] : bones.items()) add_bone(in(bone, "node"), name, nodes, found);
  }
  const Json& of_0 = in(in(in(in(json, "extensions"), "VRM"), "humanoid"), "humanBones");
  if (of_0.is_array())
    for (const Json& bone : of_0)
      if (in(bone, "bone").is_string())
        add_bone(in(bone, "node"), bone["bone"].get<std::string>(), nodes, found);
  return found;
}

double HumanoidRig::leg_length() const {
  const auto length = [&](const char* a, const char* b) { return (rest(a) - rest(b)).norm(); };
  return 0.5 * (length("leftupperleg", "leftlowerleg") + length("leftlowerleg", "leftfoot") +
                length("rightupperleg", "rightlowerleg") + length("rightlowerleg", "rightfoot"));
}

Result<HumanoidRig> read_humanoid_rig(const GlbFile& glb, const std::string& where) {
  HumanoidRig rig;
  if (!read_nodes(glb.json["nodes"], rig.nodes, rig.order)) return Error{"its nodes are damaged", where};
  for (std::size_t n = 0; n < rig.nodes.size(); ++n)
    if (!is_within_reach(rig.nodes[n].world))
      return Error{"its node " + name_of_node(glb.json["nodes"][n], n) +
                       " is farther away, or scaled by more, than a figure's can be; export it again",
                   where};
  rig.bones = bone_nodes(glb);
  std::string missing;
  for (const HumanoidBone& bone : humanoid_bones)
    if (bone.is_required && !rig.bones.contains(bone.name))
      missing += (missing.empty() ? "" : ", ") + std::string(bone.name);
  if (!missing.empty())
    return Error{
        "is no humanoid whose bones are known by VRM's list or by the names of VRM or Mixamo; it lacks " +
            missing,
        where};
  return rig;
}

}  // namespace abrazo
