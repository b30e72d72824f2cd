#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/stream/humanoid/limb_ends.hpp"
#include "core/stream/natnet/natnet_frame.hpp"
#include "core/stream/natnet/natnet_model.hpp"
#include "core/stream/protocol/stream_decoder.hpp"

namespace abrazo {

/// Conventions that the protocol does not transmit, if set by the user; others are detected from the data.
struct NatNetConventions {
  std::optional<bool> local_bones;  ///< bones in parent coordinates instead of world coordinates
  std::optional<char> up;           ///< 'y' or 'z'
};

/// Computes world positions of the bones of one skeleton. Detects the conventions once, from the first
/// frames.
class NatNetPerformer {
 public:
  /// @param name the skeleton's name, made unique
  NatNetPerformer(const NatNetSkeleton& skeleton, std::string name, const NatNetConventions& given);

  const std::string& name() const { return name_; }
  std::int32_t id() const { return id_; }
  /// Bones, then "<bone>_End" of head, hands and toes.
  const std::shared_ptr<const std::vector<std::string>>& points() const { return points_; }
  /// Whether the frame has the number of bones in the model.
  bool has_bones_of(const NatNetSkeletonFrame& frame) const { return frame.bones.size() == bones_.size(); }
  /// Points x 3, Y up [m]; rows that are not tracked are not finite. None if no bone is tracked.
  std::optional<Positions> positions(const NatNetSkeletonFrame& frame, std::vector<StreamIssue>& issues);

  /// "Ana: 21 bones, world coordinates (found from the data), Y up (found from the data)".
  std::string fact() const;

 private:
  struct Bone {
    std::string name;
    std::int32_t id;
    int parent;  ///< index, -1 = none
    Vec3 offset;
  };
  struct End {
    int bone;
    double fraction;
    bool level;
  };
  struct Sample {
    SegmentPose pose;
    bool placed = false, turned = false;  ///< position, rotation usable
  };

  void take_bones(const std::vector<NatNetBone>& bones);
  void name_points();
  bool read_samples(const NatNetSkeletonFrame& frame, std::vector<StreamIssue>& issues);
  std::optional<bool> looks_local() const;
  std::optional<char> up_of_spine() const;
  std::optional<char> up_of_pose() const;
  void to_world();

  std::string name_;
  std::int32_t id_;
  std::vector<Bone> bones_;  ///< parents before children
  std::map<std::int32_t, std::size_t> bone_of_id_;
  int head_ = -1;  ///< bone
  std::vector<End> ends_;
  std::shared_ptr<const std::vector<std::string>> points_;
  NatNetConventions given_;
  std::optional<bool> local_;
  std::optional<char> up_;
  bool flags_mean_something_ = false;  ///< a tracking flag was set at least once
  std::vector<Sample> samples_;        ///< of the present frame, by bone
};

}  // namespace abrazo
