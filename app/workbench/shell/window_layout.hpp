#pragma once

#include <QByteArray>
#include <QSize>
#include <QString>
#include <QStringList>
#include <map>
#include <optional>
#include <string>

#include "app/workbench/shell/panel_plan.hpp"
#include "core/base/result.hpp"

namespace abrazo::app {

/// Increased if changes of panels or places make files invalid.
constexpr int layout_version = 1;

/// Places and visibility of the panels of a window.
struct WindowLayout {
  QByteArray docks;          ///< as QMainWindow::saveState writes it
  QStringList known, shown;  ///< known panels, and the wanted ones among them
  PanelWishes sides;
  std::optional<int> timeline_height;  ///< pixels, as a person chose it; 0 = minimum
  /// Of panels as they were in a window with room for them; width 0 follows the window.
  std::map<QString, QSize> sizes;

  bool operator==(const WindowLayout&) const = default;
};

QByteArray text_of(const WindowLayout& layout);

/// @param file source of the text, for messages
/// @return an Error if it is not a layout, or of another version
Result<WindowLayout> parse_layout(const QByteArray& text, const std::string& file);

}  // namespace abrazo::app
