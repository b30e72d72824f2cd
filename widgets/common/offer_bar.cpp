#include "widgets/common/offer_bar.hpp"

#include <QHBoxLayout>
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
      m_row(row_in(this, {12, 6, 8, 6}, 8)),
      m_text(new QLabel(this)),
      m_close(new QToolButton(this)),
      m_leave(new QTimer(this)) {
  setObjectName("offerBar");
  m_row->addWidget(m_text, 1);
  m_row->addWidget(m_close);
  m_text->setTextFormat(Qt::PlainText);
  m_text->setWordWrap(true);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_close->setObjectName("flat");
  m_close->setAccessibleName("Close this message");
  connect(m_close, &QToolButton::clicked, this, &QWidget::hide);
  m_leave->setObjectName("leave");
  m_leave->setSingleShot(true);
  m_leave->setInterval(stays_ms);
  connect(m_leave, &QTimer::timeout, this, &QWidget::hide);
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
  showButtons({button});
  m_act = [act = std::move(act)](const QString&) {
    if (act) act();
  };
  show();
  m_leave->start();
}

void OfferBar::ask(const QString& text, const QStringList& answers, std::function<void(const QString&)> act) {
  m_text->setText(text);
  m_text->setToolTip({});
  showButtons(answers);
  m_act = std::move(act);
  show();
  m_leave->stop();
}

void OfferBar::showButtons(const QStringList& words) {
  const auto wanted = static_cast<std::size_t>(words.size());
  while (m_buttons.size() < wanted) {
    auto* button = new QPushButton(this);
    connect(button, &QPushButton::clicked, this, [this, index = static_cast<int>(m_buttons.size())] {
      hide();
      const auto act = m_act;  // which may offer something else
      act(m_answers.value(index));
    });
    m_row->insertWidget(1 + static_cast<int>(m_buttons.size()), button);
    m_buttons.push_back(button);
  }
  m_answers = words;
  for (std::size_t i = 0; i < m_buttons.size(); ++i) {
    if (i < wanted) m_buttons[i]->setText(QString(words[static_cast<int>(i)]).replace('&', "&&"));
    m_buttons[i]->setVisible(i < wanted);
  }
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
