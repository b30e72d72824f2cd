#pragma once

#include <algorithm>
#include <cmath>

#include "core/video/film_plan.hpp"

namespace abrazo::app {

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
