#pragma once

#include <QGuiApplication>
#include <QScreen>
#include <QWidget>

namespace abrazo::app {

/// Resizes a window before it is shown, but to no more than nine tenths of the screen: the rest is for
/// title and bars of the window manager, so that the buttons at the foot stay in reach.
inline void resize_within_screen(QWidget& window, const QSize& wanted) {
  window.resize(wanted.boundedTo(QGuiApplication::primaryScreen()->availableSize() * 9 / 10));
}

}  // namespace abrazo::app
