#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/session/file/session_file.hpp"
#include "core/session/frames/take_frames.hpp"

namespace abrazo {

/// A recorded pair of a library as a record: its frames as TakeFrames has them, performer A as the active
/// body and the user, B as the passive one, whoever leads. Times are those of the take, from 0.
class LibraryTakeRecord : public SessionRecord {
 public:
  /// @param tiers  what is said of the take
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
  /// With its mesh; null when there is none of this index.
  FrameSnapshotPtr frame(std::uint64_t index) const;
  /// How long a frame of the library lasts; 0 without frames.
  double frame_s() const;

 private:
  double time_of(std::uint64_t index) const;

  std::shared_ptr<const MotionLibrary> library_;
  std::string take_;
  std::shared_ptr<const TakeFrames> frames_;  ///< null where the library has none of the take
  SessionContents contents_;
};

}  // namespace abrazo
