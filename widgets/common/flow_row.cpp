#include "widgets/common/flow_row.hpp"

#include <algorithm>
#include <utility>

namespace abrazo::widgets {

FlowRow::FlowRow(QWidget* parent, int gap) : QLayout(parent) {
  setContentsMargins(0, 0, 0, 0);
  setSpacing(gap);
}

FlowRow::~FlowRow() {
  for (QLayoutItem* item : m_items) delete item;
}

void FlowRow::addItem(QLayoutItem* item) {
  m_items.push_back(item);
}

QLayoutItem* FlowRow::itemAt(int index) const {
  return index >= 0 && index < count() ? m_items[static_cast<std::size_t>(index)] : nullptr;
}

QLayoutItem* FlowRow::takeAt(int index) {
  QLayoutItem* const item = itemAt(index);
  if (item) m_items.erase(m_items.begin() + index);
  return item;
}

int FlowRow::lay(const QRect& place, bool is_moving) const {
  int y = place.top();
  for (std::size_t first = 0; first < m_items.size();) {
    int x = place.left(), height = 0;
    std::vector<std::pair<QLayoutItem*, QRect>> line;
    for (; first < m_items.size(); ++first) {
      QLayoutItem* item = m_items[first];
      if (item->isEmpty()) continue;  // hidden
      const QSize size = item->sizeHint().boundedTo({std::max(1, place.width()), QLAYOUTSIZE_MAX});
      if (!line.empty() && x + size.width() > place.left() + place.width()) break;
      line.emplace_back(item, QRect({x, y}, size));
      x += size.width() + spacing();
      height = std::max(height, size.height());
    }
    for (auto& [item, where] : line)
      if (is_moving) item->setGeometry(where.translated(0, (height - where.height()) / 2));
    if (!line.empty()) y += height + spacing();
  }
  return std::max(0, y - spacing() - place.top());
}

int FlowRow::heightForWidth(int width) const {
  return lay({0, 0, width, 0}, false);
}

QSize FlowRow::sizeHint() const {
  int width = 0, shown = 0;
  for (const QLayoutItem* item : m_items)
    if (!item->isEmpty()) width += item->sizeHint().width() + (shown++ > 0 ? spacing() : 0);
  return {width, heightForWidth(width)};
}

QSize FlowRow::minimumSize() const {
  QSize least(0, 0);
  for (const QLayoutItem* item : m_items)
    if (!item->isEmpty()) least = least.expandedTo(item->sizeHint());
  return least;
}

void FlowRow::setGeometry(const QRect& place) {
  QLayout::setGeometry(place);
  lay(place, true);
}

}  // namespace abrazo::widgets
