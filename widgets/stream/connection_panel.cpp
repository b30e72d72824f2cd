#include "widgets/stream/connection_panel.hpp"

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/common/parts.hpp"
#include "widgets/common/plain_text.hpp"
#include "widgets/common/scrolled.hpp"
#include "widgets/common/section_header.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/stream/address_form.hpp"
#include "widgets/stream/figure_grid.hpp"
#include "widgets/stream/issue_list.hpp"
#include "widgets/stream/number_row.hpp"
#include "widgets/stream/performer_card.hpp"
#include "widgets/stream/sink_list.hpp"
#include "widgets/stream/stream_head.hpp"

namespace abrazo::widgets {
namespace {

constexpr NumberRow::Range delays{0, 500, 0, 5};
constexpr int input_rate = 0;  ///< of the step rate: the input's own

QLabel* quiet_line(QWidget* parent, int lines) {
  auto* label = quiet_label({}, parent);
  label->setWordWrap(true);
  label->setContentsMargins(12, 0, 12, 0);
  label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setFixedHeight(17 * lines);
  return label;
}

QString said_of(const StreamHealth& health) {
  QStringList lines;
  QStringList senders;
  for (const std::string& sender : health.senders) senders << QString::fromStdString(sender);
  if (!senders.isEmpty()) lines << "from " + senders.join(", ");
  for (const std::string& fact : health.facts) lines << QString::fromStdString(fact);
  if (has_unknown_packets(health))
    lines << "not understood: " + QString::fromStdString(dump_text(health.first_bytes));
  return lines.join("\n");
}

}  // namespace

ConnectionPanel::ConnectionPanel(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  auto* outer = column_in(this, {}, 0);
  auto* content = new QWidget(this);
  auto* column = column_in(content, {}, 0);
  m_head = new StreamHead(content);
  m_form = new AddressForm(content);
  m_issues = new IssueList(content);
  m_traffic = new FigureGrid("Packets of the stream", content);
  m_sinks = new SinkList(content);
  auto* performers = new QWidget(content);
  m_performers = column_in(performers, {}, 0);
  m_nobody = quiet_line(performers, 2);
  m_performers->addWidget(m_nobody);
  for (QWidget* part :
       {static_cast<QWidget*>(m_head), static_cast<QWidget*>(m_form), section("Performers"), performers,
        makeCalibration(), section("Timing"), makeTiming(), section("Diagnosis"),
        static_cast<QWidget*>(m_issues), makeReport(), section("Outputs"), static_cast<QWidget*>(m_sinks)})
    column->addWidget(part);
  column->addStretch(1);
  auto* scroll = new QScrollArea(this);
  scroll_vertically(*scroll, content);
  scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);  // its coming and going would move all columns
  outer->addWidget(scroll);
  setMinimumWidth(260);
  showCalibration({}, false);
  showHealth(nullptr);
}

QWidget* ConnectionPanel::section(const QString& title) {
  m_heads.push_back(new SectionHeader(title, this));
  return m_heads.back();
}

QWidget* ConnectionPanel::makeCalibration() {
  auto* box = new QWidget(this);
  auto* column = column_in(box, {}, 4);
  auto* row = nested_row({12, 4, 12, 0}, 6);
  m_calibrate = new QPushButton("Calibrate in T-pose", box);
  m_calibrate->setToolTip(
      "Counts down, then measures the user who stands in the T-pose: rest pose and lengths of the body");
  m_forget = new QPushButton("Forget", box);
  describe(*m_forget, "Forget the calibration", "Removes the calibration and reconnects");
  row->addWidget(m_calibrate, 1);
  row->addWidget(m_forget);
  column->addLayout(row);
  m_calibration = quiet_line(box, 2);
  m_calibration->setAccessibleName("Calibration");
  column->addWidget(m_calibration);
  connect(m_calibrate, &QPushButton::clicked, this, &ConnectionPanel::calibrateRequested);
  connect(m_forget, &QPushButton::clicked, this, &ConnectionPanel::forgetRequested);
  return box;
}

QWidget* ConnectionPanel::makeTiming() {
  auto* box = new QWidget(this);
  auto* column = column_in(box, {}, 0);
  m_delay = new NumberRow("Jitter buffer delay", "ms", delays, box);
  m_delay->setToolTip(
      "Delays each pose by this time after it was due: late packets are then in time, and the latency grows "
      "by as much. Double click: 0");
  connect(m_delay, &NumberRow::changed, this, &ConnectionPanel::delayRequested);
  column->addWidget(m_delay);
  auto* row = nested_row({12, 4, 12, 4});
  auto* title = new QLabel("Solver step rate", box);
  m_stepRate = new QComboBox(box);
  describe(*m_stepRate, "Solver step rate",
           "The setting step-rate: how often the partner answers. The same as in the settings");
  m_stepRate->setFixedWidth(128);
  m_stepRate->addItem("input's rate", input_rate);
  for (const int hz : {15, 30, 60, 90, 120}) m_stepRate->addItem(QString("%1 Hz").arg(hz), hz);
  connect(m_stepRate, qOverload<int>(&QComboBox::activated), this,
          [this] { emit stepRateRequested(m_stepRate->currentData().toString()); });
  row->addWidget(title, 1);
  row->addWidget(m_stepRate);
  column->addLayout(row);
  return box;
}

