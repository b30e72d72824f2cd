#pragma once

#include <QFrame>
#include <QPointer>
#include <functional>

class QKeyEvent;
class QLabel;
class QLineEdit;

namespace abrazo::widgets {

/// A field that opens for one value, inside the window of the widget that it is about: Return takes the
/// value, Escape and a click elsewhere leave it. What cannot be taken stays, with the reason below it.
class EntryFrame : public QFrame {
  Q_OBJECT
 public:
  /// Takes the value. @return what is wrong with it; empty closes the field
  using Take = std::function<QString(const QString& value)>;

  QString complaint() const;

 protected:
  EntryFrame(QWidget& window, const QString& prompt, const QString& start, Take take);

  /// Shows it for the first time; what is typed replaces what stands there.
  void openAt(const QPoint& corner);
  void take(const QString& value);
  void leave();

  /// What Return takes.
  virtual QString value() const;
  /// Its size, and its place by `corner()`; called again when either may have changed.
  virtual void settle() = 0;
  /// Before the field gets the key. @return whether that was all
  virtual bool press(const QKeyEvent& key);
  /// Whether a key that is also a command of the window is meant for the field.
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
  QPointer<QWidget> m_before;  ///< had the focus
};

}  // namespace abrazo::widgets
