#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/motion/body/clip.hpp"
#include "core/motion/body/resample.hpp"
#include "core/session/file/session_file.hpp"
#include "core/session/run/session_replay.hpp"

namespace abrazo {

/// Which part of a session is wanted; what is not given is not limited.
struct SessionPart {
  std::optional<std::string> take;
  std::optional<double> from_s, to_s;  ///< time in the session; within the take when there is one
};

/// A stretch of a session that has frames.
struct SessionRange {
  double from_s = 0, to_s = 0;                    ///< time in the session, both included
  std::uint64_t first_frame = 0, last_frame = 0;  ///< those of the session that lie at its ends
};

/// The Error names the takes there are, or the time that the session spans.
Result<SessionRange> session_range(const SessionRecord& session, const SessionPart& part);

enum class SessionBody { User, Active, Passive };

/// Bodies of a session at even times.
struct SessionMotion {
  std::vector<Clip> clips;  ///< of equal length and rate
  EvenPoses timing;         ///< of the first one, without its poses: what was bridged
  RowsRead rows;
};

/// The user as the solver got it, and the two bodies as it gave them.
/// @param rate_hz  0 = that of the frames (median)
Result<SessionMotion> session_motion(const SessionRecord& session, const SessionRange& range,
                                     std::span<const SessionBody> bodies, double rate_hz,
                                     const Progress& progress = {});

/// What was received of a performer, whether it was solved or not.
/// @param performer  name; empty = the only one. The Error names those there are
Result<SessionMotion> performer_motion(const SessionRecord& session, const SessionPart& part,
                                       const std::string& performer, double rate_hz,
                                       const Progress& progress = {});

/// A part of a range that was solved with one library.
struct SessionSegment {
  const SessionLibrary* library = nullptr;  ///< of the contents; null when it names none
  SessionRange range;
};

/// The parts of a range by library, in order.
Result<std::vector<SessionSegment>> session_segments(const SessionRecord& session, const SessionRange& range);

/// First line of a trace of a range (docs/guide/command-line.md, Trace).
Result<std::string> session_trace_header(const SessionRecord& session, const std::string& library_name,
                                         const SessionRange& range);

/// The lines that follow it, without their ends: the frames solved again (see re_solve_session). Frames of a
/// clip are numbered as the clip's, others by their index in the session.
Result<SessionReplay> session_trace(const SessionRecord& session,
                                    std::shared_ptr<const MotionLibrary> library, const SessionRange& range,
                                    const std::function<Status(const std::string&)>& each_line,
                                    const Progress& progress = {});

}  // namespace abrazo
