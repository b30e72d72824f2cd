#pragma once

#include "core/annotation/annotations.hpp"
#include "widgets/common/entry_frame.hpp"
#include "widgets/common/palette.hpp"

class QListWidget;

namespace abrazo::widgets {

/// What a label says: a field that opens at a place, with the tier's vocabulary below it. The key of a value
/// takes it immediately while nothing was typed; typing completes from the vocabulary; Return takes what is
/// marked, or what was typed. What is typed here is no command of the window.
class ValuePicker : public EntryFrame {
  Q_OBJECT
 public:
  struct Question {
    AnnotationTier tier;  ///< whose vocabulary is offered
    QString prompt;       ///< "turn from 1.20 s to 2.45 s"
    QString start;        ///< the value there is, or the one used last
  };
  /// Replaces one that is open. @param below  its upper left corner comes there or above, in the widget
  static ValuePicker* open(QWidget& widget, const QPoint& below, const Question& question,
                           const Palette& palette, Take take);
  /// What was typed, or is marked.
  QString value() const override;

 protected:
  void settle() override;
  bool press(const QKeyEvent& key) override;
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
};

}  // namespace abrazo::widgets
