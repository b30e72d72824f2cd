#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "core/synthesis/frames/trace.hpp"

namespace abrazo {

/// The frames of a trace file (JSON lines), read one at a time; only the line offsets are kept in memory.
/// They have the bodies, user, mesh, selected pair, locks and contacts of the trace, but only the number of
/// candidates, because the library is not available. Not thread-safe.
class TraceFrames {
 public:
  /// Reads the file once and checks every line. The Error names file and line.
  static Result<TraceFrames> open(const std::filesystem::path& file, const Progress& progress);

  const TraceHeader& header() const { return header_; }
  /// Frame times, ascending [s].
  const std::vector<double>& times_s() const { return times_s_; }
  /// The last frame not after a time, the first before it.
  Result<FrameSnapshotPtr> at(double time_s);

 private:
  Result<FrameSnapshotPtr> read(std::size_t index);

  std::string file_;
  std::ifstream stream_;
  TraceHeader header_;
  std::vector<double> times_s_;
  std::vector<std::streamoff> places_;  ///< offsets of the frames' lines
  FrameSnapshotPtr newest_;
  std::size_t newest_index_ = 0;
};

/// One line of a trace as a frame. @param where  file and line, for messages
Result<FrameSnapshotPtr> read_trace_frame(std::string_view line, std::uint64_t index,
                                          const Settings& settings, const std::string& where);

}  // namespace abrazo
