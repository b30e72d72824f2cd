#include "core/evaluation/report/html_page.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "core/base/version.hpp"
#include "core/base/xml_text.hpp"
#include "core/evaluation/report/html_style.hpp"

namespace abrazo {

namespace {

std::string element(std::string_view tag, std::string_view css_class, const std::string& inner_html) {
  std::string open(tag);
  if (!css_class.empty()) open += " class=\"" + std::string(css_class) + "\"";
  return "<" + open + ">" + inner_html + "</" + std::string(tag) + ">";
}

/// Escaped, with the subscripts of the symbols that our own sentences use.
std::string with_symbols(std::string_view text) {
  static constexpr std::array<std::array<std::string_view, 2>, 9> symbols = {
      {{"M_A", "M<sub>A</sub>"},
       {"M_B", "M<sub>B</sub>"},
       {"w_\u0394", "w<sub>\u0394</sub>"},
       {"x_zmp", "x<sub>zmp</sub>"},
       {"a_ix ", "a<sub>ix</sub> "},
       {"a_iy ", "a<sub>iy</sub> "},
       {" m_i ", " m<sub>i</sub> "},
       {" x_i ", " x<sub>i</sub> "},
       {" y_i]", " y<sub>i</sub>]"}}};
  std::string html = xml_text(text);
  for (const auto& [plain, marked] : symbols)
    for (std::size_t at = html.find(plain); at != std::string::npos;
         at = html.find(plain, at + marked.size()))
      html.replace(at, plain.size(), marked);
  return html;
}

std::string_view css_class(HtmlTable::Row kind) {
  switch (kind) {
    case HtmlTable::Row::Paper:
      return "paper";
    case HtmlTable::Row::Baseline:
      return "baseline";
    case HtmlTable::Row::Own:
      break;
  }
  return "";
}

}  // namespace

HtmlTable::HtmlTable(std::string caption, std::vector<std::string> columns)
    : caption_(std::move(caption)), columns_(std::move(columns)) {}

HtmlTable& HtmlTable::row(const std::vector<std::string>& cells, Row kind) {
  if (cells.size() != columns_.size())
    throw std::invalid_argument("a row has " + std::to_string(cells.size()) + " cells, the table " +
                                std::to_string(columns_.size()) + " columns");
  longest_name_ = std::max(longest_name_, cells.front().size());
  std::string inner = "<th scope=\"row\">" + xml_text(cells.front()) + "</th>";
  for (std::size_t c = 1; c < cells.size(); ++c) inner += element("td", "", xml_text(cells[c]));
  rows_html_ += element("tr", css_class(kind), inner) + "\n";
  return *this;
}

std::string HtmlTable::html() const {
  std::string head;
  for (const std::string& column : columns_) head += "<th scope=\"col\">" + with_symbols(column) + "</th>";
  const std::string css_class = longest_name_ > 14 ? " class=\"long-names\"" : "";
  return element("p", "caption", with_symbols(caption_)) + "\n<div class=\"table\"><table" + css_class +
         " aria-label=\"" + xml_text(caption_) + "\"><thead><tr>" + head + "</tr></thead>\n<tbody>\n" +
         rows_html_ + "</tbody></table></div>\n";
}

std::string html_tiles(const std::vector<HtmlTile>& tiles) {
  if (tiles.empty()) return {};
  std::string inner;
  for (const HtmlTile& tile : tiles)
    inner +=
        element("div", "tile",
                element("div", "name", xml_text(tile.name)) + element("div", "value", xml_text(tile.value)) +
                    element("div", "comparison", xml_text(tile.comparison))) +
        "\n";
  return element("div", "tiles", inner) + "\n";
}

std::string html_finding(std::string_view text) {
  return element("p", "finding", with_symbols(text)) + "\n";
}

std::string html_definitions(const std::vector<std::string>& texts) {
  std::string inner;
  for (const std::string& text : texts) inner += element("p", "", with_symbols(text)) + "\n";
  return element("div", "definitions", "<h3>How it is measured</h3>\n" + inner) + "\n";
}

std::string html_notes(std::string_view title, const std::vector<std::string>& texts) {
  if (texts.empty()) return {};
  std::string items;
  for (const std::string& text : texts) items += element("li", "", with_symbols(text)) + "\n";
  return element("div", "notes", element("h3", "", xml_text(title)) + element("ul", "", items)) + "\n";
}

std::string html_code(std::string_view text) {
  return element("p", "", element("code", "", xml_text(text))) + "\n";
}

std::string html_figures(const std::vector<std::string>& svgs) {
  std::string inner;
  for (const std::string& svg : svgs)
    if (!svg.empty()) inner += element("figure", "", svg) + "\n";
  return inner.empty() ? std::string() : element("div", "figures", inner) + "\n";
}

std::string html_side_by_side(const std::vector<std::string>& parts_html) {
  std::string inner;
  for (const std::string& part : parts_html)
    if (!part.empty()) inner += element("div", "", part) + "\n";
  return element("div", "side-by-side", inner) + "\n";
}

std::string html_page(const HtmlPage& page) {
  std::string contents, body;
  for (const HtmlSection& section : page.sections) {
    contents += "<a href=\"#" + section.id + "\">" + xml_text(section.short_title) + "</a>\n";
    body += "<section id=\"" + section.id + "\">\n" + element("h2", "", xml_text(section.title)) + "\n" +
            section.content_html + "</section>\n";
  }
  return "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n"
         "<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, "
         "initial-scale=1\"/>\n" +
         element("title", "", xml_text(page.title)) + "\n<style>" + html_style_sheet +
         "</style>\n</head>\n<body>\n<main>\n<header>\n" + element("h1", "", xml_text(page.title)) + "\n" +
         element("p", "subtitle", xml_text(page.subtitle)) + "\n" + page.head_html +
         element("nav", "", contents) + "\n</header>\n" + body + "<footer>Written by Abrazo " + version() +
         ".</footer>\n</main>\n</body>\n</html>\n";
}

}  // namespace abrazo
