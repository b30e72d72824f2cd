#pragma once

#include <QStyledItemDelegate>

#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

class TakeFilter;
class TakeModel;

/// Places within a row.
constexpr int take_row_height = 62;
/// Where the take's length is laid out: moves, who leads above, what was selected and what is believed below.
QRect take_strip(const QRect& row);
/// The frame under a point of the strip, held at its ends.
int frame_at(const QRect& row, double x, int frames);

/// Draws a take: picture, name, facts, and its length as a strip of moves with roles above and, below, how
/// often each part was selected and, as light, where the partner is expected next.
class TakeDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  TakeDelegate(const TakeModel& model, const TakeFilter& filter, QObject* parent = nullptr);
  void setColours(const Palette& palette) { m_palette = palette; }
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  /// On the strip also the belief at that frame.
  bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                 const QModelIndex& index) override;

 private:
  void paintGround(QPainter& painter, const QStyleOptionViewItem& option, int take) const;
  void paintWords(QPainter& painter, const QRect& row, int take) const;
  void paintStrip(QPainter& painter, const QRect& strip, int take) const;
  void paintHeat(QPainter& painter, const QRect& strip, int take) const;
  void paintBelief(QPainter& painter, const QRect& strip, int take) const;
  void paintMarks(QPainter& painter, const QRect& strip, int take) const;

  const TakeModel& m_model;
  const TakeFilter& m_filter;
  Palette m_palette;
};

}  // namespace abrazo::widgets
