#pragma once

#include <QFrame>
#include <QMetaType>
#include <QPointer>

#include "widgets/common/palette.hpp"
#include "widgets/intended/intended_move_choice.hpp"

class QComboBox;
class QLabel;
class QListWidget;

Q_DECLARE_METATYPE(abrazo::widgets::IntendedMoveChoice)
Q_DECLARE_METATYPE(abrazo::widgets::IntendedMoveSpan)

namespace abrazo::widgets {

/// Pop-up list of the moves and takes that may be intended, nearest first. A click, Return or a digit
/// chooses; Escape closes it. Stays inside its window.
class IntendedMovePopup : public QFrame {
  Q_OBJECT
 public:
  explicit IntendedMovePopup(QWidget* window);
  void setColours(const Palette& palette);
  /// Opens it at the upper middle of another widget.
  void openOver(const QWidget& widget);
  void leave();
  /// In display order; the marked choice stays marked.
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
  QPointer<QWidget> m_before;  ///< previous focus
};

}  // namespace abrazo::widgets
