#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo {

/// A line of a table. A field in quotes may hold separators, line ends and doubled quotes (RFC 4180).
struct CsvRow {
  std::size_t line = 0;             ///< where it begins, from 1
  std::vector<std::string> fields;  ///< trimmed if unquoted
};

/// Rows of a table separated by commas, semicolons (then numbers may have a decimal comma) or tabs, as its
/// first line tells. Empty rows are skipped.
/// @param where name for messages
/// @return an Error with the line for unterminated quotes, and for more than 64 fields
Result<std::vector<CsvRow>> parse_csv(std::string_view text, std::string_view where);

/// A text as a field of a file: quoted if necessary, and behind an apostrophe, which `parse_csv` takes away,
/// if a spreadsheet would run it as a formula (=, +, -, @).
std::string csv_field(std::string_view text);

}  // namespace abrazo
