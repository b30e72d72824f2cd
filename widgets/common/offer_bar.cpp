#include "widgets/common/offer_bar.hpp"

#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>

#include "widgets/common/icons.hpp"
#include "widgets/common/parts.hpp"

namespace abrazo::widgets {
namespace {

constexpr int stays_ms = 20000;

}  // namespace

OfferBar::OfferBar(QWidget* parent)
    : QWidget(parent),
      m_palette(palette_of(Theme::Dark)),
      m_text(new QLabel(this)),
      m_button(new QPushButton(this)),
      m_close(new QToolButton(this)) {
  setObjectName("offerBar");
  auto* row = row_in(this, {12, 6, 8, 6}, 8);
  row->addWidget(m_text, 1);
  row->addWidget(m_button);
  row->addWidget(m_close);
  m_text->setTextFormat(Qt::PlainText);
  m_text->setWordWrap(true);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_close->setObjectName("flat");
  m_close->setAccessibleName("Close this message");
  connect(m_close, &QToolButton::clicked, this, &QWidget::hide);
  connect(m_button, &QPushButton::clicked, this, [this] {
    hide();
    if (m_act) m_act();
  });
  auto* leave = new QTimer(this);
  leave->setObjectName("leave");
  leave->setSingleShot(true);
  leave->setInterval(stays_ms);
  connect(leave, &QTimer::timeout, this, &QWidget::hide);
  hide();
}

void OfferBar::setColours(const Palette& palette) {
  m_palette = palette;
  m_close->setIcon(icon(Icon::Close, palette.secondary));
  update();
}

void OfferBar::offer(const QString& text, const QString& button, std::function<void()> act,
                     const QString& tip) {
  m_text->setText(text);
  m_text->setToolTip(tip.isEmpty() ? QString()
                                   : "<p>" + tip.toHtmlEscaped().replace("\n", "</p><p>") + "</p>");
  m_button->setText(button);
  m_act = std::move(act);
  show();
  findChild<QTimer*>("leave")->start();
}

QString OfferBar::text() const {
  return m_text->text();
}

void OfferBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), m_palette.raised);
  painter.setPen(m_palette.border);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

}  // namespace abrazo::widgets
