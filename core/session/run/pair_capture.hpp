#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/takes/paired_take.hpp"
#include "core/stream/receive/stream_receiver.hpp"

namespace abrazo {

/// Collects the incoming poses of two performers and makes a paired take of them. Thread-safe.
class PairCapture {
 public:
  PairCapture(std::string a, std::string b) : names_{std::move(a), std::move(b)} {}

  /// Ignores poses of other performers and poses that are not newer than the last.
  void add(const ReceivedPose& pose);
  const std::string& a() const { return names_[0]; }
  const std::string& b() const { return names_[1]; }

  struct State {
    std::size_t a = 0, b = 0;  ///< poses
    double length_s = 0;       ///< time in which both were tracked
  };
  State state() const;

  struct Wishes {
    std::string name;
    ActivePerformer leads = ActivePerformer::Unknown;  ///< for the whole take
    std::string label;                                 ///< for the whole take; empty = none
    double in_s = 0, out_s = 0;                        ///< trimmed at the beginning and at the end
  };
  /// Longest accepted gap between poses of a performer within the take.
  static constexpr double longest_gap_s = 0.25;
  static constexpr double shortest_s = 0.5;

  /// Both performers resampled at the lower of their rates; joints are interpolated linearly.
  /// @return an Error if a performer is missing, was lost for too long, or too little is left
  Result<PairedTake> take(const Wishes& wishes) const;

 private:
  struct Timed {
    double time_s = 0;
    Pose pose;
  };
  using Track = std::vector<Timed>;

  mutable std::mutex mutex_;
  std::string names_[2];
  Track tracks_[2];
};

}  // namespace abrazo
