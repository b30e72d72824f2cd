#pragma once

#include "widgets/common/chip.hpp"
#include "widgets/common/parts.hpp"

namespace abrazo::widgets {

inline constexpr int section_margin = 12;

/// Secondary text with word wrap.
inline QLabel* quiet_text(QWidget* parent, const QString& name) {
  auto* label = quiet_label({}, parent, 12);
  label->setAccessibleName(name);
  label->setWordWrap(true);
  label->setContentsMargins(section_margin, 0, section_margin, 0);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

inline QVBoxLayout* section_column(QWidget* box) {
  return column_in(box, {0, 0, 0, 6}, 6);
}

inline QHBoxLayout* section_row(QVBoxLayout* column) {
  auto* row = nested_row({section_margin, 0, section_margin, 0}, 6);
  column->addLayout(row);
  return row;
}

}  // namespace abrazo::widgets
