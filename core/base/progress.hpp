#pragma once

#include <functional>
#include <string_view>

namespace abrazo {

/// Called at intervals by a long job with the fraction done [0, 1] and the present activity. Returning false
/// cancels the job; it then leaves nothing behind and returns an Error "cancelled". May be empty.
using Progress = std::function<bool(double fraction, std::string_view doing)>;

/// Reports to `progress` if it is not empty. @return false if the job should stop
inline bool report(const Progress& progress, double fraction, std::string_view doing) {
  return !progress || progress(fraction, doing);
}

/// Progress of a part of a longer job, from fraction `from` to `to` of the whole.
inline Progress part(const Progress& progress, double from, double to) {
  if (!progress) return {};
  return [progress, from, to](double fraction, std::string_view doing) {
    return progress(from + fraction * (to - from), doing);
  };
}

}  // namespace abrazo
