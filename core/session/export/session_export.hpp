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

/// A part of a session to export; a field that is not set does not limit it.
struct SessionPart {
  std::optional<std::string> take;
  std::optional<double> from_s, to_s;  ///< time in the session, or in the take if one is given
};

/// A stretch of a session with frames.
struct SessionRange {
  double from_s = 0, to_s = 0;                    ///< time in the session, both included
  std::uint64_t first_frame = 0, last_frame = 0;  ///< at its ends, by index in the session
};

/// The Error lists the existing takes, or the time that the session spans.
Result<SessionRange> session_range(const SessionRecord& session, const SessionPart& part);

enum class SessionBody { User, Active, Passive };

/// Bodies of a session, resampled at a constant rate.
struct SessionMotion {
  std::vector<Clip> clips;  ///< of equal length and rate
  EvenTiming timing;        ///< of the clips
  RowsRead rows;
};

/// The user as given to the solver, and the two bodies of the result.
/// @param rate_hz 0 = median rate of the frames
Result<SessionMotion> session_motion(const SessionRecord& session, const SessionRange& range,
                                     std::span<const SessionBody> bodies, double rate_hz,
                                     const Progress& progress = {});

/// The received poses of a performer, solved or not.
/// @param performer name; empty = the only one. The Error lists the existing ones
Result<SessionMotion> performer_motion(const SessionRecord& session, const SessionPart& part,
                                       const std::string& performer, double rate_hz,
                                       const Progress& progress = {});

/// A part of a range that was solved with one library.
struct SessionSegment {
  const SessionLibrary* library = nullptr;  ///< of the contents; null if unknown
  SessionRange range;
};

/// The parts of a range by library, in order.
Result<std::vector<SessionSegment>> session_segments(const SessionRecord& session, const SessionRange& range);

/// First line of a trace of a range (docs/guide/command-line.md, Trace).
Result<std::string> session_trace_header(const SessionRecord& session, const std::string& library_name,
                                         const SessionRange& range);

/// The lines after the header, without line ends: the frames solved again (see re_solve_session). Frames of a
/// clip have the clip's frame numbers, others their index in the session.
Result<SessionReplay> session_trace(const SessionRecord& session,
                                    std::shared_ptr<const MotionLibrary> library, const SessionRange& range,
                                    const std::function<Status(const std::string&)>& each_line,
                                    const Progress& progress = {});

}  // namespace abrazo
