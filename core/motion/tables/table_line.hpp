#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace abrazo {

/// The most frequent separator of a line outside quotes: comma, semicolon or tab; `usual` if there is a tie.
char table_separator(std::string_view line, char usual);

/// Separator of a whole table.
struct TableSeparator {
  char separator = ',';
  std::size_t stated_length = 0;  ///< of a first line that states it ("sep=;", of Excel), with its end
};
/// As the first line states it, else the most frequent one of the first row, whose quotes may hold line ends.
TableSeparator separator_of_table(std::string_view text, char usual);

/// The fields of a line, trimmed and without the quotes around them, in which separators are text.
std::vector<std::string_view> table_fields(std::string_view line, char separator);

/// A number whose decimal point may be a comma, "0,5".
std::optional<double> table_number(std::string_view field);

}  // namespace abrazo
