#pragma once

#include <QColor>
#include <QImage>

class QWidget;

namespace abrazo::test {

/// Shows the widget, lets it draw, and takes its picture.
QImage picture_of(QWidget& widget);

/// Pixels whose colour is within `tolerance` of each channel.
int pixels_like(const QImage& picture, const QColor& colour, int tolerance = 24);

/// Pixels whose hue is within `degrees` of the colour's and that are colourful at all.
int pixels_of_hue(const QImage& picture, const QColor& colour, int degrees = 12);

/// Share of pixels that differ visibly.
double difference(const QImage& a, const QImage& b);

}  // namespace abrazo::test
