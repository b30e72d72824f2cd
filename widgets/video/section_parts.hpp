#pragma once

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "widgets/common/chip.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {

inline constexpr int section_margin = 12;

/// Secondary text with word wrap.
inline QLabel* quiet_text(QWidget* parent, const QString& name) {
  auto* label = new QLabel(parent);
  label->setObjectName("secondary");
  label->setAccessibleName(name);
  label->setFont(interface_font(12));
  label->setWordWrap(true);
  label->setContentsMargins(section_margin, 0, section_margin, 0);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

inline QVBoxLayout* section_column(QWidget* box) {
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 6);
  column->setSpacing(6);
  return column;
}

inline QHBoxLayout* section_row(QVBoxLayout* column) {
  auto* row = new QHBoxLayout;
  row->setContentsMargins(section_margin, 0, section_margin, 0);
  row->setSpacing(6);
  column->addLayout(row);
  return row;
}

}  // namespace abrazo::widgets
