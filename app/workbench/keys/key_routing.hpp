#pragma once

#include <QObject>
#include <functional>

class QKeyEvent;

namespace abrazo::app {

class MainWindow;

/// Which of the window's keys a focused control keeps for itself: what a control does not take, comes by
/// here on its way up, before any action may have it. Text fields and spin boxes keep theirs by themselves,
/// but for Undo and Redo (UndoOfText).
class KeyRouting : public QObject {
  Q_OBJECT
 public:
  /// Whether a key says something to what has the focus, before it is an action's.
  using Means = std::function<bool(const QKeyEvent&)>;
  /// @param timeline  of the timeline
  KeyRouting(MainWindow& window, Means timeline);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool isKept(const QKeyEvent& event) const;
  bool press(const QKeyEvent& event);

  MainWindow& m_window;
  Means m_timeline;
};

}  // namespace abrazo::app
