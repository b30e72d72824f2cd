#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo {

/// Kinds of errors that callers distinguish.
enum class DatabaseFault { Other, Full, Busy, Damaged, NotADatabase, CannotWrite };

/// What the file system of a file's folder can do; network drives may lack either.
struct FolderAbilities {
  bool locks = false;          ///< of files, against two writers
  bool shares_memory = false;  ///< a mapping of a file for several programs, which SQLite's log needs
};
/// Tried with a file that is made in the folder and removed. None if none can be made.
std::optional<FolderAbilities> abilities_of_folder_with(const std::string& path);

/// The write-ahead log beside a session file.
inline std::string log_of_session(const std::string& path) {
  return path + "-wal";
}

/// A prepared statement. Parameters and columns count from 0. Used by one thread at a time, and not longer
/// than its database.
class SessionStatement {
 public:
  SessionStatement(SessionStatement&&) noexcept;
  SessionStatement& operator=(SessionStatement&&) noexcept;
  ~SessionStatement();

  SessionStatement& bind(int parameter, double value);
  SessionStatement& bind(int parameter, std::int64_t value);
  SessionStatement& bind(int parameter, std::uint64_t value) {
    return bind(parameter, static_cast<std::int64_t>(value));
  }
  SessionStatement& bind(int parameter, int value) { return bind(parameter, std::int64_t{value}); }
  SessionStatement& bind(int parameter, bool value) { return bind(parameter, std::int64_t{value}); }
  SessionStatement& bind(int parameter, std::string_view text);
  SessionStatement& bind(int parameter, const char* text) { return bind(parameter, std::string_view(text)); }
  /// The bytes must live until the next `reset` or `run`.
  SessionStatement& bind(int parameter, std::span<const std::uint8_t> blob);
  SessionStatement& bind_null(int parameter);

  /// @return whether there is a row
  Result<bool> step();
  /// Executes a statement without rows and resets it for the next parameters.
  Status run();
  /// Ends the read transaction that `step` began; parameters stay.
  void reset();
  DatabaseFault fault() const { return fault_; }  ///< of the last step that failed

  bool is_null(int column) const;
  double real(int column) const;
  std::int64_t integer(int column) const;
  std::string text(int column) const;
  /// Valid until the next step or reset.
  std::span<const std::uint8_t> blob(int column) const;

 private:
  friend class SessionDatabase;
  struct Handle;
  explicit SessionStatement(std::unique_ptr<Handle> handle);
  std::unique_ptr<Handle> handle_;
  DatabaseFault fault_ = DatabaseFault::Other;
};

/// An SQLite database on disk: the only place that knows SQLite. Errors name the file and what to do. Used by
/// one thread at a time.
class SessionDatabase {
 public:
  enum class Access {
    Read,     ///< recovers the log of a crash if the folder is writable; otherwise only reads
    Frozen,   ///< reads the file alone, for read-only folders. No process may write it
    Salvage,  ///< reads what is readable of a damaged file; changes nothing
    Write,    ///< must exist
    Create    ///< created if missing
  };
  static Result<SessionDatabase> open(const std::string& path, Access access);
  SessionDatabase(SessionDatabase&&) noexcept;
  SessionDatabase& operator=(SessionDatabase&&) noexcept;
  ~SessionDatabase();

  const std::string& path() const;
  bool is_salvage() const;  ///< opened with Salvage
  /// Whether the log that the file had was not beside it when it was opened: it was copied alone.
  bool lacks_log() const;
  /// Statements without parameters or rows, separated by ";".
  Status execute(const std::string& sql);
  Result<SessionStatement> prepare(std::string_view sql);
  /// First column of the first row; none if there is no row.
  Result<std::optional<std::int64_t>> integer(std::string_view sql);
  Result<std::optional<std::string>> text(std::string_view sql);

  DatabaseFault fault() const { return fault_; }  ///< of the last call that failed
  std::int64_t last_row_id() const;
  /// How long to wait for another writer [ms].
  void set_patience(int milliseconds);
  /// Whether another program holds the file for writing.
  bool is_held_elsewhere();
  /// Copies everything committed into a new or empty file, which after an Error is not whole.
  Status copy_into(const std::string& path);
  /// Bytes of the file on disk, without its log: less than before if another program truncated it, 0 if it no
  /// longer begins as a database. None if unknown.
  std::optional<std::int64_t> bytes_on_disk() const;
  /// Closes without touching the log.
  Status abandon();
  /// Moves the write-ahead log into the file and removes the log, unless another program writes to them.
  Status close();

 private:
  struct Handle;
  explicit SessionDatabase(std::unique_ptr<Handle> handle);
  template <typename Value>
  Result<std::optional<Value>> first(std::string_view sql, Value (SessionStatement::*read)(int) const);
  std::unique_ptr<Handle> handle_;
  DatabaseFault fault_ = DatabaseFault::Other;
};

}  // namespace abrazo
