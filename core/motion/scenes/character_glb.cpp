#include "core/motion/scenes/character_glb.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/base/atomic_file.hpp"
#include "core/base/json_nesting.hpp"
#include "core/base/little_endian.hpp"
#include "core/base/statistics.hpp"
#include "core/base/text.hpp"
#include "core/motion/body/joint_tree.hpp"

namespace abrazo {

namespace {

using Json = nlohmann::json;
using Rotation = Eigen::Matrix3d;

constexpr std::uint64_t glb_magic = 0x46546C67, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
constexpr std::size_t header_bytes = 12, chunk_header_bytes = 8;
constexpr std::size_t most_nodes = 100'000;
constexpr int float_component = 5126;

/// A bone of a humanoid, and what turns it.
struct Bone {
  std::string_view name;    ///< of VRM, in lower case
  std::string_view mixamo;  ///< without prefix, in lower case
  std::string_view turner;  ///< node of JointTree
  std::string_view next;    ///< the bone it points at, of a limb whose direction is that of the clip
  bool is_required = true;
};
constexpr std::array bones = {Bone{"hips", "hips", "root", ""},
                              Bone{"spine", "spine", "lowerback", ""},
                              Bone{"chest", "spine1", "thorax", "", false},
                              Bone{"upperchest", "spine2", "thorax", "", false},
                              Bone{"neck", "neck", "lowerneck", "", false},
                              Bone{"head", "head", "upperneck", ""},
                              Bone{"leftshoulder", "leftshoulder", "thorax_left", "", false},
                              Bone{"leftupperarm", "leftarm", "lclavicle", "leftlowerarm"},
                              Bone{"leftlowerarm", "leftforearm", "lhumerus", "lefthand"},
                              Bone{"lefthand", "lefthand", "lwrist", ""},
                              Bone{"rightshoulder", "rightshoulder", "thorax_right", "", false},
                              Bone{"rightupperarm", "rightarm", "rclavicle", "rightlowerarm"},
                              Bone{"rightlowerarm", "rightforearm", "rhumerus", "righthand"},
                              Bone{"righthand", "righthand", "rwrist", ""},
                              Bone{"leftupperleg", "leftupleg", "lhipjoint", "leftlowerleg"},
                              Bone{"leftlowerleg", "leftleg", "lfemur", "leftfoot"},
                              Bone{"leftfoot", "leftfoot", "ltibia", ""},
                              Bone{"lefttoes", "lefttoebase", "lfoot", "", false},
                              Bone{"rightupperleg", "rightupleg", "rhipjoint", "rightlowerleg"},
                              Bone{"rightlowerleg", "rightleg", "rfemur", "rightfoot"},
                              Bone{"rightfoot", "rightfoot", "rtibia", ""},
                              Bone{"righttoes", "righttoebase", "rfoot", "", false}};

/// Content of a GLB file: its JSON, and the bytes of its first buffer.
struct Glb {
  Json json;
  std::string binary;
};

Result<Glb> parse_glb(std::string_view bytes, const std::string& where) {
  const Error wrong{"is no GLB or VRM file (glTF 2.0, binary), or is cut off", where};
  if (bytes.size() < header_bytes + chunk_header_bytes || little_endian(bytes, 0, 4) != glb_magic ||
      little_endian(bytes, 4, 4) != 2 || little_endian(bytes, 8, 4) > bytes.size())
    return wrong;
  Glb glb;
  for (std::size_t at = header_bytes; at + chunk_header_bytes <= bytes.size();) {
    const std::size_t length = little_endian(bytes, at, 4);
    const std::uint64_t kind = little_endian(bytes, at + 4, 4);
    at += chunk_header_bytes;
    if (length > bytes.size() - at) return wrong;
    const std::string_view content = bytes.substr(at, length);
    if (kind == json_chunk && glb.json.is_null()) {
      if (nests_too_deep(content)) return Error{too_deep_words, where};
      glb.json = Json::parse(content, nullptr, false);
    } else if (kind == binary_chunk && glb.binary.empty()) {
      glb.binary = content;
    }
    at += length;
  }
  if (!glb.json.is_object() || !glb.json.contains("nodes") || !glb.json["nodes"].is_array() ||
      glb.json["nodes"].size() > most_nodes)
    return wrong;
  return glb;
}

/// A node at rest.
struct RestNode {
  int parent = -1;
  Eigen::Affine3d local = Eigen::Affine3d::Identity(), world = Eigen::Affine3d::Identity();
};

Rotation rotation_of(const Eigen::Affine3d& place) {
  // Scales of characters are uniform; those that are not have no rotation to keep.
  return place.rotation();
}

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
bool read_nodes(const Json& json, std::vector<RestNode>& nodes, std::vector<int>& order) {
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
    RestNode& node = nodes[static_cast<std::size_t>(order[i])];
    node.world =
        node.parent < 0 ? node.local : nodes[static_cast<std::size_t>(node.parent)].world * node.local;
    const Json& of_node = json[static_cast<std::size_t>(order[i])];
    if (of_node.contains("children"))
      for (const Json& child : of_node["children"]) order.push_back(child.get<int>());
  }
  return order.size() == nodes.size();  // otherwise there is a circle
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c); });
  return text;
}

