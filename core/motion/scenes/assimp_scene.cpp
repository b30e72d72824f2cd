#include "core/motion/scenes/assimp_scene.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <map>
#include <set>

#include "core/base/line_reader.hpp"
#include "core/base/text.hpp"
#include "core/motion/joints/performers.hpp"
#include "core/motion/scenes/scene_animation.hpp"
#include "core/motion/scenes/scene_hierarchy.hpp"
#include "core/motion/scenes/scene_nesting.hpp"

namespace abrazo {

namespace {

constexpr const char* helper_mark = "_$AssimpFbx$_";  ///< in names of nodes that hold a pivot or one rotation
constexpr std::size_t most_nodes = 100'000;
constexpr std::size_t deepest = 1000;  ///< levels: Assimp descends by recursion

double ticks_per_second(const aiAnimation& animation) {
  return animation.mTicksPerSecond > 0 && std::isfinite(animation.mTicksPerSecond) ? animation.mTicksPerSecond
                                                                                   : 25.0;
}

/// In seconds, as the keys have it: `mDuration` may be wrong.
double length_s(const aiAnimation& animation) {
  double last = 0;
  for (unsigned c = 0; c < animation.mNumChannels; ++c) {
    const aiNodeAnim& channel = *animation.mChannels[c];
    if (channel.mNumPositionKeys > 0)
      last = std::max(last, channel.mPositionKeys[channel.mNumPositionKeys - 1].mTime);
    if (channel.mNumRotationKeys > 0)
      last = std::max(last, channel.mRotationKeys[channel.mNumRotationKeys - 1].mTime);
  }
  return last / ticks_per_second(animation);
}

class SceneReader {
 public:
  SceneReader(const aiScene& scene, MotionFormat format, const std::string& file)
      : scene_(scene), format_(format), file_(file) {}
  Result<std::vector<NamedMotion>> read();

 private:
  Status add_nodes();
  void note_bones();
  Status check_names() const;
  std::vector<const aiAnimation*> choose_animations();
  Status add_channel(const aiNodeAnim& channel, double ticks);
  void settle(NamedMotion& motion) const;

