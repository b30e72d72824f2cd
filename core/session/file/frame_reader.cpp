#include "core/session/file/frame_reader.hpp"

#include "core/session/file/decisions_json.hpp"
#include "core/session/file/frame_row.hpp"
#include "core/session/file/row_scan.hpp"

namespace abrazo {

namespace {
/// Settings that change with every frame, as while a slider is dragged, are not all kept.
constexpr std::size_t kept_settings = 256;
}  // namespace

struct FrameReader::Statements {
  SessionStatement rows, settings_from, settings, decisions_from, decisions, last_until, first_from, next,
      last, state_before, time_of, times;
};

FrameReader::FrameReader(Statements statements)
    : statements_(std::make_unique<Statements>(std::move(statements))) {}
FrameReader::~FrameReader() = default;

Result<std::unique_ptr<FrameReader>> FrameReader::open(SessionDatabase& database) {
  auto rows = database.prepare("SELECT " + frame_columns() +
                               ", checksum FROM frames WHERE frame BETWEEN ? AND ? ORDER BY frame");
  auto settings_from = database.prepare(
      "SELECT frame, "
      "(SELECT is_learning FROM learning WHERE frame <= ?1 ORDER BY frame DESC LIMIT 1) "
      "FROM settings WHERE frame <= ?1 ORDER BY frame DESC LIMIT 1");
  auto settings = database.prepare("SELECT json FROM settings WHERE frame = ?");
  auto decisions_from =
      database.prepare("SELECT frame FROM decisions WHERE frame <= ? ORDER BY frame DESC LIMIT 1");
  auto decisions = database.prepare("SELECT json FROM decisions WHERE frame = ?");
  auto last_until = database.prepare(
      "SELECT frame FROM frames INDEXED BY frames_by_time WHERE time_s <= ? AND frame >= ? "
      "ORDER BY time_s DESC, frame DESC LIMIT 1");
  auto first_from = database.prepare(
      "SELECT frame FROM frames INDEXED BY frames_by_time WHERE time_s >= ? AND frame >= ? "
      "ORDER BY time_s, frame LIMIT 1");
  auto next =
      database.prepare("SELECT frame FROM frames NOT INDEXED WHERE frame >= ? ORDER BY frame LIMIT 1");
  auto last = database.prepare("SELECT frame FROM frames NOT INDEXED ORDER BY frame DESC LIMIT 1");
  auto state_before = database.prepare(
      "SELECT frame FROM frames INDEXED BY frames_with_state WHERE state IS NOT NULL AND frame <= ? AND "
      "frame >= ? "
      "ORDER BY frame DESC LIMIT 1");
  auto time_of = database.prepare("SELECT time_s FROM frames WHERE frame = ?");
  auto times = database.prepare(
      "SELECT time_s FROM frames INDEXED BY frames_by_time WHERE time_s BETWEEN ? AND ? AND frame >= ? "
      "ORDER BY time_s");
  for (const auto* statement : {&rows, &settings_from, &settings, &decisions_from, &decisions, &last_until,
                                &first_from, &next, &last, &state_before, &time_of, &times})
    if (!*statement) return statement->error();
  return std::unique_ptr<FrameReader>(new FrameReader(Statements{
      std::move(*rows), std::move(*settings_from), std::move(*settings), std::move(*decisions_from),
      std::move(*decisions), std::move(*last_until), std::move(*first_from), std::move(*next),
      std::move(*last), std::move(*state_before), std::move(*time_of), std::move(*times)}));
}

Result<FrameReader::Read> FrameReader::decode(const SessionStatement& row) {
  auto columns = read_row(row);
  if (!columns) return columns.error();
  auto frame = frame_of(*columns);
  if (!frame) return frame.error();
  if (const Status added = add_settings(**frame); !added) return added.error();
  if (const Status added = add_decisions(**frame); !added) return added.error();
  return Read{std::move(*frame), columns->library};
}

/// The text of a frame that has one.
Result<std::string> FrameReader::text_of(SessionStatement& statement, std::int64_t frame) {
  const auto found = statement.bind(0, frame).step();
  if (!found) return found.error();
  std::string text = *found ? statement.text(0) : std::string();
  statement.reset();
  return text;
}

Status FrameReader::add_settings(FrameSnapshot& frame) {
  SessionStatement& row = statements_->settings_from;
  const auto found = row.bind(0, frame.index).step();
  if (!found) return found.error();
  if (!*found) return Error{"there are no settings of frame " + std::to_string(frame.index), {}};
  const std::int64_t from = row.integer(0);
  frame.is_learning = row.integer(1) != 0;
  row.reset();
  auto known = settings_.find(from);
  if (known == settings_.end()) {
    if (settings_.size() >= kept_settings) settings_.clear();
    const auto json = text_of(statements_->settings, from);
    known = settings_
                .emplace(from,
                         json ? parse_settings(*json, Settings{}, "settings of frame " + std::to_string(from))
                              : Result<Settings>(json.error()))
                .first;
  }
  if (!known->second) return known->second.error();
  frame.settings = *known->second;
  return Done{};
}

Status FrameReader::add_decisions(FrameSnapshot& frame) {
  const auto from = first_column(statements_->decisions_from.bind(0, frame.index));
  if (!from) return from.error();
  if (!*from) return Done{};
  auto known = decisions_.find(**from);
  if (known == decisions_.end()) {
    if (decisions_.size() >= kept_settings) decisions_.clear();
    const auto json = text_of(statements_->decisions, **from);
    const auto parsed = json ? parse_decisions(*json, "decisions of frame " + std::to_string(**from))
                             : Result<Decisions>(json.error());
    known = decisions_
                .emplace(**from,
                         parsed ? Result(*parsed == Decisions{} ? nullptr
                                                                : std::make_shared<const Decisions>(*parsed))
                                : Result<std::shared_ptr<const Decisions>>(parsed.error()))
                .first;
  }
  if (!known->second) return known->second.error();
  frame.decisions = *known->second;
  return Done{};
}

Result<std::optional<FrameReader::Read>> FrameReader::frame(std::int64_t index) {
  SessionStatement& row = statements_->rows;
  row.reset();
  const auto found = row.bind(0, index).bind(1, index).step();
  if (!found) return found.error();
  if (!*found) {
    row.reset();
    return std::optional<Read>();
  }
  auto read = decode(row);
  row.reset();
  if (!read) return read.error();
  return std::optional<Read>(std::move(*read));
}

Result<RowsRead> FrameReader::scan(std::int64_t first, std::int64_t last,
                                   const std::function<Status(Read&)>& visit) {
  return scan_rows(statements_->rows, first, last, [&](const SessionStatement& row) {
    RowOutcome outcome;
    outcome.id = row.integer(0);
    auto read = decode(row);
    outcome.damaged = !read;
    outcome.status = read ? visit(*read) : Status(read.error());
    return outcome;
  });
}

Result<std::optional<std::int64_t>> FrameReader::first_column(SessionStatement& statement) {
  const auto row = statement.step();
  if (!row) return row.error();
  std::optional<std::int64_t> value;
  if (*row) value = statement.integer(0);
  statement.reset();
  return value;
}

Result<std::optional<std::int64_t>> FrameReader::last_until(double time_s, std::int64_t from) {
  return first_column(statements_->last_until.bind(0, time_s).bind(1, from));
}

Result<std::optional<std::int64_t>> FrameReader::first_from(double time_s, std::int64_t from) {
  return first_column(statements_->first_from.bind(0, time_s).bind(1, from));
}

Result<std::optional<std::int64_t>> FrameReader::next(std::int64_t index) {
  return first_column(statements_->next.bind(0, index));
}

Result<std::optional<std::int64_t>> FrameReader::last() {
  return first_column(statements_->last);
}

Result<std::optional<std::int64_t>> FrameReader::state_before(std::int64_t index, std::int64_t from) {
  return first_column(statements_->state_before.bind(0, index).bind(1, from));
}

Result<std::optional<double>> FrameReader::time_of(std::int64_t index) {
  SessionStatement& statement = statements_->time_of;
  const auto row = statement.bind(0, index).step();
  if (!row) return row.error();
  std::optional<double> value;
  if (*row) value = statement.real(0);
  statement.reset();
  return value;
}

Result<std::vector<double>> FrameReader::times(double from_s, double to_s, std::int64_t from) {
  SessionStatement& statement = statements_->times;
  statement.bind(0, from_s).bind(1, to_s).bind(2, from);
  std::vector<double> times_s;
  while (true) {
    const auto row = statement.step();
    if (row && *row) {
      times_s.push_back(statement.real(0));
      continue;
    }
    statement.reset();
    if (!row) return row.error();
    return times_s;
  }
}

}  // namespace abrazo