using BoneNodes = std::map<std::string, int, std::less<>>;

void add_bone(const Json& node, const std::string& name, std::size_t nodes, BoneNodes& found) {
  if (node.is_number_unsigned() && node.get<std::uint64_t>() < nodes)
    found.emplace(lower_case(name), node.get<int>());
}

/// By VRM's own list, else by names.
BoneNodes bone_nodes(const Json& json) {
  BoneNodes found;
  const std::size_t nodes = json["nodes"].size();
  const Json none = Json::object();
  const auto in = [&](const Json& of, const char* key) -> const Json& {
    return of.is_object() && of.contains(key) ? of[key] : none;
  };
  const Json& of_1 = in(in(in(in(json, "extensions"), "VRMC_vrm"), "humanoid"), "humanBones");
  if (of_1.is_object())
    for (const auto& [name, bone] : of_1.items()) add_bone(in(bone, "node"), name, nodes, found);
  const Json& of_0 = in(in(in(in(json, "extensions"), "VRM"), "humanoid"), "humanBones");
  if (of_0.is_array())
    for (const Json& bone : of_0)
      if (in(bone, "bone").is_string())
        add_bone(in(bone, "node"), bone["bone"].get<std::string>(), nodes, found);
  if (!found.empty()) return found;
  for (std::size_t n = 0; n < nodes; ++n) {
    const Json& name = in(json["nodes"][n], "name");
    if (!name.is_string()) continue;
    std::string plain = lower_case(name.get<std::string>());
    if (const auto colon = plain.rfind(':'); colon != std::string::npos) plain.erase(0, colon + 1);
    if (plain.starts_with("mixamorig")) plain.erase(0, std::string_view("mixamorig").size());
    for (const Bone& bone : bones)
      if (plain == bone.name || plain == bone.mixamo) found.emplace(bone.name, static_cast<int>(n));
  }
  return found;
}

/// The rig, and the keys of its bones.
class Performer {
 public:
  Performer(std::vector<RestNode> nodes, std::vector<int> order, BoneNodes bone_nodes, const Clip& clip)
      : nodes_(std::move(nodes)), order_(std::move(order)), bone_nodes_(std::move(bone_nodes)), tree_(clip) {
    measure(clip);
  }

  void perform(const Pose& pose, double dt_s);

  struct Track {
    int node = -1;
    std::vector<float> rotations;
  };
  const std::vector<Track>& tracks() const { return tracks_; }
  const std::vector<float>& hips() const { return hips_; }
  int hips_node() const { return bone_nodes_.at("hips"); }

 private:
  Vec3 rest(std::string_view bone) const {
    return nodes_[static_cast<std::size_t>(bone_nodes_.find(bone)->second)].world.translation();
  }
  Vec3 rest_between_legs() const { return 0.5 * (rest("leftupperleg") + rest("rightupperleg")); }
  void measure(const Clip& clip);

  struct Turned {
    std::size_t turner;  ///< node of the tree
    Rotation from_rest;  ///< the bone at rest, turned to the T-pose of the tree
    std::size_t track;
  };
  std::vector<RestNode> nodes_;
  std::vector<int> order_;
  BoneNodes bone_nodes_;
  JointTree tree_;
  std::vector<Rotation> turns_;
  std::map<int, Turned> turned_;
  std::vector<Track> tracks_;
  std::vector<float> hips_;
  Rotation to_front_ = Rotation::Identity();  ///< turns the character at rest to look along +Z
  double legs_ = 1;
  double ankle_rest_ = 0, rig_ankle_rest_ = 0;
};

