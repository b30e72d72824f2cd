#include "core/session/file/session_file.hpp"

#include <limits>
#include <mutex>

#include "core/session/file/frame_reader.hpp"
#include "core/session/file/frame_row.hpp"
#include "core/session/file/project_rows.hpp"
#include "core/session/file/row_scan.hpp"
#include "core/session/file/session_contents.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/file/session_schema.hpp"

namespace abrazo {

namespace {

class OpenSessionFile : public SessionFile {
 public:
  OpenSessionFile(SessionDatabase database, SessionFacts facts, std::unique_ptr<FrameReader> reader)
      : database_(std::move(database)), reader_(std::move(reader)), facts_(std::move(facts)) {}

  const std::string& path() const override { return database_.path(); }
  const SessionContents& contents() const override { return facts_.contents; }
  bool is_being_recorded() const override { return facts_.is_being_recorded; }
  const std::vector<std::string>& recovery() const override { return facts_.recovery; }

  Result<RowsRead> each_frame(double from_s, double to_s,
                              const std::function<Status(const FrameSnapshot&)>& visit) const override {
    const std::scoped_lock lock(mutex_);
    const auto [first, last] = frames_between(from_s, to_s);
    return reader_->scan(first, last, [&](FrameReader::Read& read) -> Status {
      if (read.frame->time_s < from_s || read.frame->time_s > to_s) return Done{};
      return visit(*read.frame);
    });
  }

  Result<RowsRead> each_pose(std::optional<int> performer, double from_s, double to_s,
                             const std::function<Status(const ReceivedPose&)>& visit) const override {
    const std::scoped_lock lock(mutex_);
    auto rows = database_.prepare(
        "SELECT id, performer, arrived_s, assembled_s, time_s, sender_time_s, counter, discontinuous, pose, "
        "checksum FROM poses WHERE id BETWEEN ? AND ? ORDER BY id");
    if (!rows) return rows.error();
    return scan_rows(*rows, 1, std::numeric_limits<std::int64_t>::max() - 1,
                     [&](const SessionStatement& row) {
                       RowOutcome outcome;
                       outcome.id = row.integer(0);
                       ReceivedPose received;
                       outcome.status = decode(row, received);
                       outcome.damaged = !outcome.status;
                       const bool wanted = !performer || row.integer(1) == *performer;
                       const double time_s = row.is_null(2) ? received.pose.time_s : received.pose.arrived_s;
                       if (!outcome.damaged && wanted && time_s >= from_s && time_s <= to_s)
                         outcome.status = visit(received);
                       return outcome;
                     });
  }

  Status each_source(double from_s, double to_s,
                     const std::function<Status(const SessionSource&)>& visit) const override {
    const std::scoped_lock lock(mutex_);
    auto rows = database_.prepare(
        "SELECT f.frame, f.time_s, p.take, p.frame, p.swapped, p.label FROM frames f LEFT JOIN pairs p "
        "ON p.library = f.library AND p.pair = f.pair WHERE f.time_s BETWEEN ? AND ? ORDER BY f.frame");
    if (!rows) return rows.error();
    rows->bind(0, from_s).bind(1, to_s);
    while (true) {
      const auto row = rows->step();
      if (!row) return row.error();
      if (!*row) return Done{};
      const Status visited =
          visit({static_cast<std::uint64_t>(rows->integer(0)), rows->real(1), rows->text(2),
                 static_cast<int>(rows->integer(3)), rows->integer(4) != 0, rows->text(5)});
      if (!visited) return visited;
    }
  }

  Result<ProjectReading> project() const override {
    const std::scoped_lock lock(mutex_);
    return read_project(database_);
  }

  Result<FrameSnapshotPtr> frame(std::uint64_t index) const override {
    const std::scoped_lock lock(mutex_);
    auto read = reader_->frame(static_cast<std::int64_t>(index));
    if (!read) return read.error();
    return *read ? FrameSnapshotPtr((*read)->frame) : FrameSnapshotPtr();
  }

 private:
  /// Indices to look at; all of them where the index of times cannot be read.
  std::pair<std::int64_t, std::int64_t> frames_between(double from_s, double to_s) const {
    constexpr std::int64_t lowest = 0, highest = std::numeric_limits<std::int64_t>::max() - 1;
    const auto first = reader_->first_from(from_s, lowest);
    const auto last = reader_->last_until(to_s, lowest);
    if (!first || !last) return {lowest, highest};
    if (!*first || !*last) return {1, 0};
    // Times of a damaged file may be wrong; without a limit no row is skipped.
    const bool all =
        from_s <= facts_.contents.first_s && to_s >= facts_.contents.last_s && !facts_.recovery.empty();
    return all ? std::pair{lowest, highest} : std::pair{**first, **last};
  }

  Status decode(const SessionStatement& row, ReceivedPose& received) const {
    const auto bytes = row.blob(8);
    Checksum sum;
    sum.add(bytes);
    if (sum.value() != row.integer(9) || !read_pose(bytes, received.pose.pose))
      return Error{"pose " + std::to_string(row.integer(0)) + " is damaged", {}};
    for (const SessionPerformer& performer : facts_.contents.performers)
      if (performer.id == row.integer(1)) received.performer = performer.name;
    received.pose.arrived_s = row.is_null(2) ? -1 : row.real(2);
    received.pose.assembled_s = row.is_null(3) ? -1 : row.real(3);
    received.pose.time_s = row.real(4);
    if (!row.is_null(5)) received.sender_time_s = row.real(5);
    received.pose.frame = row.integer(6);
    received.pose.discontinuous = row.integer(7) != 0;
    return Done{};
  }

  mutable std::mutex mutex_;
  mutable SessionDatabase database_;
  std::unique_ptr<FrameReader> reader_;
  SessionFacts facts_;
};

}  // namespace

Result<std::shared_ptr<const SessionFile>> SessionFile::open(const std::string& path) {
  auto database = open_session_database(path);
  if (!database) return database.error();
  auto reader = FrameReader::open(*database);
  if (!reader) return reader.error();
  auto facts = read_facts(*database);
  if (!facts) return facts.error();
  return std::shared_ptr<const SessionFile>(
      std::make_shared<OpenSessionFile>(std::move(*database), std::move(*facts), std::move(*reader)));
}

}  // namespace abrazo
