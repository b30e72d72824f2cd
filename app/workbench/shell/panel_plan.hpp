#pragma once

#include <QSize>
#include <optional>

namespace abrazo::app {

/// Panels shown at a window size. In a small window the scene has priority. Independent of Qt.
struct PanelPlan {
  bool left = true;   ///< scene and library
  bool right = true;  ///< candidates and settings
  bool plots = true;
  bool has_low_heads = false;
  int left_width = 262;
  int right_width = 406;
};

/// The user's choices; none = decided by the size.
struct PanelWishes {
  std::optional<bool> left, right, plots;

  bool operator==(const PanelWishes&) const = default;
};

/// @param beside  width of what stands beside the scene
inline PanelPlan plan_panels(QSize window, const PanelWishes& wishes, int beside = 0) {
  constexpr int least_scene = 320, borders = 4;
  PanelPlan plan;
  plan.left = wishes.left.value_or(window.width() >= 1040 && window.height() >= 600);
  plan.right = wishes.right.value_or(window.width() >= 760);
  plan.plots = wishes.plots.value_or(window.height() >= 760);
  plan.has_low_heads = window.height() < 800;
  if (window.width() < 1440) plan.right_width = 340;
  if (window.width() < 1200) plan.right_width = 300;
  if (window.width() < 1200) plan.left_width = 230;
  if (beside == 0) return plan;
  const auto needed = [&plan, beside] {
    return beside + least_scene + borders + (plan.left ? plan.left_width : 0) +
           (plan.right ? plan.right_width : 0);
  };
  if (needed() > window.width()) plan.left = wishes.left.value_or(false);
  if (needed() > window.width()) plan.right = wishes.right.value_or(false);
  return plan;
}

}  // namespace abrazo::app
