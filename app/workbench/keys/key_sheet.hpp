#pragma once

#include <QString>

#include "app/workbench/keys/shortcut_table.hpp"
#include "widgets/common/palette.hpp"

namespace abrazo::app {

/// All present keys by menu, in columns of about equal length, as rich text.
QString key_sheet(const ShortcutTable& table, const widgets::Palette& colours, int columns);

}  // namespace abrazo::app
