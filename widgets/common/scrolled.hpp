#pragma once

#include <QScrollArea>

namespace abrazo::widgets {

/// Puts content into a scroll area that scrolls vertically, without a frame or background of its own.
inline void scroll_vertically(QScrollArea& scroll, QWidget* content) {
  scroll.setWidget(content);
  scroll.setWidgetResizable(true);
  scroll.setFrameShape(QFrame::NoFrame);
  scroll.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll.viewport()->setAutoFillBackground(false);
  content->setAutoFillBackground(false);
}

}  // namespace abrazo::widgets
