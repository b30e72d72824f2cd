#include <algorithm>
#include <bit>

#include "core/session/file/session_database.hpp"
#include "tests/fuzz/session_template.hpp"

namespace fuzz = abrazo::fuzz;

namespace {

using abrazo::FrameRow;
using abrazo::SessionDatabase;

struct Column {
  std::string table, name;
};

/// Of all tables but that of the frames, whose rows have checksums.
const std::vector<Column>& columns() {
  static const std::vector<Column> all = [] {
    std::vector<Column> found;
    const fuzz::ScratchFile file("columns.abrazo", fuzz::session_template());
    auto database = SessionDatabase::open(file.path().string(), SessionDatabase::Access::Write);
    auto rows = database->prepare(
        "SELECT t.name, c.name FROM sqlite_schema t, pragma_table_info(t.name) c WHERE t.type = 'table' AND "
        "t.name NOT IN ('frames', 'poses') AND t.name NOT LIKE 'sqlite%'");
    while (*rows->step()) found.push_back({rows->text(0), rows->text(1)});
    return found;
  }();
  return all;
}

/// One change: where (2 bytes), of which type, how many bytes follow, and these.
struct Change {
  std::size_t place = 0;
  int type = 0;
  fuzz::Bytes payload;
};

std::vector<Change> changes_of(fuzz::Bytes bytes) {
  std::vector<Change> changes;
  while (bytes.size() >= 4 && changes.size() < 32) {
    Change change{bytes[0] + 256U * bytes[1], bytes[2], {}};
    const std::size_t size = std::min<std::size_t>(bytes[3], bytes.size() - 4);
    change.payload = bytes.subspan(4, size);
    bytes = bytes.subspan(4 + size);
    changes.push_back(change);
  }
  return changes;
}

std::int64_t integer_of(fuzz::Bytes bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < std::min<std::size_t>(8, bytes.size()); ++i)
    value |= std::uint64_t{bytes[i]} << (8 * i);
  return std::bit_cast<std::int64_t>(value);
}

void change_cell(SessionDatabase& database, const Change& change) {
  const Column& column = columns()[change.place % columns().size()];
  auto update = database.prepare("UPDATE " + column.table + " SET " + column.name + " = ?");
  if (!update) return;
  switch (change.type % 5) {
    case 0:
      update->bind_null(0);
      break;
    case 1:
      update->bind(0, integer_of(change.payload));
      break;
    case 2:
      update->bind(0, std::bit_cast<double>(integer_of(change.payload)));
      break;
    case 3:
      update->bind(0, fuzz::text_of(change.payload));
      break;
    default:
      update->bind(0, change.payload);
  }
  (void)update->run();
}

/// Of a value that is there a part is replaced, or all of it.
void change_value(FrameRow::Blob& value, const Change& change) {
  if (change.type % 2 == 0 || value.empty()) {
    value.assign(change.payload.begin(), change.payload.end());
    return;
  }
  const std::size_t at = change.place / 64 * 7 % value.size();
  for (std::size_t i = 0; i < change.payload.size() && at + i < value.size(); ++i)
    value[at + i] = change.payload[i];
}

struct FieldChange {
  const Change& change;
  std::size_t wanted;
  std::size_t at = 0;
  template <typename T>
  void operator()(const char*, const char*, T& value) {
    if (at++ != wanted) return;
    if constexpr (std::is_same_v<T, FrameRow::Blob>)
      change_value(value, change);
    else if constexpr (std::is_same_v<T, std::string>)
      value = fuzz::text_of(change.payload);
    else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, FrameRow::Time>)
      value = std::bit_cast<double>(integer_of(change.payload));
    else if constexpr (std::is_same_v<T, bool>)
      value = integer_of(change.payload) != 0;
    else
      value = integer_of(change.payload);
  }
};

void change_frame(FrameRow& row, const Change& change) {
  FieldChange field{change, change.place % 64};
  FrameRow::each(row, field);
  (void)fuzz::accepted(abrazo::frame_of(row));
}

}  // namespace

/// The template with some of its cells replaced, by whoever knows how: checksums are right. Where it is only
/// a frame's, the file is left out: there are a hundred times as many tries then.
ABRAZO_FUZZ_TARGET(session_rows)(fuzz::Bytes bytes) {
  const std::vector<Change> changes = changes_of(bytes);
  FrameRow row = fuzz::frame_template();
  const auto is_of_frame = [](const Change& change) { return (change.type & 0x80) != 0; };
  for (const Change& change : changes)
    if (is_of_frame(change)) change_frame(row, change);
  if (std::all_of(changes.begin(), changes.end(), is_of_frame)) return;
  const fuzz::ScratchFile file("rows.abrazo", fuzz::session_template());
  {
    auto database = SessionDatabase::open(file.path().string(), SessionDatabase::Access::Write);
    (void)database->execute("PRAGMA synchronous=OFF; PRAGMA journal_mode=MEMORY; BEGIN");
    for (const Change& change : changes)
      if (!is_of_frame(change)) change_cell(*database, change);
    (void)database->execute("DELETE FROM frames WHERE frame = 1");
    auto insert = database->prepare(abrazo::frame_insert());
    abrazo::bind_row(*insert, row);
    (void)insert->run();
    (void)database->execute("COMMIT");
  }
  fuzz::read_session(file.path());
}
