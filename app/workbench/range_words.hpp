#pragma once

#include <QString>

#include "core/session/playback.hpp"

namespace abrazo::app {

/// "1.25 s"
inline QString in_seconds(double time_s, int decimals = 2) {
  return QString::number(time_s, 'f', decimals) + " s";
}

/// "In to out: 1.25 s to 3.00 s"
inline QString range_words(const QString& name, const Playback::Range& range) {
  return QString("%1: %2 to %3").arg(name, in_seconds(range.from_s), in_seconds(range.to_s));
}

}  // namespace abrazo::app
