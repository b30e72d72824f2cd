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
  /// Whether a key that the focused control does not keep is used before actions get it.
  using Claims = std::function<bool(const QKeyEvent&)>;
  /// @param labels  for the values of labels
  /// @param annotates  whether keys are those of annotation: then letters change neither the solver nor the
  /// scene
  KeyRouting(MainWindow& window, Claims labels, std::function<bool()> annotates);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool isKept(const QKeyEvent& event) const;
  bool isOfAnotherTask(const QKeyEvent& event) const;
  bool press(const QKeyEvent& event);

  MainWindow& m_window;
  Claims m_labels;
  std::function<bool()> m_annotates;
};

}  // namespace abrazo::app
