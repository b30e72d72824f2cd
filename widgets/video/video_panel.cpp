#include "widgets/video/video_panel.hpp"

#include <QComboBox>
#include <QResizeEvent>
#include <QSplitter>

#include "widgets/common/parts.hpp"
#include "widgets/common/scrolled.hpp"
#include "widgets/common/section_header.hpp"
#include "widgets/video/camera_section.hpp"
#include "widgets/video/overlay_section.hpp"
#include "widgets/video/section_parts.hpp"
#include "widgets/video/step_bar.hpp"
#include "widgets/video/sync_section.hpp"
#include "widgets/video/video_view.hpp"

namespace abrazo::widgets {
namespace {

constexpr double wide_from = 1.5;  // times as wide as high: the sections go beside the picture
constexpr int beside_width = 320, least_sections = 110;
constexpr int least_picture = 280;  ///< width of a picture with something beside it: that of the step bar

}  // namespace

VideoPanel::VideoPanel(QWidget* parent) : QWidget(parent) {
  auto* column = column_in(this);
  m_split = new QSplitter(Qt::Vertical, this);
  m_split->setHandleWidth(1);
  m_split->setChildrenCollapsible(false);
  m_split->addWidget(makePicture());
  m_split->addWidget(makeSections());
  m_split->setStretchFactor(0, 1);
  m_split->setStretchFactor(1, 0);
  column->addWidget(m_split);
  connect(m_split, &QSplitter::splitterMoved, this, [this] { m_isArranged = true; });
  setMinimumWidth(240);
  showFiles({}, -1);
  showFacts({}, {});
}

QWidget* VideoPanel::makePicture() {
  auto* box = new QWidget(this);
  auto* column = column_in(box, {}, 0);
  m_view = new VideoView(box);
  m_steps = new StepBar(box);
  column->addWidget(m_view, 1);
  column->addWidget(m_steps);
  return box;
}

QWidget* VideoPanel::section(const QString& title) {
  m_heads.push_back(new SectionHeader(title, this));
  return m_heads.back();
}

QWidget* VideoPanel::makeFile() {
  auto* box = new QWidget(this);
  auto* column = section_column(box);
  column->setContentsMargins(0, 4, 0, 2);
  auto* row = section_row(column);
  m_files = new QComboBox(box);
  m_files->setAccessibleName("Video that is shown");
  m_files->setMinimumContentsLength(6);
  m_files->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  auto* open = text_chip("Open…", "Another video of the subject on the timeline", box);
  m_close = text_chip("Close", "Closes this video; undo brings it back", box);
  row->addWidget(m_files, 1);
  row->addWidget(open);
  row->addWidget(m_close);
  m_facts = quiet_text(box, "Facts of the video");
  m_warning = quiet_text(box, "Warnings about the file");
  m_warning->setObjectName("warning");
  column->addWidget(m_facts);
  column->addWidget(m_warning);
  connect(open, &QToolButton::clicked, this, &VideoPanel::openRequested);
  connect(m_close, &QToolButton::clicked, this, &VideoPanel::closeRequested);
  connect(m_files, qOverload<int>(&QComboBox::activated), this, &VideoPanel::chosen);
  return box;
}

QWidget* VideoPanel::makeSections() {
  auto* content = new QWidget(this);
  auto* column = column_in(content, {}, 0);
  m_sync = new SyncSection(content);
  m_overlay = new OverlaySection(content);
  m_camera = new CameraSection(content);
  for (QWidget* part :
       {makeFile(), section("Synchronisation"), static_cast<QWidget*>(m_sync), section("Overlay"),
        static_cast<QWidget*>(m_overlay), section("Camera"), static_cast<QWidget*>(m_camera)})
    column->addWidget(part);
  column->addStretch(1);
  auto* scroll = new QScrollArea(this);
  scroll_vertically(*scroll, content);
  scroll->setMinimumHeight(90);
  return scroll;
}

void VideoPanel::setColours(const Palette& palette) {
  m_view->setColours(palette);
  m_steps->setColours(palette);
  m_overlay->setColours(palette);
  m_camera->setColours(palette);
  for (SectionHeader* head : m_heads) head->setColours(palette);
}

void VideoPanel::showFiles(const QStringList& names, int current) {
  const QSignalBlocker quiet(m_files);
  m_files->clear();
  m_files->addItems(names);
  m_files->setCurrentIndex(current);
  m_files->setEnabled(!names.isEmpty());
  m_close->setEnabled(current >= 0);
}

void VideoPanel::showFacts(const QString& facts, const QString& warning) {
  m_facts->setText(facts);
  m_facts->setVisible(!facts.isEmpty());
  m_warning->setText(warning);
  m_warning->setVisible(!warning.isEmpty());
}

QString VideoPanel::facts() const {
  return m_facts->text();
}

/// The picture has priority: as wide as possible, unless the user moved the splitter.
void VideoPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const bool wide = width() > wide_from * height() && width() >= least_picture + beside_width;
  const Qt::Orientation wanted = wide ? Qt::Horizontal : Qt::Vertical;
  if (m_split->orientation() != wanted) {
    m_split->setOrientation(wanted);
    m_isArranged = false;
  }
  if (m_isArranged) return;
  const int high = std::min(width() * 9 / 16 + m_steps->sizeHint().height(), height() - least_sections);
  wide ? m_split->setSizes({width() - beside_width, beside_width})
       : m_split->setSizes({high, height() - high});
}

}  // namespace abrazo::widgets
