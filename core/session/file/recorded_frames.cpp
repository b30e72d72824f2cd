#include "core/session/file/recorded_frames.hpp"

#include <algorithm>
#include <list>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/mesh/laplacian.hpp"
#include "core/session/file/frame_reader.hpp"
#include "core/session/file/library_reference.hpp"
#include "core/session/file/session_schema.hpp"
#include "core/session/frames/frame_in_library.hpp"

namespace abrazo {

namespace {

/// Some 4 s at 120 Hz, 10 kB each.
constexpr std::size_t cached_frames = 512;
/// Damaged frames before a time, until one that can be read is looked for no longer: some 4 s, too.
constexpr std::int64_t most_passed_over = 512;
/// Of the whole file: several views request it in turn, and again after a change of library.
constexpr std::size_t kept_overview_frames = 4096;
/// Pieces up to this length are cached: several views read through a file in turn.
constexpr std::size_t cached_piece = cached_frames / 4;

using Library = std::shared_ptr<const MotionLibrary>;

/// What the file leaves out because the library has it.
void complete(FrameSnapshot& frame, const MotionLibrary& library) {
  FrameResult& result = frame.result;
  if (result.selected < 0) return;
  const int pair = result.candidates[static_cast<std::size_t>(result.selected)].pair;
  if (pair < 0 || pair >= library.pair_count()) return;
  const auto edges = library.edges(pair);
  const auto tetrahedra = library.tetrahedra(pair);
  result.edges.assign(edges.begin(), edges.end());
  result.tetrahedra.assign(tetrahedra.begin(), tetrahedra.end());
  const bool user_is_passive = frame.settings.user_role == UserRole::Passive;
  result.selected_pair = library.pair_in_world(pair, result.query_root, user_is_passive);
  if (result.status == StepStatus::Failed) return;
  Laplacian laplacian;
  laplacian.build(result.edges, result.selected_pair, frame.settings.edge_weights);
  const PairPose residuals = laplacian.apply(result.result - result.selected_pair);
  for (const MeshEdge& edge : result.edges) {
    result.edge_weights.push_back(0.5 *
                                  (laplacian.weight(edge[0], edge[1]) + laplacian.weight(edge[1], edge[0])));
    result.edge_residuals_m.push_back(0.5 * (residuals.row(edge[0]).norm() + residuals.row(edge[1]).norm()));
  }
}

/// The frames used last, by their index in the file.
class FrameCache {
 public:
  FrameSnapshotPtr find(std::int64_t index) {
    const auto found = places_.find(index);
    if (found == places_.end()) return nullptr;
    frames_.splice(frames_.begin(), frames_, found->second);
    return found->second->second;
  }
  void add(std::int64_t index, FrameSnapshotPtr frame) {
    frames_.emplace_front(index, std::move(frame));
    places_[index] = frames_.begin();
    if (frames_.size() <= cached_frames) return;
    places_.erase(frames_.back().first);
    frames_.pop_back();
  }
  void clear() {
    places_.clear();
    frames_.clear();
  }

 private:
  std::list<std::pair<std::int64_t, FrameSnapshotPtr>> frames_;
  std::unordered_map<std::int64_t, decltype(frames_)::iterator> places_;
};

class FileFrames : public RecordedFrames {
 public:
  FileFrames(std::string path, const Origin& origin)
      : path_(std::move(path)), origin_(origin), first_frame_(origin.first_frame) {}

  Status connect() {
    auto database = open_session_database(path_);
    return database ? connect(std::move(*database)) : Status(database.error());
  }

  Status connect(SessionDatabase database) {
    database_.emplace(std::move(database));
    auto reader = FrameReader::open(*database_);
    if (!reader) return reader.error();
    auto version = database_->prepare("PRAGMA data_version");
    if (!version) return version.error();
    reader_ = std::move(*reader);
    version_.emplace(std::move(*version));
    known_version_ = -1;
    return Done{};
  }

  Status without_connection(const std::function<Status()>& run) override {
    const std::scoped_lock lock(mutex_);
    version_.reset();
    reader_.reset();
    database_.reset();
    overview_ = {};
    Status done = run();
    if (const Status connected = connect(); !connected) note_damage(1, connected.error().message);
    return done;
  }

  void add_library(Library library) override {
    if (!library) return;
    const std::string fingerprint = library_fingerprint(*library);
    const std::scoped_lock lock(mutex_);
    libraries_[fingerprint] = std::move(library);
    by_id_.clear();
    cache_.clear();
    unreadable_.clear();
    overview_ = {};
  }

  void set_library(std::int64_t row, Library library) override {
    const std::scoped_lock lock(mutex_);
    by_row_[row] = std::move(library);
  }