void Performer::measure(const Clip& clip) {
  Vec3 left = along_floor(rest("leftupperleg") - rest("rightupperleg"));
  left = left.norm() > 1e-9 ? Vec3(left.normalized()) : Vec3(Vec3::UnitX());
  Rotation facing;
  facing << left, Vec3::UnitY(), left.cross(Vec3::UnitY());
  to_front_ = facing.transpose();

  const auto length = [&](const char* a, const char* b) { return (rest(a) - rest(b)).norm(); };
  const double rig_legs =
      0.5 * (length("leftupperleg", "leftlowerleg") + length("leftlowerleg", "leftfoot") +
             length("rightupperleg", "rightlowerleg") + length("rightlowerleg", "rightfoot"));
  const double clip_legs = body_of(clip.poses).leg_length();
  legs_ = clip_legs > 1e-6 && rig_legs > 1e-6 ? rig_legs / clip_legs : 1;
  std::vector<double> ankles;
  for (const Pose& pose : clip.poses)
    ankles.push_back(std::min(pose(joints::left_ankle, 1), pose(joints::right_ankle, 1)));
  ankle_rest_ = percentile(ankles, 0.05);
  rig_ankle_rest_ = std::min(rest("leftfoot").y(), rest("rightfoot").y());

  for (const Bone& bone : bones) {
    const auto found = bone_nodes_.find(bone.name);
    if (found == bone_nodes_.end()) continue;
    const auto turner = std::ranges::find(tree_.nodes(), bone.turner, &JointTree::Node::name);
    Rotation from_rest = to_front_ * rotation_of(nodes_[static_cast<std::size_t>(found->second)].world);
    if (!bone.next.empty()) {
      const Vec3 along = to_front_ * (rest(bone.next) - rest(bone.name));
      if (along.norm() > 1e-9)
        from_rest = swing(along.normalized(), rest_direction(turner->aims_at)) * from_rest;
    }
    turned_.emplace(found->second, Turned{static_cast<std::size_t>(turner - tree_.nodes().begin()), from_rest,
                                          tracks_.size()});
    tracks_.push_back({found->second, {}});
  }
}

void Performer::perform(const Pose& pose, double dt_s) {
  tree_.rotations(pose, dt_s, turns_);
  std::vector<Eigen::Affine3d> world(nodes_.size());
  for (const int n : order_) {
    const auto at = static_cast<std::size_t>(n);
    const RestNode& node = nodes_[at];
    const Eigen::Affine3d parent =
        node.parent < 0 ? Eigen::Affine3d::Identity() : world[static_cast<std::size_t>(node.parent)];
    const auto turned = turned_.find(n);
    if (turned == turned_.end()) {
      world[at] = parent * node.local;
      continue;
    }
    const Rotation goal = turns_[turned->second.turner] * turned->second.from_rest;
    const Rotation local = rotation_of(parent).transpose() * goal;
    Vec3 translation = node.local.translation();
    if (n == hips_node()) {
      const Vec3 between = 0.5 * (joint_at(pose, joints::left_hip) + joint_at(pose, joints::right_hip));
      const Vec3 goal_between = legs_ * along_floor(between) +
                                Vec3::UnitY() * (rig_ankle_rest_ + legs_ * (between.y() - ankle_rest_));
      const Vec3 hips = goal_between - turns_[turned->second.turner] * to_front_ *
                                           (rest_between_legs() - node.world.translation());
      translation = parent.inverse() * hips;
      for (const int axis : {0, 1, 2}) hips_.push_back(static_cast<float>(translation[axis]));
    }
    const Vec3 scale = node.local.linear().colwise().norm();
    const Eigen::Quaterniond turn(local);
    world[at] = parent * Eigen::Translation3d(translation) * turn * Eigen::Scaling(scale);
    // Of the two quaternions of a rotation the one nearer to the key before: readers blend keys as they
    // stand.
    Eigen::Vector4f key = turn.normalized().coeffs().cast<float>();
    std::vector<float>& keys = tracks_[turned->second.track].rotations;
    if (keys.size() >= 4 && key.dot(Eigen::Map<const Eigen::Vector4f>(&keys[keys.size() - 4])) < 0)
      key = -key;
    keys.insert(keys.end(), key.data(), key.data() + 4);
  }
}

/// Adds values to the file's buffer. @return number of their accessor
int add_accessor(Glb& glb, const std::vector<float>& values, int per_value, const char* type) {
  glb.binary.resize((glb.binary.size() + 3) / 4 * 4);
  Json& views = glb.json["bufferViews"];
  Json& accessors = glb.json["accessors"];
  views.push_back({{"buffer", 0}, {"byteOffset", glb.binary.size()}, {"byteLength", values.size() * 4}});
  glb.binary.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
  Json accessor = {{"bufferView", views.size() - 1},
                   {"componentType", float_component},
                   {"count", values.size() / static_cast<std::size_t>(per_value)},
                   {"type", type}};
  if (per_value == 1) {
    accessor["min"] = {values.front()};
    accessor["max"] = {values.back()};
  }
  accessors.push_back(std::move(accessor));
  return static_cast<int>(accessors.size()) - 1;
}

