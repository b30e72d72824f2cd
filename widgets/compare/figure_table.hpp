#pragma once

#include <QWidget>
#include <vector>

#include "widgets/common/palette.hpp"
#include "widgets/compare/figure_rows.hpp"

namespace abrazo::widgets {

/// Figures of A and B side by side with their difference; the better one is green and has a mark.
class FigureTable : public QWidget {
  Q_OBJECT
 public:
  explicit FigureTable(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void showRows(std::vector<FigureRow> rows);
  const std::vector<FigureRow>& rows() const { return m_rows; }
  /// Tab-separated text, one line per figure, for the clipboard.
  QString text() const;

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void paintRow(QPainter& painter, const FigureRow& row, const QRectF& line) const;

  Palette m_palette;
  std::vector<FigureRow> m_rows;
};

}  // namespace abrazo::widgets
