#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/stream/humanoid/humanoid_bones.hpp"
#include "core/stream/protocol/stream_decoder.hpp"
#include "core/stream/vmc/osc_packet.hpp"

namespace abrazo::test {

using Bytes = std::vector<std::uint8_t>;

/// "2F 56 ..." -> bytes; blanks and line ends between them do not matter.
Bytes from_hex(std::string_view hex);

/// Arguments as a sender in Unity's left-handed space has them.
OscElement unity_bone(const std::string& name, const Vec3& position, const Eigen::Quaterniond& rotation);

/// A bone's local place and rotation in Unity's space.
struct UnityBone {
  Vec3 position = Vec3::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};
using UnityPose = std::map<std::string, UnityBone>;

/// A T-pose of an avatar whose rest rotations are none (VRM 0): 21 bones, hips at 0.95 m, upper arms 0.27 m,
/// forearms 0.25 m. In Unity's space the left side is at negative X.
UnityPose t_pose();

/// Unity's rotation about an axis; a positive angle is clockwise seen along the axis, as Unity has it.
Eigen::Quaterniond unity_rotation(double degrees, const Vec3& axis);

Bytes bundle_of(const std::vector<OscElement>& messages);
OscElement osc_time(float seconds);
OscElement osc_ok(int loaded);
std::vector<OscElement> bones_of(const UnityPose& pose);

/// One frame as the VMC application sends it: bundles of 12 bones, and a last one with the rest nested and T
/// last.
std::vector<Bytes> as_vmc_application(const UnityPose& pose, float time);
/// One bundle that begins with T.
std::vector<Bytes> as_slimevr(const UnityPose& pose, float time);
/// Each message by itself, T last.
std::vector<Bytes> as_plain_messages(const UnityPose& pose, float time);

/// A decoder with what came out of it so far.
class Receiver {
 public:
  explicit Receiver(const std::string& uri = "vmc://0.0.0.0:39539");

  void take(const Bytes& packet, double arrived_s, const Endpoint& from = {0x7f000001, 50000});
  /// A frame's packets, 0.1 ms apart.
  void take(const std::vector<Bytes>& packets, double arrived_s, const Endpoint& from = {0x7f000001, 50000});
  void pass_time(double now_s) { decoder->pass_time(now_s, out); }

  Vec3 point(const std::string& name) const;  ///< of the newest frame
  bool has_point(const std::string& name) const;
  int count(const std::string& kind) const;  ///< of issues
  std::string text(const std::string& kind) const;
  Pose joints() const;  ///< of the newest frame, by the built-in map "unity"

  std::unique_ptr<StreamDecoder> decoder;
  Decoded out;
};

}  // namespace abrazo::test
