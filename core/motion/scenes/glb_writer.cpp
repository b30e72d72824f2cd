#include "core/motion/scenes/glb_writer.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <sstream>

#include "core/base/positions.hpp"
#include "core/base/version.hpp"
#include "core/motion/body/body_surface.hpp"
#include "core/motion/body/joint_tree.hpp"

// Only the writer is used, and no image is ever written.
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>

namespace abrazo {

namespace {

using Rotation = Eigen::Matrix3d;
using Quaternions = std::vector<Eigen::Vector4f>;  ///< x, y, z, w
using Vectors = std::vector<Eigen::Vector3f>;

/// A joint that leaves its rest offset from its parent by more gets a translation track [m]. Along a limb of
/// 7 bones the error stays below 0.1 mm.
constexpr double rigid_m = 1e-5;

/// The glTF under construction: values go into one buffer, in the order they are added.
class GltfBuffer {
 public:
  explicit GltfBuffer(tinygltf::Model& model) : model_(model) { model_.buffers.emplace_back(); }

  /// @return number of the accessor. @param target  of the buffer view: 0 for values that no vertex has
  int add(const void* values, std::size_t count, std::size_t bytes_each, int component_type, int type,
          int target = 0) {
    std::vector<unsigned char>& data = model_.buffers[0].data;
    data.resize((data.size() + 3) / 4 * 4);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = count * bytes_each;
    view.target = target;
    model_.bufferViews.push_back(view);
    const auto* bytes = static_cast<const unsigned char*>(values);
    data.insert(data.end(), bytes, bytes + count * bytes_each);
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
    accessor.componentType = component_type;
    accessor.count = count;
    accessor.type = type;
    model_.accessors.push_back(accessor);
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  int add_times(const std::vector<float>& times_s) {
    const int number = add(times_s.data(), times_s.size(), sizeof(float), TINYGLTF_COMPONENT_TYPE_FLOAT,
                           TINYGLTF_TYPE_SCALAR);
    model_.accessors.back().minValues = {static_cast<double>(times_s.front())};
    model_.accessors.back().maxValues = {static_cast<double>(times_s.back())};
    return number;
  }
  int add_vectors(const Vectors& vectors, int target = 0) {
    return add(vectors.data(), vectors.size(), sizeof(Eigen::Vector3f), TINYGLTF_COMPONENT_TYPE_FLOAT,
               TINYGLTF_TYPE_VEC3, target);
  }
  int add_quaternions(const Quaternions& quaternions) {
    return add(quaternions.data(), quaternions.size(), sizeof(Eigen::Vector4f), TINYGLTF_COMPONENT_TYPE_FLOAT,
               TINYGLTF_TYPE_VEC4);
  }
  /// Corners as a mesh needs them: with their bounds.
  int add_corners(const Vectors& corners) {
    const int number = add_vectors(corners, TINYGLTF_TARGET_ARRAY_BUFFER);
    Eigen::Vector3f low = corners.front(), high = corners.front();
    for (const Eigen::Vector3f& corner : corners) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
    for (int axis = 0; axis < 3; ++axis) {
      model_.accessors.back().minValues.push_back(static_cast<double>(low[axis]));
      model_.accessors.back().maxValues.push_back(static_cast<double>(high[axis]));
    }
    return number;
  }
  std::size_t bytes() const { return model_.buffers[0].data.size(); }

 private:
  tinygltf::Model& model_;
};

/// The keys of one node, relative to its parent.
struct NodeKeys {
  Quaternions rotations;
  Vectors translations;
  bool is_rigid = true;  ///< always as far from its parent as at rest: needs no translations

  void add(const std::vector<JointTree::Node>& nodes, std::size_t n, const Pose& pose,
           const std::vector<Rotation>& world);
};

void NodeKeys::add(const std::vector<JointTree::Node>& nodes, std::size_t n, const Pose& pose,
                   const std::vector<Rotation>& world) {
  const JointTree::Node& node = nodes[n];
  Rotation rotation = world[n];
  Vec3 translation = joint_at(pose, node.joint);
  if (node.parent >= 0) {
    const auto parent = static_cast<std::size_t>(node.parent);
    rotation = world[parent].transpose() * world[n];
    translation = world[parent].transpose() * (translation - joint_at(pose, nodes[parent].joint));
  }
  // Of the two quaternions of a rotation the one nearer to the key before: readers blend keys as they stand.
  Eigen::Vector4f key = Eigen::Quaterniond(rotation).normalized().coeffs().cast<float>();
  if (!rotations.empty() && key.dot(rotations.back()) < 0) key = -key;
  rotations.push_back(key);
  translations.push_back(translation.cast<float>());
  is_rigid = is_rigid && node.parent >= 0 && (translation - node.offset).norm() <= rigid_m;
}

/// One clip's part of the file.
class Character {
 public:
  Character(const Clip& clip, std::string prefix, int number, tinygltf::Model& model, GltfBuffer& buffer);

