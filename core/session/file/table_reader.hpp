#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/session/file/session_database.hpp"

namespace abrazo {

/// Reads the rows of a project's tables that can be read, and counts and says which could not.
class TableReader {
 public:
  explicit TableReader(SessionDatabase& database) : database_(database) {}

  /// In order of their id, which is column 0 and not among `columns`. A row that `take` gives an error for is
  /// damaged.
  /// @param what  "annotations", for the sentence
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

/// A number that a double column must have: what SQLite gives as NULL was not a number.
Status finite(const SessionStatement& row, std::initializer_list<int> columns, const std::string& of);

}  // namespace abrazo
