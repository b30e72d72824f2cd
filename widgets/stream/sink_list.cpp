#include "widgets/stream/sink_list.hpp"

#include <QComboBox>
#include <QGridLayout>
#include <QIntValidator>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <QToolButton>

#include "widgets/common/icons.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/plain_text.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/stream/stream_sign.hpp"
#include "widgets/stream/stream_words.hpp"

namespace abrazo::widgets {

/// One sink in two lines: what goes where, how much.
class SinkCard : public QWidget {
 public:
  explicit SinkCard(SinkList* parent) : QWidget(parent), m_stop(new QToolButton(this)) {
    setFixedHeight(44);
    m_stop->setObjectName("flat");
    m_stop->setFocusPolicy(Qt::TabFocus);
    m_stop->setToolTip("Stop sending");
    connect(m_stop, &QToolButton::clicked, parent,
            [this, parent] { parent->askStop(QString::fromStdString(m_row.health.uri)); });
  }
  void setColours(const Palette& palette) {
    m_palette = palette;
    m_stop->setIcon(icon(Icon::Close, palette.secondary));
    update();
  }
  void show(const SinkRow& row) {
    m_row = row;
    const QString what = QString::fromStdString(row.health.character + " to " + row.health.uri);
    m_stop->setAccessibleName("Stop sending: " + what);
    setAccessibleName(what);
    setAccessibleDescription(figures());
    const std::string& failure = row.health.latest_failure;
    setToolTip(plain_tip(what + "\n" + figures() +
                         (failure.empty() ? QString() : "\n" + QString::fromStdString(failure))));
    update();
  }

 protected:
  void resizeEvent(QResizeEvent*) override { m_stop->setGeometry(width() - 34, 2, 22, 22); }
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    const bool failing = m_row.health.failures > 0;
    draw_sign(painter, {19, 13}, failing ? StreamMark::Warning : StreamMark::Good, m_palette);
    const bool is_user = m_row.health.character == "user";
    painter.setFont(interface_font(12, QFont::DemiBold));
    painter.setPen(m_palette.text);
    const QString who = is_user ? "User" : "Partner";
    painter.drawText(QRectF(32, 2, 60, 22), Qt::AlignVCenter | Qt::AlignLeft, who);
    painter.setFont(interface_font(12));
    const QRectF place(92, 2, width() - 92 - 40, 22);
    painter.drawText(
        place, Qt::AlignVCenter | Qt::AlignLeft,
        QFontMetricsF(painter.font())
            .elidedText(QString::fromStdString(m_row.health.uri), Qt::ElideMiddle, place.width()));
    painter.setPen(failing ? m_palette.warning : m_palette.secondary);
    const QRectF line(32, 22, width() - 44, 19);
    draw_tabular(painter, line, Qt::AlignLeft,
                 QFontMetricsF(painter.font()).elidedText(figures(), Qt::ElideRight, line.width()));
  }

 private:
  QString figures() const {
    return QString("%1 packets/s · %2 sent · %3 failed")
        .arg(m_row.packets_per_s, 5, 'f', 0)
        .arg(QString::fromStdString(count_text(m_row.health.packets)),
             QString::fromStdString(count_text(m_row.health.failures)));
  }
  Palette m_palette = palette_of(Theme::Dark);
  SinkRow m_row;
  QToolButton* m_stop;
};

SinkList::SinkList(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  auto* outer = column_in(this, {}, 0);
  m_none = quiet_label("Nothing is sent. Add the address of a game engine or a viewer.", this);
  m_none->setWordWrap(true);
  m_none->setContentsMargins(12, 2, 12, 4);
  m_none->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  outer->addWidget(m_none);
  m_column = nested_column({}, 0);
  outer->addLayout(m_column);
  outer->addWidget(makeForm());
}

QWidget* SinkList::makeForm() {
  auto* form = new QWidget(this);
  auto* grid = new QGridLayout(form);
  grid->setContentsMargins(12, 4, 12, 8);
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(6);
  grid->setColumnStretch(1, 1);
  m_character = new QComboBox(form);
  m_character->addItems({"Partner", "User"});
  m_character->setAccessibleName("Character to send");
  m_host = new QLineEdit(form);
  m_host->setPlaceholderText("127.0.0.1");
  m_host->setAccessibleName("Address to send to");
  m_port = new QLineEdit(form);
  m_port->setPlaceholderText("39540");
  m_port->setFixedWidth(72);
  m_port->setAccessibleName("Port to send to");
  m_port->setValidator(new QIntValidator(1, 65535, m_port));
  m_framing = new QComboBox(form);
  m_framing->addItem("VMC", "framing=t-last");
  m_framing->addItem("VMC, T first", "framing=t-first");
  m_framing->addItem("VMC, several bundles", "framing=split");
  m_framing->addItem("VMC, root at origin", "framing=t-last&root=origin");
  describe(
      *m_framing, "Framing",
      "VMC: a frame is one bundle, its root has the place and heading of the character. T first: as SlimeVR "
      "sends. Several bundles: for networks that lose packets above 1500 bytes. Root at origin: for "
      "receivers that take the place from the hips");
  auto* add = new QPushButton("Send", form);
  add->setFixedWidth(104);
  grid->addWidget(m_character, 0, 0);
  grid->addWidget(m_host, 0, 1);
  grid->addWidget(m_port, 0, 2);
  grid->addWidget(m_framing, 1, 0, 1, 2);
  grid->addWidget(add, 1, 2, Qt::AlignRight);
  const auto ask = [this] {
    emit sendRequested(uri(), m_character->currentIndex() == 1 ? Character::User : Character::Partner);
  };
  connect(add, &QPushButton::clicked, this, ask);
  for (QLineEdit* field : {m_host, m_port}) connect(field, &QLineEdit::returnPressed, this, ask);
  return form;
}

void SinkList::setColours(const Palette& palette) {
  m_palette = palette;
  for (SinkCard* card : m_cards) card->setColours(palette);
}

void SinkList::show(const std::vector<SinkRow>& rows) {
  while (m_cards.size() > rows.size()) {
    m_cards.back()->hide();
    m_cards.back()->deleteLater();  // its button may be the clicked one
    m_column->removeWidget(m_cards.back());
    m_cards.pop_back();
  }
  while (m_cards.size() < rows.size()) {
    m_cards.push_back(new SinkCard(this));
    m_cards.back()->setColours(m_palette);
    m_column->addWidget(m_cards.back());
  }
  for (std::size_t i = 0; i < rows.size(); ++i) m_cards[i]->show(rows[i]);
  m_none->setVisible(rows.empty());
}

QString SinkList::uri() const {
  const QString host = m_host->text().trimmed(), port = m_port->text().trimmed();
  return QString("vmc://%1:%2?%3")
      .arg(host.isEmpty() ? m_host->placeholderText() : host,
           port.isEmpty() ? m_port->placeholderText() : port, m_framing->currentData().toString());
}

void SinkList::setAddress(const QString& host, int port) {
  m_host->setText(host);
  m_port->setText(QString::number(port));
}

void SinkList::takeFocus() {
  m_host->setFocus();
  m_host->selectAll();
  // The panel may have been opened for it just now, and the field lie below what is seen of it.
  QTimer::singleShot(0, m_host, [host = m_host] {
    for (QWidget* above = host->parentWidget(); above; above = above->parentWidget())
      if (auto* scrolled = qobject_cast<QScrollArea*>(above)) scrolled->ensureWidgetVisible(host);
  });
}

}  // namespace abrazo::widgets
