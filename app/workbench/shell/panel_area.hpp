#pragma once

#include <QList>
#include <QMainWindow>
#include <map>
#include <set>
#include <vector>

#include "app/workbench/shell/window_layout.hpp"
#include "widgets/common/palette.hpp"

class QTabBar;

namespace abrazo::app {

class PanelTitle;

/// The scene in the middle and movable, floating, stackable and closable panels around it. A wanted panel is
/// shown if there is room at its side; a small window hides sides and narrows panels but remembers wanted
/// panels and sizes.
class PanelArea : public QMainWindow {
  Q_OBJECT
 public:
  PanelArea();

  /// @param id stable id in saved layouts
  /// @param content its SectionHeader of the same title, a direct child, becomes the panel's header
  /// @param shown wanted in the default layout
  QDockWidget* add(const QString& id, const QString& title, QWidget* content, Qt::DockWidgetArea area,
                   bool shown);
  QDockWidget* panel(const QString& id) const;
  std::vector<QDockWidget*> panels() const;
  /// Sets additional text in the panel's header.
  void setHead(const QString& id, const QString& text);
  void setColours(const widgets::Palette& palette);

  bool isWanted(const QString& id) const;
  void want(const QString& id, bool on);
  /// Shows or hides a whole side, regardless of the window's size.
  void wantSide(Qt::DockWidgetArea side, bool on);
  /// @param window  the size of the whole window
  void arrangeFor(QSize window);
  /// For what stands beside the scene, with this width; 0 = nothing. Sides give way to it.
  void leaveRoomBeside(int width);
  /// A panel that is worked in gets the height that the settings do not need; their own come back with an
  /// empty id.
  void favour(const QString& id);
  /// With which the settings that are tuned most are in view below the candidates [px]; 0 if nobody asks for
  /// it.
  int neededHeight() const;
  /// Without the room for the tuned settings: a person may still take it away.
  QSize minimumSizeHint() const override;
  /// Returns every panel to its initial place.
  void reset();
  WindowLayout state() const;
  /// Panels unknown to the layout go to their initial place. @return false, without a change, if it is
  /// invalid
  bool setState(const WindowLayout& layout);

 signals:
  void arranged(const abrazo::app::PanelPlan& shown);
  void wantedChanged(const QString& id, bool on);
  void neededHeightChanged();

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
  void prepareTabBars();
  void noteFront();
  void showWhatFits();
  int planned(Qt::DockWidgetArea side) const;
  void rememberSizes();
  static void setHeadHeight(const Panel& panel, int height);
  int heightOfTabs(QDockWidget* panel) const;
  int leastHeightOfPlace(QDockWidget* panel) const;
  int leastHeight(Qt::DockWidgetArea side, const QDockWidget* without = nullptr) const;
  void keepTuned();
  void restoreSizes();
  void applyUsualSizes();
  void raiseFirstOfEachPlace();

  std::vector<Panel> m_panels;
  std::set<QString> m_front;  ///< ids
  PanelWishes m_wishes;
  PanelPlan m_room;
  QSize m_window{1600, 1000};
  int m_beside = 0;  ///< width of what stands beside the scene
  /// Sizes of panels as set by the user, for windows with enough room. Width 0 follows the plan.
  std::map<QString, QSize> m_sizes;
  int m_needed = 0;         ///< neededHeight() as it was told last
  QString m_favoured;       ///< id; empty = none
  bool m_hasSizes = false;  ///< from a layout, or set at the first show
};

}  // namespace abrazo::app
