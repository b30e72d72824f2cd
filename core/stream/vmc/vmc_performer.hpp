#pragma once

#include <deque>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "core/stream/humanoid/humanoid_points.hpp"
#include "core/stream/net/datagram.hpp"
#include "core/stream/protocol/stream_decoder.hpp"
#include "core/stream/vmc/osc_packet.hpp"
#include "core/stream/vmc/vmc_framing.hpp"
#include "core/stream/vmc/vmc_watch.hpp"

namespace abrazo {

/// One sender of VMC: its present pose and complete frames.
class VmcPerformer {
 public:
  explicit VmcPerformer(std::string name) : name_(std::move(name)), watch_(name_) {}

  void take(const OscPacket& packet, const Datagram& datagram, Decoded& out);
  void pass_time(double now_s, Decoded& out);
  /// Declares the last pose (or, before any pose, the first) a T-pose.
  void calibrate();

  const std::string& name() const { return name_; }
  double first_s() const { return first_s_; }
  double last_s() const { return last_s_; }
  std::uint64_t frames() const { return frames_; }
  std::string facts() const;

 private:
  void message(const VmcMessage& message, double arrived_s, Decoded& out);
  void bone(const VmcBone& bone, double arrived_s, Decoded& out);
  std::optional<int> bone_named(const std::string& name);
  HumanoidPose tracked_pose() const;
  void finish(const std::optional<VmcFraming::Frame>& frame, Decoded& out);
  bool is_duplicate(const Datagram& datagram);

  std::string name_;
  HumanoidPose pose_;
  HumanoidPoints points_;
  VmcFraming framing_;
  VmcWatch watch_;
  bool calibrate_next_ = false;
  bool has_vrm1_thumbs_ = false;
  std::string title_;
  Vec3 scale_ = Vec3::Ones();
  std::set<std::string, std::less<>> unknown_bones_;
  double first_s_ = -1, last_s_ = -1, told_inside_s_ = -1;
  std::uint64_t frames_ = 0;
  /// Packets of the open frame: a duplicate must not end it.
  std::deque<std::pair<std::size_t, double>> recent_;
};

}  // namespace abrazo
