#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/session/frames/frame_history.hpp"

namespace abrazo::widgets {

/// What of a library a session has made use of, counted frame by frame. Plain data, no toolkit.
class TakeCoverage {
 public:
  /// Forgets everything. @param library  may be null
  void begin(std::shared_ptr<const MotionLibrary> library);
  void append(const FrameSnapshot& frame);
  /// Appends what the history has beyond what was seen of it.
  /// @return whether there was anything new
  bool append_new(const FrameHistory& history);

  /// How often a pair of the take was selected.
  int times_selected(int take) const;
  /// Share of the take's frames that were selected at least once [0, 1].
  double share_selected(int take) const;
  /// How often each part of the take was selected, the take cut into `parts` equal ones.
  std::vector<int> heat(int take, int parts) const;

  int user_frames() const { return static_cast<int>(user_frames_); }
  /// Share of the user's frames whose nearest pair is closer than `distance_m` in feature space [0, 1], to
  /// the millimetre and up to four metres; nothing before there are frames.
  std::optional<double> share_within(double distance_m) const;

 private:
  struct Take {
    int frames = 0;
    int stride = 1;
    int selected = 0;                  ///< times
    int selected_frames = 0;           ///< of the kept ones, at least once
    std::vector<std::uint32_t> times;  ///< per kept frame
  };
  std::shared_ptr<const MotionLibrary> library_;
  std::vector<Take> takes_;
  std::vector<std::uint32_t>
      distances_;  ///< user frames by the millimetres to their nearest pair; the last: more
  std::uint64_t user_frames_ = 0;
  std::uint64_t next_index_ = 0;
};

}  // namespace abrazo::widgets
