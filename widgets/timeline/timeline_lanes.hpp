#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace abrazo::widgets {

/// The rows of the timeline, from the top.
enum class TimelineLane { Source, Moves, Role, UserRole, Cost, Energy, Settings, Takes, Markers };
inline constexpr int timeline_lane_count = 9;

struct TimelineLaneInfo {
  std::string_view name;
  double height_px;
  bool shown_at_first;
};
inline constexpr std::array<TimelineLaneInfo, timeline_lane_count> timeline_lane_infos = {{
    {"Source", 27, true},
    {"Moves", 27, true},
    {"Role", 27, true},
    {"User is", 20, false},
    {"Cost", 27, true},
    {"Energy", 27, false},
    {"Settings", 20, true},
    {"Takes", 20, true},
    {"Markers", 20, true},
}};

constexpr const TimelineLaneInfo& info_of(TimelineLane lane) {
  return timeline_lane_infos[static_cast<std::size_t>(lane)];
}

/// Which lanes there are and where: the ruler above and the overview below stay, what is between scrolls
/// where the panel is low. Plain arithmetic, no toolkit.
class TimelineLanes {
 public:
  static constexpr double ruler_px = 22, overview_px = 14, gap_px = 4;

  TimelineLanes() {
    for (std::size_t lane = 0; lane < shown_.size(); ++lane)
      shown_[lane] = timeline_lane_infos[lane].shown_at_first;
  }

  bool is_shown(TimelineLane lane) const { return shown_[static_cast<std::size_t>(lane)]; }
  void set_shown(TimelineLane lane, bool on) {
    shown_[static_cast<std::size_t>(lane)] = on;
    scroll_to(scroll_px_);
  }

  /// Height of all shown lanes.
  double content_px() const {
    double sum = 0;
    for (std::size_t lane = 0; lane < shown_.size(); ++lane)
      if (shown_[lane]) sum += timeline_lane_infos[lane].height_px;
    return sum;
  }
  /// Of the whole timeline, so that nothing scrolls.
  double whole_px() const { return top_px() + content_px() + overview_px; }

  void set_height(double height_px) {
    height_px_ = height_px;
    scroll_to(scroll_px_);
  }
  double top_px() const { return ruler_px + gap_px; }
  double bottom_px() const { return std::max(top_px(), height_px_ - overview_px); }
  double most_scroll_px() const { return std::max(0.0, content_px() - (bottom_px() - top_px())); }
  double scroll_px() const { return scroll_px_; }
  void scroll_to(double px) { scroll_px_ = std::clamp(px, 0.0, most_scroll_px()); }

  /// Where the top of a lane is; it may lie outside [top_px, bottom_px].
  double top_of(TimelineLane lane) const {
    double y = top_px() - scroll_px_;
    for (std::size_t above = 0; above < static_cast<std::size_t>(lane); ++above)
      if (shown_[above]) y += timeline_lane_infos[above].height_px;
    return y;
  }

  /// @return whether a shown lane is at this height; then which
  bool lane_at(double y_px, TimelineLane& found) const {
    if (y_px < top_px() || y_px >= bottom_px()) return false;
    for (int lane = 0; lane < timeline_lane_count; ++lane) {
      const auto each = static_cast<TimelineLane>(lane);
      const double top = top_of(each);
      if (!is_shown(each) || y_px < top || y_px >= top + info_of(each).height_px) continue;
      found = each;
      return true;
    }
    return false;
  }

  /// "Source Moves": names of the shown ones, to be remembered; and back. Names it does not know are passed
  /// over.
  std::string text() const {
    std::string names;
    for (std::size_t lane = 0; lane < shown_.size(); ++lane)
      if (shown_[lane]) names += (names.empty() ? "" : " ") + std::string(timeline_lane_infos[lane].name);
    return names;
  }
  void set_text(std::string_view names) {
    for (std::size_t lane = 0; lane < shown_.size(); ++lane)
      shown_[lane] = names.find(timeline_lane_infos[lane].name) != std::string_view::npos;
    scroll_to(scroll_px_);
  }

 private:
  std::array<bool, timeline_lane_count> shown_{};
  double height_px_ = 200;
  double scroll_px_ = 0;
};

}  // namespace abrazo::widgets
