#pragma once

#include <memory>
#include <mutex>
#include <utility>

#include "core/session/frames/frame_listener.hpp"

namespace abrazo {

/// Stands between the solver thread and a listener: after it is shut, no frame reaches the listener, not even
/// one in progress.
class ListenerGate : public FrameListener {
 public:
  explicit ListenerGate(std::shared_ptr<FrameListener> behind) : behind_(std::move(behind)) {}

  void frame_solved(const FrameSnapshotPtr& frame) override {
    const std::scoped_lock lock(mutex_);
    if (behind_) behind_->frame_solved(frame);
  }

  void shut() {
    const std::scoped_lock lock(mutex_);
    behind_.reset();
  }

 private:
  std::mutex mutex_;
  std::shared_ptr<FrameListener> behind_;
};

}  // namespace abrazo
