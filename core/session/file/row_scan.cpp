#include "core/session/file/row_scan.hpp"

#include <algorithm>

namespace abrazo {

namespace {

/// Farther behind a damaged place nothing is looked for: an hour at 120 Hz and more.
constexpr std::int64_t longest_gap = std::int64_t{1} << 22;

bool is_readable(SessionStatement& rows, std::int64_t from, std::int64_t last) {
  rows.reset();
  const bool readable = rows.bind(0, from).bind(1, last).step().ok();
  rows.reset();
  return readable;
}

/// The first readable id after a damaged place; beyond `last` if there is none.
std::int64_t behind_damage(SessionStatement& rows, std::int64_t damaged, std::int64_t last) {
  std::int64_t bad = damaged, step = 1;
  while (bad + step <= last && step <= longest_gap && !is_readable(rows, bad + step, last)) {
    bad += step;
    step *= 2;
  }
  std::int64_t good = std::min(bad + step, last);
  if (!is_readable(rows, good, last)) return last + 1;
  while (good - bad > 1) {
    const std::int64_t middle = bad + (good - bad) / 2;
    (is_readable(rows, middle, last) ? good : bad) = middle;
  }
  return good;
}

}  // namespace

Result<RowsRead> scan_rows(SessionStatement& rows, std::int64_t first, std::int64_t last,
                           const std::function<RowOutcome(const SessionStatement&)>& taken) {
  RowsRead read;
  const auto damage = [&](std::uint64_t count, const Error& why) {
    read.damaged += count;
    if (read.damage.empty()) read.damage = why.message;
  };
  rows.reset();
  rows.bind(0, first).bind(1, last);
  for (std::int64_t next = first; next <= last;) {
    const auto row = rows.step();
    if (!row) {
      if (rows.fault() != DatabaseFault::Damaged) return row.error();
      const std::int64_t good = behind_damage(rows, next, last);
      damage(good > last ? 1 : static_cast<std::uint64_t>(good - next), row.error());
      next = good;
      rows.reset();
      rows.bind(0, next).bind(1, last);
      continue;
    }
    if (!*row) break;
    const RowOutcome outcome = taken(rows);
    if (outcome.damaged) {
      damage(1, outcome.status.error());
    } else if (!outcome.status) {
      rows.reset();
      return outcome.status.error();
    } else {
      ++read.read;
    }
    // Rows of a damaged tree may come in any order; going back would never end.
    if (outcome.id < next) {
      damage(1, Error{"the order of the rows is damaged", {}});
      rows.reset();
      rows.bind(0, ++next).bind(1, last);
    } else {
      next = outcome.id + 1;
    }
  }
  rows.reset();
  return read;
}

}  // namespace abrazo
