#pragma once

#include <QFrame>
#include <QMetaType>
#include <QPointer>

#include "widgets/common/palette.hpp"
#include "widgets/intended/intended_move_choice.hpp"

class QComboBox;
class QLabel;
class QListWidget;

namespace abrazo::widgets {

/// The moves and takes that may be intended, nearest first, while a person decides. A click, Return
/// or a digit chooses; Escape leaves it. Stays inside its window.
class IntendedMovePopup : public QFrame {
  Q_OBJECT
 public:
  explicit IntendedMovePopup(QWidget* window);
  void setColours(const Palette& palette);
  /// Opens it in the upper middle of another widget.
  void openOver(const QWidget& widget);
  void leave();
  /// In the order they are shown; the row that is marked stays the same choice.
  void setChoices(std::vector<IntendedMoveChoice> choices);
  const std::vector<IntendedMoveChoice>& choices() const { return m_choices; }
  IntendedMoveSpan span() const;
  void setSpan(IntendedMoveSpan span);

 signals:
  void chosen(const abrazo::widgets::IntendedMoveChoice& choice, abrazo::widgets::IntendedMoveSpan span);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void choose(int row);
  void arrange();

  Palette m_palette;
  std::vector<IntendedMoveChoice> m_choices;
  QListWidget* m_list;
  QComboBox* m_span;
  QLabel* m_hint;
  QPointer<const QWidget> m_over;
  QPointer<QWidget> m_before;  ///< had the focus
};

}  // namespace abrazo::widgets

Q_DECLARE_METATYPE(abrazo::widgets::IntendedMoveChoice)
Q_DECLARE_METATYPE(abrazo::widgets::IntendedMoveSpan)
