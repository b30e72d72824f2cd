#include "core/evaluation/plots/svg_frame.hpp"

#include <limits>

#include "core/evaluation/plots/html_text.hpp"

namespace abrazo {

namespace {

using Anchor = SvgCanvas::Anchor;

constexpr double title_size = 13, legend_row = 19;

}  // namespace

std::string series_colour(int own_index, bool reference) {
  return reference ? std::string(reference_colour) : series_colour(own_index);
}

double draw_head(SvgCanvas& canvas, const std::string& title, const std::vector<LegendEntry>& legend) {
  double y = plot_margin + title_size;
  canvas.text(plot_margin, y, title, {.size = title_size, .bold = true});
  y += 8;
  double x = plot_margin;
  bool row_open = false;
  for (const LegendEntry& entry : legend) {
    const double width = 34 + text_width(entry.name, plot_text_size);
    if (!row_open || x + width > plot_width)
      x = plot_margin, y += row_open ? legend_row : 14, row_open = true;
    if (entry.shape < 0 && !entry.dashed) {
      canvas.rectangle(x + 6, y - 9, 11, 11, "fill:" + entry.colour);
    } else {
      canvas.line(x, y - 4, x + 22, y - 4, entry.colour, 2, entry.dashed ? reference_dashes : "");
      if (entry.shape >= 0) canvas.marker(x + 11, y - 4, entry.shape, entry.colour, "");
    }
    canvas.text(x + 27, y, entry.name, {.colour = muted_colour, .size = plot_text_size});
    x += width + 10;
  }
  return y + 14;
}

void draw_vertical_axis(SvgCanvas& canvas, const PlotArea& area, const AxisScale& scale,
                        const std::string& title) {
  for (const double tick : scale.ticks()) {
    const double y = scale.at(tick);
    canvas.line(area.left, y, area.right, y, grid_colour);
    canvas.text(area.left - 6, y + 4, plain_number(tick),
                {.anchor = Anchor::End, .colour = muted_colour, .size = plot_text_size});
  }
  canvas.text(plot_margin + 10, (area.top + area.bottom) / 2, title,
              {.anchor = Anchor::Middle, .size = plot_text_size, .upwards = true});
}

void draw_horizontal_axis(SvgCanvas& canvas, const PlotArea& area, const AxisScale& scale,
                          const std::string& title, bool grid) {
  double free_from = -std::numeric_limits<double>::infinity();
  for (const double tick : scale.ticks()) {
    const double x = scale.at(tick);
    const std::string text = plain_number(tick);
    const double half = text_width(text, plot_text_size) / 2;
    if (grid) canvas.line(x, area.top, x, area.bottom, grid_colour);
    canvas.line(x, area.bottom, x, area.bottom + 4, muted_colour);
    if (x - half < free_from) continue;  // no room for this number
    free_from = x + half + 4;
    canvas.text(x, area.bottom + 17, text,
                {.anchor = Anchor::Middle, .colour = muted_colour, .size = plot_text_size});
  }
  canvas.text((area.left + area.right) / 2, area.bottom + 36, title,
              {.anchor = Anchor::Middle, .size = plot_text_size});
}

}  // namespace abrazo
