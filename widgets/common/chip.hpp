#pragma once

#include <QToolButton>

namespace abrazo::widgets {

/// A small button of a row, styled by its object name. Its tooltip is its accessible name; for symbols.
QToolButton* chip(const QString& text, const QString& tip, QWidget* parent);
/// The same with its text as the accessible name; a click does not take the focus.
QToolButton* text_chip(const QString& text, const QString& tip, QWidget* parent);

}  // namespace abrazo::widgets
