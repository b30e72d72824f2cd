#include "core/session/export/export_source.hpp"

#include <limits>
#include <stdexcept>
#include <utility>

#include "core/annotation/annotated_library.hpp"
#include "core/session/export/history_record.hpp"
#include "core/session/export/library_take_record.hpp"
#include "core/session/export/session_tiers.hpp"
#include "core/session/file/recorded_frames.hpp"
#include "core/synthesis/frames/trace.hpp"

namespace abrazo {

namespace {

class FileExport : public ExportSource {
 public:
  FileExport(std::shared_ptr<const SessionFile> file, LibraryOpener libraries)
      : file_(std::move(file)), open_library_(std::move(libraries)) {}

  const SessionRecord& record() const override { return *file_; }
  bool solves_again() const override { return true; }

  Result<FrameSnapshotPtr> with_mesh(std::uint64_t index) override {
    const SessionLibrary* library = library_at(index);
    if (!frames_ || library != library_) {
      const auto opened = open_library_(library);
      if (!opened) return opened.error();
      auto frames = RecordedFrames::open(file_->path(), opened->library);
      if (!frames) return frames.error();
      frames_ = std::move(*frames);
      library_ = library;
    }
    return frames_->frame(index);
  }

  Result<SessionReplay> each_trace_line(const SessionRange& range,
                                        const std::function<Status(const std::string&)>& line,
                                        const Progress& progress) override {
    const auto segments = session_segments(*file_, range);
    if (!segments) return segments.error();
    SessionReplay all;
    for (std::size_t s = 0; s < segments->size(); ++s) {
      const SessionSegment& segment = (*segments)[s];
      const auto opened = open_library_(segment.library);
      if (!opened) return opened.error();
      if (s == 0) {
        const auto header = session_trace_header(*file_, opened->name, range);
        if (!header) return header.error();
        if (const Status added = line(*header); !added) return added.error();
      }
      const auto count = static_cast<double>(segments->size());
      const auto replay =
          session_trace(*file_, opened->library, segment.range, line,
                        part(progress, static_cast<double>(s) / count, static_cast<double>(s + 1) / count));
      if (!replay) return replay.error();
      all.frames += replay->frames;
      all.differ += replay->differ;
      all.skipped += replay->skipped;
      if (all.note.empty()) all.note = replay->note;
    }
    return all;
  }

  Result<std::vector<Tier>> tiers(const SessionRange& range) const override {
    return session_tiers(*file_, range);
  }

 private:
  const SessionLibrary* library_at(std::uint64_t index) const {
    const SessionLibrary* found = nullptr;
    for (const SessionLibrary& library : file_->contents().libraries)
      if (library.first_frame <= index) found = &library;
    return found;
  }

  std::shared_ptr<const SessionFile> file_;
  LibraryOpener open_library_;
  const SessionLibrary* library_ = nullptr;
  std::shared_ptr<const RecordedFrames> frames_;
};

/// Lines of frames that are already complete.
Result<SessionReplay> trace_lines(const SessionRecord& session, const SessionRange& range,
                                  const std::function<Status(const std::string&)>& line,
                                  const Progress& progress) {
  SessionReplay done;
  const double length_s = std::max(1e-9, range.to_s - range.from_s);
  const auto pass = session.each_frame(range.from_s, range.to_s, [&](const FrameSnapshot& frame) -> Status {
    if (!report(progress, (frame.time_s - range.from_s) / length_s, "Writing the trace"))
      return Error{"cancelled; nothing was written", session.where()};
    if (!frame.library) {
      ++done.skipped;
      done.note = "the library that they were solved with is no longer open";
      return Done{};
    }
    ++done.frames;
    const long long number = frame.input_frame >= 0 ? frame.input_frame : static_cast<long long>(frame.index);
    return line(trace_frame_line(frame.result, *frame.library, number, frame.time_s));
  });
  if (!pass) return pass.error();
  done.skipped += pass->damaged;
  if (pass->damaged > 0) done.note = pass->damage;
  return done;
}

class HistoryExport : public ExportSource {
 public:
  explicit HistoryExport(std::unique_ptr<HistoryRecord> record) : record_(std::move(record)) {}

  const SessionRecord& record() const override { return *record_; }
  Result<FrameSnapshotPtr> with_mesh(std::uint64_t index) override { return record_->frame(index); }
  Result<SessionReplay> each_trace_line(const SessionRange& range,
                                        const std::function<Status(const std::string&)>& line,
                                        const Progress& progress) override {
    const auto header = session_trace_header(*record_, record_->library_name(), range);
    if (!header) return header.error();
    if (const Status added = line(*header); !added) return added.error();
    return trace_lines(*record_, range, line, progress);
  }
  Result<std::vector<Tier>> tiers(const SessionRange& range) const override {
    return session_tiers(*record_, range);
  }

 private:
  std::unique_ptr<HistoryRecord> record_;
};

class TakeExport : public ExportSource {
 public:
  TakeExport(const std::shared_ptr<const MotionLibrary>& library, const std::string& take,
             std::vector<Tier> noted)
      : record_(library, take,
                noted.empty() ? tiers_of(annotations_of_take(*library, take)) : std::move(noted)) {}

  const SessionRecord& record() const override { return record_; }
  Result<FrameSnapshotPtr> with_mesh(std::uint64_t index) override { return record_.frame(index); }
  Result<SessionReplay> each_trace_line(const SessionRange&, const std::function<Status(const std::string&)>&,
                                        const Progress&) override {
    return Error{"is a recorded take, which was not solved; a trace is of a session", record_.where()};
  }
  Result<std::vector<Tier>> tiers(const SessionRange& range) const override {
    // A part ends with its last frame; the whole take extends to its last annotation.
    constexpr double all_s = std::numeric_limits<double>::infinity();
    const SessionContents& contents = record_.contents();
    const double from_s = range.from_s > contents.first_s ? range.from_s : -all_s;
    const double to_s = range.to_s < contents.last_s ? range.to_s + record_.frame_s() : all_s;
    std::vector<Tier> tiers = contents.annotations;
    for (Tier& tier : tiers) tier.intervals = intervals_within(std::move(tier.intervals), from_s, to_s);
    return tiers;
  }

 private:
  LibraryTakeRecord record_;
};

}  // namespace

std::unique_ptr<ExportSource> export_of_file(std::shared_ptr<const SessionFile> file,
                                             LibraryOpener libraries) {
  return std::make_unique<FileExport>(std::move(file), std::move(libraries));
}

Result<std::unique_ptr<ExportSource>> export_of_history(RunningExport running, const Progress& progress) {
  auto record = HistoryRecord::create(std::move(running), progress);
  if (!record) return record.error();
  return std::unique_ptr<ExportSource>(std::make_unique<HistoryExport>(std::move(*record)));
}

std::unique_ptr<ExportSource> export_of_take(std::shared_ptr<const MotionLibrary> library,
                                             const std::string& take, std::vector<Tier> noted) {
  return std::make_unique<TakeExport>(library, take, std::move(noted));
}

}  // namespace abrazo
