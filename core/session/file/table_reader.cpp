#include "core/session/file/table_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/session/file/row_scan.hpp"

namespace abrazo {

namespace {

/// Most rows of a table; more than a person draws in a lifetime, so a file with more is damaged or hostile.
constexpr std::int64_t most_rows = 10'000'000;

}  // namespace

void TableReader::each(const std::string& what, const std::string& table, const std::string& columns,
                       const std::function<Status(const SessionStatement&)>& take) {
  auto rows =
      database_.prepare("SELECT id, " + columns + " FROM " + table + " WHERE id BETWEEN ? AND ? ORDER BY id");
  if (!rows) return say(what, 0, rows.error().message);
  std::int64_t seen = 0;
  const auto taken = [&](const SessionStatement& row) {
    RowOutcome outcome;
    outcome.id = row.integer(0);
    if (++seen > most_rows) {
      outcome.status = Error{"there are more than " + std::to_string(most_rows), {}};
      return outcome;
    }
    outcome.status = take(row);
    outcome.damaged = !outcome.status;
    return outcome;
  };
  const auto read = scan_rows(*rows, 1, std::numeric_limits<std::int64_t>::max() - 1, taken);
  if (!read) return say(what, 0, read.error().message);
  if (read->damaged > 0) say(what, read->damaged, read->damage);
}

void TableReader::say(const std::string& what, std::uint64_t rows, const std::string& why) {
  damaged_ += std::max<std::uint64_t>(rows, 1);
  damage_.push_back((rows > 0 ? std::to_string(rows) + " of its " + what + " could not be read: "
                              : "not all of its " + what + " can be read: ") +
                    why);
}

Status finite(const SessionStatement& row, std::initializer_list<int> columns, const std::string& of) {
  for (const int column : columns)
    if (row.is_null(column) || !std::isfinite(row.real(column)))
      return Error{of + " has something that is not a number", {}};
  return Done{};
}

}  // namespace abrazo
