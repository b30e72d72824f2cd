#include "core/session/file/session_database.hpp"

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <utility>

#include "core/base/atomic_file.hpp"
#include "core/base/limits.hpp"

namespace abrazo {

namespace {

DatabaseFault fault_of(int code) {
  switch (code & 0xff) {
    case SQLITE_FULL:
      return DatabaseFault::Full;
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return DatabaseFault::Busy;
    case SQLITE_CORRUPT:
    case SQLITE_TOOBIG:  // of a value that is read
      return DatabaseFault::Damaged;
    case SQLITE_NOTADB:
      return DatabaseFault::NotADatabase;
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
      return DatabaseFault::CannotWrite;
    default:
      return DatabaseFault::Other;
  }
}

Error error_of(int code, const char* detail, const std::string& path) {
  const std::string said = detail ? detail : sqlite3_errstr(code);
  switch (fault_of(code)) {
    case DatabaseFault::Full:
      return {"the disk is full; free some space, or record to another disk", path};
    case DatabaseFault::Busy:
      if (const auto able = abilities_of_folder_with(path); able && !able->locks)
        return {
            "the disk that the file is on locks no files (is it a network drive?), so that it can only be "
            "read "
            "there; copy it to a local disk, or have locks switched on for the drive",
            path};
      return {"another program or window is recording into this file; close it there, or choose another name",
              path};
    case DatabaseFault::Damaged:
      return {"the file is damaged (" + said +
                  "); with the shell of sqlite.org, sqlite3 FILE .recover | sqlite3 NEW.abrazo saves what is "
                  "left",
              path};
    case DatabaseFault::NotADatabase:
      return {"this is not a session file: it is no SQLite database", path};
    case DatabaseFault::CannotWrite:
      return {(code & 0xff) == SQLITE_CANTOPEN
                  ? "the file cannot be opened; does its folder exist, and may it be written?"
                  : "the file may only be read; change its permissions, or copy it to a folder of your own",
              path};
    case DatabaseFault::Other:
      break;
  }
  if ((code & 0xff) == SQLITE_IOERR)
    return {"the disk gives an error (" + said + "); is it still connected, and not full?", path};
  return {"the session file cannot be used: " + said, path};
}

}  // namespace

std::optional<FolderAbilities> abilities_of_folder_with(const std::string& path) {
  std::string name = path + ".XXXXXX";
  const int file = ::mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) return std::nullopt;
  FolderAbilities able;
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  lock.l_len = 1;
  able.locks = ::fcntl(file, F_SETLK, &lock) == 0;
  constexpr std::size_t bytes = 32768;  // of the index of SQLite's log
  if (::ftruncate(file, bytes) == 0) {
    void* const mapped = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    able.shares_memory = mapped != MAP_FAILED;
    if (able.shares_memory) ::munmap(mapped, bytes);
  } else {  // a full disk is able; it is told as what it is
    able.shares_memory = errno == ENOSPC || errno == EDQUOT || errno == EFBIG;
  }
  ::close(file);
  ::unlink(name.c_str());
  return able;
}

struct SessionDatabase::Handle {
  std::string path;
  sqlite3* database = nullptr;
  bool is_salvage = false;
  bool lacks_log = false;
  ~Handle() {
    // Statements hold a database until they are gone themselves.
    sqlite3_close_v2(database);
  }
};

struct SessionStatement::Handle {
  std::string path;
  sqlite3* database = nullptr;
  sqlite3_stmt* statement = nullptr;
  bool is_too_long = false;  ///< a value that was bound
  ~Handle() { sqlite3_finalize(statement); }
};

SessionStatement::SessionStatement(std::unique_ptr<Handle> handle) : handle_(std::move(handle)) {}
SessionStatement::SessionStatement(SessionStatement&&) noexcept = default;
SessionStatement& SessionStatement::operator=(SessionStatement&&) noexcept = default;
SessionStatement::~SessionStatement() = default;

