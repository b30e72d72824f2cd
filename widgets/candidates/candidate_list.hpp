#pragma once

#include <QWidget>
#include <algorithm>
#include <vector>

#include "widgets/candidates/candidate_order.hpp"
#include "widgets/candidates/candidate_rows.hpp"
#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// Layout of a row for a width of the list [px].
struct CandidateLayout {
  static constexpr int row_height = 24;
  static constexpr int gutter = 13;  ///< width of the pin column
  static constexpr int number_right = 30;
  static constexpr int name_left = 50;
  static constexpr int margin = 12;
  static constexpr int figure_width = 60;
  int width = 0;

  /// Width of take and frame; less in a narrow list, to leave room for the bars.
  int nameWidth() const { return width < 370 ? 108 : 134; }
  int barsLeft() const { return name_left + nameWidth(); }
  int barsWidth() const { return std::max(20, width - barsLeft() - figure_width - margin); }
};

/// The painted rows of the candidate table. Keys and actions apply to the current row.
class CandidateList : public QWidget {
  Q_OBJECT
 public:
  static constexpr int row_height = CandidateLayout::row_height;
  static constexpr const char* nothing_yet = "Nothing selected yet";

  explicit CandidateList(QWidget* parent = nullptr);
  /// In display order.
  void setRows(std::vector<CandidateRow> rows, CandidateColumn figure = CandidateColumn::Rank);
  const std::vector<CandidateRow>& rows() const { return m_rows; }
  /// Shown in place of the rows where there are none.
  void setNotice(const QString& notice);
  void setColours(const Palette& palette);
  /// Marks the row of a candidate hovered in another view; -1 = none.
  void setLinked(int candidate);
  /// The row chosen by key or click; follows its pair as long as that is a candidate.
  const CandidateRow* current() const;
  void setCurrent(int row);
  /// Makes the row of this pair current, if it is listed; -1 = none. Emits no signal.
  void setCurrentPair(int pair);
  QRectF barArea(int row) const;

 signals:
  /// Index into the frame's candidates; -1 = the pointer left.
  void candidateHovered(int candidate);
  void currentChanged(int row);
  /// The user chose the row of this pair; -1 = none.
  void pairChosen(int pair);
  void jumpAsked(const abrazo::widgets::CandidateRow& row);
  void jumpToChosenAsked();  ///< the chosen pair may no longer be listed
  void pinClicked(const abrazo::widgets::CandidateRow& row);
  void menuAsked(const abrazo::widgets::CandidateRow& row, const QPoint& globalPosition);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void fit();
  void paintRow(QPainter& painter, int index) const;
  void paintBackground(QPainter& painter, int index, const QRectF& line) const;
  void paintMarks(QPainter& painter, int index, const QRectF& line) const;
  void paintName(QPainter& painter, const CandidateRow& row, const QRectF& line) const;
  void paintBar(QPainter& painter, int index) const;
  void hover(int row);
  void point();
  void choose(int row);
  void moveBy(int rows);
  void describe();
  int rowAt(const QPoint& position) const;
  int rowOf(int pair) const;
  const CandidateRow* row(int index) const;
  QString tip(const CandidateRow& row) const;

  Palette m_palette;
  std::vector<CandidateRow> m_rows;
  QString m_notice = nothing_yet;
  CandidateColumn m_figure = CandidateColumn::Rank;
  double m_fullBar = 0;  ///< total of a full bar: grows immediately, shrinks slowly
  int m_hovered = -1;
  int m_linked = -1;   ///< a candidate
  int m_current = -1;  ///< a row
  int m_currentPair = -1;
  int m_lastRow = -1;  ///< start row for keys after the pair left the candidates
  int m_told = -1;     ///< candidate of the last hover signal
};

}  // namespace abrazo::widgets
