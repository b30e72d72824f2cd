#include "widgets/stream/performer_card.hpp"

#include <QPainter>
#include <QToolButton>
#include <QVariant>

#include "widgets/common/parts.hpp"
#include "widgets/common/plain_text.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/stream/figure_grid.hpp"
#include "widgets/stream/stream_sign.hpp"

namespace abrazo::widgets {
namespace {

constexpr int head_height = 28, line_height = 18, left = 32;

}  // namespace

PerformerCard::PerformerCard(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* column = column_in(this, {0, 0, 0, 8}, 0);
  auto* head = nested_row({12, 3, 12, 3}, 0);
  head->addStretch(1);
  m_user = makePart("User", "This performer plays the user", PerformerPart::User);
  m_second =
      makePart("Second", "The other of a pair, when two performers are recorded", PerformerPart::Second);
  m_user->setProperty("first", true);
  m_second->setProperty("last", true);
  head->addWidget(m_user);
  head->addWidget(m_second);
  column->addLayout(head);
  column->addSpacing(2 * line_height);
  m_figures = new FigureGrid("Figures of the performer", this);
  column->addWidget(m_figures);
}

QToolButton* PerformerCard::makePart(const QString& text, const QString& tip, PerformerPart part) {
  auto* button = new QToolButton(this);
  button->setObjectName("segment");
  button->setText(text);
  button->setToolTip(tip);
  button->setCheckable(true);
  button->setFocusPolicy(Qt::TabFocus);
  button->setFixedHeight(22);
  connect(button, &QToolButton::clicked, this, [this, part](bool on) {
    emit partRequested(QString::fromStdString(m_performer.performer), on ? part : PerformerPart::None);
  });
  return button;
}

void PerformerCard::setColours(const Palette& palette) {
  m_palette = palette;
  m_figures->setColours(palette);
  update();
}

void PerformerCard::show(const PerformerHealth& performer, PerformerPart part) {
  m_performer = performer;
  m_part = part;
  const QString name = QString::fromStdString(performer.performer);
  setAccessibleName("Performer " + name);
  setAccessibleDescription(performer.tracked ? "tracked" : "tracking lost");
  QString about = name + (performer.tracked ? ": tracked\n" : ": tracking lost\n") +
                  QString::fromStdString(body_line(performer) + "\n" + estimated_line(performer));
  for (const std::string& doubt : performer.calibration_doubts)
    about += "\nThe T-pose is doubtful: " + QString::fromStdString(doubt);
  setToolTip(plain_tip(about));
  m_user->setChecked(part == PerformerPart::User);
  m_user->setAccessibleName(name + " plays the user");
  m_second->setChecked(part == PerformerPart::Second);
  m_second->setAccessibleName(name + " is the second of a recorded pair");
  m_figures->show(figures_of(performer));
  update();
}

void PerformerCard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const auto write = [&](double top, double height, double room, const QString& words) {
    painter.drawText(QRectF(left, top, room, height), Qt::AlignVCenter | Qt::AlignLeft,
                     QFontMetricsF(painter.font()).elidedText(words, Qt::ElideRight, room));
  };
  draw_sign(painter, {19, head_height / 2.0}, m_performer.tracked ? StreamMark::Good : StreamMark::Warning,
            m_palette);
  const double room = m_user->x() - left - 8;
  painter.setFont(interface_font(12, QFont::DemiBold));
  painter.setPen(m_palette.text);
  const QString name = QString::fromStdString(m_performer.performer);
  const double wide = QFontMetricsF(painter.font()).horizontalAdvance(name);
  write(0, head_height, room, name);
  if (!m_performer.tracked) {
    painter.setFont(interface_font(12));
    painter.setPen(m_palette.warning);
    const QRectF rest(left + wide + 10, 0, room - wide - 10, head_height);
    const QFontMetricsF metrics(painter.font());
    for (const char* words : {"tracking lost", "lost"}) {
      if (metrics.horizontalAdvance(words) > rest.width()) continue;
      painter.drawText(rest, Qt::AlignVCenter | Qt::AlignLeft, words);
      break;
    }
  }
  painter.setFont(interface_font(12));
  painter.setPen(m_palette.secondary);
  write(head_height, line_height, width() - left - 12, QString::fromStdString(body_line(m_performer)));
  const std::string estimated = estimated_line(m_performer);
  write(head_height + line_height, line_height, width() - left - 12,
        estimated.empty() ? "every joint is sent" : QString::fromStdString(estimated));
}

}  // namespace abrazo::widgets
