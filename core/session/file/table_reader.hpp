#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/session/file/session_database.hpp"

namespace abrazo {

/// Reads the valid rows of a project's tables; counts and reports the others.
class TableReader {
 public:
  explicit TableReader(SessionDatabase& database) : database_(database) {}

  /// Visits rows in order of their id, which is column 0 and not in `columns`. A row for which `take` returns
  /// an Error counts as damaged.
  /// @param what name for messages: "annotations"
  void each(const std::string& what, const std::string& table, const std::string& columns,
            const std::function<Status(const SessionStatement&)>& take);

  std::uint64_t damaged() const { return damaged_; }
  const std::vector<std::string>& damage() const { return damage_; }

 private:
  void say(const std::string& what, std::uint64_t rows, const std::string& why);

  SessionDatabase& database_;
  std::uint64_t damaged_ = 0;
  std::vector<std::string> damage_;
};

/// Checks that double columns have numbers: SQLite stores NaN as NULL.
Status finite(const SessionStatement& row, std::initializer_list<int> columns, const std::string& of);

}  // namespace abrazo
