#pragma once

#include <QFont>
#include <QString>

#include "widgets/common/palette.hpp"

class QApplication;

namespace abrazo::widgets {

/// Inter if installed, else the system's sans-serif.
QFont interface_font(int pixel_size = 13, QFont::Weight weight = QFont::Normal);

/// The style sheet of all standard widgets in these colours.
QString style_sheet(const Palette& palette);

/// Font, QPalette and style sheet of a whole application. Widgets that are shown while a theme replaces
/// another get it in the next turns of the event loop.
void apply_theme(QApplication& application, const Palette& palette);
/// Whether there are shown widgets that do not have the theme yet.
bool is_applying_theme();

}  // namespace abrazo::widgets
