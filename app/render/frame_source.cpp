#include "app/render/frame_source.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "core/base/text.hpp"
#include "core/opening/session_frames.hpp"
#include "core/session/frames/trace_frames.hpp"

namespace abrazo::app {
namespace {

Result<FrameSource> of_session(const std::string& file, const std::string& given) {
  const auto session = open_session_frames(file, given);
  if (!session) return session.error();
  // Bodies are drawn even without a library.
  FrameSource source;
  source.warnings = session->warnings;
  if (!session->libraries.empty()) source.library = session->libraries.back();
  const auto frames = session->frames;
  source.first_s = session->contents.first_s;
  source.last_s = session->contents.last_s;
  source.at = [frames, first_s = source.first_s, file](double time_s) -> Result<FrameSnapshotPtr> {
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