  void set_first_frame(std::uint64_t index) override {
    const std::scoped_lock lock(mutex_);
    first_frame_ = index + origin_.offset_frames;
    known_version_ = -1;
    overview_ = {};
  }

  Span span() const override {
    // Readers of the extent do not wait for readers of a long range.
    const std::unique_lock reading(mutex_, std::try_to_lock);
    if (reading.owns_lock()) {
      const Span span = read_span();
      const std::scoped_lock lock(span_mutex_);
      return span_ = span;
    }
    const std::scoped_lock lock(span_mutex_);
    return span_;
  }

  FrameSnapshotPtr at(double time_s) const override {
    const std::scoped_lock lock(mutex_);
    if (!reader_) return nullptr;
    const auto index = noted(reader_->last_until(time_s + origin_.offset_s, first()));
    if (!index) return nullptr;
    for (std::int64_t near = *index; near >= first() && *index - near < most_passed_over; --near)
      if (FrameSnapshotPtr frame = read(near)) return frame;
    return nullptr;
  }

  FrameSnapshotPtr frame(std::uint64_t index) const override {
    const std::scoped_lock lock(mutex_);
    const auto in_file = static_cast<std::int64_t>(index + origin_.offset_frames);
    return !reader_ || in_file < first() ? nullptr : read(in_file);
  }

  std::vector<FrameSnapshotPtr> range(double from_s, double to_s, std::size_t most) const override {
    const std::scoped_lock lock(mutex_);
    if (!reader_) return {};
    const auto begin = noted(reader_->first_from(from_s + origin_.offset_s, first()));
    const auto end = noted(reader_->last_until(to_s + origin_.offset_s, first()));
    return begin && end ? read_between(*begin, *end, most) : std::vector<FrameSnapshotPtr>();
  }

  std::vector<FrameSnapshotPtr> between(std::uint64_t first_index, std::uint64_t last_index,
                                        std::size_t most) const override {
    const std::scoped_lock lock(mutex_);
    const Span span = read_span();
    if (!reader_ || span.frames == 0 || last_index < span.first_index) return {};
    const auto in_file = [&](std::uint64_t index) {
      return static_cast<std::int64_t>(std::clamp(index, span.first_index, span.last_index) +
                                       origin_.offset_frames);
    };
    if (first_index > span.last_index) return {};
    const std::int64_t begin = in_file(first_index), end = in_file(last_index);
    if (overview_.is(begin, end, most)) return overview_.frames;
    std::vector<FrameSnapshotPtr> frames = read_between(begin, end, most);
    if (begin == in_file(span.first_index) && end == in_file(span.last_index) && most <= kept_overview_frames)
      overview_ = {begin, end, most, frames};
    return frames;
  }

  std::vector<double> times(double from_s, double to_s) const override {
    constexpr double rounding_s = 1e-6;  // of the shifted bounds
    const std::scoped_lock lock(mutex_);
    if (!reader_) return {};
    auto found =
        reader_->times(from_s + origin_.offset_s - rounding_s, to_s + origin_.offset_s + rounding_s, first());
    if (!found) return note_damage(1, found.error().message), std::vector<double>();
    for (double& time_s : *found) time_s -= origin_.offset_s;
    std::erase_if(*found, [&](double time_s) { return time_s < from_s || time_s > to_s; });
    return std::move(*found);
  }

  bool is_kept(std::uint64_t first_index, std::uint64_t last_index, std::size_t most) const override {
    const std::scoped_lock lock(mutex_);
    return overview_.is(static_cast<std::int64_t>(first_index + origin_.offset_frames),
                        static_cast<std::int64_t>(last_index + origin_.offset_frames), most);
  }

  std::optional<std::uint64_t> state_before(std::uint64_t index) const override {
    const std::scoped_lock lock(mutex_);
    if (!reader_) return std::nullopt;
    const auto found =
        noted(reader_->state_before(static_cast<std::int64_t>(index + origin_.offset_frames), first()));
    if (!found) return std::nullopt;
    return static_cast<std::uint64_t>(*found) - origin_.offset_frames;
  }

  std::uint64_t damaged() const override {
    const std::scoped_lock lock(mutex_);
    return damaged_;
  }
  std::string damage() const override {
    const std::scoped_lock lock(mutex_);
    return damage_;
  }

 private:
  std::int64_t first() const { return static_cast<std::int64_t>(first_frame_); }

  void note_damage(std::uint64_t count, const std::string& why) const {
    damaged_ += count;
    if (damage_.empty()) damage_ = why;
  }

  /// What an index is, or nothing; that it could not be read is counted.
  std::optional<std::int64_t> noted(const Result<std::optional<std::int64_t>>& index) const {
    if (index) return *index;
    note_damage(1, index.error().message);
    return std::nullopt;
  }

