#include "core/stream/receive/sender_clock.hpp"

#include <cmath>

namespace abrazo {

bool SenderClock::take(double sent_s, double arrived_s) {
  if (smallest_.empty()) {
    begin_with(sent_s, arrived_s);
    return false;
  }
  const double late_s = arrived_s - sent_s - smallest_.front().offset_s;
  const bool set_back = sent_s < newest_sent_s_ - jump_s;
  const bool set_forward = late_s < -jump_s;
  if (late_s <= jump_s)
    late_since_s_.reset();
  else if (!late_since_s_)
    late_since_s_ = arrived_s;
  // A stalled network delivers all held packets at once; a stopped clock stays behind.
  const bool stays_behind = late_since_s_ && arrived_s - *late_since_s_ > patience_s;
  if (set_back || set_forward || stays_behind) {
    begin_with(sent_s, arrived_s);
    return true;
  }
  newest_sent_s_ = sent_s;
  const double offset_s = arrived_s - sent_s;
  while (!smallest_.empty() && smallest_.back().offset_s >= offset_s) smallest_.pop_back();
  smallest_.push_back({arrived_s, offset_s});
  while (smallest_.front().arrived_s < arrived_s - window_s) smallest_.pop_front();
  return false;
}

std::optional<double> SenderClock::session_time(double sent_s) const {
  if (smallest_.empty()) return std::nullopt;
  return sent_s + smallest_.front().offset_s;
}

void SenderClock::restart() {
  smallest_.clear();
  late_since_s_.reset();
}

void SenderClock::begin_with(double sent_s, double arrived_s) {
  restart();
  smallest_.push_back({arrived_s, arrived_s - sent_s});
  newest_sent_s_ = sent_s;
}

}  // namespace abrazo
