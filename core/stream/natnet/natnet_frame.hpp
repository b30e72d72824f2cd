#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/stream/natnet/natnet_messages.hpp"

namespace abrazo {

/// A rigid body of a frame, or a skeleton's bone.
struct NatNetBody {
  std::int32_t id = 0;           ///< for a bone: the skeleton in the upper 16 bits, the bone in the lower
  Vec3 position = Vec3::Zero();  ///< [m], axes by the server's settings
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< as sent: not checked, not normalised
  float error_m = 0;                                             ///< mean marker error
  bool tracked = false;
};

struct NatNetSkeletonFrame {
  std::int32_t id = 0;
  std::vector<NatNetBody> bones;
};

/// High-resolution time stamps of a frame, in ticks of the server's clock.
struct NatNetStamps {
  std::uint64_t mid_exposure = 0, received = 0, transmit = 0;
};

/// A FRAME message. Markers, plates and devices are only counted.
struct NatNetFrame {
  std::int32_t number = 0;
  std::vector<NatNetBody> bodies;
  std::vector<NatNetSkeletonFrame> skeletons;
  std::size_t marker_sets = 0, unlabelled_markers = 0, labelled_markers = 0, occluded_markers = 0;
  std::size_t assets = 0, force_plates = 0, devices = 0;
  /// The packet may end here: programs write different ends.
  std::optional<double> time_s;
  std::optional<NatNetStamps> stamps;
  bool recording = false;
  bool models_changed = false;
  /// Unreadable sections after the skeletons, with reasons; the frame is valid without them.
  std::vector<std::string> unread;
};

/// Reads the payload after the packet's header.
/// @return an Error if the packet ends within the skeletons
Result<NatNetFrame> parse_natnet_frame(ByteReader& reader, NatNetVersion version);

/// Writes bodies, skeletons and the end, without the sections that are only counted.
void write_natnet_frame(ByteWriter& writer, const NatNetFrame& frame, NatNetVersion version);

}  // namespace abrazo
