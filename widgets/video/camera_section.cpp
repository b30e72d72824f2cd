#include "widgets/video/camera_section.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>

#include "core/base/positions.hpp"
#include "widgets/common/selection.hpp"
#include "widgets/video/pick_list.hpp"
#include "widgets/video/section_parts.hpp"

namespace abrazo::widgets {
namespace {

constexpr double narrowest_deg = 5, widest_deg = 150;

QString counted(int count, const QString& one) {
  return QString("%1 %2%3").arg(count).arg(one, count == 1 ? "" : "s");
}

}  // namespace

std::string camera_words(const CameraStatus& status) {
  const int picks = static_cast<int>(status.picks.size());
  if (!status.trouble.empty()) return status.trouble;
  if (status.rms_px) {
    QString words = QString("Reprojection error %1 px").arg(*status.rms_px, 0, 'f', 2);
    words += status.used == picks ? QString(" over %1").arg(counted(picks, "point"))
                                  : QString(" over %1 of %2").arg(status.used).arg(counted(picks, "point"));
    return words.toStdString();
  }
  if (status.has_camera && picks == 0) return "Camera loaded; no points to check it with";
  if (picks == 0) return "Pick joints in the video: six or more determine the camera's place";
  const int missing = status.picks_needed - picks;
  const QString so_far = counted(picks, "joint") + " picked";
  return (missing > 0 ? so_far + QString("; %1 more to find the camera").arg(missing) : so_far).toStdString();
}

CameraSection::CameraSection(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  auto* column = section_column(this);
  makeLens(*column);
  makePicking(*column);
  auto* files = section_row(column);
  m_clear = text_chip("Forget", "Removes camera and points", this);
  m_save = text_chip("Save…", "Writes lens and place of the camera to a file", this);
  m_load = text_chip("Load…", "Loads lens and place from such a file", this);
  files->addWidget(m_save);
  files->addWidget(m_load);
  files->addStretch(1);
  files->addWidget(m_clear);
  connect(m_clear, &QToolButton::clicked, this, &CameraSection::clearRequested);
  connect(m_save, &QToolButton::clicked, this, &CameraSection::saveRequested);
  connect(m_load, &QToolButton::clicked, this, &CameraSection::loadRequested);
  present();
}

void CameraSection::makeLens(QVBoxLayout& column) {
  m_lens = quiet_text(this, "Lens");
  column.addWidget(m_lens);
  auto* row = section_row(&column);
  m_intrinsics = text_chip("Intrinsics…",
                           "A calibration of the lens as OpenCV writes it: camera_matrix, "
                           "distortion_coefficients, image_width, image_height (.yml, .xml, .json)",
                           this);
  m_fov = new QDoubleSpinBox(this);
  m_fov->setAccessibleName("Horizontal field of view");
  m_fov->setRange(narrowest_deg, widest_deg);
  m_fov->setDecimals(1);
  m_fov->setSuffix("° across");
  m_fov->setKeyboardTracking(false);
  m_fov->setButtonSymbols(QAbstractSpinBox::NoButtons);
  m_fov->setToolTip("Horizontal field of view of the lens, used without a calibration");
  m_focal = new QCheckBox("find it", this);
  m_focal->setAccessibleName("Find the focal length too");
  m_focal->setToolTip("The focal length is found together with the camera's place; this needs eight points");
  row->addWidget(m_intrinsics);
  row->addWidget(m_fov, 1);
  row->addWidget(m_focal);
  connect(m_intrinsics, &QToolButton::clicked, this, &CameraSection::intrinsicsRequested);
  connect(m_fov, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &CameraSection::guessRequested);
  connect(m_focal, &QCheckBox::clicked, this, &CameraSection::freeFocalRequested);
}

void CameraSection::makePicking(QVBoxLayout& column) {
  auto* row = section_row(&column);
  m_pick = new QPushButton("Pick joints", this);
  m_pick->setCheckable(true);
  m_pick->setToolTip(
      "Then press on the joint in the picture, aim with the magnifier, release. Arrow keys move the last one "
      "by a "
      "tenth of a pixel, with Shift by one; Del removes it; Escape ends");
  m_joint = new QComboBox(this);
  m_joint->setAccessibleName("Joint to pick next");
  m_joint->setMaxVisibleItems(25);
  for (int vertex = 0; vertex < pair_vertex_count; ++vertex)
    m_joint->addItem(QString::fromStdString(vertex_name(vertex)));
  row->addWidget(m_pick);
  row->addWidget(m_joint, 1);
  m_result = quiet_text(this, "Reprojection error");
  column.addWidget(m_result);
  m_list = new PickList(this);
  column.addWidget(m_list);
  m_warnings = quiet_text(this, "Warnings about the camera");
  m_warnings->setObjectName("warning");
  column.addWidget(m_warnings);
  connect(m_pick, &QPushButton::clicked, this, &CameraSection::pickingRequested);
  connect(m_joint, qOverload<int>(&QComboBox::activated), this, &CameraSection::jointChosen);
  connect(m_list, &PickList::chosen, this, &CameraSection::pickSelected);
  connect(m_list, &PickList::removeRequested, this, &CameraSection::pickRemoveRequested);
}

void CameraSection::setColours(const Palette& palette) {
  m_palette = palette;
  m_list->setColours(palette);
  present();
}

void CameraSection::show(const CameraStatus& status) {
  if (status == m_status) return;  // with each picture of a video that plays
  m_status = status;
  present();
}

void CameraSection::present() {
  const CameraStatus& status = m_status;
  for (QWidget* part :
       {static_cast<QWidget*>(m_intrinsics), static_cast<QWidget*>(m_fov), static_cast<QWidget*>(m_focal),
        static_cast<QWidget*>(m_pick), static_cast<QWidget*>(m_joint), static_cast<QWidget*>(m_load)})
    part->setEnabled(status.usable);
  m_save->setEnabled(status.has_camera);
  m_clear->setEnabled(status.has_camera || !status.picks.empty());
  const QSignalBlocker quiet(m_fov);
  m_fov->setValue(status.guessed_fov_deg);
  m_focal->setChecked(status.free_focal_length);
  m_lens->setText(status.intrinsics.empty() ? "Lens not calibrated: a field of view is guessed"
                                            : QString::fromStdString(status.intrinsics));
  QString words = QString::fromStdString(camera_words(status));
  if (!status.place.empty()) words += "\n" + QString::fromStdString(status.place);
  m_result->setText(words);
  m_result->setStyleSheet(status.trouble.empty() ? QString() : "color: " + m_palette.warning.name());
  QStringList warnings;
  for (const std::string& warning : status.warnings) warnings << "⚠ " + QString::fromStdString(warning);
  m_warnings->setText(warnings.join("\n"));
  m_warnings->setVisible(!warnings.isEmpty());
  m_list->show(status.picks);
}

void CameraSection::setPicking(bool on) {
  m_pick->setChecked(on);
  m_pick->setText(on ? "Stop picking" : "Pick joints");
}

bool CameraSection::isPicking() const {
  return m_pick->isChecked();
}

void CameraSection::setJoint(int vertex) {
  m_joint->setCurrentIndex(vertex);
}

int CameraSection::joint() const {
  return m_joint->currentIndex();
}

void CameraSection::selectPick(int index) {
  m_list->select(index);
}

QString CameraSection::text() const {
  return m_result->text();
}

}  // namespace abrazo::widgets
