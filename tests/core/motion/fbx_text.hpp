#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "core/base/positions.hpp"

namespace abrazo::test {

/// One joint of a made-up FBX file, a child of the one before it.
struct FbxJoint {
  std::string name;
  Vec3 place = Vec3(0, 10, 0);                       ///< in the parent's space
  std::string properties;                            ///< more lines, as fbx_property writes them
  std::vector<std::pair<double, Vec3>> rotations{};  ///< time in seconds, Euler angles in degrees
};

inline std::string fbx_property(const std::string& name, const Vec3& value) {
  return fmt::format("P: \"{}\", \"Vector3D\", \"Vector\", \"\",{},{},{}\n", name, value.x(), value.y(),
                     value.z());
}

/// What an FBX file says of itself.
struct FbxSettings {
  int time_mode = 6;  ///< 30 frames a second
  int up = 1, front = 2, coord = 0, front_sign = 1;
  double centimetres_per_unit = 1;
  std::vector<std::string> takes = {
      "Take 001"};  ///< each has every joint's rotations, later ones half as long
};

/// An FBX file as text: a chain of joints that turn.
inline std::string fbx_text(const std::vector<FbxJoint>& joints, const FbxSettings& settings = {}) {
  constexpr long long second = 46186158000;
  std::string objects, links;
  const auto link = [&](long child, long parent, const char* property = nullptr) {
    links += property ? fmt::format("C: \"OP\",{},{}, \"{}\"\n", child, parent, property)
                      : fmt::format("C: \"OO\",{},{}\n", child, parent);
  };
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const FbxJoint& joint = joints[j];
    objects += fmt::format(
        "Model: {}, \"Model::{}\", \"LimbNode\" {{\nVersion: 232\nProperties70: {{\n"
        "P: \"RotationActive\", \"bool\", \"\", \"\",1\n"
        "P: \"Lcl Translation\", \"Lcl Translation\", \"\", \"A\",{},{},{}\n{}}}\n}}\n",
        1000 + j, joint.name, joint.place.x(), joint.place.y(), joint.place.z(), joint.properties);
    link(static_cast<long>(1000 + j), j == 0 ? 0 : static_cast<long>(999 + j));
  }
  for (std::size_t take = 0; take < settings.takes.size(); ++take) {
    const auto id = static_cast<long>(10000 * (take + 1));
    objects += fmt::format(
        "AnimationStack: {}, \"AnimStack::{}\", \"\" {{\n}}\nAnimationLayer: {}, \"AnimLayer::Base\", \"\" "
        "{{\n}}\n",
        id, settings.takes[take], id + 1);
    link(id + 1, id);
    for (std::size_t j = 0; j < joints.size(); ++j) {
      if (joints[j].rotations.empty()) continue;
      const long node = id + 10 * static_cast<long>(j + 1);
      objects += fmt::format("AnimationCurveNode: {}, \"AnimCurveNode::R\", \"\" {{\n}}\n", node);
      link(node, id + 1);
      link(node, static_cast<long>(1000 + j), "Lcl Rotation");
      const std::size_t count = take == 0 ? joints[j].rotations.size() : (joints[j].rotations.size() + 1) / 2;
      for (int axis = 0; axis < 3; ++axis) {
        std::string times, values;
        for (std::size_t k = 0; k < count; ++k) {
          const auto& [time, angles] = joints[j].rotations[k];
          times += fmt::format("{}{}", k > 0 ? "," : "", static_cast<long long>(time * second + 0.5));
          values += fmt::format("{}{}", k > 0 ? "," : "", angles[axis]);
        }
        objects += fmt::format(
            "AnimationCurve: {}, \"AnimCurve::\", \"\" {{\nDefault: 0\nKeyVer: 4008\nKeyTime: *{} {{\na: "
            "{}\n}}\n"
            "KeyValueFloat: *{} {{\na: {}\n}}\nKeyAttrFlags: *1 {{\na: 24840\n}}\n"
            "KeyAttrDataFloat: *4 {{\na: 0,0,0,0\n}}\nKeyAttrRefCount: *1 {{\na: {}\n}}\n}}\n",
            node + 1 + axis, count, times, count, values, count);
        link(node + 1 + axis, node, axis == 0 ? "d|X" : axis == 1 ? "d|Y" : "d|Z");
      }
    }
  }
  const auto setting = [](const char* name, const char* type, auto value) {
    return fmt::format("P: \"{}\", \"{}\", \"\", \"\",{}\n", name, type, value);
  };
  return "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\nFBXHeaderVersion: 1003\nFBXVersion: 7400\n}\n"
         "GlobalSettings:  {\nVersion: 1000\nProperties70:  {\n" +
         setting("UpAxis", "int", settings.up) + setting("UpAxisSign", "int", 1) +
         setting("FrontAxis", "int", settings.front) + setting("FrontAxisSign", "int", settings.front_sign) +
         setting("CoordAxis", "int", settings.coord) + setting("CoordAxisSign", "int", 1) +
         setting("UnitScaleFactor", "double", settings.centimetres_per_unit) +
         setting("TimeMode", "enum", settings.time_mode) + "}\n}\nObjects:  {\n" + objects +
         "}\nConnections:  {\n" + links + "}\n";
}

}  // namespace abrazo::test
