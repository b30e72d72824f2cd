#include "app/render/frame_source.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "core/base/text.hpp"
#include "core/opening/library_search.hpp"
#include "core/opening/opened_session.hpp"
#include "core/session/frames/trace_frames.hpp"

namespace abrazo::app {
namespace {

Result<FrameSource> of_session(const std::string& file, const std::string& given) {
  const auto session = open_session(file);
  if (!session) return session.error();
  if (!session->has_frames()) return Error{"has no frames: nothing was recorded into it", file};
  const SessionContents& contents = session->recording.contents;
  FrameSource source;
  for (const std::string& sentence : session->recording.recovery)
    source.warnings.push_back(file + ": " + sentence);
  // Bodies are drawn also where a library is not at hand.
  const auto libraries =
      LibrarySearch({file, contents.libraries, session->project, given, {}}).all(source.warnings);
  if (!libraries) return libraries.error();
  if (!libraries->empty()) source.library = libraries->back();
  const auto frames = session->recording.frames;
  for (const auto& library : *libraries) frames->add_library(library);
  source.first_s = contents.first_s;
  source.last_s = contents.last_s;
  source.at = [frames, first_s = contents.first_s, file](double time_s) -> Result<FrameSnapshotPtr> {
    if (FrameSnapshotPtr frame = frames->at(std::max(time_s, first_s))) return frame;
    const std::string why = frames->damage();
    return Error{
        fmt::format("its frame at {:.3f} s cannot be read{}{}; render the parts before and behind it "
                    "with --to and --from",
                    time_s, why.empty() ? "" : ": ", why),
        file};
  };
  return source;
}

Result<FrameSource> of_trace(const std::string& file, const Progress& progress) {
  auto opened = TraceFrames::open(file, progress);
  if (!opened) return opened.error();
  auto frames = std::make_shared<TraceFrames>(std::move(opened).value());
  FrameSource source;
  source.first_s = frames->times_s().front();
  source.last_s = frames->times_s().back();
  source.at = [frames](double time_s) { return frames->at(time_s); };
  return source;
}

}  // namespace

Result<FrameSource> open_frames(const std::string& file, const std::string& library,
                                const Progress& progress) {
  const std::string extension = lower_case(std::filesystem::path(file).extension().string());
  if (extension == ".abrazo") return of_session(file, library);
  if (extension != ".jsonl")
    return Error{"is neither a session (.abrazo) nor a trace (.jsonl, abrazo synth --trace)", file};
  if (!library.empty()) return Error{"--library is for sessions; a trace has its meshes in it", file};
  return of_trace(file, progress);
}

}  // namespace abrazo::app
