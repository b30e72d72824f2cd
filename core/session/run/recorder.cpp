#include "core/session/run/recorder.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <future>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <variant>

#include "core/base/wake_up.hpp"
#include "core/session/file/library_fingerprints.hpp"
#include "core/session/file/recorded_frames.hpp"
#include "core/session/file/session_writer.hpp"

namespace abrazo {

namespace {

using Steady = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

/// After the disk has refused something, it is asked again so much later.
constexpr double retry_s = 1;

struct BeginTake {
  std::string name;
};
struct EndTake {};
struct EditTakes {
  TakeEdits edits;
};
using ProjectPtr = std::shared_ptr<const Project>;
struct SetLibraryPath {
  std::shared_ptr<const MotionLibrary> library;
  std::string path;
};
struct SetFingerprint {
  std::int64_t library_row = 0;
  std::string fingerprint;
};
using Item = std::variant<FrameSnapshotPtr, ReceivedPose, BeginTake, EndTake, Markers, SetLibraryPath,
                          SetFingerprint, ProjectPtr, EditTakes>;

/// One thread owns the writer; others put data in a queue.
class FileRecorder : public Recorder {
 public:
  FileRecorder(std::unique_ptr<SessionWriter> writer, std::shared_ptr<RecordedFrames> store,
               std::shared_ptr<LibraryFingerprints> fingerprints, const RecorderOptions& options,
               const std::string& path)
      : options_(options),
        fingerprints_(std::move(fingerprints)),
        writer_(std::move(writer)),
        store_(std::move(store)) {
    state_.path = path;
    state_.bytes = writer_->bytes();
    state_.file_bytes = writer_->file_bytes();
    thread_ = std::thread([this] { run(); });
  }

  ~FileRecorder() override { (void)finish(); }

  void frame_solved(const FrameSnapshotPtr& frame) override {
    const std::scoped_lock lock(mutex_);
    if (ended_) return;
    if (waiting_frames_ >= options_.waiting_frames) return lose();
    ++waiting_frames_;
    if (!state_.take.empty()) state_.take_span.extend(frame->time_s);
    push(frame);
  }

  void pose_received(const ReceivedPose& pose) override {
    const std::scoped_lock lock(mutex_);
    if (ended_) return;
    if (waiting_poses_ >= options_.waiting_poses) return lose();
    ++waiting_poses_;
    push(pose);
  }

  void begin_take(const std::string& name) override {
    const std::scoped_lock lock(mutex_);
    state_.take = name;
    state_.take_span = {};
    push(EndTake{});
    push(BeginTake{name});
  }

  void end_take() override {
    const std::scoped_lock lock(mutex_);
    state_.take.clear();
    push(EndTake{});
  }

  void set_markers(const Markers& markers) override {
    const std::scoped_lock lock(mutex_);
    push(markers);
  }

  void save_project(ProjectPtr project) override {
    const std::scoped_lock lock(mutex_);
    push(std::move(project));
  }

  void edit_takes(const TakeEdits& edits) override {
    const std::scoped_lock lock(mutex_);
    push(EditTakes{edits});
  }

  void set_library_path(const std::shared_ptr<const MotionLibrary>& library,
                        const std::string& path) override {
    const std::scoped_lock lock(mutex_);
    push(SetLibraryPath{library, path});
  }

  State state() const override {
    const std::scoped_lock lock(mutex_);
    State state = state_;
    const Steady::time_point oldest = std::min(oldest_in_batch_, oldest_in_queue_);
    if (oldest != Steady::time_point::max()) state.behind_s = Seconds(Steady::now() - oldest).count();
    return state;
  }

  std::shared_ptr<const FrameStore> store() const override { return store_; }

  Status flush() override {
    std::unique_lock lock(mutex_);
    const std::uint64_t target = pushed_;
    const std::uint64_t attempts = attempts_;
    wake_.notify();
    // A disk that refuses is asked once more, not forever.
    written_changed_.wait(lock, [&] {
      return written_ >= target || ended_ || (attempts_ > attempts && !state_.failure.empty());
    });
    if (written_ >= target) return Done{};
    return Error{state_.failure, state_.path};
  }

  Status finish() override {
    const std::scoped_lock one(finish_mutex_);
    if (!thread_.joinable()) return finished_;
    {
      const std::scoped_lock lock(mutex_);
      stopping_ = true;
    }
    wake_.notify();
    thread_.join();
    return finished_;
  }

