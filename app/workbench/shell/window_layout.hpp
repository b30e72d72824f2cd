#pragma once

#include <QByteArray>
#include <QStringList>
#include <string>

#include "app/workbench/shell/panel_plan.hpp"
#include "core/base/result.hpp"

namespace abrazo::app {

/// Changes when panels or their places change so that older files would come out wrong.
constexpr int layout_version = 1;

/// Where the panels of a window stand and which of them are wanted.
struct WindowLayout {
  QByteArray docks;          ///< as QMainWindow::saveState writes it
  QStringList known, shown;  ///< panels there were, and those of them that were wanted
  PanelWishes sides;
  int timeline_height = 0;  ///< pixels; 0 is as low as it can be

  bool operator==(const WindowLayout&) const = default;
};

QByteArray text_of(const WindowLayout& layout);

/// @param file  where the text is from, for the message
/// @return an error where it is no layout, or one of another version
Result<WindowLayout> parse_layout(const QByteArray& text, const std::string& file);

}  // namespace abrazo::app
