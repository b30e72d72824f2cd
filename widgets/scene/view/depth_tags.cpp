#include "widgets/scene/view/depth_tags.hpp"

#include <QLabel>
#include <QVariant>
#include <algorithm>

#include "widgets/common/theme.hpp"

namespace abrazo::widgets {

void DepthTags::setColours(const Palette& palette) {
  m_palette = palette;
  for (QLabel* label : m_labels) label->setProperty("warns", {});  // dressed again when it is shown next
}

void DepthTags::show(const std::vector<Tag>& tags) {
  constexpr int beside_px = 10;
  const std::size_t shown = std::min(tags.size(), most_tags);
  while (m_labels.size() < shown) {
    auto* label = new QLabel(m_parent);
    label->setObjectName("depth");
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    label->setFont(interface_font(12, QFont::DemiBold));
    m_labels.push_back(label);
  }
  for (std::size_t t = 0; t < m_labels.size(); ++t) {
    QLabel* label = m_labels[t];
    if (t >= shown) {
      label->hide();
      continue;
    }
    if (!label->property("warns").isValid() || label->property("warns").toBool() != tags[t].warns) {
      label->setProperty("warns", tags[t].warns);
      const QColor ink =
          tags[t].warns ? (m_palette.dark ? m_palette.live.lighter(140) : m_palette.live) : m_palette.text;
      label->setStyleSheet(QString("QLabel { background: %1; color: %2; border: 1px solid %3;"
                                   " border-radius: 4px; padding: 1px 5px; }")
                               .arg(m_palette.panel.name(), ink.name(), m_palette.border.name()));
    }
    if (label->text() != tags[t].text) {
      label->setText(tags[t].text);
      label->adjustSize();
    }
    // One below the other where they would overlap, the deepest first.
    QRect room(tags[t].place + QPoint(beside_px, -label->height() / 2), label->size());
    if (room.right() > m_parent->width()) room.moveRight(tags[t].place.x() - beside_px);
    for (std::size_t earlier = 0; earlier < t; ++earlier)
      if (const QRect taken = m_labels[earlier]->geometry(); taken.intersects(room))
        room.moveTop(taken.bottom() + 2);
    label->move(room.topLeft());
    label->show();
  }
}

}  // namespace abrazo::widgets
