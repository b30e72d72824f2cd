#include "app/workbench/library/body_field.hpp"

#include <QGridLayout>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/choose_button.hpp"
#include "core/motion/body/body_choice.hpp"
#include "core/motion/joints/motion_format.hpp"
#include "widgets/common/file_dialog.hpp"
#include "widgets/common/value_slider.hpp"
#include "widgets/settings/body_box.hpp"

namespace abrazo::app {
namespace {

constexpr double size_step = 0.01;

double place_of_size(double scale) {
  return std::clamp(
      (scale - BodyField::slider_least) / (BodyField::slider_greatest - BodyField::slider_least), 0.0, 1.0);
}

double size_at(double place) {
  const double scale =
      BodyField::slider_least + place * (BodyField::slider_greatest - BodyField::slider_least);
  return std::round(scale / size_step) * size_step;
}

}  // namespace

BodyField::BodyField(const QString& name, QWidget* parent) : QWidget(parent) {
  m_box = new widgets::BodyBox(false, this);
  m_box->setAccessibleName(name);
  m_box->setToolTip("library: as recorded; scale:0.3 to scale:3; or a motion file whose proportions it gets");
  m_size = new widgets::ValueSlider(this);
  m_size->setAccessibleName(name + ": size");
  m_size->setToolTip(
      "Size against the recorded body, 0.5 to 1.5; a double click returns to the recorded one");
  m_size->setDefaultPlace(place_of_size(1));
  auto* choose = choose_button(name, this);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(2);
  grid->addWidget(m_box, 0, 0);
  grid->addWidget(choose, 0, 1);
  grid->addWidget(m_size, 1, 0);
  grid->setColumnStretch(0, 1);
  setFocusProxy(m_box);
  connect(m_box, &QComboBox::editTextChanged, this, [this] {
    showSize();
    emit changed();
  });
  connect(m_size, &widgets::ValueSlider::moved, this, &BodyField::slideTo);
  connect(m_size, &widgets::ValueSlider::stepped, this, [this](int steps) {
    slideTo(m_size->place() + steps * size_step / (slider_greatest - slider_least));
  });
  connect(m_size, &widgets::ValueSlider::resetRequested, this, [this] { slideTo(place_of_size(1)); });
  connect(choose, &QToolButton::clicked, this, &BodyField::chooseFile);
  showSize();
}

void BodyField::setColours(const widgets::Palette& palette) {
  m_size->setColours(palette);
}

QString BodyField::text() const {
  return m_box->currentText().trimmed();
}

void BodyField::slideTo(double place) {
  const double scale = size_at(std::clamp(place, 0.0, 1.0));
  const bool is_recorded = std::abs(scale - 1) < 0.5 * size_step;
  m_box->setEditText(is_recorded ? QString("library") : QString("scale:%1").arg(scale, 0, 'f', 2));
}

/// A file has proportions, not one size: the slider stands in the middle.
void BodyField::showSize() {
  const auto choice = parse_body_choice(text().toStdString());
  const bool is_scaled = choice && choice->kind == BodyChoice::Kind::Scaled;
  m_size->setPlace(place_of_size(is_scaled ? choice->scale : 1));
}

void BodyField::chooseFile() {
  const QString file = widgets::choose_file(
      this, "A motion file of one person", m_folder,
      QString("Motions (%1);;All files (*)").arg(QString::fromStdString(motion_file_patterns(true))));
  if (!file.isEmpty()) m_box->setEditText(file);
}

}  // namespace abrazo::app
