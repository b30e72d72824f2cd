#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "core/stream/humanoid/humanoid_bones.hpp"
#include "core/stream/protocol/stream_decoder.hpp"
#include "core/stream/vmc/vmc_message.hpp"

namespace abrazo {

/// Detects problems of a VMC sender with valid messages: a stopped or restarted clock, a sender that is not
/// ready, bones of two people on one address. Each is reported once per second while it lasts, not once per
/// packet.
class VmcWatch {
 public:
  using Issues = std::vector<StreamIssue>;
  explicit VmcWatch(std::string sender) : sender_(std::move(sender)) {}

  void time(double value, double arrived_s, Issues& issues);
  void ok(const VmcOk& ok, double arrived_s);
  void bone(int bone, const VmcTransform& local, double arrived_s);
  void frame() { ++frames_at_this_time_; }
  void pass_time(double now_s, Issues& issues);

  const std::optional<VmcOk>& last_ok() const { return ok_; }

 private:
  /// The last two values of a bone.
  struct Trail {
    Eigen::Quaterniond last, before;
    int count = 0;
  };
  void heard(double arrived_s);
  void check(double now_s, Issues& issues);

  std::string sender_;
  std::optional<VmcOk> ok_;
  std::optional<double> time_;
  double time_changed_s_ = 0;
  std::uint64_t frames_at_this_time_ = 0;
  PerBone<Trail> trails_{};
  int moved_ = 0, alternated_ = 0;
  bool two_senders_ = false;
  double last_message_s_ = -1, last_bone_s_ = -1, first_message_s_ = -1;
  double checked_s_ = -1;
};

}  // namespace abrazo