  const aiScene& scene_;
  MotionFormat format_;
  std::string file_;
  std::vector<SceneNode> nodes_;
  std::map<std::string, std::size_t> places_;
  std::vector<ImportWarning> warnings_;
};

Eigen::Affine3d affine(const aiMatrix4x4& matrix) {
  Eigen::Affine3d result;
  for (unsigned r = 0; r < 3; ++r)
    for (unsigned c = 0; c < 4; ++c)
      result.matrix()(static_cast<int>(r), static_cast<int>(c)) = static_cast<double>(matrix[r][c]);
  result.makeAffine();
  return result;
}

/// Parents first, without recursion: a file decides how deep they are.
Status SceneReader::add_nodes() {
  std::vector<std::pair<const aiNode*, int>> pending{{scene_.mRootNode, -1}};
  while (!pending.empty()) {
    const auto [node, parent] = pending.back();
    pending.pop_back();
    if (nodes_.size() >= most_nodes)
      return Error{"has more than " + std::to_string(most_nodes) + " nodes; export the skeletons alone",
                   file_};
    SceneNode added;
    added.name = node->mName.C_Str();
    added.parent = parent;
    added.rest = affine(node->mTransformation);
    added.is_helper = added.name.find(helper_mark) != std::string::npos;
    added.is_other = node->mNumMeshes > 0;
    if (!added.rest.matrix().allFinite())
      return Error{"the node " + in_quotes(added.name) +
                       " is not at a place; its matrix holds numbers that are not finite",
                   file_};
    const int place = static_cast<int>(nodes_.size());
    places_.emplace(added.name, nodes_.size());
    nodes_.push_back(std::move(added));
    for (unsigned c = node->mNumChildren; c-- > 0;) pending.emplace_back(node->mChildren[c], place);
  }
  return Done{};
}

void SceneReader::note_bones() {
  for (unsigned m = 0; m < scene_.mNumMeshes; ++m)
    for (unsigned b = 0; b < scene_.mMeshes[m]->mNumBones; ++b)
      if (const auto found = places_.find(scene_.mMeshes[m]->mBones[b]->mName.C_Str());
          found != places_.end()) {
        nodes_[found->second].is_bone = true;
        nodes_[found->second].is_other = false;  // formats may hang a mesh on a bone
      }
  const auto note_other = [this](const aiString& name) {
    if (const auto found = places_.find(name.C_Str()); found != places_.end())
      nodes_[found->second].is_other = true;
  };
  for (unsigned c = 0; c < scene_.mNumCameras; ++c) note_other(scene_.mCameras[c]->mName);
  for (unsigned l = 0; l < scene_.mNumLights; ++l) note_other(scene_.mLights[l]->mName);
}

/// Animations name their nodes: two of one name cannot be distinguished.
Status SceneReader::check_names() const {
  std::set<std::string> moved;
  for (unsigned a = 0; a < scene_.mNumAnimations; ++a)
    for (unsigned c = 0; c < scene_.mAnimations[a]->mNumChannels; ++c)
      moved.insert(scene_.mAnimations[a]->mChannels[c]->mNodeName.C_Str());
  std::map<std::string, int> times;
  std::vector<std::string> doubled;
  for (const SceneNode& node : nodes_)
    if (!node.is_other && moved.contains(node.name) && ++times[node.name] == 2) doubled.push_back(node.name);
  if (doubled.empty()) return Done{};
  const std::string first = in_quotes(doubled.front());
  return Error{std::to_string(times[doubled.front()]) + " nodes are named " + first +
                   (doubled.size() > 1 ? ", and " + std::to_string(doubled.size() - 1) +
                                             " other names are there more than once"
                                       : std::string()) +
                   "; animations tell them by their names, so rename one armature's bones, or export each "
                   "performer to a file of its own",
               file_};
}

/// Exporters give every armature an animation of its own: those that move different nodes belong together. Of
/// several of the same nodes the longest is taken.
std::vector<const aiAnimation*> SceneReader::choose_animations() {
  std::vector<const aiAnimation*> by_length(scene_.mAnimations, scene_.mAnimations + scene_.mNumAnimations);
  std::stable_sort(by_length.begin(), by_length.end(),
                   [](const aiAnimation* a, const aiAnimation* b) { return length_s(*a) > length_s(*b); });
  std::vector<const aiAnimation*> chosen;
  std::vector<std::string> names, left_out;
  std::set<std::string> moved;
  for (const aiAnimation* animation : by_length) {
    std::set<std::string> nodes;
    for (unsigned c = 0; c < animation->mNumChannels; ++c)
      nodes.insert(animation->mChannels[c]->mNodeName.C_Str());
    const bool apart =
        std::none_of(nodes.begin(), nodes.end(), [&](const auto& node) { return moved.contains(node); });
    (apart ? names : left_out).emplace_back(animation->mName.C_Str());
    if (!apart) continue;
    chosen.push_back(animation);
    moved.merge(nodes);
  }
  if (!left_out.empty())
    warnings_.push_back({"animations", 0,
                         "holds " + std::to_string(by_length.size()) + " animations; the longest, " +
                             in_quotes(some_of(names)) + ", was taken, and left out: " + some_of(left_out)});
  return chosen;
}

/// Keys that go back in time are left out.
template <typename Key, typename Value, typename Convert>
bool take_keys(const Key* keys, unsigned count, double ticks, Keys<Value>& into, Convert convert) {
  if (!into.times_s.empty()) return true;
  for (unsigned k = 0; k < count; ++k) {
    const double time = keys[k].mTime / ticks;
    const Value value = convert(keys[k].mValue);
    if (!std::isfinite(time)) return false;
    if (!into.times_s.empty() && !(time > into.times_s.back())) continue;
    into.times_s.push_back(time);
    into.values.push_back(value);
  }
  return true;
}

Status SceneReader::add_channel(const aiNodeAnim& channel, double ticks) {
  const auto found = places_.find(channel.mNodeName.C_Str());
  if (found == places_.end()) return Done{};
  SceneNode& node = nodes_[found->second];
  const auto vector = [](const aiVector3D& v) -> Vec3 {
    return Eigen::Vector3f(v.x, v.y, v.z).cast<double>();
  };
  const auto quaternion = [](const aiQuaternion& q) {
    return Eigen::Quaternionf(q.w, q.x, q.y, q.z).cast<double>().normalized();
  };
  const bool good =
      take_keys(channel.mPositionKeys, channel.mNumPositionKeys, ticks, node.translations, vector) &&
      take_keys(channel.mRotationKeys, channel.mNumRotationKeys, ticks, node.rotations, quaternion) &&
      take_keys(channel.mScalingKeys, channel.mNumScalingKeys, ticks, node.scales, vector);
  const auto finite = [](const auto& keys) {
    return std::all_of(keys.values.begin(), keys.values.end(),
                       [](const Vec3& value) { return value.allFinite(); });
  };
  const bool turns = std::all_of(node.rotations.values.begin(), node.rotations.values.end(),
                                 [](const Eigen::Quaterniond& q) { return q.coeffs().allFinite(); });
  if (!good || !turns || !finite(node.translations) || !finite(node.scales))
    return Error{
        "the animation of " + in_quotes(node.name) + " holds numbers that are not finite; export it again",
        file_};
  return Done{};
}

void SceneReader::settle(NamedMotion& motion) const {
  motion.warnings.insert(motion.warnings.end(), warnings_.begin(), warnings_.end());
  if (format_ != MotionFormat::Fbx) {
    // glTF is in metres, Y up; the Collada reader has turned and scaled the scene to that.
    motion.metres_per_unit = 1.0;
    motion.up_axis = UpAxis::Y;
    return;
  }
  if (!scene_.mMetaData) return;
  double centimetres = 0;
  float as_float = 0;
  if (!scene_.mMetaData->Get("UnitScaleFactor", centimetres) &&
      scene_.mMetaData->Get("UnitScaleFactor", as_float))
    centimetres = static_cast<double>(as_float);
  if (centimetres > 0 && std::isfinite(centimetres)) motion.metres_per_unit = centimetres / 100;
  int32_t up = -1;
  if (scene_.mMetaData->Get("UpAxis", up) && (up == 1 || up == 2))
    motion.up_axis = up == 1 ? UpAxis::Y : UpAxis::Z;
}

Result<std::vector<NamedMotion>> SceneReader::read() {
  if (const Status added = add_nodes(); !added) return added.error();
  note_bones();
  if (scene_.mNumAnimations == 0)
    return Error{"holds no animation; export it with its animation baked", file_};
  if (const Status told_apart = check_names(); !told_apart) return told_apart.error();
  for (const aiAnimation* animation : choose_animations())
    for (unsigned c = 0; c < animation->mNumChannels; ++c)
      if (const Status added = add_channel(*animation->mChannels[c], ticks_per_second(*animation)); !added)
        return added.error();
  Result<std::vector<NamedMotion>> motions = skeletons_of(nodes_, std::nullopt, file_);
  if (!motions) return motions.error();
  for (NamedMotion& motion : *motions) settle(motion);
  return motions;
}

const char* hint_of(MotionFormat format, std::string_view bytes) {
  if (format == MotionFormat::Fbx) return "fbx";
  if (format == MotionFormat::Collada) return "dae";
  return bytes.starts_with("glTF") ? "glb" : "gltf";
}

/// Assimp's words for the reader's name in front are of no use to anyone.
std::string assimp_words(const std::string& text) {
  std::string words = text.empty() ? "no reason was given" : text.substr(0, 300);
  if (words.starts_with("No suitable reader")) return "its beginning or its structure is damaged";
  for (const char* name : {"FBX-DOM ", "FBX-Parser ", "FBX-Tokenize ", "FBX-Convert ", "GLTF: ", "Collada: "})
    if (words.starts_with(name)) words.erase(0, std::string_view(name).size());
  return words;
}

}  // namespace

Result<std::vector<NamedMotion>> read_scene(std::string_view bytes, MotionFormat format,
                                            const std::string& file) {
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_TEXTURES, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_MATERIALS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_CAMERAS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_LIGHTS, false);
  const char* hint = hint_of(format, bytes);
  if (scene_nesting(bytes, format) > deepest)
    return Error{"has elements more than " + std::to_string(deepest) +
                     " deep inside each other, which no skeleton has; it is damaged",
                 file};
  const Result<SceneHierarchy> hierarchy = scene_hierarchy(bytes, format, file);
  if (!hierarchy) return hierarchy.error();
  if (const Status tree = check_hierarchy(*hierarchy, deepest, most_nodes, file); !tree) return tree.error();
  // A .gltf may name files beside it; the others hold everything.
  const bool by_name = hint == std::string_view("gltf");
  const aiScene* scene =
      by_name ? importer.ReadFile(file, 0) : importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, hint);
  if (!scene || !scene->mRootNode)
    return Error{"cannot be read as " + std::string(name_of(format)) + " (" +
                     assimp_words(importer.GetErrorString()) +
                     "); export it again, or as another of FBX, GLB and BVH",
                 file};
  return SceneReader(*scene, format, file).read();
}

}  // namespace abrazo
