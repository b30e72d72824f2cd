#pragma once

#include <QString>
#include <cmath>
#include <cstddef>

#include "core/session/frames/playback.hpp"

namespace abrazo::app {

/// "1 frame", "1,234 frames"
inline QString counted(std::size_t count, const char* one) {
  return QString("%L1 %2%3").arg(count).arg(one, count == 1 ? "" : "s");
}

/// "1.25 s"
inline QString in_seconds(double time_s, int decimals = 2) {
  return QString::number(time_s, 'f', decimals) + " s";
}

/// "In to out: 1.25 s to 3.00 s"
inline QString range_words(const QString& name, const Playback::Range& range) {
  return QString("%1: %2 to %3").arg(name, in_seconds(range.from_s), in_seconds(range.to_s));
}

/// "about 3 min"
inline QString about(double seconds) {
  if (seconds < 10) return "a few seconds";
  if (seconds < 90) return QString("about %1 s").arg(10 * std::lround(seconds / 10));
  if (seconds < 5400) return QString("about %1 min").arg(std::lround(seconds / 60));
  return QString("about %1 h").arg(seconds / 3600, 0, 'f', 1);
}

}  // namespace abrazo::app
