#pragma once

#include <QStyledItemDelegate>

#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

class TakeFilter;
class TakeModel;

/// Layout of a row.
constexpr int take_row_height = 62;
/// Strip over the take's length: moves, with roles above, and selections and belief below.
QRect take_strip(const QRect& row);
/// The frame at a point of the strip, clamped to its ends.
int frame_at(const QRect& row, double x, int frames);

/// Draws a take: picture, name, facts, and a strip of moves with roles above and, below, the number of
/// selections of each part and, as brightness, the belief about the next partner.
class TakeDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  TakeDelegate(const TakeModel& model, const TakeFilter& filter, QObject* parent = nullptr);
  void setColours(const Palette& palette) { m_palette = palette; }
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  /// On the strip the tooltip includes the belief at that frame.
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
