#include "widgets/video/sync_section.hpp"

#include <QDoubleSpinBox>
#include <QPushButton>

#include "core/session/frames/time_place.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/video/section_parts.hpp"
#include "widgets/video/video_words.hpp"

namespace abrazo::widgets {
namespace {

constexpr double longest_s = 86'400, least_rate = 0.001, most_rate = 1000;

QString text_of(const std::string& utf8) {
  return QString::fromStdString(utf8);
}

}  // namespace

SyncSection::SyncSection(QWidget* parent) : QWidget(parent) {
  auto* column = section_column(this);
  m_words = quiet_text(this, "Synchronisation");
  column->addWidget(m_words);
  auto* buttons = section_row(column);
  m_same = new QPushButton("Same moment", this);
  m_same->setToolTip(
      "The picture that is shown and the timeline's cursor are the same moment. The first such point gives "
      "the "
      "offset, a second one the rate too (Ctrl+M)");
  m_clear = text_chip("Clear", "Sets offset and rate back: both begin together, at the same rate", this);
  buttons->addWidget(m_same, 1);
  buttons->addWidget(m_clear);
  m_points = nested_column({}, 2);
  column->addLayout(m_points);
  auto* fields = section_row(column);
  m_offset = makeField("Offset", 3);
  m_offset->setRange(-longest_s, longest_s);
  m_offset->setSuffix(" s");
  m_offset->setToolTip("Time of the video where the timeline is at 0");
  m_rate = makeField("Rate", 6);
  m_rate->setRange(least_rate, most_rate);
  m_rate->setSingleStep(0.001);
  m_rate->setToolTip(
      "Seconds of the video per second of the timeline. A number entered here removes the second point");
  fields->addWidget(new QLabel("Offset", this));
  fields->addWidget(m_offset, 1);
  fields->addWidget(new QLabel("Rate", this));
  fields->addWidget(m_rate, 1);
  m_advice = quiet_text(this, "What to do next");
  column->addWidget(m_advice);
  connect(m_same, &QPushButton::clicked, this, &SyncSection::pointRequested);
  connect(m_clear, &QToolButton::clicked, this, &SyncSection::clearRequested);
  connect(m_offset, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &SyncSection::offsetEntered);
  connect(m_rate, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &SyncSection::rateEntered);
  show({}, false);
}

QDoubleSpinBox* SyncSection::makeField(const QString& name, int decimals) {
  auto* field = new QDoubleSpinBox(this);
  field->setAccessibleName(name + " of the video");
  field->setDecimals(decimals);
  field->setKeyboardTracking(false);
  field->setButtonSymbols(QAbstractSpinBox::NoButtons);
  field->setMinimumWidth(60);
  return field;
}

void SyncSection::show(const VideoSync& sync, bool usable) {
  const bool same_points = sync.points == m_sync.points;
  m_sync = sync;
  for (QWidget* part :
       {static_cast<QWidget*>(m_same), static_cast<QWidget*>(m_offset), static_cast<QWidget*>(m_rate)})
    part->setEnabled(usable);
  m_clear->setEnabled(usable && sync != VideoSync{});
  const QSignalBlocker quiet_offset(m_offset), quiet_rate(m_rate);
  m_offset->setValue(sync.video_time(0));
  m_rate->setValue(sync.effective_rate());
  m_words->setText(text_of(offset_text(sync) + "; " + rate_text(sync)));
  m_advice->setText(usable ? text_of(sync_advice(sync)) : QString());
  m_advice->setVisible(usable);
  if (!same_points || m_rows.size() != sync.points.size()) makeRows();
}

void SyncSection::makeRows() {
  for (QWidget* row : m_rows) {
    m_points->removeWidget(row);
    row->hide();
    row->deleteLater();
  }
  m_rows.clear();
  for (std::size_t i = 0; i < m_sync.points.size(); ++i) {
    const SyncPoint& point = m_sync.points[i];
    auto* box = new QWidget(this);
    auto* row = row_in(box, {section_margin, 0, section_margin, 0});
    const QString words = QString("Timeline %1  =  video %2")
                              .arg(text_of(clock_text(point.subject_s)), text_of(clock_text(point.video_s)));
    auto* go = text_chip(words, "The cursor goes there", box);
    auto* remove = text_chip("✕", "Removes the point", box);
    remove->setAccessibleName(QString("Remove point %1").arg(i + 1));
    row->addWidget(go, 1);
    row->addWidget(remove);
    go->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(go, &QToolButton::clicked, this, [this, at = point.subject_s] { emit goToRequested(at); });
    connect(remove, &QToolButton::clicked, this,
            [this, i] { emit pointRemoveRequested(static_cast<int>(i)); });
    m_points->addWidget(box);
    m_rows.push_back(box);
  }
}

QString SyncSection::text() const {
  return m_words->text();
}

}  // namespace abrazo::widgets
