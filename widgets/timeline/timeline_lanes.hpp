#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace abrazo::widgets {

/// The computed rows of the timeline, from the top.
enum class TimelineLane { Source, Moves, Role, Cost, Energy, Settings, Takes, Markers };
inline constexpr int timeline_lane_count = 8;

struct TimelineLaneInfo {
  std::string_view name;
  double height_px;
  bool shown_at_first;
  bool says_of_a_take;  ///< has content for a take instead of the session
};
inline constexpr std::array<TimelineLaneInfo, timeline_lane_count> timeline_lane_infos = {{
    {"Source", 27, true, true},
    {"Moves", 27, true, false},
    {"Role", 27, true, false},
    {"Cost", 27, true, false},
    {"Energy", 27, false, false},
    {"Settings", 20, true, false},
    {"Takes", 20, true, false},
    {"Markers", 20, true, true},
}};

constexpr const TimelineLaneInfo& info_of(TimelineLane lane) {
  return timeline_lane_infos[static_cast<std::size_t>(lane)];
}

/// The row of a tier of annotations.
struct TierLane {
  int tier = 0;  ///< its id
  std::string name;
  bool is_empty = false;  ///< neither labels nor suggestions

  bool operator==(const TierLane&) const = default;
};

/// Layout of the lanes: the ruler above and the overview below are fixed, the lanes between scroll in a low
/// panel. Lanes of tiers are below the computed ones. Independent of Qt.
class TimelineLanes {
 public:
  static constexpr double ruler_px = 22, overview_px = 14, gap_px = 4, tier_px = 27;

  TimelineLanes() {
    for (std::size_t lane = 0; lane < shown_.size(); ++lane)
      shown_[lane] = timeline_lane_infos[lane].shown_at_first;
  }

  bool is_shown(TimelineLane lane) const {
    return shown_[static_cast<std::size_t>(lane)] && (!of_take_ || info_of(lane).says_of_a_take);
  }
  void set_shown(TimelineLane lane, bool on) {
    shown_[static_cast<std::size_t>(lane)] = on;
    settle();
  }
  /// While a take of the library is shown, lanes without content for it are hidden.
  void set_of_take(bool on) {
    of_take_ = on;
    settle();
  }
  bool is_of_take() const { return of_take_; }

  const std::vector<TierLane>& tiers() const { return tiers_; }
  void set_tiers(std::vector<TierLane> tiers) {
    tiers_ = std::move(tiers);
    settle();
  }
  /// Hiding is by name: it also applies in other subjects and after the tier returns.
  bool is_shown(const TierLane& lane) const { return !hidden_.contains(lane.name); }
  void set_tier_shown(const std::string& name, bool on) {
    on ? void(hidden_.erase(name)) : void(hidden_.insert(name));
    settle();
  }

  /// Height of all shown lanes.
  double content_px() const { return computed_px() + tiers_above(tiers_.size()); }
  /// Height at which nothing scrolls.
  double whole_px() const { return top_px() + content_px() + overview_px; }

  void set_height(double height_px) {
    height_px_ = height_px;
    settle();
  }
  double top_px() const { return ruler_px + gap_px; }
  double bottom_px() const { return std::max(top_px(), height_px_ - overview_px); }
  /// So far that the last lane is whole and a lane begins at the top.
  double most_scroll_px() const {
    const double hidden_px = content_px() - (bottom_px() - top_px());
    return hidden_px > 0 ? edge_from(hidden_px) : 0.0;
  }
  /// Where the lanes are: one begins at the top, so that none is cut there.
  double scroll_px() const { return scroll_px_; }
  /// The exact place that was asked for, from which a wheel of small steps goes on.
  double asked_scroll_px() const { return asked_scroll_px_; }
  void scroll_to(double px) {
    kept_tier_ = 0;
    before_tier_px_.reset();
    place(px);
  }
  /// Scrolls until a lane is fully visible; no effect on one that is not shown.
  void reveal(TimelineLane lane) {
    if (!is_shown(lane)) return;
    before_tier_px_.reset();
    bring(top_of(lane), info_of(lane).height_px);
  }
  /// The lane of a tier stays fully visible in every height, until it is scrolled away. The lanes of the
  /// session do not give way to an empty one: it comes into view with its first label. Afterwards the lanes
  /// return to where they were scrolled. @param tier  0 = none
  void reveal(int tier) {
    kept_tier_ = tier;
    settle();
  }

  /// Top of a lane; may be outside [top_px, bottom_px].
  double top_of(TimelineLane lane) const {
    double y = top_px() - scroll_px_;
    for (std::size_t above = 0; above < static_cast<std::size_t>(lane); ++above)
      if (is_shown(static_cast<TimelineLane>(above))) y += timeline_lane_infos[above].height_px;
    return y;
  }
  double top_of_tier(int tier) const {
    std::size_t place = 0;
    while (place < tiers_.size() && tiers_[place].tier != tier) ++place;
    return top_px() - scroll_px_ + computed_px() + tiers_above(place);
  }

