#pragma once

class QPainter;
class QSize;

namespace abrazo::widgets {

struct TimelineContent;

/// Everything but the cursor and the overview; what changes seldom enough to be kept as a picture.
void paint_timeline(QPainter& painter, const TimelineContent& content, const QSize& size);

/// The white line through all lanes.
void paint_timeline_cursor(QPainter& painter, const TimelineContent& content, const QSize& size);

/// Below the lanes: where the view lies in all there is. Nothing while all is in view.
void paint_timeline_overview(QPainter& painter, const TimelineContent& content, const QSize& size);

}  // namespace abrazo::widgets
