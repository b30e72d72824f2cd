#include "core/session/run/history_keeper.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

#include "core/session/file/library_fingerprints.hpp"
#include "core/session/frames/joined_stores.hpp"
#include "core/session/run/recorder.hpp"

namespace abrazo {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t files_within_bound = 8;
constexpr double performance_pause_s = 1;  // of a performance

/// A store whose parts change: each call asks those of the moment.
class ChangingStore : public FrameStore {
 public:
  void set(std::shared_ptr<const FrameStore> now) {
    const std::scoped_lock lock(mutex_);
    now_ = std::move(now);
  }
  Span span() const override {
    const auto now = this->now();
    return now ? now->span() : Span{};
  }
  FrameSnapshotPtr at(double time_s) const override {
    const auto now = this->now();
    return now ? now->at(time_s) : nullptr;
  }
  FrameSnapshotPtr frame(std::uint64_t index) const override {
    const auto now = this->now();
    return now ? now->frame(index) : nullptr;
  }
  std::vector<FrameSnapshotPtr> range(double from_s, double to_s, std::size_t most) const override {
    const auto now = this->now();
    return now ? now->range(from_s, to_s, most) : std::vector<FrameSnapshotPtr>();
  }
  std::vector<FrameSnapshotPtr> between(std::uint64_t first, std::uint64_t last,
                                        std::size_t most) const override {
    const auto now = this->now();
    return now ? now->between(first, last, most) : std::vector<FrameSnapshotPtr>();
  }
  std::vector<double> times(double from_s, double to_s) const override {
    const auto now = this->now();
    return now ? now->times(from_s, to_s) : std::vector<double>();
  }
  std::optional<std::uint64_t> state_before(std::uint64_t index) const override {
    const auto now = this->now();
    return now ? now->state_before(index) : std::nullopt;
  }

 private:
  std::shared_ptr<const FrameStore> now() const {
    const std::scoped_lock lock(mutex_);
    return now_;
  }
  mutable std::mutex mutex_;
  std::shared_ptr<const FrameStore> now_;
};

void remove_session(const std::string& file) {
  std::error_code ignored;
  for (const char* end : {"", "-wal", "-shm"}) fs::remove(file + end, ignored);
}

class FolderKeeper : public HistoryKeeper {
 public:
  FolderKeeper(std::string folder, RecordingFacts facts, const HistoryBound& bound)
      : folder_(std::move(folder)), facts_(std::move(facts)), bound_(bound.bytes) {
    facts_.has_times_of_file = true;
    if (!facts_.fingerprints) facts_.fingerprints = std::make_shared<LibraryFingerprints>();
    if (bound.tend_every_s > 0)
      thread_ = std::jthread([this, every_s = bound.tend_every_s](const std::stop_token& stop) {
        std::mutex sleeping;
        std::unique_lock lock(sleeping);
        std::condition_variable_any wake;
        while (!wake.wait_for(lock, stop, std::chrono::duration<double>(every_s),
                              [&] { return stop.stop_requested(); }))
          tend();
      });
  }
  ~FolderKeeper() override {
    thread_ = {};  // joined before what it uses goes
    (void)ended(std::exchange(writing_, nullptr));
  }

  void frame_solved(const FrameSnapshotPtr& frame) override {
    const std::scoped_lock lock(mutex_);
    if (!writing_) return;
    writing_->frame_solved(frame);
    if (!is_recorded_ && frame->times.arrived_s >= 0) note_performed(*frame);
  }

  void rest(std::shared_ptr<const FrameStore> recorded) override {
    const std::scoped_lock changing(changing_);
    rests_for_ = recorded;
    parts_.push_back({std::move(recorded), {}, 0});
    show_parts();
    set_recorded(true);
  }

  Status go_on() override {
    const std::scoped_lock changing(changing_);
    rests_for_ = nullptr;
    set_recorded(false);
    return begin_file();
  }

  void tend() override {
    const std::scoped_lock changing(changing_);
    // Until its first frame is there, both keep them: none falls between.
    if (rests_for_ && writing_ && rests_for_->span().frames > 0) write_to(nullptr);
    const std::uint64_t bytes = writing_ ? writing_->state().bytes : 0;
    if (writing_ && bytes >= bound() / files_within_bound) (void)begin_file();
    while (bytes_on_disk() > bound() && remove_oldest()) continue;
    note_state();
  }

  void set_bound(std::uint64_t bytes) override {
    const std::scoped_lock lock(mutex_);
    bound_ = bytes;
  }

  State state() const override {
    const std::scoped_lock lock(mutex_);
    State state = state_;
    state.bound = bound_;
    return state;
  }

  double kept_after_s(double time_s) const override {
    const std::scoped_lock changing(changing_);
    double seconds = 0;
    for (const Part& part : parts_) {
      if (part.file.empty()) continue;
      const FrameStore::Span span = part.frames->span();
      if (span.frames > 0) seconds += std::max(0.0, span.last_s - std::max(span.first_s, time_s));
    }
    return seconds;
  }

  double performed_after_s(double time_s) const override {
    const std::scoped_lock lock(mutex_);
    double seconds = 0;
    for (const Stretch& each : performed_)
      seconds += std::max(0.0, each.to_s - std::max(each.from_s, time_s));
    return seconds;
  }

