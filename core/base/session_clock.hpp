#pragma once

#include <chrono>

namespace abrazo {

/// Seconds since a session began, on the monotonic clock. A small value type; every thread of a session has a
/// copy.
class SessionClock {
 public:
  using Steady = std::chrono::steady_clock;
  explicit SessionClock(Steady::time_point start = Steady::now()) : start_(start) {}

  double now_s() const { return since_start(Steady::now()); }
  double since_start(Steady::time_point instant) const {
    return std::chrono::duration<double>(instant - start_).count();
  }
  Steady::time_point at(double session_s) const {
    return start_ + std::chrono::duration_cast<Steady::duration>(std::chrono::duration<double>(session_s));
  }

 private:
  Steady::time_point start_;
};

}  // namespace abrazo
