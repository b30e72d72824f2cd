#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"

class QSlider;
class QToolButton;

namespace abrazo::widgets {

class TabularLabel;

/// Steps through the poses from the selected pair to the result.
class MorphStrip : public QWidget {
  Q_OBJECT
 public:
  explicit MorphStrip(QWidget* parent);
  void setColours(const Palette& palette);
  /// @param steps number kept in the frame; @param text of the step, "3 / 5 + 2"
  void showStep(int step, int steps, const QString& text);

 signals:
  /// 0 is the selected pair, the last the result.
  void stepRequested(int step);
  void closeRequested();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Palette m_palette;
  QSlider* m_slider;
  QToolButton *m_back, *m_forth, *m_close;
  TabularLabel* m_text;
};

}  // namespace abrazo::widgets
