#include <fmt/format.h>

#include "core/base/line_file.hpp"
#include "core/session/export/export_parts.hpp"

namespace abrazo {

Result<ExportReport> export_trace(ExportSource& source, const ExportWish& wish, const Progress& progress) {
  const SessionRecord& session = source.record();
  const auto range = session_range(session, wish.part);
  if (!range) return range.error();
  auto lines = LineFile::open(wish.output);
  if (!lines) return lines.error();
  const auto all = source.each_trace_line(
      *range,
      [&](const std::string& text) -> Status {
        (*lines)->add(text);
        if ((*lines)->good()) return Done{};
        return Error{"could not be written whole; is the disk full?", wish.output};
      },
      progress);
  if (!all) return all.error();
  const bool again = source.solves_again();
  const std::string how = again ? "solved again" : "written";
  if (all->frames == 0)
    return Error{fmt::format("none of the frames there can be {}: {}", how, all->note), session.where()};
  if (!report(progress, 1, "Writing")) return cancelled(session);
  if (const Status finished = (*lines)->finish(); !finished) return finished.error();
  ExportReport done;
  if (all->skipped > 0)
    done.warnings.push_back({fmt::format("{}: {} frames could not be {} and are left out: {}",
                                         session.where(), all->skipped, how, all->note)});
  if (all->differ > 0)
    done.warnings.push_back(
        {fmt::format("{}: {} of {} frames differ from what was recorded; they were recorded by another "
                     "version of the program or on another machine",
                     session.where(), all->differ, all->frames)});
  done.files = {wish.output};
  done.text =
      again ? fmt::format("{} frames solved again, {} as recorded", all->frames, all->frames - all->differ)
            : fmt::format("{} frames", all->frames);
  write_range(done.figures, *range);
  done.figures.key("frames").value(static_cast<long long>(all->frames));
  done.figures.key("differ").value(static_cast<long long>(all->differ));
  done.figures.key("skipped").value(static_cast<long long>(all->skipped));
  return done;
}

}  // namespace abrazo
