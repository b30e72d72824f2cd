#pragma once

#include <QPainter>
#include <QStyledItemDelegate>

namespace abrazo::app {

/// A command in a list, its key at the right.
class CommandRow : public QStyledItemDelegate {
 public:
  static constexpr int key_role = Qt::UserRole;
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, index);
    const bool is_chosen = option.state & QStyle::State_Selected;
    painter->setPen(is_chosen ? option.palette.color(QPalette::HighlightedText)
                              : option.palette.color(QPalette::Disabled, QPalette::Text));
    painter->drawText(option.rect.adjusted(0, 0, -margin, 0), Qt::AlignRight | Qt::AlignVCenter,
                      index.data(key_role).toString());
  }

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    const int key = option->fontMetrics.horizontalAdvance(index.data(key_role).toString());
    const int room = option->rect.width() - key - 3 * margin;
    if (room > 0) option->text = option->fontMetrics.elidedText(option->text, Qt::ElideRight, room);
  }

 private:
  static constexpr int margin = 8;
};

}  // namespace abrazo::app
