#pragma once

#include <QColor>
#include <QPointF>

#include "core/stream/protocol/stream_health.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/stream/latency_rows.hpp"
#include "widgets/stream/stream_words.hpp"

class QPainter;

namespace abrazo::widgets {

QColor colour_of(StreamMark mark, const Palette& palette);
/// 14 px around a point; each mark has a different shape: ring, ring with a hand, disc, triangle, cross.
void draw_sign(QPainter& painter, QPointF middle, StreamMark mark, const Palette& palette);

StreamMark mark_of(StreamDiagnosis::Severity severity);
StreamMark mark_of(LatencyVerdict verdict);

}  // namespace abrazo::widgets
