#pragma once

#include <QTimer>

#include "core/annotation/annotations.hpp"
#include "widgets/common/entry_frame.hpp"
#include "widgets/common/palette.hpp"

class QListWidget;

namespace abrazo::widgets {

/// A field for the value of a label, with the tier's vocabulary below it. The key of a value accepts it
/// while the field is empty, unless another key follows within half a second: then it begins a text. Typing
/// completes from the vocabulary; Return accepts the marked or typed value. Keys typed here do not trigger
/// commands of the window.
class ValuePicker : public EntryFrame {
  Q_OBJECT
 public:
  struct Question {
    AnnotationTier tier;  ///< provides the vocabulary
    QString prompt;       ///< "turn from 1.20 s to 2.45 s"
    QString start;        ///< the present value, or the one used last
  };
  /// Opens a picker; replaces an open one. @param below upper left corner in the widget; above it if there is
  /// no room
  static ValuePicker* open(QWidget& widget, const QPoint& below, const Question& question,
                           const Palette& palette, Take take);
  /// The typed or marked value.
  QString value() const override;

 protected:
  void settle() override;
  bool press(const QKeyEvent& key) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool keepsFromWindow(int) const override { return true; }

 private:
  ValuePicker(QWidget& window, const Question& question, const Palette& palette, Take take);
  void fill(const QString& typed);
  bool moveOrPick(const QKeyEvent& key);

  Question m_question;
  Palette m_palette;
  QListWidget* m_list;
  QLabel* m_hint;
  bool m_untouched = true;
  QTimer m_chosen;  ///< runs while a key of the vocabulary may still begin a text
  QString m_chosenValue;
};

}  // namespace abrazo::widgets
