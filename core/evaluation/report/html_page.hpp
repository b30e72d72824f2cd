#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace abrazo {

// Pieces of a page, as XHTML. Every text given is plain and escaped here, except where `html` is in the name.

/// A table whose first column names its rows.
class HtmlTable {
 public:
  enum class Row {
    Own,
    Paper,    ///< figures printed in the paper
    Baseline  ///< for comparison
  };
  HtmlTable(std::string caption, std::vector<std::string> columns);
  HtmlTable& row(const std::vector<std::string>& cells, Row kind = Row::Own);
  std::string html() const;

 private:
  std::string caption_;
  std::vector<std::string> columns_;
  std::string rows_html_;
  std::size_t longest_name_ = 0;
};

/// A key figure with its reference value.
struct HtmlTile {
  std::string name, value, comparison;
};

std::string html_tiles(const std::vector<HtmlTile>& tiles);

/// Sentences with the findings.
std::string html_finding(std::string_view text);

/// How a figure is defined: smaller, after the figures. One paragraph for each text.
std::string html_definitions(const std::vector<std::string>& texts);

/// Observations in comparison with the paper, one per text; empty if there are none.
std::string html_notes(std::string_view title, const std::vector<std::string>& texts);

/// A line to copy, unchanged.
std::string html_code(std::string_view text);

/// Plots side by side where there is room. Empty ones are left out.
std::string html_figures(const std::vector<std::string>& svgs);

/// Parts side by side if there is room, otherwise one below the other.
std::string html_side_by_side(const std::vector<std::string>& parts_html);

struct HtmlSection {
  std::string id, title, short_title, content_html;
};

struct HtmlPage {
  std::string title, subtitle;
  std::string head_html;  ///< below the title
  std::vector<HtmlSection> sections;
};

/// The whole page: style sheet inside, nothing loaded from anywhere.
std::string html_page(const HtmlPage& page);

}  // namespace abrazo
