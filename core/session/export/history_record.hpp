#pragma once

#include <map>
#include <memory>

#include "core/session/export/export_source.hpp"

namespace abrazo {

/// The frames of a running session as a record, as a session file would give them. Used by one thread.
class HistoryRecord : public SessionRecord {
 public:
  /// Reads the frames once. @return an Error if there are none, or if cancelled
  static Result<std::unique_ptr<HistoryRecord>> create(RunningExport running, const Progress& progress);

  const std::string& where() const override { return running_.name; }
  const SessionContents& contents() const override { return contents_; }
  Result<RowsRead> each_frame(double from_s, double to_s,
                              const std::function<Status(const FrameSnapshot&)>& visit) const override;
  /// Visits none: received poses are only in the session file.
  Result<RowsRead> each_pose(std::optional<int> performer, double from_s, double to_s,
                             const std::function<Status(const ReceivedPose&)>& visit) const override;
  Status each_source(double from_s, double to_s,
                     const std::function<Status(const SessionSource&)>& visit) const override;

  /// Fast for ascending indices. Null if the frame is not kept.
  FrameSnapshotPtr frame(std::uint64_t index);
  const std::string& library_name() const { return running_.library_name; }

 private:
  explicit HistoryRecord(RunningExport running) : running_(std::move(running)) {}
  Status look_through(const Progress& progress);
  void note(const FrameSnapshot& frame);
  std::uint64_t unreadable_between(double from_s, double to_s) const;

  RunningExport running_;
  SessionContents contents_;
  std::vector<SessionSource> sources_;  ///< one per frame, in order
  std::shared_ptr<const Decisions> decisions_;
  std::uint64_t unreadable_ = 0;
  FrameRange cursor_;  ///< position of the last call of `frame`
  FrameSnapshotPtr at_cursor_;
};

}  // namespace abrazo
