#include "widgets/takes/take_panel.hpp"

#include <QCheckBox>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QToolButton>

#include "core/session/edit/take_name.hpp"
#include "widgets/common/chip.hpp"
#include "widgets/common/icons.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/plain_text.hpp"
#include "widgets/common/scrolled.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/takes/take_rows.hpp"

namespace abrazo::widgets {
namespace {

using Phase = TakeSequence::Phase;

/// A disc begins, a square ends.
QIcon mark(bool records, const QColor& colour) {
  return painted_icon({16, 16}, [&](QPainter& painter) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    records ? painter.drawRoundedRect(QRectF(3, 3, 10, 10), 1.5, 1.5)
            : painter.drawEllipse(QPointF(8, 8), 5.5, 5.5);
  });
}

}  // namespace

TakePanel::TakePanel(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setObjectName("panel");
  setAttribute(Qt::WA_StyledBackground);
  auto* content = new QWidget(this);
  auto* column = column_in(content, {0, 4, 0, 0}, 0);
  QWidget* head = makeHead();
  column->addWidget(head);
  column->addWidget(makeDisk());
  m_none = quiet_label("No takes yet. Ctrl+R records one.", content, 12);
  m_none->setContentsMargins(12, 8, 12, 8);
  m_none->setWordWrap(true);
  m_rows = new TakeRows(content);
  column->addWidget(m_none);
  column->addWidget(m_rows, 1);
  column->addStretch(0);
  // In a low window the panels above and below need their height, too: the button stays in view.
  auto* scroll = new QScrollArea(this);
  scroll_vertically(*scroll, content);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setMinimumHeight(head->minimumSizeHint().height());
  column_in(this, {}, 0)->addWidget(scroll);
  connectParts();
  showStatus({});
  showNext();
  dress();
}

QWidget* TakePanel::makeHead() {
  auto* head = new QWidget(this);
  auto* column = column_in(head, {12, 4, 12, 8}, 6);
  m_name = new QLineEdit(head);
  m_name->setPlaceholderText("take");
  describe(*m_name, "Name of the takes", "The number increases with every take of this name");
  m_next = quiet_label({}, head, 12);
  m_next->setAccessibleName("Name of the next take");
  auto* naming = nested_row({}, 8);
  naming->addWidget(m_name, 1);
  naming->addWidget(m_next, 1);
  m_record = new QPushButton(head);
  m_record->setMinimumHeight(36);
  m_record->setIconSize({16, 16});
  m_record->setFont(interface_font(14, QFont::DemiBold));
  m_again = new QPushButton("Again", head);
  m_again->setMinimumHeight(36);
  m_again->setToolTip("Starts the next take of the same name; ends the take that is being recorded");
  auto* buttons = nested_row({}, 6);
  buttons->addWidget(m_record, 3);
  buttons->addWidget(m_again, 1);
  m_elapsed = new TabularLabel(head);
  m_elapsed->setFont(interface_font(17));
  m_elapsed->setAccessibleName("Length of the take that is being recorded");
  auto* wait = quiet_label({}, head, 12);
  wait->setText("Countdown");
  m_countdown = new QSpinBox(head);
  m_countdown->setRange(0, static_cast<int>(TakeSequence::longest_countdown_s));
  m_countdown->setSuffix(" s");
  m_countdown->setSpecialValueText("none");
  m_countdown->setAccessibleName("Countdown before a take");
  m_countdown->setToolTip("Counts in large digits over the scene before a take; Again skips it");
  m_countdown->setFixedWidth(88);  // "none" with the arrows
  auto* last = nested_row({}, 6);
  last->addWidget(m_elapsed);
  last->addStretch(1);
  last->addWidget(wait);
  last->addWidget(m_countdown);
  column->addLayout(naming);
  column->addLayout(buttons);
  column->addLayout(last);
  return head;
}

QWidget* TakePanel::makeDisk() {
  auto* disk = new QWidget(this);
  auto* column = column_in(disk, {12, 2, 12, 8}, 5);
  m_disk = new QLabel(disk);
  m_disk->setFont(interface_font(12));
  m_disk->setWordWrap(true);
  m_disk->setAccessibleName("How the disk keeps up");
  m_file = quiet_label({}, disk, 12);
  m_file->setAccessibleName("Session file");
  m_file->setMinimumWidth(40);
  m_file->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  m_everything = new QCheckBox("Keep everything on disk", disk);
  m_everything->setToolTip(
      "Writes every frame, not only takes: nothing is lost, and the timeline reaches "
      "back beyond the memory");
  m_saveAs = text_chip("Save as…", "Copies the whole session to a file of your choice", disk);
  m_pair =
      text_chip("Record pair…",
                "Records two streamed performers; at the end they can become a take of the library", disk);
  auto* buttons = nested_row({}, 6);
  buttons->addWidget(m_saveAs);
  buttons->addWidget(m_pair);
  buttons->addStretch(1);
  column->addWidget(m_disk);
  column->addWidget(m_file);
  column->addWidget(m_everything);
  column->addLayout(buttons);
  return disk;
}

