#pragma once

class QPainter;
class QSize;

namespace abrazo::widgets {

struct TimelineContent;

/// Paints everything except cursor and overview: the part that changes rarely and is cached as a picture.
void paint_timeline(QPainter& painter, const TimelineContent& content, const QSize& size);

/// Paints the white line through all lanes.
void paint_timeline_cursor(QPainter& painter, const TimelineContent& content, const QSize& size);

/// Paints the overview below the lanes: the view within the whole range. Nothing if everything is in view.
void paint_timeline_overview(QPainter& painter, const TimelineContent& content, const QSize& size);

}  // namespace abrazo::widgets
