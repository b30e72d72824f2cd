#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/session/file/session_database.hpp"
#include "core/session/file/session_file.hpp"

namespace abrazo {

/// Reads frames from an open database, with the settings and decisions under which they were solved. Indices
/// and times are those of the file. Used by one thread at a time.
class FrameReader {
 public:
  static Result<std::unique_ptr<FrameReader>> open(SessionDatabase& database);

  struct Read {
    std::shared_ptr<FrameSnapshot> frame;
    std::optional<std::int64_t> library;  ///< id
  };
  /// None if there is no frame of this index. An Error if it is damaged.
  Result<std::optional<Read>> frame(std::int64_t index);
  /// Visits all frames in [first, last], in order.
  Result<RowsRead> scan(std::int64_t first, std::int64_t last, const std::function<Status(Read&)>& visit);

  /// Index of the last frame not after a time, of the first not before a time, of the first not before an
  /// index, and of the last frame; none if there is no such frame.
  Result<std::optional<std::int64_t>> last_until(double time_s, std::int64_t from);
  Result<std::optional<std::int64_t>> first_from(double time_s, std::int64_t from);
  Result<std::optional<std::int64_t>> next(std::int64_t index);
  Result<std::optional<std::int64_t>> last();
  Result<std::optional<std::int64_t>> state_before(std::int64_t index, std::int64_t from);
  Result<std::optional<double>> time_of(std::int64_t index);
  /// Of all frames in [from_s, to_s] not before an index, ascending, whether they can be read or not.
  Result<std::vector<double>> times(double from_s, double to_s, std::int64_t from);

 private:
  struct Statements;
  explicit FrameReader(Statements statements);
  Result<Read> decode(const SessionStatement& row);
  Result<std::optional<std::int64_t>> first_column(SessionStatement& statement);
  static Result<std::string> text_of(SessionStatement& statement, std::int64_t frame);
  Status add_settings(FrameSnapshot& frame);
  Status add_decisions(FrameSnapshot& frame);

  std::unique_ptr<Statements> statements_;
  /// Cache of those read last, by the first frame they apply to; also of those that cannot be read.
  std::map<std::int64_t, Result<Settings>> settings_;
  std::map<std::int64_t, Result<std::shared_ptr<const Decisions>>> decisions_;

 public:
  ~FrameReader();
};

}  // namespace abrazo