  /// Of all up to a frame, thinned if they are more than `most`.
  struct Overview {
    std::int64_t begin = 0, end = -1;
    std::size_t most = 0;
    std::vector<FrameSnapshotPtr> frames;

    bool is(std::int64_t from, std::int64_t to, std::size_t at_most) const {
      const auto count = static_cast<std::size_t>(end - begin + 1);
      return !frames.empty() && from == begin && to == end &&
             (at_most == most || (count <= at_most && count <= most));
    }
  };

  Span read_span() const {
    if (!version_) return known_span_;
    // Another connection's commit changes the version; without one nothing is new.
    const auto stepped = version_->step();
    const std::int64_t version = stepped && *stepped ? version_->integer(0) : -1;
    version_->reset();
    if (version >= 0 && version == known_version_) return known_span_;
    Span span;
    const auto begin = noted(reader_->next(first()));
    const auto end = noted(reader_->last());
    if (begin && end && *end >= *begin) {
      span.first_index = static_cast<std::uint64_t>(*begin) - origin_.offset_frames;
      span.last_index = static_cast<std::uint64_t>(*end) - origin_.offset_frames;
      span.frames = static_cast<std::uint64_t>(*end - *begin + 1);
      const auto first_s = reader_->time_of(*begin), last_s = reader_->time_of(*end);
      span.first_s = (first_s ? first_s->value_or(0) : 0) - origin_.offset_s;
      span.last_s = (last_s ? last_s->value_or(0) : 0) - origin_.offset_s;
    }
    known_version_ = version;
    return known_span_ = span;
  }

  FrameSnapshotPtr finished(FrameReader::Read& read) const {
    FrameSnapshot& frame = *read.frame;
    if (read.library) {
      if (const Library library = library_of(*read.library)) {
        if (!has_pairs_of(*library, frame)) forget_pairs(frame);
        complete(frame, *library);
        frame.library = library;
      } else {
        frame.noted_pairs = noted_pairs_of(*read.library);
      }
    }
    frame.index -= origin_.offset_frames;
    frame.time_s -= origin_.offset_s;
    for (double* time : {&frame.times.arrived_s, &frame.times.assembled_s, &frame.times.taken_s,
                         &frame.times.solved_s, &frame.times.sent_s})
      if (*time >= 0) *time -= origin_.offset_s;
    return std::move(read.frame);
  }

  /// What is shown without them is still the poses that were recorded.
  void forget_pairs(FrameSnapshot& frame) const {
    note_damage(1, "frame " + std::to_string(frame.index) + " names pairs that its library does not have");
    frame.result.candidates.clear();
    frame.result.selected = -1;
    frame.before = nullptr;
  }

  FrameSnapshotPtr read(std::int64_t index) const {
    if (FrameSnapshotPtr known = cache_.find(index)) return known;
    if (unreadable_.contains(index)) return nullptr;
    auto found = reader_->frame(index);
    if (!found) {
      note_damage(1, found.error().message);
      unreadable_.insert(index);  // requested repeatedly by a parked view
      return nullptr;
    }
    if (!*found) return nullptr;
    FrameSnapshotPtr frame = finished(**found);
    cache_.add(index, frame);
    return frame;
  }

  std::vector<FrameSnapshotPtr> read_between(std::int64_t begin, std::int64_t end, std::size_t most) const {
    std::vector<FrameSnapshotPtr> frames;
    if (end < begin || most == 0) return frames;
    const auto count = static_cast<std::size_t>(end - begin) + 1;
    if (count <= most) {
      const bool is_piece = count <= cached_piece;
      if (is_piece && find_cached(begin, end, frames)) return frames;
      const auto pass = reader_->scan(begin, end, [&](FrameReader::Read& read) -> Status {
        frames.push_back(finished(read));
        const auto index = static_cast<std::int64_t>(frames.back()->index + origin_.offset_frames);
        if (is_piece && !cache_.find(index)) cache_.add(index, frames.back());
        return Done{};
      });
      if (!pass)
        note_damage(1, pass.error().message);
      else if (pass->damaged > 0)
        note_damage(pass->damaged, pass->damage);
      return frames;
    }
    for (std::size_t i = 0; i < most; ++i) {
      // Whole numbers of up to 2^53 frames times thousands still fit.
      const auto step = most > 1 ? i * (count - 1) / (most - 1) : count - 1;
      const std::int64_t index = begin + static_cast<std::int64_t>(step);
      if (FrameSnapshotPtr frame = most <= cached_piece ? read(index) : read_without_cache(index))
        frames.push_back(std::move(frame));
    }
    return frames;
  }