  std::shared_ptr<const FrameStore> store() const override { return store_; }

  void remove() override {
    const std::scoped_lock changing(changing_);
    write_to(nullptr);
    store_->set(nullptr);
    for (const Part& part : parts_)
      if (!part.file.empty()) remove_session(part.file);
    parts_.clear();
    std::error_code ignored;
    fs::remove(folder_, ignored);
  }

  /// Every change of the parts is made by one thread at a time.
  Status begin_file() {
    std::string file;
    do file = (fs::path(folder_) / (std::to_string(++number_) + ".abrazo")).string();
    while (fs::exists(file));
    auto opened = Recorder::open(file, facts_);
    if (!opened) {
      trouble_ = opened.error().text();
      note_state();
      return opened.error();
    }
    trouble_.clear();
    parts_.push_back({(*opened)->store(), file, 0});
    show_parts();
    write_to(std::move(*opened), file);
    note_state();
    return Done{};
  }

 private:
  struct Part {
    std::shared_ptr<const FrameStore> frames;
    std::string file;         ///< empty: of a recorder, which keeps it
    std::uint64_t bytes = 0;  ///< once it is complete
  };
  struct Stretch {
    double from_s = 0, to_s = 0;
    std::uint64_t last = 0;  ///< index
  };

  void note_performed(const FrameSnapshot& frame) {
    Stretch* open = performed_.empty() ? nullptr : &performed_.back();
    if (!open || frame.index != open->last + 1 || frame.time_s - open->to_s > performance_pause_s)
      open = &performed_.emplace_back(Stretch{frame.time_s, frame.time_s, frame.index});
    open->to_s = std::max(open->to_s, frame.time_s);
    open->last = frame.index;
  }

  void set_recorded(bool on) {
    const std::scoped_lock lock(mutex_);
    is_recorded_ = on;
  }

  /// The new file has the next frame; the old one gets what still waits.
  void write_to(std::shared_ptr<Recorder> next, const std::string& file = {}) {
    const std::string complete = std::exchange(writing_file_, file);
    std::shared_ptr<Recorder> before;
    {
      const std::scoped_lock lock(mutex_);
      before = std::exchange(writing_, std::move(next));
    }
    if (!before) return;
    const std::uint64_t bytes = ended(before);
    for (Part& part : parts_)
      if (part.file == complete) part.bytes = bytes;
  }

  static std::uint64_t ended(const std::shared_ptr<Recorder>& recorder) {
    if (!recorder) return 0;
    (void)recorder->finish();
    return recorder->state().bytes;
  }

  void show_parts() {
    std::shared_ptr<const FrameStore> joined;
    for (const Part& part : parts_) joined = joined_stores(joined, part.frames);
    store_->set(joined);
  }

  std::uint64_t bytes_on_disk() const {
    std::uint64_t bytes = writing_ ? writing_->state().bytes : 0;
    for (const Part& part : parts_) bytes += part.bytes;
    return bytes;
  }

  bool remove_oldest() {
    const auto oldest =
        std::ranges::find_if(parts_, [&](const Part& part) { return !part.file.empty() && part.bytes > 0; });
    if (oldest == parts_.end()) return false;
    const std::string file = oldest->file;
    parts_.erase(oldest);
    show_parts();
    remove_session(file);
    const std::scoped_lock lock(mutex_);
    ++state_.removed_files;
    return true;
  }

  void note_state() {
    const std::uint64_t bytes = bytes_on_disk();
    const std::string failure = writing_ ? writing_->state().failure : std::string();
    const std::scoped_lock lock(mutex_);
    state_.bytes = bytes;
    state_.failure = trouble_.empty() ? failure : trouble_;
  }

  std::uint64_t bound() const {
    const std::scoped_lock lock(mutex_);
    return bound_;
  }

  const std::string folder_;
  RecordingFacts facts_;
  mutable std::mutex changing_;  ///< of the parts
  std::vector<Part> parts_;
  std::shared_ptr<const FrameStore> rests_for_;
  std::string writing_file_, trouble_;
  std::uint64_t number_ = 0;
  const std::shared_ptr<ChangingStore> store_ = std::make_shared<ChangingStore>();

  mutable std::mutex mutex_;  ///< short: the solver waits for it
  std::uint64_t bound_;
  State state_;
  std::vector<Stretch> performed_;     ///< frames of a live performer that no recorder has
  bool is_recorded_ = false;           ///< a recorder has the frames, those of its beginning as well
  std::shared_ptr<Recorder> writing_;  ///< changed under both
  std::jthread thread_;                // last: joined first
};

}  // namespace

Result<std::shared_ptr<HistoryKeeper>> HistoryKeeper::open(const std::string& folder,
                                                           const RecordingFacts& facts,
                                                           const HistoryBound& bound) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) return Error{"the folder for the history cannot be made: " + failure.message(), folder};
  auto keeper = std::make_shared<FolderKeeper>(folder, facts, bound);
  if (const Status begun = keeper->begin_file(); !begun) return begun.error();
  return std::shared_ptr<HistoryKeeper>(std::move(keeper));
}

}  // namespace abrazo
