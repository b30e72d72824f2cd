#pragma once

#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo {

/// Receives every solved frame, in order, on the solver thread. Must return at once (the recorder queues).
class FrameListener {
 public:
  virtual ~FrameListener() = default;
  virtual void frame_solved(const FrameSnapshotPtr& frame) = 0;
};

}  // namespace abrazo
