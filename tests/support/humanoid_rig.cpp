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

namespace {

struct RigFile {
  nlohmann::json json;
  std::map<std::string, Eigen::Affine3d> world;
  Eigen::AngleAxisd facing;
};

RigFile rig_file(Naming naming) {
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
  return {std::move(json), std::move(world), facing};
}

std::string glb_of(const nlohmann::json& json, const std::string& binary) {
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const auto number = [](std::size_t value) {
    std::string bytes(4, '\0');
    const auto small = static_cast<std::uint32_t>(value);
    std::memcpy(bytes.data(), &small, 4);
    return bytes;
  };
  const std::string chunk = binary.empty() ? "" : number(binary.size()) + std::string("BIN\0", 4) + binary;
  return "glTF" + number(2) + number(20 + text.size() + chunk.size()) + number(text.size()) + "JSON" + text +
         chunk;
}

/// The accessors of a mesh, filled one after the other.
class Buffer {
 public:
  template <typename Number>
  std::size_t add(nlohmann::json& json, const std::vector<Number>& numbers, std::size_t per_value,
                  const char* type, int component) {
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", numbers.size() * sizeof(Number)}});
    bytes_.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", component},
                                 {"count", numbers.size() / per_value},
                                 {"type", type}});
    return json["accessors"].size() - 1;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

}  // namespace

std::string rig(Naming naming) {
  return glb_of(rig_file(naming).json, {});
}

std::string skinned_rig(Naming naming) {
  constexpr int unsigned_short = 5123, single_float = 5126;
  RigFile file = rig_file(naming);
  std::vector<float> points, normals, weights, binds;
  std::vector<std::uint16_t> joints, indices;
  nlohmann::json nodes = nlohmann::json::array();
  for (std::size_t b = 0; b < rig_bones().size(); ++b) {
    const Eigen::Matrix4f bind = file.world[rig_bones()[b].vrm].inverse().matrix().cast<float>();
    binds.insert(binds.end(), bind.data(), bind.data() + 16);
    nodes.push_back(b + 1);
    for (const Vec3& corner : {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 2, 0)}) {
      const Vec3 point = file.facing * Vec3(rig_bones()[b].at + rig_triangle_m * corner);
      const Vec3 normal = file.facing * Vec3::UnitZ();
      for (const int axis : {0, 1, 2}) {
        points.push_back(static_cast<float>(point[axis]));
        normals.push_back(static_cast<float>(normal[axis]));
      }
      joints.insert(joints.end(), {static_cast<std::uint16_t>(b), 0, 0, 0});
      weights.insert(weights.end(), {1, 0, 0, 0});
      indices.push_back(static_cast<std::uint16_t>(indices.size()));
    }
  }
  nlohmann::json& json = file.json;
  Buffer buffer;
  nlohmann::json primitive = {{"material", 0}};
  primitive["attributes"]["POSITION"] = buffer.add(json, points, 3, "VEC3", single_float);
  primitive["attributes"]["NORMAL"] = buffer.add(json, normals, 3, "VEC3", single_float);
  primitive["attributes"]["JOINTS_0"] = buffer.add(json, joints, 4, "VEC4", unsigned_short);
  primitive["attributes"]["WEIGHTS_0"] = buffer.add(json, weights, 4, "VEC4", single_float);
  primitive["indices"] = buffer.add(json, indices, 1, "SCALAR", unsigned_short);
  json["skins"] = {
      {{"joints", nodes}, {"inverseBindMatrices", buffer.add(json, binds, 16, "MAT4", single_float)}}};
  json["meshes"] = {{{"primitives", {primitive}}}};
  json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0, 1, 1}}}}}};
  json["buffers"] = {{{"byteLength", buffer.bytes().size()}}};
  json["nodes"].push_back({{"name", "Body"}, {"mesh", 0}, {"skin", 0}});
  return glb_of(json, buffer.bytes());
}

}  // namespace abrazo::test
