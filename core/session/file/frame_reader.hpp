#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "core/session/file/session_database.hpp"
#include "core/session/file/session_file.hpp"

namespace abrazo {

/// Reads frames over an open database, with the settings and decisions they were solved under. Indices and
/// times are those of the file. Used by one thread at a time.
class FrameReader {
 public:
  static Result<std::unique_ptr<FrameReader>> open(SessionDatabase& database);

  struct Read {
    std::shared_ptr<FrameSnapshot> frame;
    std::optional<std::int64_t> library;  ///< id
  };
  /// Nothing when there is none of this index. An error when it is damaged.
  Result<std::optional<Read>> frame(std::int64_t index);
  /// All in [first, last], in order.
  Result<RowsRead> scan(std::int64_t first, std::int64_t last, const std::function<Status(Read&)>& visit);

  /// Index of the last frame not after a time, of the first not before one, of the first not before an index,
  /// and of the last frame of all; nothing when there is none.
  Result<std::optional<std::int64_t>> last_until(double time_s, std::int64_t from);
  Result<std::optional<std::int64_t>> first_from(double time_s, std::int64_t from);
  Result<std::optional<std::int64_t>> next(std::int64_t index);
  Result<std::optional<std::int64_t>> last();
  Result<std::optional<std::int64_t>> state_before(std::int64_t index, std::int64_t from);
  Result<std::optional<double>> time_of(std::int64_t index);

 private:
  struct Statements;
  explicit FrameReader(Statements statements);
  Result<Read> decode(const SessionStatement& row);
  Result<std::optional<std::int64_t>> first_column(SessionStatement& statement);
  Status add_settings(FrameSnapshot& frame);
  Status add_decisions(FrameSnapshot& frame);

  std::unique_ptr<Statements> statements_;
  /// Read last, by the frame from which on they are in force.
  std::map<std::int64_t, Settings> settings_;
  std::map<std::int64_t, std::shared_ptr<const Decisions>> decisions_;

 public:
  ~FrameReader();
};

}  // namespace abrazo
