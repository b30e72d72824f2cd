#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/library/takes/tier.hpp"
#include "core/session/export/session_export.hpp"
#include "core/session/frames/frame_range.hpp"

namespace abrazo {

/// Where an export takes everything from. Used by one thread.
class ExportSource {
 public:
  virtual ~ExportSource() = default;

  virtual const SessionRecord& record() const = 0;
  /// A frame of a range with its mesh; null when it is not there or cannot be read.
  virtual Result<FrameSnapshotPtr> with_mesh(std::uint64_t index) = 0;
  /// The trace of a range, line by line, the header first.
  virtual Result<SessionReplay> each_trace_line(const SessionRange& range,
                                                const std::function<Status(const std::string&)>& line,
                                                const Progress& progress) = 0;
  /// Whether traces are solved again rather than written as they were.
  virtual bool solves_again() const { return false; }
  /// What the session says about its time, and what a person said of it.
  virtual Result<std::vector<Tier>> tiers(const SessionRange& range) const = 0;
};

/// A library that frames of a session were solved with.
struct LibraryAtHand {
  std::shared_ptr<const MotionLibrary> library;
  std::string name;  ///< for the head of a trace: as it was given, else as the session calls it
};
/// Opens the library of a part of a session; null: the part names none. See library_opener in core/opening.
using LibraryOpener = std::function<Result<LibraryAtHand>(const SessionLibrary*)>;

/// A session file. Meshes and traces need its libraries.
std::unique_ptr<ExportSource> export_of_file(std::shared_ptr<const SessionFile> file,
                                             LibraryOpener libraries);

/// What a running session has, in memory and in the file it is recorded to.
struct RunningExport {
  std::string name;   ///< in messages and labels
  FrameRange frames;  ///< those that may be asked for
  std::shared_ptr<const MotionLibrary> library;
  std::string library_name, input;  ///< for the head of a trace
  std::vector<SessionTake> takes = {};
  std::vector<SessionMarker> markers = {};
  std::vector<Tier> noted = {};  ///< what a person said
};
/// Looks through all frames once. @return an Error when it was cancelled
Result<std::unique_ptr<ExportSource>> export_of_history(RunningExport running, const Progress& progress = {});

/// A recorded pair of the library: performer A is "active" and also the user, B "passive", whoever leads; the
/// tiers say who does.
/// @param noted  its tiers; empty = the roles and moves that the library has
/// @throws std::invalid_argument when the library has no such take
std::unique_ptr<ExportSource> export_of_take(std::shared_ptr<const MotionLibrary> library,
                                             const std::string& take, std::vector<Tier> noted = {});

}  // namespace abrazo
