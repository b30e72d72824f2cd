#include "widgets/plots/pane_arrangement.hpp"

#include <algorithm>

namespace abrazo::widgets {
namespace {

std::vector<std::string_view> parts(std::string_view text, char separator) {
  std::vector<std::string_view> found;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    found.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return found;
}

PaneSeries pane_of(std::string_view text) {
  PaneSeries pane;
  for (const std::string_view key : parts(text, ',')) {
    const auto series = find_series(key);
    if (series && can_join(pane, *series) && std::ranges::find(pane, *series) == pane.end())
      pane.push_back(*series);
  }
  return pane;
}

}  // namespace

PaneArrangement default_arrangement() {
  return {usual_series("Energy"), usual_series("Residuals"), usual_series("Cost")};
}

bool can_join(const PaneSeries& pane, Series series) {
  return pane.empty() || info_of(pane.front()).unit == info_of(series).unit;
}

bool share_scale(const PaneSeries& a, const PaneSeries& b) {
  if (a.empty() || b.empty()) return false;
  const SeriesInfo &first = info_of(a.front()), &second = info_of(b.front());
  return first.group == second.group && first.unit == second.unit;
}

std::string why_not(const PaneSeries& pane, Series series) {
  if (can_join(pane, series)) return {};
  const SeriesInfo& wanted = info_of(series);
  return "'" + std::string(wanted.name) + "' is in " + std::string(wanted.unit) + ", this pane in " +
         std::string(info_of(pane.front()).unit) + "; add a pane for it";
}

std::string title_of(const PaneSeries& pane) {
  if (pane.empty()) return "Nothing chosen";
  const SeriesInfo& first = info_of(pane.front());
  const bool same = std::ranges::all_of(pane, [&](Series s) { return info_of(s).group == first.group; });
  const std::string unit = first.unit == "1" ? "" : " [" + std::string(first.unit) + "]";
  return std::string(first.group) + (same ? "" : " …") + unit;
}

std::vector<std::string_view> series_groups() {
  std::vector<std::string_view> groups;
  for (const SeriesInfo& info : all_series())
    if (groups.empty() || groups.back() != info.group) groups.push_back(info.group);
  return groups;
}

PaneSeries series_of_group(std::string_view group) {
  PaneSeries found;
  for (const SeriesInfo& info : all_series())
    if (info.group == group) found.push_back(info.series);
  return found;
}

PaneSeries usual_series(std::string_view group) {
  using enum Series;
  if (group == "Residuals") return {FootLock, ExcessPenetration};
  if (group == "Selected edge") return {EdgeLength, EdgeReference};
  if (group == "Cost") return {PoseCost, LeaderCost, FollowerCost};
  if (group == "Cost by intent")
    return {ExpectedPartner, LeaderMotion, UnlikelyMove, NotMeant, ChangeOfSource};
  return series_of_group(group);
}

std::string text_of(const PaneArrangement& panes) {
  std::string text;
  for (const PaneSeries& pane : panes) {
    if (pane.empty()) continue;
    if (!text.empty()) text += ';';
    for (const Series series : pane) {
      if (series != pane.front()) text += ',';
      text += info_of(series).key;
    }
  }
  return text;
}

PaneArrangement arrangement_of(std::string_view text) {
  PaneArrangement panes;
  for (const std::string_view part : parts(text, ';')) {
    PaneSeries pane = pane_of(part);
    if (!pane.empty() && panes.size() < most_panes) panes.push_back(std::move(pane));
  }
  return panes.empty() ? default_arrangement() : panes;
}

PaneGrid plan_panes(int panes, int width_px, int height_px) {
  constexpr int readable_width = 230, least_width = 130, least_height = 92;
  PaneGrid grid;
  if (panes <= 0) return grid;
  grid.collapsed = height_px < least_height;
  const int most_rows = std::clamp(height_px / least_height, 1, panes);
  const auto shared = [panes](int by) { return (panes + by - 1) / by; };
  while (grid.rows < most_rows && width_px / shared(grid.rows) < readable_width) ++grid.rows;
  grid.columns = std::clamp(width_px / least_width, 1, shared(grid.rows));
  // Where not all fit, those that are in view are readable.
  if (shared(grid.columns) > grid.rows) grid.columns = std::clamp(width_px / readable_width, 1, grid.columns);
  grid.all_rows = shared(grid.columns);
  return grid;
}

}  // namespace abrazo::widgets
