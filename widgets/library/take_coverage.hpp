#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/session/frames/frame_history.hpp"

namespace abrazo::widgets {

/// Use of a library by a session, counted frame by frame. Plain data, independent of Qt.
class TakeCoverage {
 public:
  /// Resets all counts. @param library may be null
  void begin(std::shared_ptr<const MotionLibrary> library);
  /// @param stands_for  number of frames, the others of which were left out
  void append(const FrameSnapshot& frame, std::uint64_t stands_for = 1);
  /// Appends the new frames of the history. Of a long recording it reads some, each for those left out.
  /// @return whether there was anything new
  bool append_new(const FrameHistory& history);

  /// Number of selections of the take's pairs.
  int times_selected(int take) const;
  /// Share of the take's frames that were selected at least once [0, 1].
  double share_selected(int take) const;
  /// Number of selections of each of `parts` equal parts of the take.
  std::vector<int> heat(int take, int parts) const;

  /// Whether frames were left out, so that numbers and shares are estimates.
  bool is_estimated() const { return all_ > read_; }
  /// One in so many frames was read.
  int frames_each() const { return read_ > 0 ? static_cast<int>((all_ + read_ / 2) / read_) : 1; }
  int user_frames() const { return static_cast<int>(user_frames_); }
  /// Share of the user's frames whose nearest pair is closer than `distance_m` in feature space [0, 1], to
  /// the millimetre and up to four metres; none without frames.
  std::optional<double> share_within(double distance_m) const;

 private:
  struct Take {
    int frames = 0;
    int stride = 1;
    int selected = 0;                  ///< times
    int selected_frames = 0;           ///< kept frames selected at least once
    std::vector<std::uint64_t> times;  ///< per kept frame
  };
  std::shared_ptr<const MotionLibrary> library_;
  std::vector<Take> takes_;
  std::vector<std::uint64_t>
      distances_;  ///< histogram of user frames by distance to the nearest pair [mm]; the last bin: more
  std::uint64_t user_frames_ = 0;
  std::uint64_t next_index_ = 0;
  std::uint64_t read_ = 0, all_ = 0;  ///< frames that were read, and those that they stand for
};

}  // namespace abrazo::widgets
