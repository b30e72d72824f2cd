#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/opening/opened_session.hpp"
#include "core/session/file/recorded_frames.hpp"

namespace abrazo {

/// The recorded frames of a session file, with those of its libraries that are at hand: without one its
/// frames have bodies and measures, and no mesh.
struct SessionFrames {
  std::string file;
  SessionContents contents;
  std::shared_ptr<RecordedFrames> frames;
  std::vector<std::shared_ptr<const MotionLibrary>> libraries;  ///< a given library comes last
  std::vector<std::string> warnings;  ///< what was recovered, and which library is missing or another
};

/// @param library  a library or manifest in the place of its own; empty = where the session says
/// @return an Error when nothing was recorded into it, or the given library cannot be read
Result<SessionFrames> open_session_frames(const std::string& file, const std::string& library = {});

/// Goes through the frames of a session in their order.
class SessionWalk {
 public:
  /// @param session  outlives the walk
  explicit SessionWalk(const SessionFrames& session)
      : session_(session), next_(session.contents.first_frame) {}

  /// The next frame that was kept; null behind the last. An Error names one that is there and cannot be read;
  /// the walk may go on behind it.
  Result<FrameSnapshotPtr> next();

 private:
  const SessionFrames& session_;
  std::uint64_t next_;
};

}  // namespace abrazo
