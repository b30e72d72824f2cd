#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <fstream>

#include "app/cli/export_parts.hpp"
#include "app/cli/session_reading.hpp"
#include "core/base/atomic_file.hpp"
#include "core/mesh/vtu_writer.hpp"
#include "core/session/recorded_frames.hpp"

namespace abrazo::app {

namespace {

/// Several files that appear together, when the last one is written.
class FileSeries {
 public:
  Status add(const std::string& path, const std::string& content) {
    AtomicFile& file = files_.emplace_back(path);
    std::ofstream out(file.partial(), std::ios::binary);
    out << content;
    out.close();
    if (!out) return Error{"could not be written whole; is the folder writable, the disk full?", path};
    paths_.push_back(path);
    return Done{};
  }
  Status commit() {
    for (AtomicFile& file : files_)
      if (const Status done = file.commit(); !done) return done;
    return Done{};
  }
  const std::vector<std::string>& paths() const { return paths_; }

 private:
  std::deque<AtomicFile> files_;
  std::vector<std::string> paths_;
};

/// "mesh_0007.vtu" of "mesh.pvd".
std::string numbered(const std::string& output, std::uint64_t number, std::uint64_t of) {
  const std::size_t digits = std::max<std::size_t>(4, std::to_string(of).size());
  return std::filesystem::path(output).replace_extension().string() +
         fmt::format("_{:0{}}.vtu", number, digits);
}

Result<std::string> mesh_text(const FrameSnapshot& frame, const SessionFile& file) {
  const FrameResult& result = frame.result;
  if (result.edges.empty())
    return Error{fmt::format("frame {} has no mesh: {}", frame.index, result.status_text()), file.path()};
  return write_vtu({frame.time_s, result.result, result.selected_pair, result.edges, result.tetrahedra,
                    result.edge_weights, result.edge_residuals_m});
}

/// The frame that --time or --frame name; the first one when neither does.
Result<std::uint64_t> chosen_frame(const SessionFile& file, const ExportWish& wish,
                                   const SessionRange& range) {
  if (wish.frame) {
    const auto index = static_cast<std::uint64_t>(*wish.frame);
    if (*wish.frame >= 0 && index >= range.first_frame && index <= range.last_frame) return index;
    return Error{fmt::format("has no frame {} there; they go from {} to {}", *wish.frame, range.first_frame,
                             range.last_frame),
                 file.path()};
  }
  if (!wish.time_s) return range.first_frame;
  if (*wish.time_s < range.from_s || *wish.time_s > range.to_s)
    return Error{fmt::format("has no frame at {:.3f} s; they go from {:.3f} to {:.3f} s", *wish.time_s,
                             range.from_s, range.to_s),
                 file.path()};
  std::uint64_t index = range.first_frame;
  const Status looked =
      file.each_source(range.from_s, *wish.time_s, [&](const SessionSource& frame) -> Status {
        index = frame.frame;
        return Done{};
      });
  if (!looked) return looked.error();
  return index;
}

/// Frames of a range with their meshes, one after another.
class MeshFrames {
 public:
  MeshFrames(const SessionFile& file, const std::string& library) : file_(file), libraries_(file, library) {}

  Result<FrameSnapshotPtr> read(const SessionSegment& segment, std::uint64_t index) {
    if (!frames_ || segment.library != library_) {
      const auto opened = libraries_.open(segment.library);
      if (!opened) return opened.error();
      auto frames = RecordedFrames::open(file_.path(), opened->library);
      if (!frames) return frames.error();
      frames_ = std::move(*frames);
      library_ = segment.library;
    }
    return frames_->frame(index);
  }

