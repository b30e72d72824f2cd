#include "core/evaluation/plots/svg_canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/xml_text.hpp"

namespace abrazo {

namespace {

constexpr double mean_glyph_width = 0.6;  ///< of the size, sans serif

// Okabe and Ito (2008), yellow last: it is faint on white.
constexpr std::array<std::string_view, 7> okabe_ito = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                       "#e69f00", "#56b4e9", "#f0e442"};

std::string_view anchor_name(SvgCanvas::Anchor anchor) {
  switch (anchor) {
    case SvgCanvas::Anchor::Middle:
      return "middle";
    case SvgCanvas::Anchor::End:
      return "end";
    case SvgCanvas::Anchor::Start:
      break;
  }
  return "start";
}

std::string title_element(std::string_view tooltip) {
  return tooltip.empty() ? std::string() : "<title>" + xml_text(tooltip) + "</title>";
}

bool starts_glyph(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

}  // namespace

SvgCanvas::SvgCanvas(double width, double height, std::string_view title)
    : head_(fmt::format("<svg class=\"plot\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" "
                        "width=\"{0}\" height=\"{1}\" role=\"img\" aria-label=\"{2}\">",
                        coordinate(width), coordinate(height), xml_text(title))) {}

void SvgCanvas::text(double x, double y, std::string_view content, const TextStyle& style) {
  body_ += fmt::format(
      "<text x=\"{0}\" y=\"{1}\" text-anchor=\"{2}\" style=\"fill:{3};font-size:{4}px{5}\"{6}>{7}</text>",
      coordinate(x), coordinate(y), anchor_name(style.anchor), style.colour, coordinate(style.size),
      style.bold ? ";font-weight:600" : "",
      style.upwards ? fmt::format(" transform=\"rotate(-90 {} {})\"", coordinate(x), coordinate(y)) : "",
      xml_text(content));
}

void SvgCanvas::line(double x1, double y1, double x2, double y2, std::string_view colour, double width,
                     std::string_view dashes) {
  body_ +=
      fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" style=\"stroke:{};stroke-width:{}{}\"/>",
                  coordinate(x1), coordinate(y1), coordinate(x2), coordinate(y2), colour, coordinate(width),
                  dashes.empty() ? std::string() : fmt::format(";stroke-dasharray:{}", dashes));
}

void SvgCanvas::rectangle(double x, double y, double width, double height, std::string_view style,
                          std::string_view tooltip) {
  body_ +=
      fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" style=\"{}\">{}</rect>", coordinate(x),
                  coordinate(y), coordinate(width), coordinate(height), style, title_element(tooltip));
}

void SvgCanvas::polyline(const std::string& points, std::string_view colour, std::string_view dashes) {
  body_ += fmt::format("<polyline points=\"{}\" style=\"fill:none;stroke:{};stroke-width:2{}\"/>", points,
                       colour, dashes.empty() ? std::string() : fmt::format(";stroke-dasharray:{}", dashes));
}

void SvgCanvas::marker(double x, double y, int shape, std::string_view colour, std::string_view tooltip) {
  static constexpr std::array<std::string_view, 4> outlines = {
      "a3.6,3.6 0 1,0 7.2,0 a3.6,3.6 0 1,0 -7.2,0", "v-3.3 h6.6 v6.6 h-6.6 z", "m0,3.2 l4,-7.2 l4,7.2 z",
      "l4.4,-4.4 l4.4,4.4 l-4.4,4.4 z"};
  static constexpr std::array<double, 4> half_widths = {3.6, 3.3, 4, 4.4};
  const std::size_t kind = static_cast<std::size_t>(shape) % outlines.size();
  body_ += fmt::format("<path d=\"M{},{} {}\" style=\"fill:{};stroke:var(--page,#fff)\">{}</path>",
                       coordinate(x - half_widths[kind]), coordinate(y), outlines[kind], colour,
                       title_element(tooltip));
}

std::string SvgCanvas::finish() const {
  return head_ + body_ + "</svg>";
}

std::string series_colour(int n) {
  const std::size_t index = static_cast<std::size_t>(n) % okabe_ito.size();
  return fmt::format("var(--series-{},{})", index + 1, okabe_ito[index]);
}

double text_width(std::string_view text, double size) {
  return mean_glyph_width * size * static_cast<double>(std::count_if(text.begin(), text.end(), starts_glyph));
}

std::string fitted(std::string_view text, double width, double size) {
  if (text_width(text, size) <= width) return std::string(text);
  std::size_t end = text.size();
  const auto shortened = [&] { return std::string(text.substr(0, end)) + "\u2026"; };
  while (end > 0 && text_width(shortened(), size) > width) {
    --end;
    while (end > 0 && !starts_glyph(text[end])) --end;
  }
  return shortened();
}

std::string coordinate(double value) {
  std::string digits = fmt::format("{:.2f}", value);
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits == "-0" ? "0" : digits;
}

}  // namespace abrazo
