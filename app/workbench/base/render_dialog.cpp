#include "app/workbench/base/render_dialog.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "app/workbench/base/range_words.hpp"

namespace abrazo::app {
RenderDialog::RenderDialog(QWidget* parent) : QDialog(parent) {
  setObjectName("renderRange");
  setWindowTitle("Render a range as video");
  auto* form = new QFormLayout(this);
  form->setContentsMargins(20, 16, 20, 16);
  m_whatTitle = new QLabel("What", this);
  m_what = new QComboBox(this);
  m_what->setAccessibleName("What is rendered");
  m_what->addItems({"The scene", "The reference video with its overlay"});
  m_span = new QComboBox(this);
  m_span->setAccessibleName("Range");
  m_size = new QComboBox(this);
  m_size->setAccessibleName("Size in pixels");
  m_rate = new QDoubleSpinBox(this);
  m_rate->setAccessibleName("Pictures per second");
  m_rate->setRange(FilmPlan::slowest_hz, FilmPlan::fastest_hz);
  m_rate->setDecimals(2);
  m_rate->setValue(30);
  m_rate->setSuffix(" Hz");
  m_captions = new QCheckBox("With legends and facts of the frame", this);
  m_captions->setChecked(true);
  m_estimate = new QLabel(this);
  m_render = new QPushButton("Render…", this);
  m_render->setDefault(true);
  auto* cancel = new QPushButton("Close", this);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch(1);
  buttons->addWidget(cancel);
  buttons->addWidget(m_render);
  form->addRow(m_whatTitle, m_what);
  form->addRow("Range", m_span);
  form->addRow("Size", m_size);
  form->addRow("Rate", m_rate);
  form->addRow(QString(), m_captions);
  form->addRow(QString(), m_estimate);
  form->addRow(buttons);
  connect(m_span, qOverload<int>(&QComboBox::currentIndexChanged), this, &RenderDialog::estimate);
  connect(m_rate, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &RenderDialog::estimate);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(m_what, qOverload<int>(&QComboBox::currentIndexChanged), this, &RenderDialog::chooseWhat);
  connect(m_render, &QPushButton::clicked, this,
          [this] { isOfVideo() ? emit videoRenderRequested() : emit renderRequested(); });
  offerVideo({}, 0);
}

void RenderDialog::offerVideo(QSize size, double rate_hz) {
  m_video = QSize(size.width() & ~1, size.height() & ~1);
  if (isOfVideo() && rate_hz != m_videoRate) m_rate->setValue(rate_hz);
  m_videoRate = rate_hz;
  for (QWidget* part : {static_cast<QWidget*>(m_whatTitle), static_cast<QWidget*>(m_what)})
    part->setVisible(!size.isEmpty());
  if (size.isEmpty()) m_what->setCurrentIndex(0);
}

bool RenderDialog::isOfVideo() const {
  return m_what->currentIndex() == 1;
}

/// A video is best rendered at its own size and rate.
void RenderDialog::chooseWhat() {
  m_captions->setEnabled(!isOfVideo());
  if (isOfVideo() != m_wasOfVideo) {
    if (isOfVideo()) m_sceneRate = m_rate->value();
    m_rate->setValue(isOfVideo() ? m_videoRate : m_sceneRate);
    m_wasOfVideo = isOfVideo();
  }
  const QString title = QString("%1 × %2  (as the video)").arg(m_video.width()).arg(m_video.height());
  if (const int old = m_size->findText("(as the video)", Qt::MatchEndsWith); old >= 0)
    m_size->removeItem(old);
  if (!isOfVideo()) return;
  m_size->insertItem(0, title, m_video);
  m_size->setCurrentIndex(0);
}

void RenderDialog::offer(const Playback& playback, const std::optional<Playback::Range>& range, QSize view) {
  m_whole = {playback.first_s, playback.last_s};
  m_range = range.value_or(m_whole);
  m_span->clear();
  if (range && m_range != m_whole) m_span->addItem(range_words("In to out", m_range));
  m_span->addItem(range_words("Everything", m_whole));
  m_size->clear();
  const QSize even(view.width() & ~1, view.height() & ~1);
  for (const QSize size : {QSize(1280, 720), QSize(1920, 1080), QSize(3840, 2160), even})
    m_size->addItem(
        QString("%1 × %2%3").arg(size.width()).arg(size.height()).arg(size == even ? "  (as the view)" : ""),
        size);
  chooseWhat();
  estimate();
}

RangeRequest RenderDialog::request() const {
  const bool whole = m_span->currentIndex() == m_span->count() - 1;
  const Playback::Range& range = whole ? m_whole : m_range;
  return {{range.from_s, range.to_s, m_rate->value()},
          m_size->currentData().toSize(),
          m_captions->isChecked(),
          {}};
}

void RenderDialog::estimate() {
  const FilmPlan plan = request().plan;
  m_estimate->setText(QString("%1 pictures, %2 of film")
                          .arg(plan.pictures())
                          .arg(in_seconds(plan.pictures() / plan.rate_hz)));
  m_render->setEnabled(plan.pictures() > 1);
}

}  // namespace abrazo::app
