#pragma once

#include <QObject>
#include <thread>
#include <vector>

#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo::app {

/// Frees the frames of an ended session on a thread of its own: after some minutes they are so many that the
/// window would not respond meanwhile. Deletes itself afterwards; an owner that is deleted earlier waits.
class FrameRelease : public QObject {
 public:
  FrameRelease(std::vector<FrameSnapshotPtr> frames, QObject* owner);

 private:
  std::jthread m_worker;
};

}  // namespace abrazo::app
