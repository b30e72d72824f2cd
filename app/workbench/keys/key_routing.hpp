#pragma once

#include <QObject>
#include <functional>

class QKeyEvent;

namespace abrazo::app {

class MainWindow;

/// Decides which of the window's keys a focused control keeps: keys that the control does not handle pass
/// through here before actions get them. Text fields and spin boxes keep theirs by themselves, except Undo
/// and Redo (UndoOfText).
class KeyRouting : public QObject {
  Q_OBJECT
 public:
  /// Whether the focused control uses a key before actions do.
  using Means = std::function<bool(const QKeyEvent&)>;
  /// @param timeline for the timeline
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
