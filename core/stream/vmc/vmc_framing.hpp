#pragma once

#include <bitset>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/stream/humanoid/humanoid_bones.hpp"

namespace abrazo {

/// Detects the end of a frame of a VMC sender; the protocol does not define it, and senders differ. A frame
/// ends when (a) one of its bones arrives again, (b) T arrives with a new value after bones, unless bones
/// usually go on behind it, (c) a bundle that began with T ends, (d) nothing arrives for 8 ms. See
/// docs/guide/live/vmc.md.
class VmcFraming {
 public:
  struct Frame {
    std::optional<double> time;  ///< the sender's T that belongs to it
    double first_arrived_s = 0, arrived_s = 0;
    int held = 0;  ///< bones of the previous frame missing in this one
  };
  static constexpr double silence_s = 0.008;

  void packet_begins() { put_off_in_packet_ = false; }
  /// Call before a bone is set. @return the frame that ended before it
  std::optional<Frame> bone(int bone, double arrived_s);
  std::optional<Frame> time(double value, double arrived_s);
  void bundle_begins();
  /// Any message that is not T, within a bundle or not.
  void other();
  std::optional<Frame> bundle_ends();
  std::optional<Frame> silence(double now_s);

  bool is_open() const { return seen_.any(); }
  bool is_time_first() const { return time_first_; }
  /// Bones went on right behind each of the last T: it is sent in the middle of frames, or by another timer.
  bool is_time_inside() const { return inside_ >= times_that_tell; }
  std::uint64_t mixed() const { return mixed_; }  ///< times that (a) was deferred because bones were missing

 private:
  static constexpr int times_that_tell = 3;
  Frame close();

  std::bitset<humanoid::bone_count> seen_, usual_;
  std::vector<int> bundles_;          ///< open bundles: 0 empty so far, 1 began with T, 2 with something else
  std::optional<double> frame_time_;  ///< a T received before the frame's bones
  double frame_time_arrived_s_ = 0;
  std::optional<double> last_time_;
  double first_arrived_s_ = 0, last_arrived_s_ = 0;
  bool time_first_ = false;
  std::optional<double> inner_time_;     ///< a T between the frame's bones
  std::optional<double> last_inside_s_;  ///< arrival of a T behind bones, until the next bone
  int inside_ = 0;
  int put_off_ = 0;
  bool put_off_in_packet_ = false;
  std::uint64_t mixed_ = 0;
};

}  // namespace abrazo
