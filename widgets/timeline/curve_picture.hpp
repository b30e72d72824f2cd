#pragma once

#include <QColor>
#include <QImage>
#include <vector>

#include "widgets/timeline/sample_curve.hpp"

namespace abrazo::widgets {

/// A curve with one column per pixel: a line that covers the extent of each column. Written pixel by pixel,
/// because stroking thousands of points takes tens of milliseconds.
/// @param upper value at the upper edge, where larger values are cut. 0 is at the lower edge
/// @param thickness_px  of the line
QImage curve_picture(const std::vector<SampleCurve::Extent>& columns, double upper, int height_px,
                     double thickness_px, const QColor& colour);

}  // namespace abrazo::widgets
