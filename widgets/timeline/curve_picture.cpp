#include "widgets/timeline/curve_picture.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo::widgets {
namespace {

/// Share of pixel row `y` that [top, bottom] covers.
double covered(int y, double top, double bottom) {
  return std::clamp(std::min(bottom, y + 1.0) - std::max(top, static_cast<double>(y)), 0.0, 1.0);
}

void draw_column(QImage& picture, int x, double top, double bottom, const QColor& colour) {
  const int first = std::max(0, static_cast<int>(std::floor(top)));
  const int last = std::min(picture.height() - 1, static_cast<int>(std::floor(bottom)));
  for (int y = first; y <= last; ++y) {
    const double share = covered(y, top, bottom);
    const auto part = [share](int channel) { return static_cast<int>(std::lround(share * channel)); };
    reinterpret_cast<QRgb*>(picture.scanLine(y))[x] =
        qRgba(part(colour.red()), part(colour.green()), part(colour.blue()), part(255));
  }
}

}  // namespace

QImage curve_picture(const std::vector<SampleCurve::Extent>& columns, double upper, int height_px,
                     double thickness_px, const QColor& colour) {
  QImage picture(static_cast<int>(columns.size()), std::max(height_px, 1),
                 QImage::Format_ARGB32_Premultiplied);
  picture.fill(Qt::transparent);
  const double room = picture.height() - thickness_px, half = thickness_px / 2;
  const auto y = [&](float value) {
    return half + room * (1 - std::clamp(static_cast<double>(value) / upper, 0.0, 1.0));
  };
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (is_empty(columns[i])) continue;
    double top = y(columns[i].most), bottom = y(columns[i].least);
    const double own_top = top, own_bottom = bottom;
    // Extends half-way to each neighbour, so that a steep curve has no holes.
    for (const std::size_t neighbour : {i - 1, i + 1}) {
      if (neighbour >= columns.size() || is_empty(columns[neighbour])) continue;
      const double next_top = y(columns[neighbour].most), next_bottom = y(columns[neighbour].least);
      if (next_bottom < own_top) top = std::min(top, (own_top + next_bottom) / 2);
      if (next_top > own_bottom) bottom = std::max(bottom, (own_bottom + next_top) / 2);
    }
    draw_column(picture, static_cast<int>(i), top - half, bottom + half, colour);
  }
  return picture;
}

}  // namespace abrazo::widgets
