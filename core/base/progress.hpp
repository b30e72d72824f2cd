#pragma once

#include <functional>
#include <string_view>

namespace abrazo {

/// Called now and then by a long job with the fraction done [0, 1] and what it is doing.
/// Returning false asks the job to stop; it then leaves nothing behind and returns an Error "cancelled".
/// May be empty.
using Progress = std::function<bool(double fraction, std::string_view doing)>;

/// Reports if there is someone to report to. @return false when the job should stop
inline bool report(const Progress& progress, double fraction, std::string_view doing) {
  return !progress || progress(fraction, doing);
}

/// Progress of a part of a longer job, which goes from `from` to `to` of the whole.
inline Progress part(const Progress& progress, double from, double to) {
  if (!progress) return {};
  return [progress, from, to](double fraction, std::string_view doing) {
    return progress(from + fraction * (to - from), doing);
  };
}

}  // namespace abrazo