 private:
  void push(Item item) {
    if (ended_) return;
    if (queue_.empty()) oldest_in_queue_ = Steady::now();
    queue_.push_back(std::move(item));
    ++pushed_;
  }

  void lose() {
    ++state_.lost;
    if (state_.failure.empty())
      state_.failure = "the disk does not keep up: what was solved in the meantime is lost";
  }

  void run() {
    std::deque<Item> batch;
    bool stopping = false;
    while (true) {
      const double wait_s = failed_ ? retry_s : options_.commit_interval_s;
      if (!stopping)
        wake_.wait_until(Steady::now() + std::chrono::duration_cast<Steady::duration>(Seconds(wait_s)));
      std::uint64_t lost = 0;
      std::deque<Item> known = known_fingerprints(false);
      {
        const std::scoped_lock lock(mutex_);
        for (Item& item : known) push(std::move(item));
        if (batch.empty()) oldest_in_batch_ = oldest_in_queue_;
        oldest_in_queue_ = Steady::time_point::max();
        for (Item& item : queue_) batch.push_back(std::move(item));
        queue_.clear();
        stopping = stopping_;
        lost = state_.lost;
      }
      const Status written = batch.empty() ? Status(Done{}) : write(batch, lost);
      settle(batch, written);
      if (stopping && has_ended()) break;
    }
    write_last_fingerprints();
    close(batch);
  }

  /// Of the rows that lack theirs.
  std::deque<Item> known_fingerprints(bool wait) {
    std::deque<Item> known;
    std::erase_if(unknown_, [&](const Unknown& one) {
      if (!wait && one.fingerprint.wait_for(Seconds(0)) != std::future_status::ready) return false;
      // Without one a library is known by its number of pairs.
      if (const std::string& fingerprint = one.fingerprint.get(); !fingerprint.empty())
        known.emplace_back(SetFingerprint{one.library_row, fingerprint});
      return true;
    });
    return known;
  }

  /// Frames wait for it no longer: all are on disk.
  void write_last_fingerprints() {
    if (failed_ || unknown_.empty()) return;
    std::deque<Item> known = known_fingerprints(true);
    std::uint64_t lost = 0;
    {
      const std::scoped_lock lock(mutex_);
      lost = state_.lost;
    }
    const Status written = write(known, lost);
    settle(known, written);
  }

  /// What came in since the last batch is still written, unless the disk refuses.
  bool has_ended() {
    const std::scoped_lock lock(mutex_);
    ended_ = failed_ || queue_.empty();
    return ended_;
  }

  Status write(const std::deque<Item>& batch, std::uint64_t lost) {
    Status written = writer_->begin_batch();
    try {
      for (const Item& item : batch) {
        if (!written) break;
        written = std::visit(*this, item);
      }
      if (written) written = writer_->commit(lost);
    } catch (const std::exception& failure) {
      written = Error{failure.what(), state_.path};
    }
    if (!written) writer_->roll_back();
    return written;
  }

  /// Counts the data on disk, or reports why it is not.
  void settle(std::deque<Item>& batch, const Status& written) {
    const std::uint64_t bytes = writer_->bytes(), file_bytes = writer_->file_bytes();
    const std::string misplaced = writer_->misplaced();
    std::deque<Item> done;  // destroyed outside the lock
    const std::scoped_lock lock(mutex_);
    ++attempts_;
    state_.bytes = bytes;
    state_.file_bytes = std::max(state_.file_bytes, file_bytes);
    if (!written) {
      state_.failure = written.error().message;
      failed_ = true;
    } else {
      for (const Item& item : batch) count(item);
      written_ += batch.size();
      done.swap(batch);
      oldest_in_batch_ = Steady::time_point::max();
      if (failed_ || !done.empty()) state_.failure.clear();
      failed_ = false;
      // Seen also while nothing comes in, and over once the file is back.
      if (!misplaced.empty() || state_.failure == misplaced_) state_.failure = misplaced;
      misplaced_ = misplaced;
    }
    written_changed_.notify_all();
  }

  void count(const Item& item) {
    if (std::holds_alternative<FrameSnapshotPtr>(item)) {
      ++state_.frames;
      --waiting_frames_;
    } else if (std::holds_alternative<ReceivedPose>(item)) {
      ++state_.poses;
      --waiting_poses_;
    }
  }

