#include <fmt/format.h>

#include <filesystem>

#include "core/base/atomic_file.hpp"
#include "core/base/file_series.hpp"
#include "core/mesh/vtu_writer.hpp"
#include "core/session/export/export_parts.hpp"
#include "core/session/export/export_plan.hpp"

namespace abrazo {

namespace {

/// "mesh_0007.vtu" of "mesh.pvd".
std::string numbered(const std::string& output, std::uint64_t number, std::uint64_t of) {
  const std::size_t digits = std::max<std::size_t>(4, std::to_string(of).size());
  return std::filesystem::path(output).replace_extension().string() +
         fmt::format("_{:0{}}.vtu", number, digits);
}

Result<std::string> mesh_text(const FrameSnapshot& frame, const SessionRecord& session) {
  const FrameResult& result = frame.result;
  if (result.edges.empty())
    return Error{fmt::format("frame {} has no mesh: {}", frame.index, result.status_text()), session.where()};
  return write_vtu({frame.time_s, result.result, result.selected_pair, result.edges, result.tetrahedra,
                    result.edge_weights, result.edge_residuals_m});
}

/// The frame that the wish names; the first one when it names none.
Result<std::uint64_t> chosen_frame(const SessionRecord& session, const ExportWish& wish,
                                   const SessionRange& range) {
  if (wish.at_frame) {
    const auto index = *wish.at_frame;
    if (index >= range.first_frame && index <= range.last_frame) return index;
    return Error{fmt::format("has no frame {} there; they go from {} to {}", index, range.first_frame,
                             range.last_frame),
                 session.where()};
  }
  if (!wish.at_s) return range.first_frame;
  if (*wish.at_s < range.from_s || *wish.at_s > range.to_s)
    return Error{fmt::format("has no frame at {:.3f} s; they go from {:.3f} to {:.3f} s", *wish.at_s,
                             range.from_s, range.to_s),
                 session.where()};
  std::uint64_t index = range.first_frame;
  const Status looked =
      session.each_source(range.from_s, *wish.at_s, [&](const SessionSource& frame) -> Status {
        index = frame.frame;
        return Done{};
      });
  if (!looked) return looked.error();
  return index;
}

Result<ExportReport> export_one_mesh(ExportSource& source, const ExportWish& wish,
                                     const SessionRange& range) {
  const SessionRecord& session = source.record();
  const auto index = chosen_frame(session, wish, range);
  if (!index) return index.error();
  const auto frame = source.with_mesh(*index);
  if (!frame) return frame.error();
  if (!*frame) return Error{fmt::format("frame {} is not there or damaged", *index), session.where()};
  const auto text = mesh_text(**frame, session);
  if (!text) return text.error();
  if (const Status written = write_whole_file(wish.output, *text); !written) return written.error();
  const FrameResult& result = (*frame)->result;
  ExportReport done;
  done.files = {wish.output};
  done.text = fmt::format("frame {} at {:.3f} s, {} edges, {} tetrahedra", *index, (*frame)->time_s,
                          result.edges.size(), result.tetrahedra.size());
  done.figures.key("frame").value(static_cast<long long>(*index));
  done.figures.key("time_s").value((*frame)->time_s);
  done.figures.key("edges").value(static_cast<long long>(result.edges.size()));
  done.figures.key("tetrahedra").value(static_cast<long long>(result.tetrahedra.size()));
  return done;
}

Result<ExportReport> export_mesh_series(ExportSource& source, const ExportWish& wish,
                                        const SessionRange& range, const Progress& progress) {
  const SessionRecord& session = source.record();
  const std::uint64_t of = range.last_frame - range.first_frame + 1;
  const std::string output = std::filesystem::path(wish.output).replace_extension(".pvd").string();
  FileSeries series;
  std::vector<SeriesFile> entries;
  std::uint64_t without = 0;
  SeriesClock clock{wish.rate_hz, range.from_s};
  for (std::uint64_t index = range.first_frame; index <= range.last_frame; ++index) {
    if (!report(progress, static_cast<double>(index - range.first_frame) / static_cast<double>(of),
                "Writing meshes"))
      return cancelled(session);
    const auto frame = source.with_mesh(index);
    if (!frame) return frame.error();
    if (!*frame || (*frame)->result.edges.empty()) {
      ++without;
      continue;
    }
    if (!clock.wants((*frame)->time_s)) continue;
    const auto text = mesh_text(**frame, session);
    if (!text) return text.error();
    const std::string path = numbered(output, entries.size() + 1, of);
    if (const Status added = series.add(path, *text); !added) return added.error();
    entries.push_back({(*frame)->time_s, std::filesystem::path(path).filename().string()});
  }
  report(progress, 1, "Writing meshes");
  if (entries.empty()) return Error{"no frame there has a mesh", session.where()};
  if (const Status added = series.add(output, write_pvd(entries)); !added) return added.error();
  if (const Status done = series.commit(); !done) return done.error();
  ExportReport done;
  if (without > 0)
    done.warnings.push_back(
        {fmt::format("{}: {} frames have no mesh and are left out", session.where(), without)});
  done.files = series.paths();
  done.text = fmt::format("{} frames", entries.size());
  write_range(done.figures, range);
  done.figures.key("frames").value(static_cast<long long>(entries.size()));
  done.figures.key("without_mesh").value(static_cast<long long>(without));
  return done;
}

}  // namespace

Result<ExportReport> export_mesh(ExportSource& source, const ExportWish& wish, const Progress& progress) {
  const SessionRecord& session = source.record();
  const auto range = session_range(session, wish.part);
  if (!range) return range.error();
  const bool part_chosen = wish.part.take || wish.part.from_s || wish.part.to_s;
  if (!wish.one_mesh() && (part_chosen || wish.output.ends_with(".pvd")))
    return export_mesh_series(source, wish, *range, progress);
  auto done = export_one_mesh(source, wish, *range);
  if (done && !wish.one_mesh())
    done->warnings.push_back(
        {"only the first frame is written; choose another, or a series by a part of the session or a name "
         "that "
         "ends with .pvd",
         Hint::ChooseFrames});
  return done;
}

}  // namespace abrazo
