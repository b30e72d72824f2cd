#pragma once

#include <algorithm>
#include <cmath>

namespace abrazo::app {

/// The moments of a film of something recorded: the beginning, then one every 1 / rate seconds up to the end.
struct FilmPlan {
  static constexpr double slowest_hz = 1, fastest_hz = 240;
  double from_s = 0, to_s = 0;
  double rate_hz = 30;

  int pictures() const {
    constexpr double rounding = 1e-6;
    return to_s < from_s ? 0 : static_cast<int>(std::floor((to_s - from_s) * rate_hz + rounding)) + 1;
  }
  double time_of(int picture) const { return from_s + picture / rate_hz; }
};

/// A live film keeps real time: a picture that is late, or could not be taken in, is made up for by the next
/// that stands for longer.
class FilmClock {
 public:
  explicit FilmClock(double rate_hz) : m_rateHz(rate_hz) {}

  /// How many pictures the one of this moment stands for; 0 while none is due.
  int due(double elapsed_s) const {
    return std::max(0, static_cast<int>(std::floor(elapsed_s * m_rateHz)) + 1 - m_given);
  }
  void given(int pictures) { m_given += pictures; }
  /// A picture had to be left out: what took it in was still busy.
  void dropped() { ++m_dropped; }
  int pictures() const { return m_given; }
  int left_out() const { return m_dropped; }

 private:
  double m_rateHz;
  int m_given = 0, m_dropped = 0;
};

}  // namespace abrazo::app