// A parameter that does not exist is a programming mistake, which `step` then reports; memory is the only
// other thing that can fail here.
SessionStatement& SessionStatement::bind(int parameter, double value) {
  sqlite3_bind_double(handle_->statement, parameter + 1, value);
  return *this;
}

SessionStatement& SessionStatement::bind(int parameter, std::int64_t value) {
  sqlite3_bind_int64(handle_->statement, parameter + 1, value);
  return *this;
}

SessionStatement& SessionStatement::bind(int parameter, std::string_view text) {
  handle_->is_too_long |=
      sqlite3_bind_text64(handle_->statement, parameter + 1, text.data() ? text.data() : "", text.size(),
                          SQLITE_TRANSIENT, SQLITE_UTF8) == SQLITE_TOOBIG;
  return *this;
}

SessionStatement& SessionStatement::bind(int parameter, std::span<const std::uint8_t> blob) {
  if (blob.empty())
    sqlite3_bind_zeroblob(handle_->statement, parameter + 1, 0);
  else
    sqlite3_bind_blob64(handle_->statement, parameter + 1, blob.data(), blob.size(), SQLITE_STATIC);
  return *this;
}

SessionStatement& SessionStatement::bind_null(int parameter) {
  sqlite3_bind_null(handle_->statement, parameter + 1);
  return *this;
}

Result<bool> SessionStatement::step() {
  const bool is_too_long = std::exchange(handle_->is_too_long, false);
  const int code = is_too_long ? SQLITE_TOOBIG : sqlite3_step(handle_->statement);
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  const int extended = sqlite3_extended_errcode(handle_->database);
  if (code == SQLITE_TOOBIG && sqlite3_stmt_readonly(handle_->statement) == 0) {
    sqlite3_reset(handle_->statement);
    return Error{"a text is longer than the 16 MB that a row of a session file may have; shorten it",
                 handle_->path};
  }
  fault_ = fault_of(code);
  Error error = error_of(extended, sqlite3_errmsg(handle_->database), handle_->path);
  sqlite3_reset(handle_->statement);
  return error;
}

Status SessionStatement::run() {
  const auto stepped = step();
  sqlite3_reset(handle_->statement);
  if (!stepped) return stepped.error();
  return Done{};
}

void SessionStatement::reset() {
  sqlite3_reset(handle_->statement);
}

bool SessionStatement::is_null(int column) const {
  return sqlite3_column_type(handle_->statement, column) == SQLITE_NULL;
}

double SessionStatement::real(int column) const {
  return sqlite3_column_double(handle_->statement, column);
}

std::int64_t SessionStatement::integer(int column) const {
  return sqlite3_column_int64(handle_->statement, column);
}

std::string SessionStatement::text(int column) const {
  const void* bytes = sqlite3_column_text(handle_->statement, column);
  if (!bytes) return {};
  const int size = sqlite3_column_bytes(handle_->statement, column);
  return {static_cast<const char*>(bytes), static_cast<std::size_t>(size)};
}

std::span<const std::uint8_t> SessionStatement::blob(int column) const {
  const void* bytes = sqlite3_column_blob(handle_->statement, column);
  const int size = sqlite3_column_bytes(handle_->statement, column);
  if (!bytes || size <= 0) return {};
  return {static_cast<const std::uint8_t*>(bytes), static_cast<std::size_t>(size)};
}

SessionDatabase::SessionDatabase(std::unique_ptr<Handle> handle) : handle_(std::move(handle)) {}
SessionDatabase::SessionDatabase(SessionDatabase&&) noexcept = default;
SessionDatabase& SessionDatabase::operator=(SessionDatabase&&) noexcept = default;
SessionDatabase::~SessionDatabase() = default;

namespace {

/// A file name as a URI, the only way to set "immutable".
std::string frozen_uri(const std::string& path) {
  static constexpr char digits[] = "0123456789ABCDEF";
  std::string uri = "file:";
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '?' || c == '#' || c == '%' || byte <= ' ' || byte > '~') {
      uri += '%';
      uri += digits[byte >> 4];
      uri += digits[byte & 0xf];
    } else {
      uri += c;
    }
  }
  return uri + "?immutable=1";
}

}  // namespace

