#include "core/stream/natnet/natnet_performer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/text.hpp"
#include "core/stream/protocol/sent_rotation.hpp"

namespace abrazo {

namespace {

constexpr std::string_view end_suffix = "_End";

/// A bone that has nothing behind it, by the names of Motive's conventions (Motive, FBX, BVH, Unreal), in
/// lower case.
struct EndRule {
  std::string_view names;
  double fraction;
  bool level;
};
constexpr std::array end_rules = {
    EndRule{" head ", crown_beyond_neck_length, false},
    EndRule{" lhand rhand lefthand righthand leftwrist rightwrist hand_l hand_r ", hand_beyond_forearm_length,
            false},
    EndRule{" ltoe rtoe lefttoebase righttoebase lefttoe righttoe ball_l ball_r ", toes_beyond_foot_length,
            true}};

bool is_one_of(std::string_view names, const std::string& name) {
  return names.find(" " + lower_case(name) + " ") != std::string_view::npos;
}

/// From Z up to Y up: a quarter turn about x.
Vec3 z_up_to_y_up(const Vec3& v) {
  return {v.x(), v.z(), -v.y()};
}

/// The axis that a vector is mostly parallel to, if it is y or z and clearly so.
std::optional<char> clear_axis(const Vec3& v) {
  const double y = std::abs(v.y()), z = std::abs(v.z()), x = std::abs(v.x());
  if (y > 2 * std::max(x, z)) return 'y';
  if (z > 2 * std::max(x, y)) return 'z';
  return std::nullopt;
}

std::string how(bool given, std::string_view option) {
  return given ? " (as set)" : " (found from the data; option " + std::string(option) + ")";
}

}  // namespace

NatNetPerformer::NatNetPerformer(const NatNetSkeleton& skeleton, std::string name,
                                 const NatNetConventions& given)
    : name_(std::move(name)), id_(skeleton.id), given_(given), local_(given.local_bones), up_(given.up) {
  take_bones(skeleton.bones);
  name_points();
}

/// Sorts parents before children. What names no parent of the skeleton is a root; so is one of a circle.
void NatNetPerformer::take_bones(const std::vector<NatNetBone>& bones) {
  std::map<std::int32_t, std::size_t> place;  // in `bones`
  for (std::size_t b = 0; b < bones.size(); ++b) place.emplace(bones[b].id, b);
  std::vector<bool> seen(bones.size(), false);
  std::vector<std::size_t> line;  // a bone, its parent, and so on up to one that is taken
  for (std::size_t b = 0; b < bones.size(); ++b) {
    line.clear();
    for (std::size_t above = b; !seen[above];) {
      seen[above] = true;
      line.push_back(above);
      if (const auto parent = place.find(bones[above].parent); parent != place.end()) above = parent->second;
    }
    for (; !line.empty(); line.pop_back()) {
      const NatNetBone& bone = bones[line.back()];
      const auto parent = bone_of_id_.find(bone.parent);
      const int parent_index = parent == bone_of_id_.end() ? -1 : static_cast<int>(parent->second);
      bone_of_id_.emplace(bone.id, bones_.size());
      bones_.push_back({bone.name, bone.id, parent_index, bone.offset});
    }
  }
}

void NatNetPerformer::name_points() {
  std::vector<std::string> names;
  for (std::size_t b = 0; b < bones_.size(); ++b) {
    names.push_back(bones_[b].name);
    if (is_one_of(" head ", bones_[b].name)) head_ = static_cast<int>(b);
    for (const EndRule& rule : end_rules)
      if (bones_[b].parent >= 0 && is_one_of(rule.names, bones_[b].name))
        ends_.push_back({static_cast<int>(b), rule.fraction, rule.level});
  }
  for (const End& end : ends_)
    names.push_back(bones_[static_cast<std::size_t>(end.bone)].name + std::string(end_suffix));
  points_ = std::make_shared<const std::vector<std::string>>(std::move(names));
}

/// @return whether any bone is there
bool NatNetPerformer::read_samples(const NatNetSkeletonFrame& frame, std::vector<StreamIssue>& issues) {
  samples_.assign(bones_.size(), Sample{});
  const bool any_flag = std::any_of(frame.bones.begin(), frame.bones.end(),
                                    [](const NatNetBody& bone) { return bone.tracked; });
  // Some versions never set the flags of bones; then they are ignored.
  flags_mean_something_ = flags_mean_something_ || any_flag;
  bool any = false;
  for (const NatNetBody& body : frame.bones) {
    const auto found = bone_of_id_.find(body.id & 0xFFFF);
    if (found == bone_of_id_.end()) continue;
    Sample& sample = samples_[found->second];
    if (!body.position.allFinite() || !body.rotation.coeffs().allFinite()) {
      issues.push_back({"not-finite", "the bone " + bones_[found->second].name + " of " + name_ +
                                          " has a position or rotation that is not finite"});
      continue;
    }
    if (flags_mean_something_ && !body.tracked) continue;
    sample.pose.position = body.position;
    sample.placed = true;
    sample.turned = is_rotation(body.rotation);
    if (sample.turned) sample.pose.rotation = body.rotation.normalized();
    any = any || !body.position.isZero(0);
  }
  return any;
}

/// Compares both readings with the lengths that the model announces: in local coordinates a bone is at its
/// offset; in world coordinates its distance from its parent is the length of the offset.
std::optional<bool> NatNetPerformer::looks_local() const {
  double local_error = 0, world_error = 0, lengths = 0, farthest = 0;
  int compared = 0;
  for (std::size_t b = 0; b < bones_.size(); ++b) {
    if (bones_[b].parent < 0 || !samples_[b].placed) continue;
    const Sample& parent = samples_[static_cast<std::size_t>(bones_[b].parent)];
    if (!parent.placed) continue;
    const double length = bones_[b].offset.norm();
    local_error += (samples_[b].pose.position - bones_[b].offset).norm();
    world_error += std::abs((samples_[b].pose.position - parent.pose.position).norm() - length);
    farthest = std::max(farthest, samples_[b].pose.position.norm());
    lengths += length;
    ++compared;
  }
  if (compared < 3) return std::nullopt;
  constexpr double no_offsets_m = 0.05, longest_bone_m = 0.8;
  // Without offsets: no bone is as long as a person is high.
  if (lengths < no_offsets_m * compared) return farthest < longest_bone_m;
  return local_error < world_error;
}

/// In the rest pose all rotations are the identity, so the position of a bone in its parent's space is its
/// rest offset in any pose. From the root to the head it points upwards.
std::optional<char> NatNetPerformer::up_of_spine() const {
  if (head_ < 0) return std::nullopt;
  Vec3 rest = Vec3::Zero();
  for (int b = head_; bones_[static_cast<std::size_t>(b)].parent >= 0;) {
    const int parent = bones_[static_cast<std::size_t>(b)].parent;
    const Sample& here = samples_[static_cast<std::size_t>(b)];
    const Sample& below = samples_[static_cast<std::size_t>(parent)];
    if (!here.placed || (!local_.value_or(false) && (!below.placed || !below.turned))) return std::nullopt;
    rest += local_.value_or(false)
                ? here.pose.position
                : below.pose.rotation.conjugate() * Vec3(here.pose.position - below.pose.position);
    b = parent;
  }
  return rest.norm() > 0.1 ? clear_axis(rest) : std::nullopt;
}

/// Of a standing person.
std::optional<char> NatNetPerformer::up_of_pose() const {
  if (head_ < 0) return std::nullopt;
  const Sample& head = samples_[static_cast<std::size_t>(head_)];
  if (bones_.empty() || !head.placed || !samples_.front().placed) return std::nullopt;
  return clear_axis(head.pose.position - samples_.front().pose.position);
}

void NatNetPerformer::to_world() {
  for (std::size_t b = 0; b < bones_.size(); ++b) {
    if (bones_[b].parent < 0) continue;
    const Sample& parent = samples_[static_cast<std::size_t>(bones_[b].parent)];
    Sample& bone = samples_[b];
    bone.placed = bone.placed && parent.placed && parent.turned;
    bone.turned = bone.turned && parent.turned;
    bone.pose.position = parent.pose.position + parent.pose.rotation * bone.pose.position;
    bone.pose.rotation = parent.pose.rotation * bone.pose.rotation;
  }
}

std::optional<Positions> NatNetPerformer::positions(const NatNetSkeletonFrame& frame,
                                                    std::vector<StreamIssue>& issues) {
  if (!read_samples(frame, issues)) return std::nullopt;
  if (!local_) local_ = looks_local();
  if (!up_) up_ = up_of_spine();
  if (local_.value_or(false)) to_world();
  if (!up_) up_ = up_of_pose();
  if (up_.value_or('y') == 'z')
    for (Sample& sample : samples_) {
      sample.pose.position = z_up_to_y_up(sample.pose.position);
      sample.pose.rotation.vec() = z_up_to_y_up(sample.pose.rotation.vec());
    }

  Positions points = Positions::Constant(static_cast<Eigen::Index>(points_->size()), 3,
                                         std::numeric_limits<double>::quiet_NaN());
  for (std::size_t b = 0; b < bones_.size(); ++b)
    if (samples_[b].placed) points.row(static_cast<Eigen::Index>(b)) = samples_[b].pose.position.transpose();
  auto row = static_cast<Eigen::Index>(bones_.size());
  for (const End& end : ends_) {
    const Sample& last = samples_[static_cast<std::size_t>(end.bone)];
    const Sample& before =
        samples_[static_cast<std::size_t>(bones_[static_cast<std::size_t>(end.bone)].parent)];
    if (last.placed && last.turned && before.placed && before.turned)
      points.row(row) = limb_end(before.pose, last.pose, end.fraction, end.level).transpose();
    ++row;
  }
  return points;
}

std::string NatNetPerformer::fact() const {
  std::string text = name_ + ": " + std::to_string(bones_.size()) + " bones, ";
  text += !local_ ? "coordinates not known yet"
                  : (*local_ ? "coordinates of the parent bone" : "world coordinates") +
                        how(given_.local_bones.has_value(), "coordinates=global|local");
  text += !up_ ? ", Y up assumed (option up=y|z)"
               : ", " + std::string(*up_ == 'z' ? "Z up" : "Y up") + how(given_.up.has_value(), "up=y|z");
  if (!flags_mean_something_) text += ", no tracking flags";
  return text;
}

}  // namespace abrazo
