#include "core/annotation/label_keys.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo {

namespace {

constexpr double jump_s = 0.05;  // backwards by more is no tick but a loop that starts over

}  // namespace

const AnnotationTier* tier_of_key(const Annotations& annotations, int active_tier, char key) {
  const AnnotationTier* active = annotations.tier(active_tier);
  if (active && active->entry_of_key(key)) return active;
  if (key < '1' || key > '9') return nullptr;
  const AnnotationTier* only = nullptr;
  for (const AnnotationTier& tier : annotations.tiers()) {
    if (!tier.entry_of_key(key)) continue;
    if (only) return nullptr;
    only = &tier;
  }
  return only;
}

std::vector<LabelKeys::Said> LabelKeys::set_taps(bool on, const Moment& now) {
  auto said = finish(now);
  taps_ = on;
  return said;
}

bool LabelKeys::hold(char key) {
  const bool repeats = release_of(key) != nullptr;
  held_[key].reset();
  return !repeats;
}

std::vector<LabelKeys::Said> LabelKeys::press(char key, const AnnotationTier& tier, const Moment& now) {
  std::vector<Said> said;
  const auto before = std::find_if(running_.begin(), running_.end(),
                                   [&](const auto& running) { return running.second.tier == tier.id; });
  const bool stops = taps_ && before != running_.end() && before->first == key;
  if (before != running_.end()) end(before->first, now.cursor_s, now.fps, said);
  if (!stops) running_[key] = {tier.id, tier.entry_of_key(key)->value, now.cursor_s};
  last_s_ = now.cursor_s;
  return said;
}

void LabelKeys::let_go(char key, const Moment& now) {
  const auto found = held_.find(key);
  if (found != held_.end() && !found->second) found->second = now;
}

std::vector<LabelKeys::Said> LabelKeys::settle() {
  std::vector<Said> said;
  for (const auto& [key, release] : held_)
    if (release && !taps_) end(key, release->cursor_s, release->fps, said);
  std::erase_if(held_, [](const auto& held) { return held.second.has_value(); });
  return said;
}

std::vector<LabelKeys::Said> LabelKeys::let_all_go(const Moment& now) {
  for (auto& [key, release] : held_)
    if (!release) release = now;
  return settle();
}

const LabelKeys::Moment* LabelKeys::release_of(char key) const {
  const auto found = held_.find(key);
  return found != held_.end() && found->second ? &*found->second : nullptr;
}

std::vector<LabelKeys::Said> LabelKeys::finish(const Moment& now) {
  std::vector<Said> said;
  while (!running_.empty()) end(running_.begin()->first, now.cursor_s, now.fps, said);
  return said;
}

std::vector<LabelKeys::Said> LabelKeys::follow(const Moment& now) {
  std::vector<Said> said;
  const bool starts_over = now.speed > 0 && now.cursor_s < last_s_ - jump_s;
  if (!running_.empty() && (now.is_parked || starts_over)) {
    const auto running = running_;
    const double until_s = now.is_parked ? now.cursor_s : std::max(last_s_, now.out_s.value_or(last_s_));
    for (const auto& [key, each] : running) {
      const std::size_t said_before = said.size();
      end(key, until_s, now.fps, said);
      // Pressed within the last frame of the loop: the label is still empty and applies to the next pass.
      const bool said_nothing = said.size() == said_before;
      const bool is_over = !taps_ && release_of(key);
      if (!now.is_parked && !is_over && (taps_ || said_nothing))
        running_[key] = {each.tier, each.value, now.cursor_s};
    }
  }
  last_s_ = now.cursor_s;
  return said;
}

void LabelKeys::end(char key, double at_s, double fps, std::vector<Said>& said) {
  const auto found = running_.find(key);
  if (found == running_.end()) return;
  const Running ended = found->second;
  running_.erase(found);
  if (const Moment* release = taps_ ? nullptr : release_of(key)) at_s = release->cursor_s;
  const auto frame = [fps](double time_s) { return fps > 0 ? std::round(time_s * fps) / fps : time_s; };
  const Annotations::Range span{frame(std::min(ended.from_s, at_s)), frame(std::max(ended.from_s, at_s))};
  if (span.last_s > span.first_s) said.push_back({ended.tier, ended.value, span});
}

}  // namespace abrazo
