#include "core/motion/scenes/assimp_scene.hpp"

#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdint>
#include <map>
#include <new>
#include <set>

#include "core/base/line_reader.hpp"
#include "core/base/text.hpp"
#include "core/motion/joints/performers.hpp"
#include "core/motion/scenes/files_beside.hpp"
#include "core/motion/scenes/scene_animation.hpp"
#include "core/motion/scenes/scene_hierarchy.hpp"
#include "core/motion/scenes/scene_nesting.hpp"

namespace abrazo {

namespace {

constexpr const char* helper_mark = "_$AssimpFbx$_";  ///< in names of nodes that hold a pivot or one rotation
constexpr const char* post_rotation = "_$AssimpFbx$_PostRotation";
constexpr std::size_t most_nodes = 100'000;
constexpr std::size_t deepest = 1000;  ///< levels: Assimp descends by recursion

/// Below 0 where Assimp does not know the time mode of an FBX file; the keys' ticks are then too.
double ticks_per_second(const aiAnimation& animation) {
  return animation.mTicksPerSecond != 0 && std::isfinite(animation.mTicksPerSecond)
             ? animation.mTicksPerSecond
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
  SceneReader(const aiScene& scene, MotionFormat format, const std::string& file,
              const std::string& animation, bool all_are_bones)
      : scene_(scene), format_(format), file_(file), wanted_(animation), all_are_bones_(all_are_bones) {}
  Result<std::vector<NamedMotion>> read();

 private:
  Status add_nodes();
  void note_bones();
  Status check_names() const;
  Result<std::vector<const aiAnimation*>> choose_animations();
  std::optional<double> stated_rate(const aiAnimation& animation) const;
  Status add_channel(const aiNodeAnim& channel, double ticks);
  std::vector<std::size_t> helpers_of(const SceneNode& node) const;
  void clear_helpers();
  void settle(NamedMotion& motion) const;
  void settle_fbx_space(NamedMotion& motion) const;

  const aiScene& scene_;
  MotionFormat format_;
  std::string file_, wanted_;
  bool all_are_bones_;
  std::vector<SceneNode> nodes_;
  std::map<std::string, std::size_t> places_;
  std::vector<std::string> animations_;  ///< names of all, those that were taken first
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
  if (all_are_bones_)
    for (SceneNode& node : nodes_) node.is_bone = !node.name.empty();
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
                   "performer to a separate file",
               file_};
}

/// What an animation is called: exporters put the armature in front, "Anna|Walk", or a layer behind.
bool is_called(const std::string& animation, const std::string& wanted) {
  if (animation == wanted) return true;
  const std::vector<std::string_view> parts = split_fields(animation, '|');
  return std::find(parts.begin() + (parts.size() > 1 ? 1 : 0), parts.end(), wanted) != parts.end();
}

/// Exporters give every armature an animation of its own: those that move different nodes belong together. Of
/// several of the same nodes the one that is wanted is taken, or the longest.
Result<std::vector<const aiAnimation*>> SceneReader::choose_animations() {
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
    const std::string name = animation->mName.C_Str();
    const bool takes =
        (wanted_.empty() || is_called(name, wanted_)) &&
        std::none_of(nodes.begin(), nodes.end(), [&](const auto& node) { return moved.contains(node); });
    (takes ? names : left_out).push_back(name);
    if (!takes) continue;
    chosen.push_back(animation);
    moved.merge(nodes);
  }
  if (chosen.empty())
    return Error{"has no animation " + in_quotes(wanted_) + "; it holds " + some_of(left_out, 40), file_};
  if (!left_out.empty() && wanted_.empty())
    warnings_.push_back({"animations", 0,
                         "holds " + std::to_string(by_length.size()) + " animations; the longest, " +
                             in_quotes(some_of(names)) + ", was taken, and left out: " + some_of(left_out),
                         Hint::ChooseAnimation});
  animations_ = names;
  animations_.insert(animations_.end(), left_out.begin(), left_out.end());
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

/// FBX says it; Assimp's ticks are its frames.
std::optional<double> SceneReader::stated_rate(const aiAnimation& animation) const {
  int32_t mode = 0;
  if (format_ != MotionFormat::Fbx || !scene_.mMetaData || !scene_.mMetaData->Get("FrameRate", mode))
    return std::nullopt;
  constexpr double slowest = 2, fastest = 1000;
  const double rate = animation.mTicksPerSecond;
  return mode > 0 && rate >= slowest && rate <= fastest ? std::optional(rate) : std::nullopt;
}

/// The helpers above a node, the nearest first.
std::vector<std::size_t> SceneReader::helpers_of(const SceneNode& node) const {
  std::vector<std::size_t> helpers;
  for (int above = node.parent; above >= 0; above = nodes_[helpers.back()].parent) {
    const SceneNode& helper = nodes_[static_cast<std::size_t>(above)];
    if (!helper.is_helper || !helper.name.starts_with(node.name + helper_mark)) break;
    helpers.push_back(static_cast<std::size_t>(above));
  }
  return helpers;
}

/// Assimp splits a node with pivots or a turn of its joint into helpers above it. Where the keys stand at the
/// node itself, they hold all of its transform, and the helpers would turn it a second time; where they stand
/// at helpers, each has its part.
/// A rotation is Rpre * R * Rpost^-1 (FBX SDK, "Computing transformation matrices"). Assimp 5.2 has that at
/// the helper, and Rpost itself in the keys.
void SceneReader::clear_helpers() {
  const auto moves = [](const SceneNode& node) {
    return !node.translations.times_s.empty() || !node.rotations.times_s.empty() ||
           !node.scales.times_s.empty();
  };
  for (SceneNode& node : nodes_) {
    if (node.is_helper || !moves(node)) continue;
    const std::vector<std::size_t> helpers = helpers_of(node);
    if (std::any_of(helpers.begin(), helpers.end(), [&](std::size_t h) { return moves(nodes_[h]); }))
      continue;
    for (const std::size_t helper : helpers) {
      if (nodes_[helper].name.ends_with(post_rotation)) {
        const Eigen::Quaterniond back(nodes_[helper].rest.linear());
        for (Eigen::Quaterniond& turn : node.rotations.values) turn = turn * back * back;
      }
      nodes_[helper].rest.setIdentity();
    }
  }
}

void SceneReader::settle(NamedMotion& motion) const {
  motion.warnings.insert(motion.warnings.end(), warnings_.begin(), warnings_.end());
  motion.animations = animations_;
  if (format_ == MotionFormat::Fbx) return settle_fbx_space(motion);
  // glTF is in metres, Y up; the Collada reader has turned and scaled the scene to that.
  motion.metres_per_unit = 1.0;
  motion.up_axis = UpAxis::Y;
}

/// Turns the points so that the file's front is where it is in files of the usual axes: Z of Y up, -Y of Z
/// up.
void turn_to_front(NamedMotion& motion, const Eigen::Matrix3d& right_up_front) {
  Eigen::Matrix3d usual = right_up_front;
  if (motion.up_axis == UpAxis::Z) {
    usual.row(1) = -right_up_front.row(2);
    usual.row(2) = right_up_front.row(1);
  }
  if (usual.isIdentity()) return;
  for (Positions& frame : motion.frames) frame *= usual.transpose();
}

void SceneReader::settle_fbx_space(NamedMotion& motion) const {
  if (!scene_.mMetaData) return;
  double centimetres = 0;
  float as_float = 0;
  if (!scene_.mMetaData->Get("UnitScaleFactor", centimetres) &&
      scene_.mMetaData->Get("UnitScaleFactor", as_float))
    centimetres = static_cast<double>(as_float);
  if (centimetres > 0 && std::isfinite(centimetres)) motion.metres_per_unit = centimetres / 100;
  Eigen::Matrix3d right_up_front = Eigen::Matrix3d::Zero();
  int32_t up = -1;
  int row = 0;
  for (const char* name : {"CoordAxis", "UpAxis", "FrontAxis"}) {
    int32_t axis = -1, sign = 1;
    scene_.mMetaData->Get(std::string(name) + "Sign", sign);
    if (scene_.mMetaData->Get(name, axis) && axis >= 0 && axis < 3)
      right_up_front(row, axis) = sign < 0 ? -1 : 1;
    if (row++ == 1) up = axis;
  }
  if (up == 1 || up == 2) motion.up_axis = up == 1 ? UpAxis::Y : UpAxis::Z;
  if (right_up_front.determinant() != 1) return;  // no axes that a right-handed space can have
  if (up == 0) motion.up_axis = UpAxis::Y;
  turn_to_front(motion, right_up_front);
}

Result<std::vector<NamedMotion>> SceneReader::read() {
  if (const Status added = add_nodes(); !added) return added.error();
  note_bones();
  if (scene_.mNumAnimations == 0)
    return Error{"holds no animation; export it with its animation baked", file_};
  if (const Status told_apart = check_names(); !told_apart) return told_apart.error();
  const auto animations = choose_animations();
  if (!animations) return animations.error();
  for (const aiAnimation* animation : *animations)
    for (unsigned c = 0; c < animation->mNumChannels; ++c)
      if (const Status added = add_channel(*animation->mChannels[c], ticks_per_second(*animation)); !added)
        return added.error();
  clear_helpers();
  Result<std::vector<NamedMotion>> motions = skeletons_of(nodes_, stated_rate(*animations->front()), file_);
  if (!motions) return motions.error();
  for (NamedMotion& motion : *motions) settle(motion);
  return motions;
}

const char* hint_of(MotionFormat format, std::string_view bytes) {
  if (format == MotionFormat::Fbx) return "fbx";
  if (format == MotionFormat::Collada) return "dae";
  return bytes.starts_with("glTF") ? "glb" : "gltf";
}

/// Content that the stream owns.
class OwnedStream : public Assimp::IOStream {
 public:
  explicit OwnedStream(std::string content)
      : content_(std::move(content)),
        stream_(reinterpret_cast<const uint8_t*>(content_.data()), content_.size()) {}
  std::size_t Read(void* into, std::size_t size, std::size_t count) override {
    return stream_.Read(into, size, count);
  }
  std::size_t Write(const void* /*from*/, std::size_t /*size*/, std::size_t /*count*/) override { return 0; }
  aiReturn Seek(std::size_t offset, aiOrigin origin) override { return stream_.Seek(offset, origin); }
  std::size_t Tell() const override { return stream_.Tell(); }
  std::size_t FileSize() const override { return stream_.FileSize(); }
  void Flush() override {}

