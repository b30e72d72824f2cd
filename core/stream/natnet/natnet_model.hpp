#pragma once

#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/stream/natnet/natnet_messages.hpp"

namespace abrazo {

/// A bone of a skeleton's description.
struct NatNetBone {
  std::string name;            ///< without the prefix of the skeleton's name
  std::int32_t id = 0;         ///< the lower 16 bits of the number in frames
  std::int32_t parent = 0;     ///< id; 0 = none
  Vec3 offset = Vec3::Zero();  ///< from the parent in the rest pose [m]
};

struct NatNetSkeleton {
  std::string name;
  std::int32_t id = 0;
  std::vector<NatNetBone> bones;
};

/// A MODELDEF message: names for the numbers in frames.
struct NatNetModel {
  std::vector<NatNetSkeleton> skeletons;
  std::vector<std::string> rigid_bodies;  ///< names of those without a skeleton
  std::size_t marker_sets = 0, force_plates = 0, devices = 0, cameras = 0, assets = 0;
  /// Unreadable descriptions, with reasons.
  std::vector<std::string> unread;
};

/// Reads the payload after the packet's header.
/// @return an Error if the packet ends too early
Result<NatNetModel> parse_natnet_model(ByteReader& reader, NatNetVersion version);

void write_natnet_model(ByteWriter& writer, const NatNetModel& model, NatNetVersion version);

}  // namespace abrazo
