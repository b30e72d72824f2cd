#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>

#include "core/base/positions.hpp"

namespace abrazo {

/// How often something happened within the last five seconds, to half a second.
class RecentCount {
 public:
  static constexpr double window_s = 5;
  void add(double now_s, std::uint64_t count = 1);
  std::uint64_t value(double now_s) const;

 private:
  static constexpr int buckets = 10;
  std::int64_t bucket_of(double now_s) const;
  struct Bucket {
    std::int64_t number = -1;
    std::uint64_t count = 0;
  };
  std::array<Bucket, buckets> counts_{};
};

/// When the frames of a performer came, over the last second (at least the last few).
class ArrivalMeter {
 public:
  void add(double first_arrived_s, double arrived_s);
  struct Times {
    double rate_hz = 0;
    double interval_p50_ms = 0, interval_p95_ms = 0;
    double assembly_p50_ms = 0, assembly_p95_ms = 0;
  };
  Times times(double now_s) const;
  /// The rate alone; 0 when nothing has come for a second, or for some intervals of a slow stream.
  double rate_hz(double now_s) const;

 private:
  struct Arrival {
    double arrived_s, assembly_s;
  };
  std::deque<Arrival> arrivals_;
};

/// How the performer stands and moves, as far as it tells something about the stream: medians over the last
/// three seconds.
class PostureMeter {
 public:
  void add(const Pose& pose, double arrived_s);

  struct Posture {
    bool is_known = false;          ///< false until half a second was seen
    double bones_height_m = 0;      ///< standing height that the bones' lengths give
    double hips_above_feet_m = 0;   ///< along Y
    double hips_before_feet_m = 0;  ///< along Z, which is up where Z is
    double head_above_hips_m = 0;
    double lowest_foot_m = 0;  ///< toe base
    double alternating = 0;    ///< share of frames that jump away and back: two performers in one
    double jumps = 0;          ///< share of frames that a person cannot reach from the previous one
  };
  Posture posture() const;
  /// For how long no joint has moved by as much as a hundredth of a millimetre [s].
  double frozen_s() const { return last_arrived_s_ - changed_s_; }

  /// Joints' mean displacement that no person makes from one frame to the next [m].
  static constexpr double impossible_step_m = 0.4;
  /// Whether no person moves like this between two frames that are so far apart in time.
  static bool is_jump(const Pose& from, const Pose& to, double elapsed_s);

 private:
  struct Sample {
    double arrived_s, height, hips_y, hips_z, head_y, foot_y;
  };
  std::deque<Sample> samples_;
  std::optional<Pose> last_, before_last_;
  Pose still_ = Pose::Zero();  ///< since it last moved
  double last_arrived_s_ = 0, changed_s_ = 0, first_arrived_s_ = 0;
  double alternating_ = 0, jumps_ = 0;  ///< smoothed shares
};

}  // namespace abrazo
