#include "widgets/stream/scene_notice.hpp"

#include <QEvent>
#include <QPainter>
#include <algorithm>

#include "widgets/common/theme.hpp"
#include "widgets/stream/stream_sign.hpp"

namespace abrazo::widgets {
namespace {

constexpr int badge_top = 48;  // below the chips
constexpr int pad = 24;

}  // namespace

SceneNotice::SceneNotice(QWidget* over) : QWidget(over), m_palette(palette_of(Theme::Dark)) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setObjectName("scene notice");
  setFocusPolicy(Qt::NoFocus);
  over->installEventFilter(this);
  hide();
}

void SceneNotice::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void SceneNotice::say(const QString& large, const QString& line, const QString& detail) {
  if (large == m_large && line == m_line && detail == m_detail && m_badge.isEmpty() && isVisible()) return;
  m_large = large;
  m_line = line;
  m_detail = detail;
  m_badge.clear();
  present();
}

void SceneNotice::badge(StreamMark mark, const QString& words) {
  if (mark == m_mark && words == m_badge) return;
  m_large.clear();
  m_line.clear();
  m_detail.clear();
  m_mark = mark;
  m_badge = words;
  present();
}

void SceneNotice::clear() {
  m_large.clear();
  m_line.clear();
  m_detail.clear();
  m_badge.clear();
  hide();
}

QString SceneNotice::words() const {
  QStringList said;
  for (const QString& part : {m_large, m_line, m_detail, m_badge})
    if (!part.isEmpty()) said << part;
  return said.join(", ");
}

void SceneNotice::present() {
  setAccessibleName(words());
  setGeometry(parentWidget()->rect());
  raise();
  show();
  update();
}

bool SceneNotice::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize) setGeometry(parentWidget()->rect());
  return QWidget::eventFilter(watched, event);
}

void SceneNotice::paintBadge(QPainter& painter) {
  const QFont font = interface_font(12, QFont::DemiBold);
  painter.setFont(font);
  const double wide = std::min(QFontMetricsF(font).horizontalAdvance(m_badge) + 44, width() - 16.0);
  const QRectF place((width() - wide) / 2, badge_top, wide, 28);
  QColor ground = m_palette.panel;
  ground.setAlpha(235);
  painter.setPen(QPen(colour_of(m_mark, m_palette), 1));
  painter.setBrush(ground);
  painter.drawRoundedRect(place, 6, 6);
  draw_sign(painter, {place.left() + 17, place.center().y()}, m_mark, m_palette);
  painter.setPen(m_palette.text);
  const QRectF words = place.adjusted(32, 0, -8, 0);
  painter.drawText(words, Qt::AlignVCenter | Qt::AlignLeft,
                   QFontMetricsF(font).elidedText(m_badge, Qt::ElideRight, words.width()));
}

void SceneNotice::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!m_badge.isEmpty()) return paintBadge(painter);
  const QFont large = interface_font(std::clamp(height() / 5, 40, 120), QFont::DemiBold),
              line = interface_font(16, QFont::DemiBold), detail = interface_font(13);
  struct Part {
    const QString& text;
    const QFont& font;
    const QColor& colour;
  };
  const Part parts[] = {{m_large, large, m_palette.text},
                        {m_line, line, m_palette.text},
                        {m_detail, detail, m_palette.secondary}};
  const double room = width() - 4 * pad;
  double wide = 0, high = 0;
  for (const Part& part : parts) {
    if (part.text.isEmpty()) continue;
    const QRectF needs = QFontMetricsF(part.font).boundingRect(
        QRectF(0, 0, room, 4000), Qt::AlignHCenter | Qt::TextWordWrap, part.text);
    wide = std::max(wide, needs.width());
    high += needs.height() + 6;
  }
  QRectF ground(0, 0, wide + 2 * pad, high - 6 + 2 * pad);
  ground.moveCenter(QPointF(width() / 2.0, height() / 2.0));
  QColor veil = m_palette.panel;
  veil.setAlpha(225);
  painter.setPen(QPen(m_palette.border, 1));
  painter.setBrush(veil);
  painter.drawRoundedRect(ground, 8, 8);
  double y = ground.top() + pad;
  for (const Part& part : parts) {
    if (part.text.isEmpty()) continue;
    const QRectF place(ground.left() + pad, y, ground.width() - 2 * pad, 4000);
    painter.setFont(part.font);
    painter.setPen(part.colour);
    QRectF taken;
    painter.drawText(place, Qt::AlignHCenter | Qt::TextWordWrap, part.text, &taken);
    y += taken.height() + 6;
  }
}

}  // namespace abrazo::widgets
