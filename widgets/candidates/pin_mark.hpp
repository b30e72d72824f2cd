#pragma once

#include <QColor>
#include <QPointF>

class QPainter;

namespace abrazo::widgets {

/// A pin, 8 x 10 px, centred. @param filled outline only when false
void draw_pin(QPainter& painter, const QPointF& middle, const QColor& colour, bool filled);

/// A circle with a bar across, 8 px.
void draw_veto(QPainter& painter, const QPointF& middle, const QColor& colour);

/// A speech bubble, 9 px: the intended move. @param out crossed out: not the intended move
void draw_meant(QPainter& painter, const QPointF& middle, const QColor& colour, bool out = false);

/// An arrow to the right, 8 px: continues the source.
void draw_continuation(QPainter& painter, const QPointF& middle, const QColor& colour);

}  // namespace abrazo::widgets