namespace {

constexpr int usual_patience_ms = 2000;

/// SQLite would wait for whoever writes into a pipe. The file itself and the three that SQLite keeps beside
/// one.
Status check_files(const std::string& path) {
  for (const char* ending : {"", "-journal", "-wal", "-shm"}) {
    const std::filesystem::path file = path + ending;
    std::error_code failure;
    if (!std::filesystem::is_other(file, failure)) continue;
    if (*ending == '\0')
      return Error{"is a pipe, a socket or a device, no file; choose a session (.abrazo)", path};
    return Error{
        "beside the file lies '" + file.filename().string() +
            "', which is a pipe, a socket or a device, no file. Move it away, then open the session again",
        path};
  }
  return Done{};
}

/// SQLite's own descriptor: closing another one would drop the locks that this program holds on the file.
sqlite3_file* file_of(sqlite3* database) {
  sqlite3_file* file = nullptr;
  const bool is_known =
      database && sqlite3_file_control(database, "main", SQLITE_FCNTL_FILE_POINTER, &file) == SQLITE_OK;
  return is_known && file && file->pMethods ? file : nullptr;
}

/// The first bytes of the database header; none if the file is shorter, or is not open.
std::optional<std::array<char, 20>> head_of(sqlite3* database) {
  std::array<char, 20> head{};
  sqlite3_file* const file = file_of(database);
  if (!file || file->pMethods->xRead(file, head.data(), static_cast<int>(head.size()), 0) != SQLITE_OK)
    return std::nullopt;
  return head;
}

/// Whether the header says that there is a log beside the file (bytes 18 and 19, 2: WAL).
bool has_log_by_its_head(sqlite3* database) {
  const auto head = head_of(database);
  return head && (*head)[18] == 2 && (*head)[19] == 2;
}

/// A journal that SQLite finds beside a database may name another one, which it then deletes. Journals of
/// session files never do.
Status check_journal(const std::string& path) {
  static constexpr std::array<char, 8> magic = {'\xd9', '\xd5', '\x05', '\xf9',
                                                '\x20', '\xa1', '\x63', '\xd7'};
  const std::string journal = path + "-journal";
  std::ifstream file(journal, std::ios::binary | std::ios::ate);
  if (!file || file.tellg() < static_cast<std::streamoff>(magic.size())) return Done{};
  std::array<char, 8> end{};
  file.seekg(-static_cast<std::streamoff>(end.size()), std::ios::end);
  file.read(end.data(), end.size());
  if (!file || end != magic) return Done{};
  return Error{
      "beside the file lies a journal that names a file of its own, which would be deleted; this "
      "program never writes such a one. Move '" +
          std::filesystem::path(journal).filename().string() + "' away, then open the session again",
      path};
}

/// A file from others may hold a malicious schema.
void defend(sqlite3* database, bool is_salvage) {
  const auto set = [&](int option, int value) { sqlite3_db_config(database, option, value, nullptr); };
  set(SQLITE_DBCONFIG_DEFENSIVE, is_salvage ? 0 : 1);
  set(SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0);
  set(SQLITE_DBCONFIG_ENABLE_TRIGGER, 0);
  set(SQLITE_DBCONFIG_ENABLE_VIEW, 0);  // those in the file are for people
  set(SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, 0);
  set(SQLITE_DBCONFIG_ENABLE_FTS3_TOKENIZER, 0);
  set(SQLITE_DBCONFIG_DQS_DDL, 0);
  set(SQLITE_DBCONFIG_DQS_DML, 0);
  sqlite3_limit(database, SQLITE_LIMIT_LENGTH, limits::session_row_bytes);
  sqlite3_limit(database, SQLITE_LIMIT_SQL_LENGTH, 1 << 20);
  sqlite3_limit(database, SQLITE_LIMIT_EXPR_DEPTH, 100);
  sqlite3_limit(database, SQLITE_LIMIT_COMPOUND_SELECT, 10);
  sqlite3_limit(database, SQLITE_LIMIT_TRIGGER_DEPTH, 1);
  sqlite3_limit(database, SQLITE_LIMIT_ATTACHED, 1);  // a copy of the session is one
  sqlite3_limit(database, SQLITE_LIMIT_WORKER_THREADS, 0);
}

/// Creates a missing file. SQLite would follow a dangling link and create its target.
Status make_database_file(const std::string& path) {
  namespace fs = std::filesystem;
  if (make_new_file(path) || errno != EEXIST) return Done{};  // SQLite reports the reason
  std::error_code failure;
  if (!fs::is_symlink(path, failure) || fs::exists(path, failure)) return Done{};
  return Error{"is a link to " + fs::read_symlink(path, failure).string() +
                   ", which does not exist; remove the link, or name the file itself",
               path};
}

}  // namespace

