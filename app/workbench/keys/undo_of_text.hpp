#pragma once

#include <QObject>
#include <QPointer>

class QUndoStack;
class QWidget;

namespace abrazo::app {

/// Which Undo and Redo a text or number field with the focus keeps: only those of what was typed there after
/// the last step of the window. The others are the window's, whatever was typed before them.
class UndoOfText : public QObject {
  Q_OBJECT
 public:
  /// @param window  that the fields are in, or in a panel of it that floats
  UndoOfText(QWidget& window, QUndoStack& steps);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void watch(QWidget* focused);

  QWidget& m_window;
  QPointer<QWidget> m_watched;  ///< the text field with the focus
  bool m_typed = false;         ///< in it, and since then there was no step
};

}  // namespace abrazo::app
