#include "core/motion/scenes/character_glb.hpp"

#include <memory>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.hpp"
#include "core/motion/scenes/glb_file.hpp"
#include "core/motion/scenes/gltf_json.hpp"
#include "core/motion/scenes/rig_motion.hpp"

namespace abrazo {

namespace {

using Json = nlohmann::json;

/// Keys of a rig's bones, as readers of glTF want them.
struct RigKeys {
  std::vector<float> times_s, hips;       ///< hips: translations
  std::vector<std::vector<float>> bones;  ///< rotations; in the order of RigMotion::turns
};

void add_key(const RigMotion& motion, RigKeys& keys) {
  keys.bones.resize(motion.turns().size());
  for (std::size_t b = 0; b < keys.bones.size(); ++b) {
    // Of the two quaternions of a rotation the one nearer to the key before: readers blend keys as they
    // stand.
    Eigen::Vector4f key = motion.turns()[b].local.coeffs().cast<float>();
    std::vector<float>& track = keys.bones[b];
    if (track.size() >= 4 && key.dot(Eigen::Map<const Eigen::Vector4f>(&track[track.size() - 4])) < 0)
      key = -key;
    track.insert(track.end(), key.data(), key.data() + 4);
  }
  for (const int axis : {0, 1, 2}) keys.hips.push_back(static_cast<float>(motion.hips_translation()[axis]));
}

/// Adds values to the file's buffer. @return number of their accessor
int add_accessor(GlbFile& glb, const std::vector<float>& values, int per_value, const char* type) {
  glb.binary.resize((glb.binary.size() + 3) / 4 * 4);
  Json& views = glb.json["bufferViews"];
  Json& accessors = glb.json["accessors"];
  views.push_back({{"buffer", 0}, {"byteOffset", glb.binary.size()}, {"byteLength", values.size() * 4}});
  glb.binary.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
  Json accessor = {{"bufferView", views.size() - 1},
                   {"componentType", gltf::single_float},
                   {"count", values.size() / static_cast<std::size_t>(per_value)},
                   {"type", type}};
  if (per_value == 1) {
    accessor["min"] = {values.front()};
    accessor["max"] = {values.back()};
  }
  accessors.push_back(std::move(accessor));
  return static_cast<int>(accessors.size()) - 1;
}

void add_animation(GlbFile& glb, const RigMotion& motion, const RigKeys& keys) {
  Json animation = {{"name", "motion"}, {"samplers", Json::array()}, {"channels", Json::array()}};
  const int times = add_accessor(glb, keys.times_s, 1, "SCALAR");
  const auto add_track = [&](int node, const char* path, int values) {
    animation["samplers"].push_back({{"input", times}, {"output", values}, {"interpolation", "LINEAR"}});
    animation["channels"].push_back(
        {{"sampler", animation["samplers"].size() - 1}, {"target", {{"node", node}, {"path", path}}}});
  };
  for (std::size_t b = 0; b < keys.bones.size(); ++b)
    add_track(motion.turns()[b].node, "rotation", add_accessor(glb, keys.bones[b], 4, "VEC4"));
  add_track(motion.hips_node(), "translation", add_accessor(glb, keys.hips, 3, "VEC3"));
  glb.json["animations"] = Json::array({std::move(animation)});
  Json& buffers = glb.json["buffers"];
  if (buffers.empty()) buffers.push_back(Json::object());
  buffers[0]["byteLength"] = glb.binary.size();
}

bool has_lists(Json& json) {
  for (const char* key : {"bufferViews", "accessors", "buffers"}) {
    if (!json.contains(key)) json[key] = Json::array();
    if (!json[key].is_array()) return false;
  }
  const Json& buffers = json["buffers"];
  return buffers.empty() || (buffers[0].is_object() && !buffers[0].contains("uri"));
}

}  // namespace

Result<std::vector<std::string>> write_character_glbs(std::string_view character, std::span<const Clip> clips,
                                                      const std::string& where) {
  for (const Clip& clip : clips)
    if (clip.poses.empty() || !(clip.fps > 0)) return Error{"has no frames", clip.name};
  const auto file = parse_glb(character, where);
  if (!file) return file.error();
  auto read = read_humanoid_rig(*file, where);
  if (!read) return read.error();
  const auto rig = std::make_shared<const HumanoidRig>(std::move(*read));
  std::vector<RigMotion> motions = rig_motions(rig, clips);
  std::vector<std::string> performances;
  for (std::size_t c = 0; c < clips.size(); ++c) {
    GlbFile glb = *file;
    if (!has_lists(glb.json)) return Error{"its buffers are damaged", where};
    RigMotion& motion = motions[c];
    RigKeys keys;
    for (std::size_t f = 0; f < clips[c].poses.size(); ++f) {
      motion.set_pose(clips[c].poses[f], 1 / clips[c].fps);
      keys.times_s.push_back(static_cast<float>(static_cast<double>(f) / clips[c].fps));
      add_key(motion, keys);
    }
    add_animation(glb, motion, keys);
    auto text = glb_text(glb, where);
    if (!text) return text.error();
    performances.push_back(std::move(*text));
  }
  return performances;
}

Status check_character_file(const std::string& output) {
  if (output.ends_with(".glb") || output.ends_with(".vrm")) return Done{};
  return Error{"a character with its motion is written as .glb or .vrm", output};
}

Result<std::vector<std::string>> character_performances(const std::string& character,
                                                        std::span<const Clip> clips) {
  const auto file = read_whole_file(character);
  if (!file) return file.error();
  return write_character_glbs(*file, clips, character);
}

}  // namespace abrazo
