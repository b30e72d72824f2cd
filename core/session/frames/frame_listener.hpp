#pragma once

#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo {

/// Is given every solved frame, in order, by the solver thread: must return at once (the recorder queues).
class FrameListener {
 public:
  virtual ~FrameListener() = default;
  virtual void frame_solved(const FrameSnapshotPtr& frame) = 0;
};

}  // namespace abrazo
