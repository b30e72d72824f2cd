#pragma once

#include <bitset>
#include <optional>
#include <vector>

#include "core/stream/humanoid/humanoid_bones.hpp"

namespace abrazo {

/// Tells where one frame of a VMC sender ends: the protocol does not say, and senders differ. A frame closes
/// when (a) a bone that it has comes again, (b) T comes with a new value after bones, (c) a bundle ends that
/// began with T, (d) nothing came for 8 ms. See docs/guide/live/vmc.md.
class VmcFraming {
 public:
  struct Frame {
    std::optional<double> time;  ///< the sender's T that belongs to it
    double first_arrived_s = 0, arrived_s = 0;
    int held = 0;  ///< bones of the frame before that did not come in this one
  };
  static constexpr double silence_s = 0.008;

  void packet_begins() { put_off_in_packet_ = false; }
  /// A bone is about to be set. @return the frame that ended in front of it
  std::optional<Frame> bone(int bone, double arrived_s);
  std::optional<Frame> time(double value, double arrived_s);
  void bundle_begins();
  /// Any message that is not T, within a bundle or not.
  void other();
  std::optional<Frame> bundle_ends();
  std::optional<Frame> silence(double now_s);

  bool is_open() const { return seen_.any(); }
  bool is_time_first() const { return time_first_; }
  std::uint64_t mixed() const { return mixed_; }  ///< times that (a) was put off since bones were missing

 private:
  Frame close();

  std::bitset<humanoid::bone_count> seen_, usual_;
  std::vector<int>
      bundles_;  ///< open ones: 0 nothing came in it yet, 1 it began with T, 2 with something else
  std::optional<double> frame_time_;  ///< a T that came in front of the frame's bones
  double frame_time_arrived_s_ = 0;
  std::optional<double> last_time_;
  double first_arrived_s_ = 0, last_arrived_s_ = 0;
  bool time_first_ = false;
  int put_off_ = 0;
  bool put_off_in_packet_ = false;
  std::uint64_t mixed_ = 0;
};

}  // namespace abrazo
