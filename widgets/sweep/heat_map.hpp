#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"
#include "widgets/sweep/sweep_grid.hpp"

namespace abrazo::widgets {

/// A grid of two settings in colours, with its legend. Hovering shows the value of a cell, a click or the
/// arrow keys select it, Return or a double click adopts it. A ring marks the best cell, hatching marks cells
/// without a value.
class HeatMap : public QWidget {
  Q_OBJECT
 public:
  explicit HeatMap(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  /// A change of size drops the selection.
  void showGrid(const SweepGrid& grid);
  const SweepGrid& grid() const { return m_grid; }
  int selected() const { return m_selected; }  ///< a point; -1 = none
  void select(int point);
  /// Rectangle of a point.
  QRectF cellRect(int point) const;
  QSize sizeHint() const override { return {560, 380}; }
  QSize minimumSizeHint() const override { return {320, 240}; }

 signals:
  void selectionChanged(int point);
  void hovered(int point);  ///< -1 = outside the cells
  void adoptRequested(int point);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QRectF area() const;
  int pointAt(const QPointF& place) const;
  void hover(int point);
  void describe();
  void drawCell(QPainter& painter, int point) const;
  void drawNames(QPainter& painter) const;
  void drawMarks(QPainter& painter) const;
  void drawLegend(QPainter& painter) const;
  void drawHatching(QPainter& painter, const QRectF& rect, bool crossed) const;

  Palette m_palette;
  SweepGrid m_grid;
  int m_selected = -1;
  int m_hovered = -1;
};

}  // namespace abrazo::widgets
