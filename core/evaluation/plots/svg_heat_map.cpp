#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/evaluation/plots/html_text.hpp"
#include "core/evaluation/plots/svg_canvas.hpp"
#include "core/evaluation/plots/svg_plot.hpp"

namespace abrazo {

namespace {

using Anchor = SvgCanvas::Anchor;
using Rgb = std::array<int, 3>;

constexpr double margin = 8, text_size = 12, heat_map_title_size = 13, cell_height = 28;

// Viridis (van der Walt and Smith, 2015) at 0, 1/8, ... 1.
constexpr std::array<Rgb, 9> viridis_anchors = {Rgb{68, 1, 84},    Rgb{71, 45, 123},  Rgb{59, 82, 139},
                                                Rgb{44, 114, 142}, Rgb{33, 145, 140}, Rgb{40, 174, 128},
                                                Rgb{94, 201, 98},  Rgb{173, 220, 48}, Rgb{253, 231, 37}};

Rgb viridis_rgb(double fraction) {
  const double place = std::clamp(fraction, 0.0, 1.0) * (viridis_anchors.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), viridis_anchors.size() - 2);
  const double part = place - static_cast<double>(below);
  Rgb colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = static_cast<int>(
        std::lround((1 - part) * viridis_anchors[below][c] + part * viridis_anchors[below + 1][c]));
  return colour;
}

bool is_light(const Rgb& colour) {
  return 0.299 * colour[0] + 0.587 * colour[1] + 0.114 * colour[2] > 110;
}

struct Layout {
  double left, top, cell_width, right, bottom;
};

double longest(const std::vector<std::string>& names) {
  double width = 0;
  for (const std::string& name : names) width = std::max(width, text_width(name, text_size));
  return width;
}

Layout lay_out(const HeatMap& map) {
  double widest_cell = 0;
  for (const auto& row : map.cells)
    for (const HeatCell& cell : row) widest_cell = std::max(widest_cell, text_width(cell.text, text_size));
  Layout layout{};
  layout.left = margin + 18 + std::min(longest(map.rows), 170.0) + 8;
  layout.cell_width = std::clamp(widest_cell + 12, 40.0, 90.0);
  const bool turned = longest(map.columns) > layout.cell_width - 4;
  layout.top = margin + heat_map_title_size + 26 + (turned ? std::min(longest(map.columns), 130.0) : 12) + 6;
  layout.right = layout.left + layout.cell_width * static_cast<double>(map.columns.size());
  layout.bottom = layout.top + cell_height * static_cast<double>(map.rows.size());
  return layout;
}

void draw_names(SvgCanvas& canvas, const HeatMap& map, const Layout& layout) {
  const bool turned = longest(map.columns) > layout.cell_width - 4;
  for (std::size_t c = 0; c < map.columns.size(); ++c) {
    const double x = layout.left + layout.cell_width * (static_cast<double>(c) + 0.5);
    if (turned)
      canvas.text(x + 4, layout.top - 6, fitted(map.columns[c], 130, text_size),
                  {.size = text_size, .upwards = true});
    else
      canvas.text(x, layout.top - 6, map.columns[c], {.anchor = Anchor::Middle, .size = text_size});
  }
  for (std::size_t r = 0; r < map.rows.size(); ++r)
    canvas.text(layout.left - 8, layout.top + cell_height * (static_cast<double>(r) + 0.5) + 4,
                fitted(map.rows[r], 170, text_size), {.anchor = Anchor::End, .size = text_size});
  canvas.text((layout.left + layout.right) / 2, margin + heat_map_title_size + 20, map.column_title,
              {.anchor = Anchor::Middle, .colour = muted_colour, .size = text_size});
  canvas.text(margin + 10, (layout.top + layout.bottom) / 2, map.row_title,
              {.anchor = Anchor::Middle, .colour = muted_colour, .size = text_size, .upwards = true});
}

double fraction_of(const HeatMap& map, double value) {
  return map.high > map.low ? std::clamp((value - map.low) / (map.high - map.low), 0.0, 1.0) : 0.5;
}

void draw_cell(SvgCanvas& canvas, const HeatMap& map, const HeatCell& cell, double x, double y,
               double width) {
  std::string style = "fill:none";
  std::string text_colour(muted_colour);
  if (cell.value && std::isfinite(*cell.value)) {
    const double fraction = fraction_of(map, *cell.value);
    if (map.colours == HeatMap::Colours::Viridis) {
      style = "fill:" + viridis(fraction);
      text_colour = is_light(viridis_rgb(fraction)) ? "#111" : "#fff";
    } else {
      style = fmt::format("fill:{};fill-opacity:{:.3f}", series_colour(0), 0.9 * fraction);
      text_colour = fraction > 0.55 ? "var(--page,#fff)" : fraction > 0 ? ink_colour : muted_colour;
    }
  }
  canvas.rectangle(x, y, width, cell_height, style + ";stroke:var(--grid,#ddd)", cell.tooltip);
  canvas.text(x + width / 2, y + cell_height / 2 + 4, cell.text,
              {.anchor = Anchor::Middle, .colour = text_colour, .size = text_size});
}

void draw_scale(SvgCanvas& canvas, const HeatMap& map, const Layout& layout) {
  constexpr int steps = 48;
  constexpr double width = 4 * steps;
  const double y = layout.bottom + 14;
  for (int s = 0; s < steps; ++s) {
    const double fraction = (s + 0.5) / steps;
    const std::string fill =
        map.colours == HeatMap::Colours::Viridis
            ? "fill:" + viridis(fraction)
            : fmt::format("fill:{};fill-opacity:{:.3f}", series_colour(0), 0.9 * fraction);
    canvas.rectangle(layout.left + width * s / steps, y, width / steps, 10,
                     fill + ";shape-rendering:crispEdges");
  }
  canvas.text(layout.left, y + 24, plain_number(map.low), {.colour = muted_colour, .size = text_size});
  canvas.text(layout.left + width, y + 24, plain_number(map.high),
              {.anchor = Anchor::End, .colour = muted_colour, .size = text_size});
  canvas.text(layout.left + width / 2, y + 40, map.value_title,
              {.anchor = Anchor::Middle, .size = text_size});
}

}  // namespace

