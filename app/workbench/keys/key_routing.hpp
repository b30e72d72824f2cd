#pragma once

#include <QObject>

class QKeyEvent;

namespace abrazo::app {

class LabelKeyFilter;
class MainWindow;

/// Which of the window's keys a focused control keeps for itself: what a control does not take, comes by
/// here on its way up, before any action may have it. Text fields and spin boxes keep theirs by themselves.
class KeyRouting : public QObject {
  Q_OBJECT
 public:
  explicit KeyRouting(MainWindow& window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool isKept(const QKeyEvent& event) const;
  bool press(const QKeyEvent& event);

  MainWindow& m_window;
  const LabelKeyFilter* m_labels;
};

}  // namespace abrazo::app