QWidget* ConnectionPanel::makeReport() {
  auto* box = new QWidget(this);
  auto* column = column_in(box, {}, 0);
  column->addSpacing(6);
  column->addWidget(m_traffic);
  column->addSpacing(2);
  m_said = quiet_line(box, 3);
  m_said->setAccessibleName("Senders");
  column->addWidget(m_said);
  auto* row = nested_row({12, 4, 12, 4});
  m_copy = new QPushButton("Copy report", box);
  m_copy->setToolTip("All figures, diagnoses and issues as text, for a support request");
  row->addWidget(m_copy);
  row->addStretch(1);
  column->addLayout(row);
  connect(m_copy, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(QString::fromStdString(report_of(m_health))); });
  return box;
}

void ConnectionPanel::setColours(const Palette& palette) {
  m_palette = palette;
  m_head->setColours(palette);
  m_form->setColours(palette);
  m_issues->setColours(palette);
  m_traffic->setColours(palette);
  m_sinks->setColours(palette);
  m_delay->setColours(palette);
  for (SectionHeader* head : m_heads) head->setColours(palette);
  for (PerformerCard* card : m_cards) card->setColours(palette);
}

void ConnectionPanel::showHealth(const StreamHealth* health) {
  m_connected = health != nullptr;
  m_health = health ? *health : StreamHealth{};
  m_head->show(headline_of(health));
  m_form->setConnected(m_connected);
  m_issues->show(health);
  m_traffic->show(traffic_of(m_health));
  const QString said = said_of(m_health);
  if (said != m_said->text()) {
    m_said->setText(said);
    m_said->setToolTip(plain_tip(said));
  }
  m_copy->setEnabled(m_connected);
  showPerformers();
}

void ConnectionPanel::showPerformers() {
  const auto& performers = m_health.performers;
  while (m_cards.size() > performers.size()) {
    m_performers->removeWidget(m_cards.back());
    m_cards.back()->hide();
    m_cards.back()->deleteLater();
    m_cards.pop_back();
  }
  while (m_cards.size() < performers.size()) {
    m_cards.push_back(new PerformerCard(this));
    m_cards.back()->setColours(m_palette);
    connect(m_cards.back(), &PerformerCard::partRequested, this, &ConnectionPanel::choose);
    m_performers->addWidget(m_cards.back());
  }
  for (std::size_t i = 0; i < performers.size(); ++i) {
    const QString name = QString::fromStdString(performers[i].performer);
    const QString user = m_user.isEmpty() ? QString::fromStdString(m_health.followed) : m_user;
    const bool is_user = user.isEmpty() ? i == 0 : name == user;
    m_cards[i]->show(performers[i], is_user            ? PerformerPart::User
                                    : name == m_second ? PerformerPart::Second
                                                       : PerformerPart::None);
  }
  m_nobody->setVisible(performers.empty());
  m_nobody->setText(m_connected ? "No performer yet. Performers are listed here by sender."
                                : "Connect to a stream; its performers are listed here.");
  const bool calibrates = !performers.empty();
  m_forget->setEnabled(calibrates && std::any_of(performers.begin(), performers.end(),
                                                 [](const PerformerHealth& one) { return one.calibrated; }));
}

void ConnectionPanel::choose(const QString& performer, PerformerPart part) {
  if (part == PerformerPart::User) emit userChosen(performer);
  if (part == PerformerPart::Second) emit secondChosen(performer);
  if (part == PerformerPart::None && performer == m_second) emit secondChosen({});
  showPerformers();  // restores a part that was not released
}

void ConnectionPanel::setParts(const QString& user, const QString& second) {
  m_user = user;
  m_second = second;
  showPerformers();
}

void ConnectionPanel::showCalibration(const QString& words, bool under_way) {
  m_calibrate->setText(under_way ? "Cancel the calibration" : "Calibrate in T-pose");
  m_calibration->setText(words.isEmpty() ? "Sets rest pose and bone lengths to those of the user." : words);
  m_calibration->setToolTip(m_calibration->text());
}

void ConnectionPanel::setDelay(int ms) {
  m_delay->setNumber(ms);
}

void ConnectionPanel::setStepRate(double hz) {
  const int rate = static_cast<int>(hz);
  int row = m_stepRate->findData(rate);
  const QString own = QString("%1 Hz").arg(hz);
  if (row < 0 || rate != hz) {
    row = m_stepRate->findText(own);
    if (row < 0) {
      m_stepRate->addItem(own, hz);
      row = m_stepRate->count() - 1;
    }
  }
  m_stepRate->setCurrentIndex(row);
}

void ConnectionPanel::showSinks(const std::vector<SinkRow>& rows) {
  m_sinks->show(rows);
}

}  // namespace abrazo::widgets
