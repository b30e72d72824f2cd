#pragma once

#include <QToolButton>

namespace abrazo::widgets {

/// A small button among others of a row; the theme knows it by its object name.
/// Its tip is its accessible name: for signs.
QToolButton* chip(const QString& text, const QString& tip, QWidget* parent);
/// Its text is; a click leaves the focus where it was.
QToolButton* text_chip(const QString& text, const QString& tip, QWidget* parent);

}  // namespace abrazo::widgets