Result<SessionDatabase> SessionDatabase::open(const std::string& path, Access access) {
  if (const Status files = check_files(path); !files) return files.error();
  if (const Status harmless = check_journal(path); !harmless) return harmless.error();
  if (access == Access::Create)
    if (const Status made = make_database_file(path); !made) return made.error();
  auto handle = std::make_unique<Handle>();
  handle->path = path;
  int flags = SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_EXRESCODE;
  if (access == Access::Frozen)
    flags |= SQLITE_OPEN_READONLY | SQLITE_OPEN_URI;
  else if (access == Access::Salvage)
    flags |= SQLITE_OPEN_READONLY;
  else
    flags |= SQLITE_OPEN_READWRITE;  // SQLite itself falls back to reading what may not be written
  // A name such as ":memory:" is one of a file, too.
  std::error_code failure;
  const std::string full = std::filesystem::absolute(path, failure).string();
  const std::string name = access == Access::Frozen ? frozen_uri(full) : full;
  const int code = sqlite3_open_v2(name.c_str(), &handle->database, flags, nullptr);
  if (code != SQLITE_OK) return error_of(code, nullptr, path);
  // SQLite makes an empty log when it first reads.
  handle->lacks_log =
      has_log_by_its_head(handle->database) && !std::filesystem::exists(log_of_session(path), failure);
  sqlite3_extended_result_codes(handle->database, 1);
  handle->is_salvage = access == Access::Salvage;
  defend(handle->database, handle->is_salvage);
  SessionDatabase opened(std::move(handle));
  opened.set_patience(usual_patience_ms);
  // No page of a file that others may cut short is mapped, and every page is looked over before it is used.
  (void)opened.execute("PRAGMA mmap_size=0; PRAGMA cell_size_check=ON");
  // Without this a truncated file is refused as a whole.
  if (access == Access::Salvage) (void)opened.execute("PRAGMA writable_schema=ON");
  const bool writes = access == Access::Write || access == Access::Create;
  if (!writes) (void)opened.execute("PRAGMA query_only=ON");
  if (writes && sqlite3_db_readonly(opened.handle_->database, "main") == 1)
    return error_of(SQLITE_READONLY, nullptr, path);
  return opened;
}

const std::string& SessionDatabase::path() const {
  return handle_->path;
}

bool SessionDatabase::lacks_log() const {
  return handle_->lacks_log;
}

bool SessionDatabase::is_salvage() const {
  return handle_->is_salvage;
}

Status SessionDatabase::execute(const std::string& sql) {
  const int code = sqlite3_exec(handle_->database, sql.c_str(), nullptr, nullptr, nullptr);
  if (code == SQLITE_OK) return Done{};
  fault_ = fault_of(code);
  return error_of(sqlite3_extended_errcode(handle_->database), sqlite3_errmsg(handle_->database),
                  handle_->path);
}

Result<SessionStatement> SessionDatabase::prepare(std::string_view sql) {
  auto handle = std::make_unique<SessionStatement::Handle>();
  handle->path = handle_->path;
  handle->database = handle_->database;
  const int code = sqlite3_prepare_v3(handle_->database, sql.data(), static_cast<int>(sql.size()),
                                      SQLITE_PREPARE_PERSISTENT, &handle->statement, nullptr);
  if (code == SQLITE_OK) return SessionStatement(std::move(handle));
  fault_ = fault_of(code);
  return error_of(sqlite3_extended_errcode(handle_->database), sqlite3_errmsg(handle_->database),
                  handle_->path);
}

