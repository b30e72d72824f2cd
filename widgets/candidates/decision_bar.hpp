#pragma once

#include <QWidget>
#include <vector>

#include "core/session/frames/decision_edits.hpp"
#include "widgets/common/palette.hpp"

class QToolButton;

namespace abrazo::widgets {

/// Pin and vetoes in force, one button each; a click removes it. Takes no room if there are none.
class DecisionBar : public QWidget {
  Q_OBJECT
 public:
  explicit DecisionBar(QWidget* parent = nullptr);
  void setDecisions(std::vector<Decision> decisions);
  void setColours(const Palette& palette);
  const std::vector<QToolButton*>& buttons() const { return m_buttons; }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void lifted(const abrazo::Decision& decision);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void makeButtons();
  int arrange();

  Palette m_palette;
  std::vector<Decision> m_decisions;
  std::vector<QToolButton*> m_buttons;
};

}  // namespace abrazo::widgets
