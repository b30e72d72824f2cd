#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "core/bodies/pair_retargeting.hpp"
#include "core/session/frames/frame_store.hpp"

namespace abrazo::app {

/// A recorded pair, and the pieces of it that are computed for other bodies.
struct PreviewedPair {
  std::shared_ptr<const RecordedPair> recorded;  ///< of the previewed frames
  long long first_frame = 0;                     ///< of the take
  struct Piece {
    std::shared_ptr<const RetargetedPair> pair;
    std::size_t first = 0;  ///< its first frame among the recorded ones
    bool has(std::size_t frame) const { return frame >= first && frame - first < pair->frames.size(); }
  };
  std::vector<Piece> pieces;  ///< a later one replaces an earlier one where both have a frame

  std::size_t frames() const { return recorded ? recorded->active.poses.size() : 0; }
  double fps() const { return recorded->active.fps; }
  double time_of(std::size_t frame) const {
    return (static_cast<double>(first_frame) + static_cast<double>(frame)) / fps();
  }
  /// The frame at a time, clamped to the ends.
  std::size_t frame_at(double time_s) const;
  /// The piece with this frame; null if it is not computed.
  const Piece* piece_of(std::size_t frame) const;
};

/// The pair as frames that every view of solved frames can show: the recording, or the pair on other bodies
/// where it is computed and the recording elsewhere. Frame f of the take has the time f / fps. Made on
/// demand; the last one is cached.
class RetargetedFrames : public FrameStore {
 public:
  enum class Shows { Recording, Retargeted };
  RetargetedFrames(PreviewedPair pair, Shows shows);

  Span span() const override;
  FrameSnapshotPtr at(double time_s) const override;
  FrameSnapshotPtr frame(std::uint64_t index) const override;
  std::vector<FrameSnapshotPtr> range(double from_s, double to_s, std::size_t most) const override;
  std::vector<FrameSnapshotPtr> between(std::uint64_t first, std::uint64_t last,
                                        std::size_t most) const override;
  std::optional<std::uint64_t> state_before(std::uint64_t) const override { return std::nullopt; }

 private:
  FrameSnapshotPtr make(std::size_t frame) const;

  PreviewedPair pair_;
  Shows shows_;
  mutable std::mutex mutex_;
  mutable FrameSnapshotPtr last_;
};

}  // namespace abrazo::app