void add_animation(Glb& glb, const Performer& performer, const std::vector<float>& times_s) {
  Json animation = {{"name", "motion"}, {"samplers", Json::array()}, {"channels", Json::array()}};
  const int times = add_accessor(glb, times_s, 1, "SCALAR");
  const auto add_track = [&](int node, const char* path, int values) {
    animation["samplers"].push_back({{"input", times}, {"output", values}, {"interpolation", "LINEAR"}});
    animation["channels"].push_back(
        {{"sampler", animation["samplers"].size() - 1}, {"target", {{"node", node}, {"path", path}}}});
  };
  for (const Performer::Track& track : performer.tracks())
    add_track(track.node, "rotation", add_accessor(glb, track.rotations, 4, "VEC4"));
  add_track(performer.hips_node(), "translation", add_accessor(glb, performer.hips(), 3, "VEC3"));
  glb.json["animations"] = Json::array({std::move(animation)});
  Json& buffers = glb.json["buffers"];
  if (buffers.empty()) buffers.push_back(Json::object());
  buffers[0]["byteLength"] = glb.binary.size();
}

void append_chunk(std::string& file, std::uint64_t kind, std::string content, char filler) {
  content.resize((content.size() + 3) / 4 * 4, filler);
  for (const std::uint64_t number : {static_cast<std::uint64_t>(content.size()), kind})
    for (int byte = 0; byte < 4; ++byte) file += static_cast<char>(number >> (8 * byte) & 0xFFU);
  file += content;
}

Result<std::string> text_of(const Glb& glb, const std::string& where) {
  std::string chunks;
  append_chunk(chunks, json_chunk, glb.json.dump(-1, ' ', false, Json::error_handler_t::replace), ' ');
  append_chunk(chunks, binary_chunk, glb.binary, '\0');
  const std::size_t bytes = header_bytes + chunks.size();
  if (bytes > std::numeric_limits<std::uint32_t>::max())
    return Error{"the character with its motion is longer than a GLB file can be (4 GB)", where};
  std::string file = "glTF";
  for (const std::uint64_t number : {std::uint64_t{2}, static_cast<std::uint64_t>(bytes)})
    for (int byte = 0; byte < 4; ++byte) file += static_cast<char>(number >> (8 * byte) & 0xFFU);
  return file + chunks;
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

Result<std::string> write_character_glb(std::string_view character, const Clip& clip,
                                        const std::string& where) {
  if (clip.poses.empty() || !(clip.fps > 0)) return Error{"has no frames", clip.name};
  auto glb = parse_glb(character, where);
  if (!glb) return glb.error();
  std::vector<RestNode> nodes;
  std::vector<int> order;
  if (!read_nodes(glb->json["nodes"], nodes, order) || !has_lists(glb->json))
    return Error{"its nodes or buffers are damaged", where};
  BoneNodes found = bone_nodes(glb->json);
  std::string missing;
  for (const Bone& bone : bones)
    if (bone.is_required && !found.contains(bone.name))
      missing += (missing.empty() ? "" : ", ") + std::string(bone.name);
  if (!missing.empty())
    return Error{
        "is no humanoid whose bones are known by VRM's list or by the names of VRM or Mixamo; it lacks " +
            missing,
        where};
  Performer performer(std::move(nodes), std::move(order), std::move(found), clip);
  std::vector<float> times_s;
  for (std::size_t f = 0; f < clip.poses.size(); ++f) {
    times_s.push_back(static_cast<float>(static_cast<double>(f) / clip.fps));
    performer.perform(clip.poses[f], 1 / clip.fps);
  }
  add_animation(*glb, performer, times_s);
  return text_of(*glb, where);
}

Status check_character_file(const std::string& output) {
  if (output.ends_with(".glb") || output.ends_with(".vrm")) return Done{};
  return Error{"a character with its motion is written as .glb or .vrm", output};
}

Result<std::vector<std::string>> character_performances(const std::string& character,
                                                        std::span<const Clip> clips) {
  const auto file = read_whole_file(character);
  if (!file) return file.error();
  std::vector<std::string> performances;
  for (const Clip& clip : clips) {
    auto performed = write_character_glb(*file, clip, character);
    if (!performed) return performed.error();
    performances.push_back(std::move(*performed));
  }
  return performances;
}

}  // namespace abrazo
