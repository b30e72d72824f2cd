#pragma once

#include <QObject>
#include <QPointer>

class QUndoStack;
class QWidget;

namespace abrazo::app {

/// Decides which Undo and Redo a focused text or number field keeps: only those for text typed after the last
/// undo step of the window. Others belong to the window.
class UndoOfText : public QObject {
  Q_OBJECT
 public:
  /// @param window window of the fields, including its floating panels
  UndoOfText(QWidget& window, QUndoStack& steps);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void watch(QWidget* focused);

  QWidget& m_window;
  QPointer<QWidget> m_watched;  ///< the text field with the focus
  bool m_typed = false;         ///< text was typed in it after the last step
};

}  // namespace abrazo::app
