#include "core/stream/receive/sender_clock.hpp"

#include <cmath>
#include <limits>

namespace abrazo {

namespace {

/// Distance to the next number that the sender could have sent: a number that a 32-bit float holds exactly
/// came in one.
double resolution_of(double sent_s) {
  const auto single = static_cast<float>(sent_s);
  if (static_cast<double>(single) != sent_s) return 0;
  return static_cast<double>(std::nextafter(single, std::numeric_limits<float>::infinity()) - single);
}

}  // namespace

bool SenderClock::take(double sent_s, double arrived_s) {
  const bool jumped = follow(sent_s, arrived_s);
  if (const Doubt found = doubt_about(sent_s, arrived_s, jumped); found != Doubt::None) {
    doubt_ = found;
    doubtful_until_s_ = arrived_s + proof_s;
  } else if (arrived_s >= doubtful_until_s_) {
    doubt_ = Doubt::None;
  }
  last_sent_s_ = sent_s;
  return jumped && doubt_ == Doubt::None;
}

SenderClock::Doubt SenderClock::doubt_about(double sent_s, double arrived_s, bool jumped) {
  if (resolution_of(sent_s) > coarsest_s) return Doubt::Coarse;
  if (last_sent_s_ == sent_s) return Doubt::Stands;
  if (jumped) jumped_s_.push_back(arrived_s);
  while (!jumped_s_.empty() && jumped_s_.front() < arrived_s - jumps_within_s) jumped_s_.pop_front();
  return jumped_s_.size() > most_jumps ? Doubt::Jumps : Doubt::None;
}

bool SenderClock::follow(double sent_s, double arrived_s) {
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
  if (smallest_.empty() || doubt_ != Doubt::None) return std::nullopt;
  return sent_s + smallest_.front().offset_s;
}

void SenderClock::restart() {
  smallest_.clear();
  late_since_s_.reset();
  last_sent_s_.reset();
}

void SenderClock::begin_with(double sent_s, double arrived_s) {
  smallest_.clear();
  late_since_s_.reset();
  smallest_.push_back({arrived_s, arrived_s - sent_s});
  newest_sent_s_ = sent_s;
}

}  // namespace abrazo