std::string viridis(double fraction) {
  const Rgb colour = viridis_rgb(fraction);
  return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

std::string svg_heat_map(const HeatMap& map) {
  if (map.rows.empty() || map.columns.empty()) return {};
  const Layout layout = lay_out(map);
  const double width =
      std::max({layout.right + margin, 2 * margin + text_width(map.title, heat_map_title_size),
                map.value_title.empty() ? 0.0 : layout.left + 260});
  SvgCanvas canvas(width, layout.bottom + (map.value_title.empty() ? margin : 60), map.title);
  canvas.text(margin, margin + heat_map_title_size, map.title, {.size = heat_map_title_size, .bold = true});
  draw_names(canvas, map, layout);
  for (std::size_t r = 0; r < map.cells.size(); ++r)
    for (std::size_t c = 0; c < map.cells[r].size(); ++c)
      draw_cell(canvas, map, map.cells[r][c], layout.left + layout.cell_width * static_cast<double>(c),
                layout.top + cell_height * static_cast<double>(r), layout.cell_width);
  if (map.marked)
    canvas.rectangle(layout.left + layout.cell_width * map.marked->second + 1.5,
                     layout.top + cell_height * map.marked->first + 1.5, layout.cell_width - 3,
                     cell_height - 3, "fill:none;stroke:#d55e00;stroke-width:3;pointer-events:none");
  if (!map.value_title.empty()) draw_scale(canvas, map, layout);
  return canvas.finish();
}

}  // namespace abrazo
