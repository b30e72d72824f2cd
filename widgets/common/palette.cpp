#include "widgets/common/palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/base/text.hpp"
#include "widgets/common/qt_versions.hpp"

namespace abrazo::widgets {
namespace {

Palette dark_palette() {
  Palette p;
  p.dark = true;
  p.window = "#16181d", p.panel = "#1b1e24", p.raised = "#262b34", p.border = "#2a2f38";
  p.text = "#d7dbe3", p.secondary = "#8a92a0";
  p.active = "#3f8fe8", p.passive = "#f2714f", p.user = "#93a1b5";
  p.ghost_active = "#e8c547", p.ghost_passive = "#c79bff";
  p.accent = "#2f6fb8";
  p.live = "#c8372d", p.warning = "#e8c547", p.good = "#3bb273";
  p.scene_top = "#20242b", p.scene_bottom = "#15171b", p.grid = "#7d8797";
  p.energy_deformation = "#d7dbe3", p.energy_velocity = "#7fd6b0", p.energy_constraint = "#e8c547";
  p.residual_bones = "#5aa9e6", p.residual_locks = "#f2714f", p.residual_penetration = "#c79bff";
  return p;
}

Palette light_palette() {
  Palette p;
  p.dark = false;
  p.window = "#f4f5f7", p.panel = "#ffffff", p.raised = "#eceff3", p.border = "#d5dae1";
  p.text = "#1d2026", p.secondary = "#5b6472";
  p.active = "#1f6fc9", p.passive = "#d2512f", p.user = "#66748a";
  p.ghost_active = "#b08d00", p.ghost_passive = "#8a5fd0";
  p.accent = "#2f6fb8";
  p.live = "#b52c23", p.warning = "#8a6a00", p.good = "#1f7a4b";
  p.scene_top = "#fbfcfd", p.scene_bottom = "#dfe3e9", p.grid = "#8b95a3";
  p.energy_deformation = "#4a5260", p.energy_velocity = "#178a5f", p.energy_constraint = "#a07b00";
  p.residual_bones = "#1f6fc9", p.residual_locks = "#d2512f", p.residual_penetration = "#8a5fd0";
  return p;
}

double linear(double channel) {
  return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& c) {
  return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}

}  // namespace

const Palette& palette_of(Theme theme) {
  static const Palette dark = dark_palette();
  static const Palette light = light_palette();
  return theme == Theme::Dark ? dark : light;
}

QColor label_colour(const Palette& palette, std::string_view label) {
  // Labels come from people: "Open hold", "open_hold" and "open-hold, slow" are the same move here.
  std::string name = lower_case(label);
  std::replace(name.begin(), name.end(), '_', ' ');
  std::replace(name.begin(), name.end(), '-', ' ');
  static const std::array<std::pair<const char*, const char*>, 6> moves = {{{"open hold", "#5aa9e6"},
                                                                            {"closed hold", "#3bb273"},
                                                                            {"turn", "#e15554"},
                                                                            {"cross body", "#e1a23b"},
                                                                            {"walk", "#9a86d8"},
                                                                            {"in and out", "#4dbfae"}}};
  for (const auto& [move, colour] : moves)
    if (name.find(move) != std::string::npos)
      return palette.dark ? QColor(colour) : QColor(colour).darker(112);
  if (name.empty() || name.find("basic") != std::string::npos) return QColor("#59616e");
  // A move that is none of these has a colour by its name, the same in every session (FNV-1a).
  static const std::array<const char*, 8> others = {"#d279b8", "#8fb84a", "#c98a5b", "#6f8fe8",
                                                    "#c7b23f", "#59b5c9", "#b06bd1", "#d9776a"};
  std::uint32_t hash = 2166136261u;
  for (const char letter : name) hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619u;
  const QColor colour(others[hash % others.size()]);
  return palette.dark ? colour : colour.darker(112);
}

QColor take_colour(const Palette& palette, int take) {
  static const std::array<const char*, 12> hues = {"#4d6f9f", "#a3654a", "#5b8f72", "#7b5f97",
                                                   "#98784a", "#4a8a8f", "#94545f", "#6d8450",
                                                   "#5a65a3", "#8f5a85", "#8d8a4b", "#59768a"};
  const QColor hue(hues[static_cast<std::size_t>(std::max(take, 0)) % hues.size()]);
  return palette.dark ? hue : mixed(hue, Qt::white, 0.72);
}

QColor mixed(const QColor& top, const QColor& bottom, double share) {
  const auto blend = [share](double a, double b) { return colour_part(share * a + (1 - share) * b); };
  return QColor::fromRgbF(blend(top.redF(), bottom.redF()), blend(top.greenF(), bottom.greenF()),
                          blend(top.blueF(), bottom.blueF()));
}

double contrast(const QColor& a, const QColor& b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

}  // namespace abrazo::widgets
