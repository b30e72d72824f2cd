#pragma once

#include <QFrame>
#include <QPointer>
#include <functional>

class QKeyEvent;
class QLabel;
class QLineEdit;

namespace abrazo::widgets {

/// A pop-up field for one value, inside the window of its widget: Return accepts the value, Escape and a
/// click elsewhere cancel. A rejected value stays, with the reason below it.
class EntryFrame : public QFrame {
  Q_OBJECT
 public:
  /// Accepts the value. @return the reason of a rejection; empty closes the field
  using Take = std::function<QString(const QString& value)>;

  QString complaint() const;

 protected:
  EntryFrame(QWidget& window, const QString& prompt, const QString& start, Take take);

  /// Opens the field with its text selected.
  void openAt(const QPoint& corner);
  void take(const QString& value);
  void leave();

  /// The value accepted by Return.
  virtual QString value() const;
  /// Sets size and position from `corner()`; called again after changes.
  virtual void settle() = 0;
  /// Called before the field gets the key. @return whether the key was handled
  virtual bool press(const QKeyEvent& key);
  /// Whether the field keeps a key that is also a command of the window.
  virtual bool keepsFromWindow(int key) const;

  void moveInside(QPoint place);
  bool eventFilter(QObject* watched, QEvent* event) override;

  QLabel& title() { return *m_title; }
  QLineEdit& field() { return *m_field; }
  const QLineEdit& field() const { return *m_field; }
  QPoint corner() const { return m_corner; }

 private:
  QLabel *m_title, *m_complaint;
  QLineEdit* m_field;
  Take m_take;
  QPoint m_corner;             ///< in the window
  QPointer<QWidget> m_before;  ///< previous focus
};

}  // namespace abrazo::widgets
