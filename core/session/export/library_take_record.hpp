#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/session/file/session_file.hpp"
#include "core/session/frames/take_frames.hpp"

namespace abrazo {

/// A take of a library as a record, with the frames of TakeFrames: performer A is the active body and the
/// user, B the passive body, whoever leads. Times are those of the take, from 0.
class LibraryTakeRecord : public SessionRecord {
 public:
  /// @param tiers annotations of the take
  /// @throws std::invalid_argument when the library has no such take
  LibraryTakeRecord(std::shared_ptr<const MotionLibrary> library, const std::string& take,
                    std::vector<Tier> tiers);

  const std::string& where() const override { return take_; }
  const SessionContents& contents() const override { return contents_; }
  Result<RowsRead> each_frame(double from_s, double to_s,
                              const std::function<Status(const FrameSnapshot&)>& visit) const override;
  Result<RowsRead> each_pose(std::optional<int> performer, double from_s, double to_s,
                             const std::function<Status(const ReceivedPose&)>& visit) const override;
  Status each_source(double from_s, double to_s,
                     const std::function<Status(const SessionSource&)>& visit) const override;
  /// A frame with its mesh; null if there is none of this index.
  FrameSnapshotPtr frame(std::uint64_t index) const;
  /// Duration of a frame of the library [s]; 0 without frames.
  double frame_s() const;

 private:
  double time_of(std::uint64_t index) const;

  std::shared_ptr<const MotionLibrary> library_;
  std::string take_;
  std::shared_ptr<const TakeFrames> frames_;  ///< null if the library has no frame of the take
  SessionContents contents_;
};

}  // namespace abrazo
