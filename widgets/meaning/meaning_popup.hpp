#pragma once

#include <QFrame>
#include <QMetaType>
#include <QPointer>

#include "widgets/common/palette.hpp"
#include "widgets/meaning/meaning_choice.hpp"

class QComboBox;
class QLabel;
class QListWidget;

namespace abrazo::widgets {

/// "I mean this move": the moves and takes there are, nearest first, while a person decides. A click, Return
/// or a digit chooses; Escape leaves it. Stays inside its window.
class MeaningPopup : public QFrame {
  Q_OBJECT
 public:
  explicit MeaningPopup(QWidget* window);
  void setColours(const Palette& palette);
  /// Opens it in the upper middle of another widget.
  void openOver(const QWidget& widget);
  void leave();
  /// In the order they are shown; the row that is marked stays the same choice.
  void setChoices(std::vector<MeaningChoice> choices);
  const std::vector<MeaningChoice>& choices() const { return m_choices; }
  MeaningSpan span() const;
  void setSpan(MeaningSpan span);

 signals:
  void chosen(const abrazo::widgets::MeaningChoice& choice, abrazo::widgets::MeaningSpan span);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void choose(int row);
  void arrange();

  Palette m_palette;
  std::vector<MeaningChoice> m_choices;
  QListWidget* m_list;
  QComboBox* m_span;
  QLabel* m_hint;
  QPointer<const QWidget> m_over;
  QPointer<QWidget> m_before;  ///< had the focus
};

}  // namespace abrazo::widgets

Q_DECLARE_METATYPE(abrazo::widgets::MeaningChoice)
Q_DECLARE_METATYPE(abrazo::widgets::MeaningSpan)