 private:
  std::string content_;
  Assimp::MemoryIOStream stream_;
};

/// All that Assimp sees of the disk: the bytes of the scene under a name of ours, and for .gltf, which may
/// name further files, what lies beside it.
class SceneFiles : public Assimp::IOSystem {
 public:
  SceneFiles(std::string_view bytes, const std::string& hint, const std::string& file)
      : name_("scene." + hint), bytes_(bytes) {
    if (hint == "gltf") beside_.emplace(file);
  }
  const std::string& name() const { return name_; }
  /// Why a file that the scene names was not opened; nothing when all were.
  const std::optional<Error>& refused() const { return refused_; }

  bool Exists(const char* file) const override { return file == name_; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    if (std::string_view(mode).find_first_of("wa+") != std::string_view::npos) return nullptr;
    if (file == name_)
      return new Assimp::MemoryIOStream(reinterpret_cast<const uint8_t*>(bytes_.data()), bytes_.size());
    if (!beside_) return nullptr;
    Result<std::string> content = beside_->read(file);
    if (content) return new OwnedStream(std::move(*content));
    refused_ = content.error();
    return nullptr;
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }
  bool CreateDirectory(const std::string& /*path*/) override { return false; }
  bool ChangeDirectory(const std::string& /*path*/) override { return false; }
  bool DeleteFile(const std::string& /*file*/) override { return false; }

 private:
  std::string name_;
  std::string_view bytes_;
  std::optional<FilesBeside> beside_;
  std::optional<Error> refused_;
};

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
                                            const std::string& file, const std::string& animation) {
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
  auto* files = new SceneFiles(bytes, hint, file);
  importer.SetIOHandler(files);  // which deletes it
  const aiScene* scene = importer.ReadFile(files->name(), 0);
  if ((!scene || !scene->mRootNode) && files->refused()) return *files->refused();
  if (!scene && std::string_view(importer.GetErrorString()).find("bad_alloc") != std::string_view::npos)
    throw std::bad_alloc();
  if (!scene || !scene->mRootNode)
    return Error{"cannot be read as " + std::string(name_of(format)) + " (" +
                     assimp_words(importer.GetErrorString()) +
                     "); export it again, or as another of FBX, GLB and BVH",
                 file};
  // An animation for characters: no mesh says which of its nodes are bones, and few may be moved.
  const bool is_vrma = bytes.find("VRMC_vrm_animation") != std::string_view::npos;
  return SceneReader(*scene, format, file, animation, is_vrma).read();
}

}  // namespace abrazo
