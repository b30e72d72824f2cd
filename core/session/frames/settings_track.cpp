#include "core/session/frames/settings_track.hpp"

#include <algorithm>
#include <utility>

namespace abrazo {

namespace {

std::string setting_name(const SettingInfo& info) {
  return std::string(info.symbol.empty() ? info.title : info.symbol);
}

bool is_inputs_own(const Settings& settings, const SettingInfo& info) {
  return info.key == "step-rate" && settings.step_rate_hz == 0;
}

std::string one_change(const SettingInfo& info, const Settings& before, const Settings& after) {
  const std::string unit = info.unit.empty() ? "" : " " + std::string(info.unit);
  const auto value = [&](const Settings& settings, const std::string& with_unit) {
    return is_inputs_own(settings, info) ? "the input's" : setting_text(settings, info.key) + with_unit;
  };
  return setting_name(info) + " " + value(before, is_inputs_own(after, info) ? unit : "") + " \u2192 " +
         value(after, unit);
}

/// While a library is learned the paper's method stands in for the intent, so the method changes by itself.
std::string reason_of(const Settings& before, const Settings& after, bool was_learning, bool is_learning) {
  if (before.selection == after.selection || was_learning == is_learning) return "";
  return is_learning ? "the library is being learned" : "the library was learned";
}

std::string with_reason(const std::string& text, const std::string& reason) {
  return reason.empty() ? text : reason + ": " + text;
}

}  // namespace

std::vector<std::string_view> changed_settings(const Settings& before, const Settings& after) {
  std::vector<std::string_view> keys;
  for (const SettingInfo& info : all_settings())
    if (setting_text(before, info.key) != setting_text(after, info.key)) keys.push_back(info.key);
  return keys;
}

std::string change_text(const Settings& before, const Settings& after) {
  const std::vector<std::string_view> keys = changed_settings(before, after);
  if (keys.size() > 1)
    for (const std::string_view name : preset_names)
      if (*preset(name) == after) return "preset " + std::string(name);
  std::string text;
  for (const std::string_view key : keys)
    text += (text.empty() ? "" : ", ") + one_change(*find_setting(key), before, after);
  return text;
}

void SettingsTrack::append(const FrameSnapshot& frame) {
  if (started_ && frame.index <= last_frame_) return;
  if (!started_) first_ = last_ = frame.settings;
  started_ = true;
  last_frame_ = frame.index;
  const bool was_learning = std::exchange(learning_, frame.is_learning);
  if (frame.settings == last_) return;
  const std::string reason = reason_of(last_, frame.settings, was_learning, frame.is_learning);
  changes_.push_back({.time_s = frame.time_s,
                      .until_s = frame.time_s,
                      .frame = frame.index,
                      .before = last_,
                      .after = frame.settings,
                      .text = with_reason(change_text(last_, frame.settings), reason),
                      .reason = reason});
  last_ = frame.settings;
}

void SettingsTrack::append(std::span<const FrameSnapshotPtr> frames) {
  for (const FrameSnapshotPtr& frame : frames) append(*frame);
}

void SettingsTrack::evict_before(double time_s) {
  while (!changes_.empty() && changes_.front().time_s < time_s) {
    first_ = changes_.front().after;
    changes_.pop_front();
  }
}

void SettingsTrack::clear() {
  *this = {};
}

const Settings* SettingsTrack::at(double time_s) const {
  if (!started_) return nullptr;
  const auto after =
      std::upper_bound(changes_.begin(), changes_.end(), time_s,
                       [](double t, const SettingsChange& change) { return t < change.time_s; });
  return after == changes_.begin() ? &first_ : &std::prev(after)->after;
}

const Settings* SettingsTrack::at_frame(std::uint64_t frame) const {
  if (!started_) return nullptr;
  const auto after =
      std::upper_bound(changes_.begin(), changes_.end(), frame,
                       [](std::uint64_t f, const SettingsChange& change) { return f < change.frame; });
  return after == changes_.begin() ? &first_ : &std::prev(after)->after;
}

std::vector<SettingsChange> SettingsTrack::merged(double gap_s) const {
  std::vector<SettingsChange> merged;
  std::vector<std::string_view> moved;  // by the last of `merged`
  for (const SettingsChange& change : changes_) {
    const std::vector<std::string_view> keys = changed_settings(change.before, change.after);
    if (merged.empty() || change.time_s - merged.back().until_s > gap_s || keys != moved) {
      merged.push_back(change);
      moved = keys;
      continue;
    }
    merged.back().until_s = change.time_s;
    merged.back().after = change.after;
    merged.back().reason = change.reason;
    merged.back().text = with_reason(change_text(merged.back().before, change.after), change.reason);
  }
  std::erase_if(merged, [](const SettingsChange& change) { return change.before == change.after; });
  return merged;
}

}  // namespace abrazo