  /// @return whether a shown lane is at this height; sets `found`
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
  /// Id of the tier whose shown lane is at this height; 0 = none.
  int tier_at(double y_px) const {
    if (y_px < top_px() || y_px >= bottom_px()) return 0;
    for (const TierLane& lane : tiers_) {
      const double top = top_of_tier(lane.tier);
      if (is_shown(lane) && y_px >= top && y_px < top + tier_px) return lane.tier;
    }
    return 0;
  }

  /// "Source Moves|notes": stored form of the shown computed lanes and the hidden tiers. Unknown lane names
  /// are ignored. In a tier's name '|' is "%7C" and '%' is "%25".
  std::string text() const {
    std::string names;
    for (std::size_t lane = 0; lane < shown_.size(); ++lane)
      if (shown_[lane]) names += (names.empty() ? "" : " ") + std::string(timeline_lane_infos[lane].name);
    for (const std::string& hidden : hidden_) names += "|" + in_list(hidden);
    return names;
  }
  void set_text(std::string_view names) {
    const std::string_view computed = names.substr(0, names.find('|'));
    for (std::size_t lane = 0; lane < shown_.size(); ++lane)
      shown_[lane] = computed.find(timeline_lane_infos[lane].name) != std::string_view::npos;
    hidden_.clear();
    for (std::size_t bar = names.find('|'); bar != std::string_view::npos;) {
      const std::size_t next = names.find('|', bar + 1);
      const std::size_t length = next == std::string_view::npos ? next : next - bar - 1;
      hidden_.insert(from_list(names.substr(bar + 1, length)));
      bar = next;
    }
    settle();
  }

 private:
  static std::string in_list(std::string_view name) {
    std::string listed;
    for (const char c : name) listed += c == '|' ? "%7C" : c == '%' ? "%25" : std::string(1, c);
    return listed;
  }
  static std::string from_list(std::string_view listed) {
    std::string name;
    for (; !listed.empty(); listed.remove_prefix(1)) {
      const bool is_bar = listed.starts_with("%7C");
      const bool is_spelled = is_bar || listed.starts_with("%25");
      name += is_bar ? '|' : listed.front();
      if (is_spelled) listed.remove_prefix(2);
    }
    return name;
  }

  void place(double px) {
    asked_scroll_px_ = std::clamp(px, 0.0, most_scroll_px());
    scroll_px_ = edge_near(asked_scroll_px_);
  }
  /// After another height or other lanes.
  void settle() {
    place(before_tier_px_.value_or(asked_scroll_px_));
    before_tier_px_.reset();
    keep_tier();
  }
  void keep_tier() {
    const double before_px = asked_scroll_px_;
    for (const TierLane& lane : tiers_)
      if (lane.tier == kept_tier_ && is_shown(lane) && (of_take_ || !lane.is_empty))
        bring(top_of_tier(lane.tier), tier_px);
    if (asked_scroll_px_ != before_px) before_tier_px_ = before_px;
  }
  void bring(double top, double height) {
    const double bottom = top + height;
    if (top < top_px()) place(scroll_px_ - (top_px() - top));
    if (bottom > bottom_px()) place(edge_from(scroll_px_ + bottom - bottom_px()));
  }

  /// Calls `visit(top)` with the top of each shown lane, from the first one's, 0.
  template <typename Visit>
  void each_edge(Visit visit) const {
    double top = 0;
    for (std::size_t lane = 0; lane < shown_.size(); ++lane) {
      if (!is_shown(static_cast<TimelineLane>(lane))) continue;
      visit(top);
      top += timeline_lane_infos[lane].height_px;
    }
    for (const TierLane& lane : tiers_) {
      if (!is_shown(lane)) continue;
      visit(top);
      top += tier_px;
    }
  }
  /// The first top of a lane that is not above `px`; the last one if there is none.
  double edge_from(double px) const {
    constexpr double rounding_px = 1e-6;
    double found = 0;
    each_edge([&](double top) {
      if (found < px - rounding_px) found = top;
    });
    return found;
  }
  double edge_near(double px) const {
    double found = 0;
    each_edge([&](double top) {
      if (std::abs(top - px) <= std::abs(found - px)) found = top;
    });
    return found;
  }

  double computed_px() const {
    double sum = 0;
    for (int lane = 0; lane < timeline_lane_count; ++lane)
      if (is_shown(static_cast<TimelineLane>(lane)))
        sum += timeline_lane_infos[static_cast<std::size_t>(lane)].height_px;
    return sum;
  }
  double tiers_above(std::size_t place) const {
    double sum = 0;
    for (std::size_t above = 0; above < place; ++above)
      if (is_shown(tiers_[above])) sum += tier_px;
    return sum;
  }

  std::array<bool, timeline_lane_count> shown_{};
  bool of_take_ = false;
  std::vector<TierLane> tiers_;
  std::set<std::string> hidden_;
  double height_px_ = 200;
  double scroll_px_ = 0, asked_scroll_px_ = 0;
  int kept_tier_ = 0;                     ///< id of the tier that stays in view; 0 = none
  std::optional<double> before_tier_px_;  ///< the asked place, if the kept tier moved the lanes from there
};

}  // namespace abrazo::widgets