  void close(const std::deque<Item>& batch) {
    std::uint64_t lost = 0;
    {
      const std::scoped_lock lock(mutex_);
      for (const std::deque<Item>* items : std::array<const std::deque<Item>*, 2>{&batch, &queue_})
        for (const Item& item : *items)
          if (item.index() < 2) ++state_.lost;  // a frame or a pose
      lost = state_.lost;
    }
    const Status closed = store_->without_connection([&] { return writer_->close(lost); });
    const std::scoped_lock lock(mutex_);
    queue_.clear();
    state_.take.clear();
    state_.bytes = writer_->bytes();
    if (closed) state_.file_bytes = state_.bytes;              // the log is in it
    if (state_.failure == misplaced_) state_.failure.clear();  // closing reports the result
    if (!closed && state_.failure.empty()) state_.failure = closed.error().message;
    if (!state_.failure.empty())
      finished_ =
          Error{state_.failure + (lost > 0 ? "; " + std::to_string(lost) + " frames and poses are missing"
                                           : std::string()),
                state_.path};
    else if (lost > 0)
      finished_ = Error{"the disk did not keep up: " + std::to_string(lost) + " frames and poses are missing",
                        state_.path};
    written_changed_.notify_all();
  }

 public:
  // What is done with each kind of item; called by std::visit on the writing thread.
  Status operator()(const FrameSnapshotPtr& frame) {
    const Status written = writer_->write(*frame);
    if (written && writer_->library_row() != library_row_) note_library();
    if (written && !std::exchange(has_frames_, true)) store_->set_first_frame(frame->index);
    return written;
  }
  Status operator()(const ReceivedPose& pose) { return writer_->write(pose); }
  Status operator()(const Markers& markers) { return writer_->write(markers); }
  Status operator()(const ProjectPtr& project) { return writer_->write(*project); }
  Status operator()(const EditTakes& takes) { return writer_->edit_takes(takes.edits); }
  Status operator()(const EndTake&) { return writer_->end_take(); }
  Status operator()(const BeginTake& take) {
    writer_->begin_take(take.name);
    return Done{};
  }
  Status operator()(const SetLibraryPath& path) {
    writer_->set_library_path(path.library, path.path);
    return Done{};
  }
  Status operator()(const SetFingerprint& known) {
    return writer_->set_fingerprint(known.library_row, known.fingerprint);
  }

 private:
  /// Before a frame of it can be read: it is not committed yet.
  void note_library() {
    library_row_ = writer_->library_row();
    if (!library_row_ || !writer_->library()) return;
    store_->set_library(*library_row_, writer_->library());
    unknown_.push_back({*library_row_, fingerprints_->of(writer_->library())});
  }

  /// A row whose library's fingerprint is not known yet.
  struct Unknown {
    std::int64_t library_row = 0;
    std::shared_future<std::string> fingerprint;
  };

  const RecorderOptions options_;
  const std::shared_ptr<LibraryFingerprints> fingerprints_;
  std::unique_ptr<SessionWriter> writer_;  ///< of the thread
  std::shared_ptr<RecordedFrames> store_;
  std::string misplaced_;                    ///< owned by the thread: reported at the last write
  bool failed_ = false;                      ///< of the thread: the last attempt to write
  bool has_frames_ = false;                  ///< of the thread
  std::optional<std::int64_t> library_row_;  ///< of the thread: of the newest frame
  std::vector<Unknown> unknown_;             ///< of the thread

  WakeUp wake_;
  mutable std::mutex mutex_;
  std::condition_variable written_changed_;
  std::deque<Item> queue_;
  std::size_t waiting_frames_ = 0, waiting_poses_ = 0;  ///< in the queue and in the running batch
  std::uint64_t pushed_ = 0, written_ = 0, attempts_ = 0;
  Steady::time_point oldest_in_queue_ = Steady::time_point::max();
  Steady::time_point oldest_in_batch_ = Steady::time_point::max();
  State state_;
  bool stopping_ = false, ended_ = false;

  std::mutex finish_mutex_;
  Status finished_ = Done{};
  std::thread thread_;
};

}  // namespace

Result<std::shared_ptr<Recorder>> Recorder::open(const std::string& path, const RecordingFacts& facts,
                                                 const RecorderOptions& options) {
  auto writer = SessionWriter::open(path, facts, options);
  if (!writer) return writer.error();
  auto store = RecordedFrames::open(path, (*writer)->origin());
  if (!store) return store.error();
  auto fingerprints = facts.fingerprints ? facts.fingerprints : std::make_shared<LibraryFingerprints>();
  return std::shared_ptr<Recorder>(std::make_shared<FileRecorder>(std::move(*writer), std::move(*store),
                                                                  std::move(fingerprints), options, path));
}

}  // namespace abrazo
