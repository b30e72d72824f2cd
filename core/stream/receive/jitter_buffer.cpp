#include "core/stream/receive/jitter_buffer.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo {

namespace {

constexpr std::size_t most_entries = 1024;
constexpr double kept_s = 1;  ///< after it was due, for readers that sleep

}  // namespace

void JitterBuffer::set_delay(double delay_s) {
  delay_s_ = std::isfinite(delay_s) ? std::clamp(delay_s, 0.0, longest_delay_s) : 0.0;
}

JitterBuffer::Fate JitterBuffer::push(Entry entry, double now_s) {
  play_until(now_s);
  if (played_ && entry.place < *played_) return Fate::Late;
  auto position = entries_.end();
  while (position != entries_.begin() && entry.place < (position - 1)->place) --position;
  const bool is_newest = position == entries_.end();
  // Due times keep the sender's order regardless of the clocks.
  if (position != entries_.begin()) entry.sent_s = std::max(entry.sent_s, (position - 1)->sent_s);
  if (!is_newest) entry.sent_s = std::min(entry.sent_s, position->sent_s);
  entries_.insert(position, std::move(entry));
  play_until(now_s);
  while (entries_.size() > most_entries ||
         (entries_.size() > 1 && entries_[1].sent_s + delay_s_ < now_s - kept_s)) {
    entries_.pop_front();
    ++forgotten_;
  }
  return is_newest ? Fate::Taken : Fate::Reordered;
}

void JitterBuffer::play_until(double now_s) {
  for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) {
    if (entry->sent_s + delay_s_ > now_s) continue;
    if (!played_ || *played_ < entry->place) played_ = entry->place;
    return;
  }
}

JitterBuffer::Cursor JitterBuffer::now(double now_s) {
  play_until(now_s);
  for (std::size_t i = entries_.size(); i-- > 0;)
    if (entries_[i].sent_s + delay_s_ <= now_s) return {forgotten_ + i};
  return {forgotten_};
}

std::optional<JitterBuffer::Due> JitterBuffer::due_after(const Cursor& cursor, double now_s) {
  play_until(now_s);
  const std::uint64_t number = std::max(cursor.next, forgotten_);
  if (number >= forgotten_ + entries_.size()) return std::nullopt;
  const Entry& entry = entries_[static_cast<std::size_t>(number - forgotten_)];
  if (entry.sent_s + delay_s_ > now_s) return std::nullopt;
  return Due{&entry, number};
}

std::optional<double> JitterBuffer::next_due_s(const Cursor& cursor) const {
  const std::uint64_t number = std::max(cursor.next, forgotten_);
  if (number >= forgotten_ + entries_.size()) return std::nullopt;
  return entries_[static_cast<std::size_t>(number - forgotten_)].sent_s + delay_s_;
}

}  // namespace abrazo
