#pragma once

#include <QWidget>
#include <vector>

#include "core/metrics/run_comparison.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/compare/curve_scale.hpp"

namespace abrazo::widgets {

/// One figure of two runs over the steps they share: A dashed, B solid, with the time cursor. A click seeks.
class CompareCurve : public QWidget {
  Q_OBJECT
 public:
  explicit CompareCurve(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void setFigure(StepFigure figure);
  StepFigure figure() const { return m_figure; }
  void setSteps(std::vector<ComparedStep> steps);
  void setCursor(double time_s);
  /// Values at the cursor: "A 151 mm · B 64 mm".
  QString reading() const;

  QSize sizeHint() const override { return {300, 104}; }
  QSize minimumSizeHint() const override { return {160, 72}; }

 signals:
  void seekRequested(double time_s);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  CurveScale scale() const;
  void paintRun(QPainter& painter, const CurveScale& scale, bool of_b) const;
  void stepBy(int steps);

  Palette m_palette;
  StepFigure m_figure = StepFigure::PartnerDistance;
  std::vector<ComparedStep> m_steps;
  double m_cursor_s = -1;
};

}  // namespace abrazo::widgets
