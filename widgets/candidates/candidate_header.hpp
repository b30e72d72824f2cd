#pragma once

#include <QWidget>
#include <vector>

#include "widgets/candidates/candidate_order.hpp"
#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// The heads of the candidate table's columns: a click sorts by one, another turns it around.
class CandidateHeader : public QWidget {
  Q_OBJECT
 public:
  explicit CandidateHeader(QWidget* parent = nullptr);
  void setOrder(const CandidateOrder& order);
  /// The columns are those of its terms.
  void setMethod(SelectionMethod method);
  void setColours(const Palette& palette);
  /// Where a column's head is; empty when there is no room for it.
  QRectF area(CandidateColumn column) const;

 signals:
  void columnClicked(abrazo::widgets::CandidateColumn column);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Head {
    CandidateColumn column;
    QString name;
    QRectF area;
  };
  /// How much is said of each term, by the room there is.
  enum class Fit { Names, Brief, Swatches };
  std::vector<Head> heads() const;
  double widthOf(CandidateColumn column, Fit fit) const;
  Fit fitOfTerms(double until_distance, double until_total) const;
  static QString name(CandidateColumn column, Fit fit);

  SelectionMethod m_method = SelectionMethod::Paper;
  CandidateOrder m_order;
  Palette m_palette;
};

}  // namespace abrazo::widgets
