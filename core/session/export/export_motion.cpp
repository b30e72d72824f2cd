#include <fmt/format.h>

#include <algorithm>

#include "core/base/output_file.hpp"
#include "core/motion/scenes/character_glb.hpp"
#include "core/session/export/export_parts.hpp"

namespace abrazo {

namespace {

std::string number_of(std::size_t count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

void warn_of_damage(ExportReport& report, const SessionRecord& session, const RowsRead& rows) {
  if (rows.damaged > 0)
    report.warnings.push_back({fmt::format("{}: {} frames could not be read and are left out; the first: {}",
                                           session.where(), rows.damaged, rows.damage)});
}

void warn_of_timing(ExportReport& report, const SessionRecord& session, const EvenTiming& timing) {
  if (timing.gaps > 0)
    report.warnings.push_back({fmt::format(
        "{}: {} interpolated across {}, from the pose before to the pose after; the longest gap is "
        "{:.3f} s, at {:.3f} s",
        session.where(), number_of(timing.bridged, "frame"), number_of(timing.gaps, "gap"),
        timing.longest_gap_s, timing.longest_gap_at_s)});
  if (timing.discarded > 0)
    report.warnings.push_back(
        {fmt::format("{}: {} poses are left out, whose time is not after that of the one before",
                     session.where(), timing.discarded)});
}

Result<SessionMotion> motion_of(const SessionRecord& session, const ExportWish& wish,
                                const Progress& progress) {
  if (wish.performer) return performer_motion(session, wish.part, *wish.performer, wish.rate_hz, progress);
  const auto range = session_range(session, wish.part);
  if (!range) return range.error();
  return session_motion(session, *range, wish.bodies, wish.rate_hz, progress);
}

/// The content of each file of the wish.
Result<std::vector<std::string>> contents_of(const SessionMotion& motion, const ExportWish& wish) {
  if (!wish.character.empty()) return character_performances(wish.character, motion.clips);
  auto content = clip_file_content(wish.output, motion.clips, wish.space);
  if (!content) return content.error();
  return std::vector{std::move(*content)};
}

}  // namespace

Result<ExportReport> export_motion(const ExportSource& source, const ExportWish& wish,
                                   const Progress& progress) {
  const SessionRecord& session = source.record();
  const auto motion = motion_of(session, wish, part(progress, 0, 0.6));
  if (!motion) return motion.error();
  ExportReport done;
  warn_of_damage(done, session, motion->rows);
  warn_of_timing(done, session, motion->timing);
  if (!report(progress, 0.6, "Putting the file together")) return cancelled(session);
  const auto contents = contents_of(*motion, wish);
  if (!contents) return contents.error();
  if (!report(progress, 0.9, "Writing")) return cancelled(session);
  done.files = wish.files();
  WholeFiles written;
  for (std::size_t i = 0; i < contents->size(); ++i)
    if (const Status added = written.add(done.files[i], (*contents)[i]); !added) return added.error();
  if (const Status named = written.commit(); !named) return named.error();
  const Clip& clip = motion->clips.front();
  done.text = fmt::format("{} frames at {:g} Hz", clip.poses.size(), clip.fps);
  done.figures.key("from_s").value(motion->timing.first_s);
  done.figures.key("to_s").value(motion->timing.first_s +
                                 static_cast<double>(clip.poses.size() - 1) / clip.fps);
  done.figures.key("frames").value(static_cast<long long>(clip.poses.size()));
  done.figures.key("rate_hz").value(clip.fps);
  done.figures.key("resampled").value(!motion->timing.unchanged);
  done.figures.key("gaps").value(static_cast<long long>(motion->timing.gaps));
  done.figures.key("longest_gap_s").value(motion->timing.longest_gap_s);
  done.figures.key("damaged").value(static_cast<long long>(motion->rows.damaged));
  return done;
}

}  // namespace abrazo
