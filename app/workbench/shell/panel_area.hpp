#pragma once

#include <QList>
#include <QMainWindow>
#include <map>
#include <vector>

#include "app/workbench/shell/window_layout.hpp"
#include "widgets/common/palette.hpp"

class QTabBar;

namespace abrazo::app {

class PanelTitle;

/// The scene in the middle and the panels around it, which a person moves, floats, stacks and closes. A panel
/// is shown where it is wanted and there is room at its side; a small window hides sides and narrows panels
/// without forgetting what was wanted there, and how large.
class PanelArea : public QMainWindow {
  Q_OBJECT
 public:
  PanelArea();

  /// @param id       names the panel in saved layouts; stays the same between versions
  /// @param content  whose own SectionHeader of the same title, a direct child, becomes the panel's head
  /// @param shown    wanted in the usual layout
  QDockWidget* add(const QString& id, const QString& title, QWidget* content, Qt::DockWidgetArea area,
                   bool shown);
  QDockWidget* panel(const QString& id) const;
  std::vector<QDockWidget*> panels() const;
  /// More words at the panel's head than its name.
  void setHead(const QString& id, const QString& text);
  void setColours(const widgets::Palette& palette);

  bool isWanted(const QString& id) const;
  void want(const QString& id, bool on);
  /// A whole side, whatever the size of the window.
  void wantSide(Qt::DockWidgetArea side, bool on);
  /// @param window  the size of the whole window
  void arrangeFor(QSize window);
  /// Every panel where it was added.
  void reset();
  WindowLayout state() const;
  /// Panels that the layout does not know go where they were added. @return whether it could be read; else
  /// nothing has changed
  bool setState(const WindowLayout& layout);

 signals:
  void arranged(const abrazo::app::PanelPlan& shown);
  void wantedChanged(const QString& id, bool on);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  struct Panel {
    QDockWidget* dock;
    PanelTitle* title;
    Qt::DockWidgetArea usual_side;
    bool usually_shown, wanted;
  };
  Panel* find(const QString& id);
  const Panel* find(const QString& id) const;
  void place(Panel& panel);
  bool hasRoom(const Panel& panel) const;
  QList<QTabBar*> tabBars() const;
  void showWhatFits();
  int planned(Qt::DockWidgetArea side) const;
  void rememberSizes();
  void restoreSizes();
  void applyUsualSizes();
  void raiseFirstOfEachPlace();

  std::vector<Panel> m_panels;
  PanelWishes m_wishes;
  PanelPlan m_room;
  QSize m_window{1600, 1000};
  /// Of each panel that was seen, as a person has it while there is room. A width of 0 follows the plan.
  std::map<QString, QSize> m_sizes;
  bool m_hasSizes = false;  ///< of a layout, or once they were given at the first show
};

}  // namespace abrazo::app
