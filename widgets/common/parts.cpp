#include "widgets/common/parts.hpp"

#include <QHeaderView>
#include <QTableView>

#include "widgets/common/theme.hpp"

namespace abrazo::widgets {

QLabel* quiet_label(const QString& text, QWidget* parent, int px) {
  auto* label = new QLabel(text, parent);
  label->setObjectName("secondary");
  if (px > 0) label->setFont(interface_font(px));
  return label;
}

void describe(QWidget& widget, const QString& name, const QString& tip) {
  widget.setAccessibleName(name);
  widget.setToolTip(tip);
}

void make_rows(QTableView& table, int row_px) {
  table.verticalHeader()->hide();
  table.verticalHeader()->setDefaultSectionSize(row_px);
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.setShowGrid(false);
}

}  // namespace abrazo::widgets
