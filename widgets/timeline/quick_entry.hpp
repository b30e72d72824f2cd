#pragma once

#include <QFrame>
#include <QPointer>
#include <functional>

class QLabel;
class QLineEdit;

namespace abrazo::widgets {

/// A field that opens for one value, above another widget and inside its window: Return takes the value,
/// Escape and a click elsewhere leave it. What cannot be taken stays, with the reason below it.
class QuickEntry : public QFrame {
  Q_OBJECT
 public:
  /// Takes the text. @return what is wrong with it; empty closes the field
  using Take = std::function<QString(const QString& text)>;

  /// Replaces one that is open. @param above  its lower left corner comes there, in the widget
  static QuickEntry* open(QWidget& widget, const QPoint& above, const QString& prompt, const QString& start,
                          Take take);
  QString complaint() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QuickEntry(QWidget& window, const QString& prompt, const QString& start, Take take);
  void accept();
  void leave();
  void settle();

  QLineEdit* m_field;
  QLabel* m_complaint;
  Take m_take;
  QPoint m_corner;
  QPointer<QWidget> m_before;  ///< had the focus
};

}  // namespace abrazo::widgets