 private:
  const SessionFile& file_;
  SessionLibraries libraries_;
  const SessionLibrary* library_ = nullptr;
  std::shared_ptr<const RecordedFrames> frames_;
};

Result<Exported> export_one_mesh(const SessionFile& file, const ExportWish& wish, const SessionRange& range) {
  const auto index = chosen_frame(file, wish, range);
  if (!index) return index.error();
  const auto segments = session_segments(file, range);
  if (!segments) return segments.error();
  MeshFrames frames(file, wish.library);
  for (const SessionSegment& segment : *segments) {
    if (*index > segment.range.last_frame) continue;
    const auto frame = frames.read(segment, *index);
    if (!frame) return frame.error();
    if (!*frame) return Error{fmt::format("frame {} is not there or damaged", *index), file.path()};
    const auto text = mesh_text(**frame, file);
    if (!text) return text.error();
    if (const Status written = write_whole_file(wish.output, *text); !written) return written.error();
    Exported exported;
    exported.files = {wish.output};
    exported.text = fmt::format("frame {} at {:.3f} s, {} edges, {} tetrahedra", *index, (*frame)->time_s,
                                (*frame)->result.edges.size(), (*frame)->result.tetrahedra.size());
    exported.figures.key("frame").value(static_cast<long long>(*index));
    exported.figures.key("time_s").value((*frame)->time_s);
    exported.figures.key("edges").value(static_cast<long long>((*frame)->result.edges.size()));
    exported.figures.key("tetrahedra").value(static_cast<long long>((*frame)->result.tetrahedra.size()));
    return exported;
  }
  return Error{fmt::format("frame {} is not there", *index), file.path()};
}

/// Which frames a series has: all, or at the wanted rate those that were shown then.
struct SeriesClock {
  double rate_hz = 0;
  double next_s = 0;
  bool wants(double time_s) {
    if (rate_hz <= 0) return true;
    if (time_s + 1e-9 < next_s) return false;
    while (next_s <= time_s + 1e-9) next_s += 1 / rate_hz;
    return true;
  }
};

Result<Exported> export_mesh_series(CommandLine& line, const SessionFile& file, const ExportWish& wish,
                                    const SessionRange& range) {
  const auto segments = session_segments(file, range);
  if (!segments) return segments.error();
  const Progress progress = terminal_progress(line);
  const std::uint64_t of = range.last_frame - range.first_frame + 1;
  const std::string output = std::filesystem::path(wish.output).replace_extension(".pvd").string();
  MeshFrames frames(file, wish.library);
  FileSeries series;
  std::vector<SeriesFile> entries;
  std::uint64_t without = 0;
  SeriesClock clock{wish.rate_hz, range.from_s};
  for (const SessionSegment& segment : *segments)
    for (std::uint64_t index = segment.range.first_frame; index <= segment.range.last_frame; ++index) {
      if (!report(progress, static_cast<double>(index - range.first_frame) / static_cast<double>(of),
                  "meshes"))
        return Error{"cancelled", file.path()};
      const auto frame = frames.read(segment, index);
      if (!frame) return frame.error();
      if (!*frame || (*frame)->result.edges.empty()) {
        ++without;
        continue;
      }
      if (!clock.wants((*frame)->time_s)) continue;
      const auto text = mesh_text(**frame, file);
      if (!text) return text.error();
      const std::string path = numbered(output, entries.size() + 1, of);
      if (const Status added = series.add(path, *text); !added) return added.error();
      entries.push_back({(*frame)->time_s, std::filesystem::path(path).filename().string()});
    }
  report(progress, 1, "meshes");
  if (entries.empty()) return Error{"no frame there has a mesh", file.path()};
  if (const Status added = series.add(output, write_pvd(entries)); !added) return added.error();
  if (const Status done = series.commit(); !done) return done.error();
  if (without > 0)
    warn(line, fmt::format("{}: {} frames have no mesh and are left out", file.path(), without));
  Exported exported;
  exported.files = series.paths();
  exported.text = fmt::format("{} frames", entries.size());
  write_range(exported.figures, range);
  exported.figures.key("frames").value(static_cast<long long>(entries.size()));
  exported.figures.key("without_mesh").value(static_cast<long long>(without));
  return exported;
}

}  // namespace

Result<Exported> export_mesh(CommandLine& line, const SessionFile& file, const ExportWish& wish) {
  const auto range = session_range(file, wish.part);
  if (!range) return range.error();
  const bool one_chosen = wish.frame || wish.time_s;
  const bool part_chosen = wish.part.take || wish.part.from_s || wish.part.to_s;
  if (!one_chosen && (part_chosen || wish.output.ends_with(".pvd")))
    return export_mesh_series(line, file, wish, *range);
  if (!one_chosen)
    warn(line,
         "only the first frame is written; choose another with --time or --frame, or a series with "
         "--from, --to, --take or a name that ends with .pvd");
  return export_one_mesh(file, wish, *range);
}

}  // namespace abrazo::app