template <typename Value>
Result<std::optional<Value>> SessionDatabase::first(std::string_view sql,
                                                    Value (SessionStatement::*read)(int) const) {
  auto statement = prepare(sql);
  if (!statement) return statement.error();
  const auto row = statement->step();
  if (!row) {
    fault_ = statement->fault();
    return row.error();
  }
  if (!*row || statement->is_null(0)) return std::optional<Value>();
  return std::optional((*statement.*read)(0));
}

Result<std::optional<std::int64_t>> SessionDatabase::integer(std::string_view sql) {
  return first(sql, &SessionStatement::integer);
}

Result<std::optional<std::string>> SessionDatabase::text(std::string_view sql) {
  return first(sql, &SessionStatement::text);
}

std::int64_t SessionDatabase::last_row_id() const {
  return sqlite3_last_insert_rowid(handle_->database);
}

void SessionDatabase::set_patience(int milliseconds) {
  sqlite3_busy_timeout(handle_->database, milliseconds);
}

bool SessionDatabase::is_held_elsewhere() {
  // A read-only connection cannot test the lock.
  const auto query_only = integer("PRAGMA query_only");
  const bool only_reads = query_only && query_only->value_or(0) != 0;
  if (only_reads) (void)execute("PRAGMA query_only=OFF");
  set_patience(0);
  const bool free = execute("BEGIN IMMEDIATE").ok();
  const bool held = !free && fault() == DatabaseFault::Busy;
  if (free) (void)execute("ROLLBACK");
  set_patience(usual_patience_ms);
  if (only_reads) (void)execute("PRAGMA query_only=ON");
  return held;
}

Status SessionDatabase::copy_into(const std::string& path) {
  std::string quoted;
  for (const char c : path) quoted += c == '\'' ? "''" : std::string(1, c);
  (void)execute("PRAGMA query_only=OFF");  // it is the copy that is written
  const Status copied = execute("VACUUM INTO '" + quoted + "'");
  if (!copied) return Error{copied.error().message, path};
  return Done{};
}

std::optional<std::int64_t> SessionDatabase::bytes_on_disk() const {
  static constexpr std::string_view begin("SQLite format 3\0", 16);
  sqlite3_file* const file = file_of(handle_->database);
  if (!file) return std::nullopt;
  sqlite3_int64 bytes = 0;
  if (file->pMethods->xFileSize(file, &bytes) != SQLITE_OK) return std::nullopt;
  const auto head = head_of(handle_->database);
  return head && std::string_view(head->data(), begin.size()) == begin ? bytes : 0;
}

Status SessionDatabase::abandon() {
  sqlite3_file_control(handle_->database, "main", SQLITE_FCNTL_PERSIST_WAL, std::array{1}.data());
  sqlite3_db_config(handle_->database, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
  const int code = sqlite3_close_v2(std::exchange(handle_->database, nullptr));
  if (code != SQLITE_OK) return error_of(code, nullptr, handle_->path);
  return Done{};
}

Status SessionDatabase::close() {
  // The file and log of a program that records into them are its own to write.
  const bool is_held = is_held_elsewhere();
  // A program that reads the file at the moment prevents it from becoming a plain file, which its last reader
  // then makes of it when it closes.
  set_patience(0);
  const Status checkpointed = is_held ? Status(Done{}) : execute("PRAGMA wal_checkpoint(TRUNCATE)");
  if (checkpointed && !is_held) (void)execute("PRAGMA journal_mode=DELETE");
  const int code = sqlite3_close_v2(std::exchange(handle_->database, nullptr));
  if (!checkpointed && fault_ != DatabaseFault::Busy) return checkpointed.error();
  if (code != SQLITE_OK) return error_of(code, nullptr, handle_->path);
  return Done{};
}

}  // namespace abrazo
