#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/takes/paired_take.hpp"
#include "core/stream/receive/stream_receiver.hpp"

namespace abrazo {

/// The poses of two performers as they come in, and the paired take that they make. Safe to call from any
/// thread.
class PairCapture {
 public:
  PairCapture(std::string a, std::string b) : names_{std::move(a), std::move(b)} {}

  /// Of others than the two it is passed over, and so is one that is not newer than the last.
  void add(const ReceivedPose& pose);
  const std::string& a() const { return names_[0]; }
  const std::string& b() const { return names_[1]; }

  struct State {
    std::size_t a = 0, b = 0;  ///< poses
    double length_s = 0;       ///< in which both were there
  };
  State state() const;

  struct Wishes {
    std::string name;
    ActivePerformer leads = ActivePerformer::Unknown;  ///< throughout
    std::string label;                                 ///< of all of it; empty = none
    double in_s = 0, out_s = 0;                        ///< cut off at the beginning and at the end
  };
  /// Longest time without a pose of a performer, within what is used of it.
  static constexpr double longest_gap_s = 0.25;
  static constexpr double shortest_s = 0.5;

  /// Both at the lower of their rates, frame for frame: joints go straight from pose to pose.
  /// @return an Error when one of them was not there, was lost for too long, or too little is left
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
