#pragma once

#include <algorithm>
#include <cmath>

#include "core/video/film_plan.hpp"

namespace abrazo::app {

/// Timing of a live film: a late or dropped picture is compensated by showing the next one longer.
class FilmClock {
 public:
  explicit FilmClock(double rate_hz) : m_rateHz(rate_hz) {}

  /// Number of frames for which the present picture stands; 0 = none is due.
  int due(double elapsed_s) const {
    return std::max(0, static_cast<int>(std::floor(elapsed_s * m_rateHz)) + 1 - m_given);
  }
  void given(int pictures) { m_given += pictures; }
  /// Reports a dropped picture, because the writer was busy.
  void dropped() { ++m_dropped; }
  int pictures() const { return m_given; }
  int left_out() const { return m_dropped; }

 private:
  double m_rateHz;
  int m_given = 0, m_dropped = 0;
};

}  // namespace abrazo::app
