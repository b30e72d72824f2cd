#pragma once

#include <QWidget>
#include <vector>

#include "widgets/candidates/candidate_order.hpp"
#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// The header of the candidate table: a click sorts by a column, another click reverses the order. Terms have
/// their colour beside their name, so that it is the legend of the bars; where they have no room beside the
/// other columns, they have lines of their own.
class CandidateHeader : public QWidget {
  Q_OBJECT
 public:
  explicit CandidateHeader(QWidget* parent = nullptr);
  void setOrder(const CandidateOrder& order);
  /// Sets the columns to the terms of a method.
  void setMethod(SelectionMethod method);
  void setColours(const Palette& palette);
  /// Area of a column's header; empty if there is no room for it.
  QRectF area(CandidateColumn column) const;

 signals:
  void columnClicked(abrazo::widgets::CandidateColumn column);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Head {
    CandidateColumn column;
    QString name;
    QRectF area;
  };
  std::vector<Head> heads() const;
  double widthOf(CandidateColumn column) const;
  double widthOfTerms() const;
  bool termsStandAlone() const;
  void arrange();

  SelectionMethod m_method = SelectionMethod::Paper;
  CandidateOrder m_order;
  Palette m_palette;
};

}  // namespace abrazo::widgets
