#pragma once

#include <QToolButton>

namespace abrazo::widgets {

/// A small button among others of a row; the theme knows it by its object name.
QToolButton* chip(const QString& text, const QString& tip, QWidget* parent);

}  // namespace abrazo::widgets
