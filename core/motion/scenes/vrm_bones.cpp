#include "core/motion/scenes/vrm_bones.hpp"

#include <map>

#include "core/motion/scenes/glb_file.hpp"
#include "core/motion/scenes/humanoid_rig.hpp"

namespace abrazo {

namespace {

constexpr double rest_fps = 30;  ///< of one frame, which has no rate

/// VRM's list, in a file that has one: bones by their nodes.
std::map<int, std::string> listed_bones(const GlbFile& glb) {
  std::map<int, std::string> bones;
  for (const auto& [name, node] : vrm_bone_nodes(glb)) bones.emplace(node, name);
  return bones;
}

}  // namespace

void name_by_vrm(std::string_view bytes, std::vector<NamedMotion>& motions) {
  if (!bytes.starts_with("glTF") || bytes.find("\"humanBones\"") == std::string_view::npos) return;
  const auto glb = parse_glb(bytes, "");
  if (!glb) return;
  std::map<std::string, std::string> names;
  for (const auto& [node, bone] : listed_bones(*glb)) {
    const auto& json = glb->json["nodes"][static_cast<std::size_t>(node)];
    if (json.contains("name") && json["name"].is_string())
      names.emplace(json["name"].get<std::string>(), bone);
  }
  for (NamedMotion& motion : motions)
    for (std::string& point : motion.points)
      if (const auto found = names.find(point); found != names.end()) point = found->second;
}

Result<std::optional<NamedMotion>> rest_pose_of_vrm(std::string_view bytes, const std::string& where) {
  const std::optional<NamedMotion> none;
  if (!bytes.starts_with("glTF") || bytes.find("\"humanBones\"") == std::string_view::npos) return none;
  const auto glb = parse_glb(bytes, where);
  if (!glb) return glb.error();
  if (glb->json.contains("animations") && !glb->json["animations"].empty()) return none;
  const auto rig = read_humanoid_rig(*glb, where);
  if (!rig) return rig.error();
  NamedMotion motion;
  std::map<int, int> points;
  for (const int node : rig->order)
    for (const auto& [bone, at] : rig->bones) {
      if (at != node || points.contains(node)) continue;
      int parent = rig->nodes[static_cast<std::size_t>(node)].parent;
      while (parent >= 0 && !points.contains(parent))
        parent = rig->nodes[static_cast<std::size_t>(parent)].parent;
      points.emplace(node, static_cast<int>(motion.points.size()));
      motion.points.push_back(bone);
      motion.parents.push_back(parent < 0 ? -1 : points.at(parent));
    }
  Positions places(static_cast<Eigen::Index>(motion.points.size()), 3);
  for (const auto& [node, point] : points)
    places.row(point) = rig->nodes[static_cast<std::size_t>(node)].world.translation().transpose();
  motion.frames.push_back(std::move(places));
  motion.fps = rest_fps;
  motion.metres_per_unit = 1.0;
  motion.up_axis = UpAxis::Y;
  motion.warnings.push_back({"rest-pose", 0, "holds no animation; its rest pose was read, as one frame"});
  return std::optional<NamedMotion>(std::move(motion));
}

}  // namespace abrazo
