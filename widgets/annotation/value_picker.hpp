#pragma once

#include <QFrame>
#include <QPointer>
#include <functional>

#include "core/annotation/annotations.hpp"
#include "widgets/common/palette.hpp"

class QLabel;
class QLineEdit;
class QListWidget;

namespace abrazo::widgets {

/// What a label says: a field that opens at a place, with the tier's vocabulary below it. The key of a value
/// takes it at once while nothing was typed; typing completes from the vocabulary; Return takes what is
/// marked, or what was typed; Escape and a click elsewhere leave it.
class ValuePicker : public QFrame {
  Q_OBJECT
 public:
  /// Takes the value. @return what is wrong with it; empty closes the field
  using Take = std::function<QString(const QString& value)>;

  struct Question {
    AnnotationTier tier;  ///< whose vocabulary is offered
    QString prompt;       ///< "turn from 1.20 s to 2.45 s"
    QString start;        ///< the value there is, or the one used last
  };
  /// Replaces one that is open. @param below  its upper left corner comes there or above, in the widget
  static ValuePicker* open(QWidget& widget, const QPoint& below, const Question& question,
                           const Palette& palette, Take take);
  /// What was typed, or is marked.
  QString value() const;
  QString complaint() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  ValuePicker(QWidget& window, const Question& question, const Palette& palette, Take take);
  void fill(const QString& typed);
  void settle();
  void take(const QString& value);
  void leave();
  bool press(int key, const QString& text);

  Question m_question;
  Palette m_palette;
  Take m_take;
  QLineEdit* m_field;
  QListWidget* m_list;
  QLabel *m_complaint, *m_hint;
  QPoint m_corner;
  bool m_untouched = true;
  QPointer<QWidget> m_before;  ///< had the focus
};

}  // namespace abrazo::widgets
