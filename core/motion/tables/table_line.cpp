#include "core/motion/tables/table_line.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "core/base/text.hpp"

namespace abrazo {

namespace {

constexpr std::string_view separators = ",;\t";

std::string_view without_quotes(std::string_view field) {
  return field.size() > 1 && field.front() == '"' && field.back() == '"'
             ? trimmed(field.substr(1, field.size() - 2))
             : field;
}

}  // namespace

char table_separator(std::string_view line, char usual) {
  std::array<std::ptrdiff_t, separators.size()> counts{};
  bool is_quoted = false;
  for (const char c : line) {
    if (c == '"') is_quoted = !is_quoted;
    if (const std::size_t which = separators.find(c); !is_quoted && which != std::string_view::npos)
      ++counts[which];
  }
  const std::ptrdiff_t most = *std::ranges::max_element(counts);
  if (counts[separators.find(usual)] == most) return usual;
  return separators[static_cast<std::size_t>(std::ranges::find(counts, most) - counts.begin())];
}

TableSeparator separator_of_table(std::string_view text, char usual) {
  constexpr std::string_view said = "sep=";
  const std::size_t first_end = std::min(text.find_first_of("\r\n"), text.size());
  if (text.starts_with(said) && first_end == said.size() + 1) {
    std::size_t behind = std::min(first_end + 1, text.size());
    if (text.substr(first_end).starts_with("\r\n")) ++behind;
    return {text[said.size()], behind};
  }
  const std::size_t begin = text.find_first_not_of("\r\n");
  if (begin == std::string_view::npos) return {usual, 0};
  std::size_t end = begin;  // line ends in quotes are text
  for (bool is_quoted = false; end < text.size() && (is_quoted || (text[end] != '\n' && text[end] != '\r'));
       ++end)
    if (text[end] == '"') is_quoted = !is_quoted;
  return {table_separator(text.substr(begin, end - begin), usual), 0};
}

std::vector<std::string_view> table_fields(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  if (line.find('"') == std::string_view::npos) return split_fields(line, separator);
  bool is_quoted = false;
  std::size_t from = 0;
  for (std::size_t at = 0; at <= line.size(); ++at) {
    if (at < line.size() && line[at] == '"') is_quoted = !is_quoted;
    if (at < line.size() && (is_quoted || line[at] != separator)) continue;
    fields.push_back(without_quotes(trimmed(line.substr(from, at - from))));
    from = at + 1;
  }
  return fields;
}

std::optional<double> table_number(std::string_view field) {
  field = without_quotes(field);
  const std::size_t comma = field.find(',');
  if (comma == std::string_view::npos) return parse_number(field);
  std::string with_point(field.substr(0, 64));
  std::ranges::replace(with_point, ',', '.');
  return parse_number(with_point);
}

}  // namespace abrazo
