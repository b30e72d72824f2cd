#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>

#include "core/base/positions.hpp"

namespace abrazo {

/// Number of events within the last five seconds, with a resolution of half a second.
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

/// Arrival times of a performer's frames over the last second (at least the last few).
class ArrivalMeter {
 public:
  void add(double first_arrived_s, double arrived_s);
  struct Times {
    double rate_hz = 0;
    double interval_p50_ms = 0, interval_p95_ms = 0;
    double assembly_p50_ms = 0, assembly_p95_ms = 0;
  };
  Times times(double now_s) const;
  /// Frame rate; 0 if nothing arrived for a second, or for some intervals of a slow stream.
  double rate_hz(double now_s) const;

 private:
  struct Arrival {
    double arrived_s, assembly_s;
  };
  std::deque<Arrival> arrivals_;
};

/// Posture and motion of a performer, as evidence of problems in the stream: medians over the last three
/// seconds.
class PostureMeter {
 public:
  void add(const Pose& pose, double arrived_s);

  struct Posture {
    bool is_known = false;          ///< false for the first half second
    double bones_height_m = 0;      ///< standing height from bone lengths
    double hips_above_feet_m = 0;   ///< along Y
    double hips_before_feet_m = 0;  ///< along Z, which may be up
    double head_above_hips_m = 0;
    double lowest_foot_m = 0;  ///< toe base
    double alternating = 0;    ///< share of frames that alternate between two places: two performers in one
                               ///< stream
    double jumps = 0;          ///< share of frames that are impossible after the previous one
  };
  Posture posture() const;
  /// Duration in which no joint moved by 0.01 mm or more [s].
  double frozen_s() const { return last_arrived_s_ - changed_s_; }

  /// Impossible mean displacement of the joints between two frames [m].
  static constexpr double impossible_step_m = 0.4;
  /// Whether the displacement is impossible for a person in the elapsed time.
  static bool is_jump(const Pose& from, const Pose& to, double elapsed_s);

 private:
  struct Sample {
    double arrived_s, height, hips_y, hips_z, head_y, foot_y;
  };
  std::deque<Sample> samples_;
  std::optional<Pose> last_, before_last_;
  Pose still_ = Pose::Zero();  ///< pose at the last movement
  double last_arrived_s_ = 0, changed_s_ = 0, first_arrived_s_ = 0;
  double alternating_ = 0, jumps_ = 0;  ///< smoothed shares
};

}  // namespace abrazo
