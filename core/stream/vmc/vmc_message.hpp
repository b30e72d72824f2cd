#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <variant>

#include "core/base/positions.hpp"
#include "core/stream/protocol/stream_decoder.hpp"
#include "core/stream/vmc/osc_packet.hpp"

namespace abrazo {

/// Position and rotation, right-handed, Y up, the character facing +Z [m].
struct VmcTransform {
  Vec3 position = Vec3::Zero();
  std::optional<Eigen::Quaterniond> rotation;  ///< none if the received one was invalid
};

/// The messages of the VMC protocol that are relevant for a pose.
struct VmcBone {
  std::string name;
  VmcTransform local;
};
struct VmcRoot {
  VmcTransform world;
  Vec3 scale = Vec3::Ones();  ///< of the avatar relative to the real person, for mixed reality (2.1)
  Vec3 offset = Vec3::Zero();
};
struct VmcTime {
  double seconds = 0;
};
struct VmcOk {
  int loaded = 1;
  int calibration = 3;  ///< 0 none, 1 waiting, 2 in progress, 3 done
  int tracking = 1;     ///< 0 bad
};
/// An avatar was loaded: its title.
struct VmcModel {
  std::string title;
};
/// Any other address; the protocol allows ignoring it.
struct VmcOther {};
/// End of a limb beyond its last bone ("Head", "LeftHand", "LeftToes", ...), local to the bone. An extension
/// by Abrazo, under the protocol's address for extensions.
struct VmcEnd {
  std::string bone;
  Vec3 local = Vec3::Zero();
};
using VmcMessage = std::variant<VmcOther, VmcBone, VmcRoot, VmcTime, VmcOk, VmcModel, VmcEnd>;

inline constexpr const char* vmc_end_address = "/VMC/Thru/abrazo/End";

/// @return none if the message does not match its address; the reason is added to `issues`
std::optional<VmcMessage> read_vmc(const OscElement& message, std::vector<StreamIssue>& issues);

/// Converts between Unity's left-handed space (Y up, Z forward, X right) and ours by mirroring X.
Vec3 mirrored(const Vec3& position);
Eigen::Quaterniond mirrored(const Eigen::Quaterniond& rotation);

OscElement vmc_bone_message(const std::string& name, const Vec3& position,
                            const Eigen::Quaterniond& rotation);
/// With the scale and offset of version 2.1, which change nothing.
OscElement vmc_root_message(const Vec3& position, const Eigen::Quaterniond& rotation);
OscElement vmc_end_message(const std::string& bone, const Vec3& local);

}  // namespace abrazo
