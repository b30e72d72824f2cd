#include "core/opening/session_frames.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/opening/library_search.hpp"

namespace abrazo {

Result<SessionFrames> open_session_frames(const std::string& file, const std::string& library) {
  auto session = open_session(file);
  if (!session) return session.error();
  if (!session->has_frames()) return Error{"has no frames: nothing was recorded into it", file};
  SessionFrames opened{.file = file,
                       .contents = std::move(session->recording.contents),
                       .frames = session->recording.frames,
                       .libraries = {},
                       .warnings = {}};
  for (const std::string& sentence : session->recording.recovery)
    opened.warnings.push_back(file + ": " + sentence);
  auto libraries =
      LibrarySearch({file, opened.contents.libraries, session->project, library, {}}).all(opened.warnings);
  if (!libraries) return libraries.error();
  opened.libraries = std::move(*libraries);
  for (const auto& each : opened.libraries) opened.frames->add_library(each);
  return opened;
}

Result<FrameSnapshotPtr> SessionWalk::next() {
  while (next_ <= session_.contents.last_frame) {
    const std::uint64_t index = next_++;
    const std::uint64_t damaged = session_.frames->damaged();
    // Not frame(), which says of a damaged one only once that it is.
    std::vector<FrameSnapshotPtr> found = session_.frames->between(index, index, 1);
    if (!found.empty()) return std::move(found.front());
    if (session_.frames->damaged() > damaged)
      return Error{fmt::format("its frame {} cannot be read: {}", index, session_.frames->damage()),
                   session_.file};
  }
  return FrameSnapshotPtr();
}

}  // namespace abrazo
