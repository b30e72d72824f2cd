#pragma once

#include <QApplication>
#include <QColor>
#include <QWidget>

namespace abrazo::widgets {

/// A share of red, green, blue or opacity, 0 to 1, as QColor takes it: double in Qt 5, float in Qt 6.
using ColourPart = decltype(QColor().alphaF());

constexpr ColourPart colour_part(double share) {
  return static_cast<ColourPart>(share);
}

/// Sharp pictures and lengths on screens with small pixels: to be asked for in Qt 5, before there is an
/// application.
inline void use_small_pixels() {
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
}

/// Whether it stands for the screen itself, which Qt 5 lists among the widgets.
inline bool is_desktop([[maybe_unused]] const QWidget& widget) {
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  return widget.windowType() == Qt::Desktop;
#else
  return false;
#endif
}

}  // namespace abrazo::widgets
