#include "app/workbench/document/frame_release.hpp"

#include <QMetaObject>
#include <utility>

namespace abrazo::app {

FrameRelease::FrameRelease(std::vector<FrameSnapshotPtr> frames, QObject* owner)
    : QObject(owner), m_worker([this, frames = std::move(frames)]() mutable {
        frames.clear();
        QMetaObject::invokeMethod(this, &QObject::deleteLater, Qt::QueuedConnection);
      }) {}

}  // namespace abrazo::app
