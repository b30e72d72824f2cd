#pragma once

#include <QWidget>
#include <vector>

#include "widgets/candidates/candidate_rows.hpp"
#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// The painted rows of the candidate table.
class CandidateList : public QWidget {
  Q_OBJECT
 public:
  static constexpr int row_height = 24;

  explicit CandidateList(QWidget* parent = nullptr);
  void setRows(std::vector<CandidateRow> rows);
  const std::vector<CandidateRow>& rows() const { return m_rows; }
  void setColours(const Palette& palette);
  /// The bars' part of a row.
  double nameWidth() const;
  QRectF barArea(int row) const;

 signals:
  void candidateHovered(int candidate);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void paintRow(QPainter& painter, int index) const;
  void hover(int row);
  QString tip(const CandidateRow& row) const;

  Palette m_palette;
  std::vector<CandidateRow> m_rows;
  double m_fullBar =
      0;  ///< total that fills the bar: keeps to round numbers so that bars can be compared over time
  int m_hovered = -1;
};

}  // namespace abrazo::widgets
