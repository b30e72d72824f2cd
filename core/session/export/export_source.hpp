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

/// The data source of an export. Used by one thread.
class ExportSource {
 public:
  virtual ~ExportSource() = default;

  virtual const SessionRecord& record() const = 0;
  /// A frame of a range with its mesh; null if it is missing or unreadable.
  virtual Result<FrameSnapshotPtr> with_mesh(std::uint64_t index) = 0;
  /// Passes on the trace of a range line by line, header first.
  virtual Result<SessionReplay> each_trace_line(const SessionRange& range,
                                                const std::function<Status(const std::string&)>& line,
                                                const Progress& progress) = 0;
  /// Whether traces are solved again instead of written from stored frames.
  virtual bool solves_again() const { return false; }
  /// Tiers of the session itself and those that a person annotated.
  virtual Result<std::vector<Tier>> tiers(const SessionRange& range) const = 0;
};

/// A library that frames of a session were solved with.
struct LibraryAtHand {
  std::shared_ptr<const MotionLibrary> library;
  std::string name;  ///< for the header of a trace: as given, else the session's name for it
};
/// Opens the library of a part of a session; null if the part names none. See library_opener in core/opening.
using LibraryOpener = std::function<Result<LibraryAtHand>(const SessionLibrary*)>;

/// A session file. Meshes and traces need its libraries.
std::unique_ptr<ExportSource> export_of_file(std::shared_ptr<const SessionFile> file,
                                             LibraryOpener libraries);

/// A running session as a source: frames in memory and in its file.
struct RunningExport {
  std::string name;   ///< in messages and labels
  FrameRange frames;  ///< those that may be exported
  std::shared_ptr<const MotionLibrary> library;
  std::string library_name, input;  ///< for the header of a trace
  std::vector<SessionTake> takes = {};
  std::vector<SessionMarker> markers = {};
  std::vector<Tier> noted = {};  ///< annotated by a person
};
/// Reads all frames once. @return an Error if cancelled
Result<std::unique_ptr<ExportSource>> export_of_history(RunningExport running, const Progress& progress = {});

/// A take of the library: performer A is "active" and also the user, B "passive", whoever leads; the tiers
/// say who leads.
/// @param noted its tiers; empty = roles and moves of the library
/// @throws std::invalid_argument when the library has no such take
std::unique_ptr<ExportSource> export_of_take(std::shared_ptr<const MotionLibrary> library,
                                             const std::string& take, std::vector<Tier> noted = {});

}  // namespace abrazo
