#pragma once

#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/stream/natnet/natnet_messages.hpp"

namespace abrazo {

/// A bone of a skeleton's description.
struct NatNetBone {
  std::string name;            ///< without the skeleton's name before it
  std::int32_t id = 0;         ///< the lower 16 bits of the number in frames
  std::int32_t parent = 0;     ///< id; 0 = none
  Vec3 offset = Vec3::Zero();  ///< from the parent in the rest pose [m]
};

struct NatNetSkeleton {
  std::string name;
  std::int32_t id = 0;
  std::vector<NatNetBone> bones;
};

/// A MODELDEF message: what the numbers in frames mean.
struct NatNetModel {
  std::vector<NatNetSkeleton> skeletons;
  std::vector<std::string> rigid_bodies;  ///< names of those that belong to no skeleton
  std::size_t marker_sets = 0, force_plates = 0, devices = 0, cameras = 0, assets = 0;
  /// Descriptions that could not be read, and why.
  std::vector<std::string> unread;
};

/// Reads what follows the packet's head.
/// @return an Error when the packet ends too early
Result<NatNetModel> parse_natnet_model(ByteReader& reader, NatNetVersion version);

void write_natnet_model(ByteWriter& writer, const NatNetModel& model, NatNetVersion version);

}  // namespace abrazo
