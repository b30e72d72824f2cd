#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"

class QDockWidget;
class QMenu;
class QToolButton;

namespace abrazo::widgets {
class SectionHeader;
}

namespace abrazo::app {

/// The title bar of a panel: name, and under the pointer a menu of places and a close button.
class PanelTitle : public QWidget {
  Q_OBJECT
 public:
  /// @param header  shown as the name; becomes a child of this
  PanelTitle(widgets::SectionHeader* header, QDockWidget* panel);
  widgets::SectionHeader& header() { return *m_header; }
  void setColours(const widgets::Palette& palette);

 signals:
  void closeRequested();
  void moveRequested(Qt::DockWidgetArea area);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  QMenu* makeMenu();
  QToolButton* button(const QString& what);

  QDockWidget* m_panel;
  widgets::SectionHeader* m_header;
  QToolButton *m_more, *m_close;
};

}  // namespace abrazo::app
