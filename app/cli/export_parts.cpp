#include "app/cli/export_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli/clip_file.hpp"
#include "app/cli/interruption.hpp"
#include "app/cli/line_file.hpp"
#include "app/cli/session_reading.hpp"
#include "core/base/atomic_file.hpp"
#include "core/library/eaf_file.hpp"
#include "core/session/session_tiers.hpp"

namespace abrazo::app {

namespace {

void warn_of_damage(CommandLine& line, const SessionFile& file, std::uint64_t damaged,
                    const std::string& why) {
  if (damaged > 0)
    warn(line, fmt::format("{}: {} frames could not be read and are left out; the first: {}", file.path(),
                           damaged, why));
}

void warn_of_timing(CommandLine& line, const SessionFile& file, const EvenPoses& timing) {
  if (timing.gaps > 0)
    warn(line, fmt::format("{}: {} gaps are bridged from the pose before to the pose after; the longest is "
                           "{:.3f} s, at {:.3f} s",
                           file.path(), timing.gaps, timing.longest_gap_s, timing.longest_gap_at_s));
  if (timing.discarded > 0)
    warn(line, fmt::format("{}: {} poses are left out, whose time is not after that of the one before",
                           file.path(), timing.discarded));
}

}  // namespace

Result<Exported> export_motion(CommandLine& line, const SessionFile& file, const ExportWish& wish) {
  std::vector<SessionBody> bodies;
  for (const std::string& what : wish.what)
    bodies.push_back(what == "user"     ? SessionBody::User
                     : what == "active" ? SessionBody::Active
                                        : SessionBody::Passive);
  Result<SessionMotion> motion = Error{"", ""};
  if (wish.performer.empty()) {
    const auto range = session_range(file, wish.part);
    if (!range) return range.error();
    motion = session_motion(file, *range, bodies, wish.rate_hz);
  } else {
    motion = performer_motion(file, wish.part, wish.performer, wish.rate_hz);
  }
  if (!motion) return motion.error();
  warn_of_damage(line, file, motion->rows.damaged, motion->rows.damage);
  warn_of_timing(line, file, motion->timing);
  if (interrupted()) return Error{"cancelled", file.path()};
  if (const Status written = write_clip_file(wish.output, motion->clips); !written) return written.error();
  const Clip& clip = motion->clips.front();
  Exported exported;
  exported.files = {wish.output};
  exported.text = fmt::format("{} frames at {:g} Hz", clip.poses.size(), clip.fps);
  exported.figures.key("from_s").value(motion->timing.first_s);
  exported.figures.key("to_s").value(motion->timing.first_s +
                                     static_cast<double>(clip.poses.size() - 1) / clip.fps);
  exported.figures.key("frames").value(static_cast<long long>(clip.poses.size()));
  exported.figures.key("rate_hz").value(clip.fps);
  exported.figures.key("resampled").value(!motion->timing.unchanged);
  exported.figures.key("gaps").value(static_cast<long long>(motion->timing.gaps));
  exported.figures.key("longest_gap_s").value(motion->timing.longest_gap_s);
  exported.figures.key("damaged").value(static_cast<long long>(motion->rows.damaged));
  return exported;
}

Result<Exported> export_labels(CommandLine&, const SessionFile& file, const ExportWish& wish) {
  const auto range = session_range(file, wish.part);
  if (!range) return range.error();
  const auto tiers = session_tiers(file, *range);
  if (!tiers) return tiers.error();
  Result<std::string> content = std::string();
  if (wish.output.ends_with(".eaf")) {
    const auto& runs = file.contents().runs;
    content = write_eaf(
        *tiers, {file.contents().program, runs.empty() ? "1970-01-01T00:00:00Z" : runs.front().begun_at});
  } else if (wish.output.ends_with(".csv")) {
    content = session_labels_csv(file, *range, wish.rate_hz);
  } else {
    content = tiers_json(*tiers);
  }
  if (!content) return content.error();
  if (const Status written = write_whole_file(wish.output, *content); !written) return written.error();
  Exported exported;
  exported.files = {wish.output};
  write_range(exported.figures, *range);
  exported.figures.key("tiers").begin_array();
  for (const Tier& tier : *tiers) {
    exported.text +=
        fmt::format("{}{} {}", exported.text.empty() ? "" : ", ", tier.intervals.size(), tier.name);
    exported.figures.begin_object().key("name").value(tier.name);
    exported.figures.key("intervals").value(static_cast<long long>(tier.intervals.size())).end_object();
  }
  exported.figures.end_array();
  if (wish.output.ends_with(".csv")) {
    const auto lines = std::count(content->begin(), content->end(), '\n') - 1;
    exported.text = fmt::format("{} moves", lines);
    exported.figures.key("moves").value(static_cast<long long>(lines));
  }
  return exported;
}

Result<Exported> export_trace(CommandLine& line, const SessionFile& file, const ExportWish& wish) {
  const auto range = session_range(file, wish.part);
  if (!range) return range.error();
  const auto segments = session_segments(file, *range);
  if (!segments) return segments.error();
  SessionLibraries libraries(file, wish.library);
  auto lines = LineFile::open(wish.output);
  if (!lines) return lines.error();
  SessionReplay all;
  for (std::size_t s = 0; s < segments->size(); ++s) {
    const SessionSegment& segment = (*segments)[s];
    const auto opened = libraries.open(segment.library);
    if (!opened) return opened.error();
    if (s == 0) {
      const auto header = session_trace_header(file, opened->path, *range);
      if (!header) return header.error();
      (*lines)->add(*header);
    }
    const auto count = static_cast<double>(segments->size());
    const auto replay = session_trace(
        file, opened->library, segment.range,
        [&](const std::string& text) -> Status {
          (*lines)->add(text);
          if ((*lines)->good()) return Done{};
          return Error{"could not be written whole; is the disk full?", wish.output};
        },
        part(terminal_progress(line), static_cast<double>(s) / count, static_cast<double>(s + 1) / count));
    if (!replay) return replay.error();
    all.frames += replay->frames;
    all.differ += replay->differ;
    all.skipped += replay->skipped;
    if (all.note.empty()) all.note = replay->note;
  }
  if (all.frames == 0) return Error{"none of the frames there can be solved again: " + all.note, file.path()};
  if (const Status finished = (*lines)->finish(); !finished) return finished.error();
  if (all.skipped > 0)
    warn(line, fmt::format("{}: {} frames could not be solved again and are left out: {}", file.path(),
                           all.skipped, all.note));
  if (all.differ > 0)
    warn(line, fmt::format("{}: {} of {} frames differ from what was recorded; they were recorded by another "
                           "version of the program or on another machine",
                           file.path(), all.differ, all.frames));
  Exported exported;
  exported.files = {wish.output};
  exported.text = fmt::format("{} frames solved again, {} as recorded", all.frames, all.frames - all.differ);
  write_range(exported.figures, *range);
  exported.figures.key("frames").value(static_cast<long long>(all.frames));
  exported.figures.key("differ").value(static_cast<long long>(all.differ));
  exported.figures.key("skipped").value(static_cast<long long>(all.skipped));
  return exported;
}

}  // namespace abrazo::app