void TakePanel::connectParts() {
  connect(m_record, &QPushButton::clicked, this, &TakePanel::recordRequested);
  connect(m_again, &QPushButton::clicked, this, &TakePanel::againRequested);
  connect(m_name, &QLineEdit::textChanged, this, &TakePanel::showNext);
  connect(m_name, &QLineEdit::textEdited, this, &TakePanel::nameEdited);
  connect(m_countdown, qOverload<int>(&QSpinBox::valueChanged), this, &TakePanel::countdownEdited);
  connect(m_everything, &QCheckBox::clicked, this, [this](bool on) {
    m_everything->setChecked(m_status.is_everything_kept);  // until the answer shows it
    emit everythingRequested(on);
  });
  connect(m_saveAs, &QToolButton::clicked, this, &TakePanel::saveAsRequested);
  connect(m_pair, &QToolButton::clicked, this, &TakePanel::pairRequested);
  connect(m_rows, &TakeRows::goToRequested, this, &TakePanel::goToRequested);
  connect(m_rows, &TakeRows::renameRequested, this, &TakePanel::renameRequested);
  connect(m_rows, &TakeRows::removeRequested, this, &TakePanel::removeRequested);
}

void TakePanel::setColours(const Palette& palette) {
  m_palette = palette;
  m_rows->setColours(palette);
  dress();
  showStatus(m_status);
}

/// The one thing here that must be found without reading.
void TakePanel::dress() {
  const bool busy = m_status.phase != Phase::Idle;
  const QColor ground = busy ? m_palette.panel : m_palette.live;
  const QColor ink =
      busy ? (m_palette.dark ? m_palette.live.lighter(140) : m_palette.live) : QColor(Qt::white);
  m_record->setIcon(mark(busy, ink));
  m_record->setText(m_status.phase == Phase::Recording      ? " Stop"
                    : m_status.phase == Phase::CountingDown ? " Cancel"
                                                            : " Record");
  describe(*m_record,
           m_status.phase == Phase::Recording      ? "Stop recording"
           : m_status.phase == Phase::CountingDown ? "Cancel the countdown"
                                                   : "Record a take",
           !m_status.can_record ? "A take is recorded of a live performer: connect a stream first"
           : busy               ? "Ctrl+R"
                                : "Record a take (Ctrl+R)");
  m_record->setStyleSheet(
      QString("QPushButton { background: %1; color: %2; border: 2px solid %3; border-radius: 6px; }"
              "QPushButton:hover, QPushButton:focus { border-color: %4; }"
              "QPushButton:disabled { background: %5; color: %6; border-color: %5; }")
          .arg(ground.name(), ink.name(), m_palette.live.name(), m_palette.text.name(),
               m_palette.raised.name(), m_palette.secondary.name()));
}

void TakePanel::setTakes(const RecordedTakes& takes) {
  m_takes = takes;
  m_rows->setTakes(takes);
  m_rows->setVisible(!takes.empty());
  m_none->setVisible(takes.empty());
  showNext();
}

void TakePanel::showStatus(const RecordingStatus& status) {
  const bool look = status.phase != m_status.phase || status.can_record != m_status.can_record;
  m_status = status;
  if (look) dress();
  m_record->setEnabled(status.can_record);
  m_again->setEnabled(status.can_record && !m_takes.empty());
  m_saveAs->setEnabled(!status.file.empty());
  m_pair->setEnabled(status.can_record);
  m_everything->setChecked(status.is_everything_kept);
  const QString length = QString::fromStdString(duration_text(status.elapsed_s));
  m_elapsed->setText(status.phase == Phase::Recording      ? "● " + length
                     : status.phase == Phase::CountingDown ? QString("in %1").arg(status.count)
                                                           : QString());
  m_elapsed->setColour(m_palette.dark ? m_palette.live.lighter(140) : m_palette.live);
  const DiskWords words = disk_words(status);
  const QColor ink = words.weight == DiskWords::Weight::Failed
                         ? (m_palette.dark ? m_palette.live.lighter(140) : m_palette.live)
                     : words.weight == DiskWords::Weight::Behind ? m_palette.warning
                                                                 : m_palette.text;
  m_disk->setText((words.weight == DiskWords::Weight::Fine ? "" : "⚠ ") + QString::fromStdString(words.text));
  const QString dress = "color: " + ink.name();  // set anew, even the same is worked out for the whole panel
  if (m_disk->styleSheet() != dress) m_disk->setStyleSheet(dress);
  const QString file = QString::fromStdString(status.file);
  const QString folder = QString::fromStdString(status.folder);
  m_file->setVisible(!file.isEmpty() || !folder.isEmpty());
  m_file->setText(file.isEmpty() ? "kept in " + folder : QFileInfo(file).fileName());
  m_file->setToolTip(plain_tip(file.isEmpty() ? folder : file));
  showNext();
}

void TakePanel::showNext() {
  const bool busy = m_status.phase != Phase::Idle;
  m_next->setText((busy ? "now " : "next ") + (busy ? QString::fromStdString(m_status.take) : nextName()));
  m_again->setToolTip(m_takes.empty()
                          ? "There is no take to repeat yet"
                          : "Records " + QString::fromStdString(again_name(m_takes.names())) +
                                " immediately; ends the take that is being recorded (Ctrl+Shift+R)");
}

QString TakePanel::typedName() const {
  return m_name->text();
}

void TakePanel::setTypedName(const QString& name) {
  if (name != m_name->text()) m_name->setText(name);
}

QString TakePanel::nextName() const {
  return QString::fromStdString(next_take_name(m_name->text().toStdString(), m_takes.names()));
}

int TakePanel::countdown() const {
  return m_countdown->value();
}

void TakePanel::setCountdown(int seconds) {
  const QSignalBlocker quiet(m_countdown);
  m_countdown->setValue(seconds);
}

QString TakePanel::diskText() const {
  return m_disk->text();
}

QString TakePanel::elapsedText() const {
  return m_elapsed->text();
}

}  // namespace abrazo::widgets
