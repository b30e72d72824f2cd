#include "tests/support/humanoid_rig.hpp"

#include <Eigen/Geometry>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

namespace abrazo::test {

const std::vector<RigBone>& rig_bones() {
  static const std::vector<RigBone> all = [] {
    std::vector<RigBone> bones = {{"hips", "Hips", "", {0, 0.9, 0}},
                                  {"spine", "Spine", "hips", {0, 1.0, 0}},
                                  {"neck", "Neck", "spine", {0, 1.35, 0}},
                                  {"head", "Head", "neck", {0, 1.45, 0}}};
    for (const double side : {1.0, -1.0}) {
      const std::string vrm = side > 0 ? "left" : "right", mixamo = side > 0 ? "Left" : "Right";
      bones.push_back({vrm + "UpperArm", mixamo + "Arm", "spine", {side * 0.18, 1.3, 0}});
      bones.push_back({vrm + "LowerArm", mixamo + "ForeArm", vrm + "UpperArm", {side * 0.43, 1.3, 0}});
      bones.push_back({vrm + "Hand", mixamo + "Hand", vrm + "LowerArm", {side * 0.67, 1.3, 0}});
      bones.push_back({vrm + "UpperLeg", mixamo + "UpLeg", "hips", {side * 0.09, 0.85, 0}});
      bones.push_back({vrm + "LowerLeg", mixamo + "Leg", vrm + "UpperLeg", {side * 0.09, 0.46, 0}});
      bones.push_back({vrm + "Foot", mixamo + "Foot", vrm + "LowerLeg", {side * 0.09, 0.08, 0}});
    }
    return bones;
  }();
  return all;
}

std::string rig(Naming naming) {
  const Eigen::AngleAxisd facing(naming == Naming::Vrm0 ? 3.14159265358979323846 : 0, Vec3::UnitY());
  std::map<std::string, Eigen::Affine3d> world;
  nlohmann::json json = {{"asset", {{"version", "2.0"}}}, {"scenes", {{{"nodes", {0}}}}}};
  json["nodes"].push_back({{"name", "Armature"}, {"scale", {0.01, 0.01, 0.01}}, {"children", {1}}});
  world[""] = Eigen::Affine3d(Eigen::Scaling(0.01));
  std::map<std::string, std::size_t> numbers;
  nlohmann::json of_0 = nlohmann::json::array(), of_1 = nlohmann::json::object();
  for (const RigBone& bone : rig_bones()) {
    const std::size_t number = json["nodes"].size();
    numbers[bone.vrm] = number;
    const Eigen::Quaterniond own(
        Eigen::AngleAxisd(0.4 * static_cast<double>(number), Vec3(1, 2, 3).normalized()));
    const Eigen::Affine3d goal = Eigen::Translation3d(facing * bone.at) * own * Eigen::Scaling(0.01);
    const Eigen::Affine3d local = world[bone.parent].inverse() * goal;
    const Eigen::Quaterniond turn(local.rotation());
    json["nodes"].push_back(
        {{"name", naming == Naming::Mixamo ? "mixamorig:" + bone.mixamo : "J_" + std::to_string(number)},
         {"translation", {local.translation().x(), local.translation().y(), local.translation().z()}},
         {"rotation", {turn.x(), turn.y(), turn.z(), turn.w()}}});
    if (!bone.parent.empty()) json["nodes"][numbers[bone.parent]]["children"].push_back(number);
    world[bone.vrm] = goal;
    of_0.push_back({{"bone", bone.vrm}, {"node", number}});
    of_1[bone.vrm] = {{"node", number}};
  }
  if (naming == Naming::Vrm0) json["extensions"]["VRM"]["humanoid"]["humanBones"] = of_0;
  if (naming == Naming::Vrm1) json["extensions"]["VRMC_vrm"]["humanoid"]["humanBones"] = of_1;
  json["animations"] = {
      {{"name", "idle"}, {"samplers", nlohmann::json::array()}, {"channels", nlohmann::json::array()}}};
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const auto number = [](std::size_t value) {
    std::string bytes(4, '\0');
    const auto small = static_cast<std::uint32_t>(value);
    std::memcpy(bytes.data(), &small, 4);
    return bytes;
  };
  return "glTF" + number(2) + number(20 + text.size()) + number(text.size()) + "JSON" + text;
}

}  // namespace abrazo::test