  /// @return whether all of them are cached; if not, `found` is empty
  bool find_cached(std::int64_t begin, std::int64_t end, std::vector<FrameSnapshotPtr>& found) const {
    for (std::int64_t index = begin; index <= end; ++index) {
      FrameSnapshotPtr known = cache_.find(index);
      if (!known) return found.clear(), false;
      found.push_back(std::move(known));
    }
    return true;
  }

  FrameSnapshotPtr read_without_cache(std::int64_t index) const {
    if (FrameSnapshotPtr known = cache_.find(index)) return known;
    auto found = reader_->frame(index);
    if (found && *found) return finished(**found);
    if (!found) note_damage(1, found.error().message);
    return nullptr;
  }

  /// The available library of a row of the file; null if there is none.
  Library library_of(std::int64_t id) const {
    if (const auto meant = by_row_.find(id); meant != by_row_.end()) return meant->second;
    if (const auto known = by_id_.find(id); known != by_id_.end()) return known->second;
    auto row = database_->prepare("SELECT fingerprint, pairs FROM libraries WHERE id = ?");
    Library found;
    if (row) {
      const auto stepped = row->bind(0, id).step();
      if (stepped && *stepped) {
        const std::string fingerprint = row->text(0);
        const auto exact = libraries_.find(fingerprint);
        if (exact != libraries_.end()) found = exact->second;
        for (const auto& [known, library] : libraries_)
          if (!found && (is_same_motion(known, fingerprint) ||
                         (!is_comparable(fingerprint) && library->pair_count() == row->integer(1))))
            found = library;
      }
    }
    return by_id_[id] = found;
  }

  /// What the file notes of the pairs of a library that is not at hand.
  std::shared_ptr<const NotedPairs> noted_pairs_of(std::int64_t id) const {
    std::shared_ptr<const NotedPairs>& known = noted_by_id_[id];
    if (known) return known;
    auto noted = std::make_shared<NotedPairs>();
    auto named = database_->prepare("SELECT name, absolute_path FROM libraries WHERE id = ?");
    if (named) {
      const auto row = named->bind(0, id).step();
      if (row && *row) noted->library = named->text(0), noted->file = named->text(1);
    }
    auto rows = database_->prepare("SELECT pair, take, frame, swapped, label FROM pairs WHERE library = ?");
    if (rows) {
      rows->bind(0, id);
      for (auto more = rows->step(); more && *more; more = rows->step())
        noted->by_number.insert_or_assign(static_cast<int>(rows->integer(0)),
                                          NotedPair{rows->text(1), static_cast<int>(rows->integer(2)),
                                                    rows->integer(3) != 0, rows->text(4)});
    }
    return known = std::move(noted);
  }

  const std::string path_;
  const Origin origin_;
  mutable std::mutex mutex_;                         ///< of all that follows but the span
  std::uint64_t first_frame_;                        ///< in the file
  mutable std::optional<SessionDatabase> database_;  ///< none when it could not be opened again
  std::unique_ptr<FrameReader> reader_;
  mutable std::optional<SessionStatement> version_;
  mutable FrameCache cache_;
  mutable std::unordered_set<std::int64_t> unreadable_;
  mutable Overview overview_;
  std::unordered_map<std::string, Library> libraries_;  ///< by fingerprint
  std::unordered_map<std::int64_t, Library> by_row_;    ///< that were said
  mutable std::unordered_map<std::int64_t, Library> by_id_;
  mutable std::unordered_map<std::int64_t, std::shared_ptr<const NotedPairs>> noted_by_id_;
  mutable std::uint64_t damaged_ = 0;
  mutable std::string damage_;
  mutable std::int64_t known_version_ = -1;
  mutable Span known_span_;

  mutable std::mutex span_mutex_;
  mutable Span span_;
};

}  // namespace

Result<std::shared_ptr<RecordedFrames>> RecordedFrames::open(const std::string& path,
                                                             std::shared_ptr<const MotionLibrary> library) {
  auto frames = open(path, Origin{});
  if (frames) (*frames)->add_library(std::move(library));
  return frames;
}

Result<std::shared_ptr<RecordedFrames>> RecordedFrames::over(SessionDatabase database) {
  auto frames = std::make_shared<FileFrames>(database.path(), Origin{});
  if (const Status connected = frames->connect(std::move(database)); !connected) return connected.error();
  return std::shared_ptr<RecordedFrames>(std::move(frames));
}

Result<std::shared_ptr<RecordedFrames>> RecordedFrames::open(const std::string& path, const Origin& origin) {
  auto frames = std::make_shared<FileFrames>(path, origin);
  if (const Status connected = frames->connect(); !connected) return connected.error();
  return std::shared_ptr<RecordedFrames>(std::move(frames));
}

}  // namespace abrazo
