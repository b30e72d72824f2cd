#include "widgets/timeline/quick_entry.hpp"

#include <QLayout>
#include <QLineEdit>
#include <algorithm>
#include <utility>

namespace abrazo::widgets {

QuickEntry* QuickEntry::open(QWidget& widget, const QPoint& above, const QString& prompt,
                             const QString& start, Take take) {
  QWidget& window = *widget.window();
  for (auto* other : window.findChildren<QuickEntry*>()) delete other;
  auto* entry = new QuickEntry(window, prompt, start, std::move(take));
  entry->openAt(widget.mapTo(&window, above));
  return entry;
}

QuickEntry::QuickEntry(QWidget& window, const QString& prompt, const QString& start, Take take)
    : EntryFrame(window, prompt, start, std::move(take)) {
  layout()->setContentsMargins(12, 8, 12, 10);
  field().setMinimumWidth(300);
}

/// Above its corner, and inside the window.
void QuickEntry::settle() {
  constexpr int widest = 420, margin = 8;
  setFixedWidth(std::min(widest, std::max(200, parentWidget()->width() - 2 * margin)));
  const int tall =
      layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width()) : sizeHint().height();
  resize(width(), tall);
  moveInside(corner() - QPoint(0, tall));
}

}  // namespace abrazo::widgets