  void add_skeleton();
  void add_body();
  void add_tracks(tinygltf::Animation& animation);

 private:
  std::vector<Vec3> rest_places() const;
  void add_skin(const std::vector<Vec3>& places);
  int add_material();
  void add_track(tinygltf::Animation& animation, std::size_t node, const char* path, int times, int values);

  const Clip& clip_;
  std::string prefix_;
  int number_;  ///< of the character in the file, from 0
  tinygltf::Model& model_;
  GltfBuffer& buffer_;
  JointTree tree_;
  int first_node_ = -1;  ///< of the model: that of the tree's node 0
  int skin_ = -1;
};

Character::Character(const Clip& clip, std::string prefix, int number, tinygltf::Model& model,
                     GltfBuffer& buffer)
    : clip_(clip), prefix_(std::move(prefix)), number_(number), model_(model), buffer_(buffer), tree_(clip) {}

/// Where the nodes stand in the T-pose, with the lowest of them on the floor and the root over the origin.
std::vector<Vec3> Character::rest_places() const {
  const auto& nodes = tree_.nodes();
  std::vector<Vec3> places(nodes.size(), Vec3::Zero());
  double lowest = 0;
  for (std::size_t n = 1; n < nodes.size(); ++n) {
    places[n] = places[static_cast<std::size_t>(nodes[n].parent)] + nodes[n].offset;
    lowest = std::min(lowest, places[n].y());
  }
  for (Vec3& place : places) place.y() -= lowest;
  return places;
}

void Character::add_skeleton() {
  const auto& nodes = tree_.nodes();
  const std::vector<Vec3> places = rest_places();
  first_node_ = static_cast<int>(model_.nodes.size());
  for (const auto& node : nodes) {
    tinygltf::Node added;
    added.name = prefix_ + node.name;
    const Vec3 offset = node.parent < 0 ? places.front() : node.offset;
    added.translation = {offset.x(), offset.y(), offset.z()};
    for (const int child : node.children) added.children.push_back(first_node_ + child);
    model_.nodes.push_back(added);
  }
  // Beside one another as in the first frame, also where nothing plays the animation.
  model_.nodes[static_cast<std::size_t>(first_node_)].translation[0] = clip_.poses.front()(joints::Root, 0);
  model_.nodes[static_cast<std::size_t>(first_node_)].translation[2] = clip_.poses.front()(joints::Root, 2);
  // Below a node of its own, so that every reader takes each character for a skeleton of its own.
  tinygltf::Node group;
  group.name = clip_.name.empty() ? "character" : clip_.name;
  group.children = {first_node_};
  model_.nodes.push_back(group);
  model_.scenes[0].nodes.push_back(static_cast<int>(model_.nodes.size()) - 1);
  add_skin(places);
}

void Character::add_skin(const std::vector<Vec3>& places) {
  tinygltf::Skin skin;
  skin.name = clip_.name.empty() ? "character" : clip_.name;
  skin.skeleton = first_node_;
  std::vector<Eigen::Matrix4f> inverse_binds;
  for (std::size_t n = 0; n < places.size(); ++n) {
    skin.joints.push_back(first_node_ + static_cast<int>(n));
    Eigen::Matrix4f& inverse = inverse_binds.emplace_back(Eigen::Matrix4f::Identity());
    inverse.topRightCorner<3, 1>() = -places[n].cast<float>();
  }
  skin.inverseBindMatrices = buffer_.add(inverse_binds.data(), inverse_binds.size(), sizeof(Eigen::Matrix4f),
                                         TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_MAT4);
  model_.skins.push_back(skin);
  skin_ = static_cast<int>(model_.skins.size()) - 1;
}

int Character::add_material() {
  constexpr std::array<std::array<double, 3>, 2> colours = {{{0.05, 0.27, 0.80}, {0.89, 0.16, 0.08}}};
  tinygltf::Material material;
  material.name = model_.skins[static_cast<std::size_t>(skin_)].name;
  const auto& colour = colours[static_cast<std::size_t>(number_) % colours.size()];
  material.pbrMetallicRoughness.baseColorFactor = {colour[0], colour[1], colour[2], 1};
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.pbrMetallicRoughness.roughnessFactor = 0.8;
  model_.materials.push_back(material);
  return static_cast<int>(model_.materials.size()) - 1;
}

void Character::add_body() {
  const auto& nodes = tree_.nodes();
  const BodySurface surface = body_surface(nodes, rest_places());
  Vectors corners, normals;
  std::vector<std::array<std::uint8_t, 4>> joints;
  for (const BodySurface::Vertex& vertex : surface.vertices) {
    corners.push_back(vertex.place.cast<float>());
    normals.push_back(vertex.normal.cast<float>());
    joints.push_back({static_cast<std::uint8_t>(vertex.node), 0, 0, 0});
  }
  const std::vector<Eigen::Vector4f> weights(corners.size(), Eigen::Vector4f(1, 0, 0, 0));
  tinygltf::Primitive primitive;
  primitive.attributes["POSITION"] = buffer_.add_corners(corners);
  primitive.attributes["NORMAL"] = buffer_.add_vectors(normals, TINYGLTF_TARGET_ARRAY_BUFFER);
  primitive.attributes["JOINTS_0"] =
      buffer_.add(joints.data(), joints.size(), 4, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_TYPE_VEC4,
                  TINYGLTF_TARGET_ARRAY_BUFFER);
  primitive.attributes["WEIGHTS_0"] =
      buffer_.add(weights.data(), weights.size(), sizeof(Eigen::Vector4f), TINYGLTF_COMPONENT_TYPE_FLOAT,
                  TINYGLTF_TYPE_VEC4, TINYGLTF_TARGET_ARRAY_BUFFER);
  primitive.indices = buffer_.add(surface.corners.data(), surface.corners.size(), sizeof(std::uint16_t),
                                  TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR,
                                  TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  primitive.material = add_material();
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  tinygltf::Mesh mesh;
  mesh.name = prefix_ + "body";
  mesh.primitives.push_back(primitive);
  model_.meshes.push_back(mesh);
  tinygltf::Node node;
  node.name = mesh.name;
  node.mesh = static_cast<int>(model_.meshes.size()) - 1;
  node.skin = skin_;
  model_.nodes.push_back(node);
  model_.scenes[0].nodes.push_back(static_cast<int>(model_.nodes.size()) - 1);
}

void Character::add_track(tinygltf::Animation& animation, std::size_t node, const char* path, int times,
                          int values) {
  tinygltf::AnimationSampler sampler;
  sampler.input = times;
  sampler.output = values;
  sampler.interpolation = "LINEAR";
  animation.samplers.push_back(sampler);
  tinygltf::AnimationChannel channel;
  channel.sampler = static_cast<int>(animation.samplers.size()) - 1;
  channel.target_node = first_node_ + static_cast<int>(node);
  channel.target_path = path;
  animation.channels.push_back(channel);
}

void Character::add_tracks(tinygltf::Animation& animation) {
  std::vector<NodeKeys> keys(tree_.nodes().size());
  std::vector<float> times_s;
  std::vector<Rotation> world;
  for (std::size_t f = 0; f < clip_.poses.size(); ++f) {
    times_s.push_back(static_cast<float>(static_cast<double>(f) / clip_.fps));
    tree_.rotations(clip_.poses[f], 1.0 / clip_.fps, world);
    for (std::size_t n = 0; n < keys.size(); ++n) keys[n].add(tree_.nodes(), n, clip_.poses[f], world);
  }
  const int times = buffer_.add_times(times_s);
  for (std::size_t n = 0; n < keys.size(); ++n) {
    add_track(animation, n, "rotation", times, buffer_.add_quaternions(keys[n].rotations));
    if (!keys[n].is_rigid)
      add_track(animation, n, "translation", times, buffer_.add_vectors(keys[n].translations));
  }
}

Status check(std::span<const Clip> clips) {
  if (clips.empty()) return Error{"there is no clip to write", ""};
  std::set<std::string> names;
  for (const Clip& clip : clips) {
    if (clip.poses.empty()) return Error{"has no frames", clip.name};
    if (!(clip.fps > 0) || !std::isfinite(clip.fps)) return Error{"has no frame rate", clip.name};
    if (clips.size() > 1 && (clip.name.empty() || !names.insert(clip.name).second))
      return Error{"clips in one GLB file need names that differ", clip.name};
    for (std::size_t f = 0; f < clip.poses.size(); ++f)
      if (!clip.poses[f].allFinite())
        return Error{"has a position that is not finite", clip.name + ": frame " + std::to_string(f)};
  }
  return Done{};
}

Result<std::string> text_of(tinygltf::Model& model) {
  std::ostringstream out;
  if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, out, false, true))
    return Error{"the GLB could not be put together", ""};
  return out.str();
}

}  // namespace

Result<std::string> write_glb(std::span<const Clip> clips) {
  if (const Status checked = check(clips); !checked) return checked.error();
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = std::string("Abrazo ") + version();
  model.scenes.emplace_back();
  model.defaultScene = 0;
  GltfBuffer buffer(model);
  tinygltf::Animation animation;
  animation.name = "motion";
  for (std::size_t c = 0; c < clips.size(); ++c) {
    const std::string prefix = clips.size() > 1 ? clips[c].name + ":" : "";
    Character character(clips[c], prefix, static_cast<int>(c), model, buffer);
    character.add_skeleton();
    character.add_body();
    character.add_tracks(animation);
  }
  // A GLB counts its bytes in 32 bits; the JSON before the buffer takes a few kB per character.
  if (buffer.bytes() > std::numeric_limits<std::uint32_t>::max() - (std::size_t{16} << 20))
    return Error{
        "the motion is longer than a GLB file can hold (4 GB); write a part of it, or at a lower rate",
        clips[0].name};
  model.animations.push_back(std::move(animation));
  return text_of(model);
}

}  // namespace abrazo
