#include "core/session/run/saved_history.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/session/file/library_fingerprints.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/file/session_schema.hpp"
#include "core/session/file/session_writer.hpp"

namespace abrazo {
namespace {

/// In one transaction: they stay in SQLite's cache until the commit. Pages that leave it earlier change the
/// file's log, and the writer takes that for another program's.
constexpr std::uint64_t frames_in_batch = 64;

using Indices = std::vector<std::uint64_t>;

/// Ascending. From the index by time, which is small: the rows are not read.
Result<Indices> frames_in(const std::string& path) {
  std::error_code failure;
  if (!std::filesystem::exists(path, failure) || std::filesystem::file_size(path, failure) == 0)
    return Indices();
  auto database = open_session_database(path);
  if (!database) return database.error();
  auto rows = database->prepare("SELECT frame FROM frames INDEXED BY frames_by_time");
  if (!rows) return rows.error();
  Indices indices;
  while (true) {
    const auto more = rows->step();
    if (!more) return more.error();
    if (!*more) break;
    indices.push_back(static_cast<std::uint64_t>(rows->integer(0)));
  }
  std::ranges::sort(indices);
  return indices;
}

/// Writes each stretch of frames as a run of its own: the writer then notes the settings, decisions, input
/// and library in force at its first frame, whatever the frames around it in the file were solved with.
class StretchWriter {
 public:
  StretchWriter(std::string path, RecordingFacts facts) : path_(std::move(path)), facts_(std::move(facts)) {
    facts_.has_times_of_file = true;
    if (!facts_.fingerprints) facts_.fingerprints = std::make_shared<LibraryFingerprints>();
  }
  ~StretchWriter() { drop(); }
  StretchWriter(const StretchWriter&) = delete;
  StretchWriter& operator=(const StretchWriter&) = delete;

  Status write(const FrameSnapshot& frame) {
    if (!writer_) {
      auto opened = SessionWriter::open(path_, facts_, {}, SessionWriter::Origin::Saved);
      if (!opened) return opened.error();
      writer_ = std::move(*opened);
      library_row_.reset();
      in_batch_ = 0;
      if (const Status begun = writer_->begin_batch(); !begun) return begun;
    }
    if (const Status written = writer_->write(frame); !written) return written;
    if (const Status noted = note_fingerprint(); !noted) return noted;
    if (++in_batch_ < frames_in_batch) return Done{};
    in_batch_ = 0;
    if (const Status committed = writer_->commit(0); !committed) return committed;
    return writer_->begin_batch();
  }

  /// @param lost frames of the stretch that could not be read
  Status end(std::uint64_t lost) {
    if (!writer_) return Done{};
    const Status ended = writer_->close(lost);
    writer_.reset();
    return ended;
  }

 private:
  Status note_fingerprint() {
    const auto row = writer_->library_row();
    if (!row || row == library_row_ || !writer_->library()) return Done{};
    library_row_ = row;
    const std::string fingerprint = facts_.fingerprints->of(writer_->library()).get();
    // Without one a library is known by its number of pairs.
    return fingerprint.empty() ? Status(Done{}) : writer_->set_fingerprint(*row, fingerprint);
  }

  void drop() {
    if (!writer_) return;
    writer_->roll_back();
    (void)writer_->close(0);
  }

  const std::string path_;
  RecordingFacts facts_;
  std::unique_ptr<SessionWriter> writer_;
  std::optional<std::int64_t> library_row_;
  std::uint64_t in_batch_ = 0;
};

}  // namespace

Result<std::uint64_t> add_history(const std::string& path, HistoryToSave history, const Progress& progress) {
  const auto known = frames_in(path);
  if (!known) return known.error();
  const auto is_known = [&](std::uint64_t index) { return std::ranges::binary_search(*known, index); };
  StretchWriter writer(path, std::move(history.facts));
  const std::uint64_t all = history.frames.size();
  std::uint64_t seen = 0, lost = 0;
  std::optional<std::uint64_t> next;
  while (const FrameSnapshotPtr frame = history.frames.next()) {
    if (seen++ % frames_in_batch == 0 &&
        !report(progress, static_cast<double>(seen) / static_cast<double>(all), "Saving the history"))
      return Error{"saving was cancelled", path};
    for (; next && *next < frame->index; ++*next)
      if (!is_known(*next)) ++lost;
    next = frame->index + 1;
    const bool is_there = is_known(frame->index);
    if (const Status done = is_there ? writer.end(std::exchange(lost, 0)) : writer.write(*frame); !done)
      return done.error();
  }
  if (const Status ended = writer.end(lost); !ended) return ended.error();
  return all - seen;
}

}  // namespace abrazo
