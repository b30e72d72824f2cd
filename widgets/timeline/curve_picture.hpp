#pragma once

#include <QColor>
#include <QImage>
#include <vector>

#include "widgets/timeline/sample_curve.hpp"

namespace abrazo::widgets {

/// A curve of one column for each pixel: a line through the columns that stands as high as their values
/// reach. Written pixel by pixel, because stroking thousands of points takes tens of milliseconds.
/// @param upper  value at the upper edge; larger ones are cut there. 0 lies at the lower edge
/// @param thickness_px  of the line
QImage curve_picture(const std::vector<SampleCurve::Extent>& columns, double upper, int height_px,
                     double thickness_px, const QColor& colour);

}  // namespace abrazo::widgets
