#pragma once

#include <cstdint>

namespace abrazo {

/// The frames of a take that is being recorded, or was: those that the recorder accepted between its begin
/// and its end. This decides alone what belongs to a take: file, window and exports have the same frames.
struct TakeSpan {
  double first_s = 0, last_s = 0;  ///< of the first and the last frame, session clock; 0 without frames
  std::uint64_t frames = 0;

  void extend(double time_s) {
    if (frames++ == 0) first_s = time_s;
    last_s = time_s;
  }
  bool operator==(const TakeSpan&) const = default;
};

}  // namespace abrazo
