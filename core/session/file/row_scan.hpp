#pragma once

#include <cstdint>
#include <functional>

#include "core/session/file/session_database.hpp"
#include "core/session/file/session_file.hpp"

namespace abrazo {

/// Result of one row: taken, damaged, or stop.
struct RowOutcome {
  std::int64_t id = 0;
  bool damaged = false;
  Status status = Done{};  ///< why it is damaged, or why to stop
};

/// Reads rows in order of their id and continues after damaged ones.
/// @param rows   "SELECT ... WHERE id BETWEEN ? AND ? ORDER BY id"
/// @param taken  called on every row; must set the id
/// @return an Error if `taken` stops, or the file cannot be read at all
Result<RowsRead> scan_rows(SessionStatement& rows, std::int64_t first, std::int64_t last,
                           const std::function<RowOutcome(const SessionStatement&)>& taken);

}  // namespace abrazo
