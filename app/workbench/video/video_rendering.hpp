#pragma once

#include <QPointer>

#include "app/workbench/base/job.hpp"
#include "app/workbench/base/range_rendering.hpp"

namespace abrazo {
class FrameHistory;
}

namespace abrazo::widgets {
class MessageBar;
}

namespace abrazo::app {

class VideoDesk;

/// Renders the shown video on a worker; the message bar shows progress, can cancel, and reports the end.
/// @param history  of the shown frames; may be null
/// @param running  the job; a second one is refused until it ends
void render_video(VideoDesk& desk, const FrameHistory* history, widgets::MessageBar& messages,
                  const RangeRequest& request, QPointer<Job>& running);

}  // namespace abrazo::app
