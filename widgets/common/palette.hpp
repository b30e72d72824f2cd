#pragma once

#include <QColor>
#include <string_view>

namespace abrazo::widgets {

enum class Theme { Dark, Light };

/// Colours with one meaning each, shared by scene, bars, lanes and plots.
struct Palette {
  bool dark = true;
  QColor window, panel, raised, border;
  QColor text, secondary;
  QColor active, passive;  ///< the characters, their cost terms, their tracks
  QColor user;             ///< the query and the pose cost
  QColor ghost_active, ghost_passive;
  QColor accent;
  QColor live, warning, good;
  QColor scene_top, scene_bottom, grid;
  QColor energy_deformation, energy_velocity, energy_constraint;
  QColor residual_bones, residual_locks, residual_penetration;
};

const Palette& palette_of(Theme theme);

/// Colour of a move; unknown moves share one grey.
QColor label_colour(const Palette& palette, std::string_view label);

/// One hue per take, muted; hues repeat after twelve.
QColor take_colour(const Palette& palette, int take);

/// `share` of `top` over `bottom`.
QColor mixed(const QColor& top, const QColor& bottom, double share);

/// WCAG contrast of two opaque colours, 1 to 21.
double contrast(const QColor& a, const QColor& b);

}  // namespace abrazo::widgets
