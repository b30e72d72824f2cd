#include "app/workbench/shell/scene_picture.hpp"

#include <algorithm>

#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app {

QImage without_background(const QImage& on_black, const QImage& on_white) {
  const QImage black = on_black.convertToFormat(QImage::Format_RGB32);
  const QImage white = on_white.convertToFormat(QImage::Format_RGB32);
  QImage result(black.size(), QImage::Format_ARGB32_Premultiplied);
  result.setDevicePixelRatio(on_black.devicePixelRatio());
  if (white.size() != black.size()) return {};
  for (int y = 0; y < black.height(); ++y) {
    const auto* b = reinterpret_cast<const QRgb*>(black.constScanLine(y));
    const auto* w = reinterpret_cast<const QRgb*>(white.constScanLine(y));
    auto* line = reinterpret_cast<QRgb*>(result.scanLine(y));
    for (int x = 0; x < black.width(); ++x) {
      const int through =
          std::max({qRed(w[x]) - qRed(b[x]), qGreen(w[x]) - qGreen(b[x]), qBlue(w[x]) - qBlue(b[x]), 0});
      // On black a colour shows as much as it covers: premultiplied already.
      const int alpha = std::max({255 - through, qRed(b[x]), qGreen(b[x]), qBlue(b[x])});
      line[x] = qRgba(qRed(b[x]), qGreen(b[x]), qBlue(b[x]), alpha);
    }
  }
  return result;
}

QImage transparent_picture(widgets::SceneView& scene) {
  const QImage on_black = scene.picture(QColor(Qt::black));
  return without_background(on_black, scene.picture(QColor(Qt::white)));
}

}  // namespace abrazo::app
